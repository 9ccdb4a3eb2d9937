// From the file to the hair: see the header.
#include "app/opening_sign.h"

namespace hairpaint::app {

OpeningSign::OpeningSign(const ProjectFiles& files, const Session& session, view::HeadView& area) : QObject(&area)
{
    connect(&files, &ProjectFiles::openingBegan, this,
            [&area](const QString& doing) { area.showVeil(tr("%1…").arg(doing)); });
    connect(&files, &ProjectFiles::openingEnded, this, [&files, &area](bool isOpen) {
        area.showVeil(isOpen ? tr("Growing the hair of '%1'…").arg(files.displayName()) : QString());
    });
    const auto end = [&area] { area.showVeil({}); };
    connect(&area, &view::HeadView::ownHairShown, this, end);
    connect(&session, &Session::hairFailed, this, end);
}

} // namespace hairpaint::app
