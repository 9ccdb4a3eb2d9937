// A layer in a program of the user's: written as an image, watched, and taken back whenever that program saves it.
#pragma once

#include "app/background/jobs.h"
#include "app/session.h"

#include <QFileSystemWatcher>
#include <QObject>
#include <QTemporaryDir>
#include <QTimer>

#include <map>
#include <memory>

namespace hairpaint::app {

/// Each time the program saves, the layer becomes what the image holds: one undo step. Several layers may be away at
/// once; the images go when this does. GUI thread.
class OutsideEdit : public QObject
{
    Q_OBJECT
public:
    OutsideEdit(Session& session, Jobs& jobs);

    /// Writes the active layer as a PNG image of 16 bits, its coverage as alpha, and has the system open it.
    void begin();

Q_SIGNALS:
    void told(const QString& message); ///< For the status bar.
    void failed(const QString& message);

private:
    /// A layer that is away.
    struct Away
    {
        model::LayerAddress layer;
        QByteArray bytes; ///< Of the file, as last written or read.
    };

    void look();
    void takeBack(const QString& path, const model::LayerAddress& layer);
    void replaceLayer(const model::LayerAddress& address, sim::TiledRaster raster);

    Session& m_session;
    Jobs& m_jobs;
    std::unique_ptr<QTemporaryDir> m_folder; ///< From the first layer on.
    QFileSystemWatcher m_watcher;
    QTimer m_quiet;                 ///< Programs write in several steps: it is looked at once they are done.
    std::map<QString, Away> m_away; ///< By path.
    int m_number = 0;
};

} // namespace hairpaint::app
