// From the file to the hair: see the header.
#include "app/window/opening_sign.h"

#include "view/widgets/veil.h"

namespace hairpaint::app {

OpeningSign::OpeningSign(const ProjectFiles& files, const Session& session, view::HeadView& area) : QObject(&area)
{
    auto* veil = new view::Veil(&area);
    connect(&files, &ProjectFiles::openingBegan, this,
            [veil](const QString& doing) { veil->showText(tr("%1…").arg(doing)); });
    connect(&files, &ProjectFiles::openingEnded, this, [&files, veil](bool isOpen) {
        veil->showText(isOpen ? tr("Growing the hair of '%1'…").arg(files.displayName()) : QString());
    });
    const auto end = [veil] { veil->showText({}); };
    connect(&area, &view::HeadView::ownHairShown, this, end);
    connect(&session, &Session::hairFailed, this, end);
}

} // namespace hairpaint::app
