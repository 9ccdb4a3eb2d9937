// Meshes of other programs, put on the head.
#pragma once

#include "app/exchange/file_work.h"
#include "app/session/session.h"
#include "view/head_area/head_view.h"

#include <QObject>
#include <QString>

namespace hairpaint::app {

/// GUI thread.
class WornExchange : public QObject
{
    Q_OBJECT
public:
    WornExchange(Session& session, FileWork& files);

    void putOn(view::HeadView& head); ///< Asks for the file.
    /// One undo step: the mesh where the brush was last on the head.
    void putOn(const QString& path, view::HeadView& head);

private:
    Session& m_session;
    FileWork& m_files;
};

} // namespace hairpaint::app
