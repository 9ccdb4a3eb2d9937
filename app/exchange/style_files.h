// The user's own styles, as files of the library or from elsewhere.
#pragma once

#include "app/exchange/file_work.h"
#include "app/session.h"

namespace hairpaint::app {

/// GUI thread.
class StyleFiles : public QObject
{
    Q_OBJECT
public:
    StyleFiles(Session& session, FileWork& files);

    void save();                      ///< The open project's hair; asks for the name.
    void rename(const QString& path); ///< Asks for the name.
    void remove(const QString& path); ///< To the trash, after a question.
    void applyFrom(const QString& path);

Q_SIGNALS:
    void changed(); ///< The library.

private:
    Session& m_session;
    FileWork& m_files;
};

} // namespace hairpaint::app
