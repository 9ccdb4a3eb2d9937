// Edits a layer in another program: writes it as an image, watches that, and reads it whenever that program saves it.
#pragma once

#include "app/exchange/file_work.h"
#include "app/project/file_watch.h"
#include "app/session/session.h"

#include <QObject>
#include <QTemporaryDir>

#include <map>
#include <memory>
#include <optional>

namespace hairpaint::app {

/// Each time the other program saves, the layer becomes what the image holds: one undo step. Several layers may be
/// edited outside at once, until another project is opened; the images are removed with this object. GUI thread.
class OutsideEdit : public QObject
{
    Q_OBJECT
public:
    OutsideEdit(Session& session, FileWork& files);

    /// Writes the active layer as a PNG image of 16 bits, its coverage as alpha, and has the system open it.
    void begin();

private:
    /// A layer that another program edits.
    struct Away
    {
        std::optional<model::LayerAddress> layer; ///< None once its project is no longer open.
        QByteArray bytes;                         ///< The file's content as last written or read.
        std::unique_ptr<FileWatch> watch;
    };

    void look(const QString& path);
    void takeBack(const QString& path, model::LayerAddress layer);
    void replaceLayer(const model::LayerAddress& address, sim::TiledRaster raster);

    Session& m_session;
    FileWork& m_files;
    std::unique_ptr<QTemporaryDir> m_folder; ///< Made for the first layer.
    std::map<QString, Away> m_away;          ///< By path.
    int m_number = 0;
    bool m_isTaking = false; ///< Whether an image is being read back; others wait.
};

} // namespace hairpaint::app
