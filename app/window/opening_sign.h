// While another project is being opened the 3D area says so, until that project's own hair is there.
#pragma once

#include "app/project/project_files.h"
#include "app/session/session.h"
#include "view/head_area/head_view.h"

#include <QObject>

namespace hairpaint::app {

/// Belongs to the area; the others outlive it. GUI thread.
class OpeningSign : public QObject
{
    Q_OBJECT
public:
    OpeningSign(const ProjectFiles& files, const Session& session, view::HeadView& area);
};

} // namespace hairpaint::app
