// The user's own styles, as files of the library or from elsewhere.
#pragma once

#include "app/exchange/file_work.h"
#include "app/session/session.h"
#include "model/styles/preset.h"
#include "view/panels/style_menu.h"
#include "view/rendering/scene.h"

#include <QTemporaryDir>

#include <functional>
#include <memory>
#include <optional>

namespace hairpaint::app {

/// GUI thread.
class StyleFiles : public QObject
{
    Q_OBJECT
public:
    StyleFiles(Session& session, FileWork& files);

    void save(); ///< Saves the open project's hair as a style; asks for the name.
    void carryOut(const QString& path, view::StyleOrder order); ///< Asks for what is needed.
    void applyFrom(const QString& path);                        ///< Reads a style from elsewhere; emits wanted().
    void importStyles();                                        ///< Asks for files.
    void importStyles(const QStringList& paths);                ///< Broken ones are left out and reported.
    void exportOwn(); ///< Exports all of the user's own styles; asks for a folder.
    void undo();      ///< Takes back what undoOffered() announced last.
    /// `camera` gives the 3D area's.
    void setCamera(std::function<rendering::Camera()> camera) { m_camera = std::move(camera); }

Q_SIGNALS:
    void changed(); ///< The library has changed.
    void renamed(const QString& before, const QString& after);
    /// `sentence` tells what was done and undo() can take back; empty: there is nothing to take back any more.
    void undoOffered(const QString& sentence);
    /// A style from elsewhere, on this head, is to be put on.
    void wanted(const std::shared_ptr<const hairpaint::model::Preset>& preset);

private:
    /// A file as it was.
    struct Kept
    {
        QString path;
        QString at; ///< In the trash, or a copy in m_copies.
        bool isMoved = false;
    };
    void rename(const QString& path);
    void tag(const QString& path);
    void replace(const QString& path);
    void takePicture(const QString& path);
    void exportOne(const QString& path);
    void remove(const QString& path);
    /// Changes a style's file, so that undo() brings the old one back.
    void changeFile(const QString& path, const Doing& doing, const QString& sentence,
                    const std::function<void(model::Preset&, const model::Progress&)>& change);
    void offerUndo(const Kept& kept, const QString& sentence);

    Session& m_session;
    FileWork& m_files;
    std::function<rendering::Camera()> m_camera;
    QTemporaryDir m_copies;
    std::optional<Kept> m_kept;
};

} // namespace hairpaint::app
