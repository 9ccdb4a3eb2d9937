// The user's own styles, as files of the library or from elsewhere.
#pragma once

#include "app/exchange/file_work.h"
#include "app/session/session.h"
#include "model/styles/preset.h"

#include <memory>

namespace hairpaint::app {

/// GUI thread.
class StyleFiles : public QObject
{
    Q_OBJECT
public:
    StyleFiles(Session& session, FileWork& files);

    void save();                         ///< The open project's hair; asks for the name.
    void rename(const QString& path);    ///< Asks for the name.
    void remove(const QString& path);    ///< To the trash, after a question.
    void applyFrom(const QString& path); ///< Emits wanted().

Q_SIGNALS:
    void changed(); ///< The library has changed.
    /// A style from elsewhere, on this head, is to be put on.
    void wanted(const std::shared_ptr<const hairpaint::model::Preset>& preset);

private:
    Session& m_session;
    FileWork& m_files;
};

} // namespace hairpaint::app
