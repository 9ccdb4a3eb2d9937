// The View menu: see the header.
#include "app/window/menus/view_menu.h"

#include "app/window/menus/pointed_area.h"
#include "view/head_area/head_view.h"
#include "view/paint_area/paint_view.h"

namespace hairpaint::app {

namespace {

/// Where the 3D area is looked at from; keys on the number pad as in Blender.
void addStandardViews(QMenu& menu, ActionSet& actions, view::HeadView& head)
{
    using rendering::StandardView;
    const auto side = [&head](const char* id, const QString& text, QKeyCombination key, StandardView view) {
        return ActionRow{.id = id, .text = text, .keys = {key}, .run = [&head, view] { head.setView(view); }};
    };
    constexpr Qt::KeyboardModifier kPad = Qt::KeypadModifier;
    constexpr Qt::KeyboardModifiers kOtherSide = Qt::ControlModifier | kPad;
    actions.add(
        menu,
        {side("look.front", ViewMenu::tr("&Front"), kPad | Qt::Key_1, StandardView::Front),
         side("look.back", ViewMenu::tr("&Back"), QKeyCombination(kOtherSide, Qt::Key_1), StandardView::Back),
         side("look.right", ViewMenu::tr("&Right"), kPad | Qt::Key_3, StandardView::Right),
         side("look.left", ViewMenu::tr("&Left"), QKeyCombination(kOtherSide, Qt::Key_3), StandardView::Left),
         side("look.top", ViewMenu::tr("&Top"), kPad | Qt::Key_7, StandardView::Top),
         side("look.bottom", ViewMenu::tr("B&elow"), QKeyCombination(kOtherSide, Qt::Key_7), StandardView::Bottom),
         side("look.threeQuarter", ViewMenu::tr("T&hree-quarter"), kPad | Qt::Key_5, StandardView::ThreeQuarter)});
}

} // namespace

ViewMenu::ViewMenu(const QString& title, ActionSet& actions, Workspace& workspace, view::EditorState& editor,
                   LivePreferences& preferences, Exchange& exchange, QWidget* parent)
    : QMenu(title, parent)
{
    addAreas(actions, workspace);
    addSeparator();
    addLook(actions, workspace, editor, exchange);
    addSeparator();
    addStandardViews(*addMenu(tr("&Look from")), actions, workspace.headView());
    addSeparator();
    addThemes(actions, preferences);
}

void ViewMenu::addAreas(ActionSet& actions, Workspace& workspace)
{
    using Areas = Workspace::Areas;
    const auto area = [&workspace](const char* id, const QString& text, Qt::Key key, Areas areas) {
        return ActionRow{.id = id,
                         .text = text,
                         .keys = {key},
                         .run = [&workspace, areas] { workspace.showAreas(areas); },
                         .on = [&workspace, areas] { return workspace.areas() == areas; }};
    };
    actions.add(*this, {area("view.both", tr("&Both areas"), Qt::Key_F1, Areas::Both),
                        area("view.head", tr("&3D area only"), Qt::Key_F2, Areas::Head),
                        area("view.paint", tr("&Paint area only"), Qt::Key_F3, Areas::Paint),
                        {"view.swap", tr("&Swap sides"), {Qt::Key_F4}, [&workspace] { workspace.swapAreas(); }, "swap"},
                        {.id = "view.panels",
                         .text = tr("&Hide panels"),
                         .keys = {Qt::Key_F11},
                         .run = [&workspace] { workspace.setPanelsHidden(!workspace.panelsHidden()); },
                         .on = [&workspace] { return workspace.panelsHidden(); }},
                        {.id = "view.nextArea",
                         .text = tr("&Next area"),
                         .keys = {Qt::Key_F6},
                         .run = [&workspace] { workspace.focusAreas().step(true); }},
                        {.id = "view.previousArea",
                         .text = tr("Pre&vious area"),
                         .keys = {Qt::SHIFT | Qt::Key_F6},
                         .run = [&workspace] { workspace.focusAreas().step(false); }}});
}

void ViewMenu::addLook(ActionSet& actions, Workspace& workspace, view::EditorState& editor, Exchange& exchange)
{
    view::HeadView& head = workspace.headView();
    view::PaintView& paint = workspace.paintView();
    const auto* pointed = new PointedArea(head, paint); // Belongs to the head's area.
    const auto underMouse = [&head, &paint, pointed](void (view::HeadView::*ofHead)(),
                                                     void (view::PaintView::*ofPaint)()) {
        return [&head, &paint, pointed, ofHead, ofPaint] { pointed->isHead() ? (head.*ofHead)() : (paint.*ofPaint)(); };
    };
    actions.add(
        *this,
        {{"view.fit", tr("&Fit"), {Qt::Key_F}, underMouse(&view::HeadView::fit, &view::PaintView::fit), "fit"},
         {"view.home",
          tr("&Reset view"),
          {Qt::Key_Home},
          underMouse(&view::HeadView::resetCamera, &view::PaintView::resetView),
          "home"},
         {"view.turnToBrush", tr("&Turn to the brush"), {Qt::Key_Period}, [&head] { head.turnToBrush(); }},
         {"view.mirror", tr("&Mirror the paint area"), {Qt::SHIFT | Qt::Key_M}, [&paint] { paint.mirrorView(); }},
         {.id = "view.wireframe",
          .text = tr("&Wireframe"),
          .run = [&editor] { editor.options().setWireframe(!editor.options().wireframe()); },
          .icon = "wireframe",
          .on = [&editor] { return editor.options().wireframe(); }},
         {.id = "view.colliders",
          .text = tr("Show &colliders"),
          .run = [&editor] { editor.options().setCollidersShown(!editor.options().collidersShown()); },
          .on = [&editor] { return editor.options().collidersShown(); }},
         {.id = "view.directions",
          .text = tr("Show d&irections"),
          .keys = {Qt::SHIFT | Qt::Key_D},
          .run = [&editor] { editor.options().setDirectionsShown(!editor.options().directionsShown()); },
          .icon = "direction",
          .on = [&editor] { return editor.options().directionsShown(); }},
         {.id = "view.cards",
          .text = tr("Hair &as cards"),
          .run = [&head, &exchange] { head.cardsShown() ? head.showCards(nullptr) : exchange.hair().previewCards(); },
          .on = [&head] { return head.cardsShown(); }},
         {.id = "view.night",
          .text = tr("Dar&k paper"),
          .run = [&editor] { editor.options().setNightPaper(!editor.options().nightPaper()); },
          .icon = "paper",
          .on = [&editor] { return editor.options().nightPaper(); }}});
}

void ViewMenu::addThemes(ActionSet& actions, LivePreferences& preferences)
{
    const auto theme = [&preferences](const char* id, const QString& text, view::ThemeKind kind) {
        return ActionRow{.id = id,
                         .text = text,
                         .run =
                             [&preferences, kind] {
                                 view::Preferences changed = preferences.current();
                                 changed.theme = kind;
                                 preferences.set(changed);
                             },
                         .on = [&preferences, kind] { return preferences.current().theme == kind; }};
    };
    actions.add(*this, {theme("view.dark", tr("&Dark theme"), view::ThemeKind::Dark),
                        theme("view.light", tr("Li&ght theme"), view::ThemeKind::Light)});
}

} // namespace hairpaint::app
