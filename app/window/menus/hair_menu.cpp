// The Hair menu: see the header.
#include "app/window/menus/hair_menu.h"

#include "app/window/menus/worn_order.h"
#include "model/document/scene_commands.h"

namespace hairpaint::app {

HairMenu::HairMenu(const QString& title, ActionSet& actions, Session& session, Workspace& workspace,
                   WindowDialogs& dialogs, Exchange& exchange, Jobs& jobs, QWidget* parent)
    : QMenu(title, parent), m_faceHair(session, jobs, *parent->window()), m_holdHair(session, exchange.hair(), jobs)
{
    view::HeadView& head = workspace.headView();
    view::Sidebar& sidebar = workspace.sidebar();
    sidebar.hair().setGrow([&jobs](const model::HairKind& kind, const std::shared_ptr<const model::Head>& head) {
        return growHair(jobs, kind, head);
    });
    addWeather(actions, session, head, dialogs);
    addSkin(actions, session);
    addSeparator();
    addSimulation(actions, session);
    addMotions(actions, session, head);
    addWorn(actions, session, head, dialogs, exchange);
    actions.add(*this, {{.id = "hair.hold",
                         .text = tr("Hol&d as it lies now"),
                         .keys = {Qt::SHIFT | Qt::Key_H},
                         .run = [this] { m_holdHair.hold(); },
                         .icon = "comb-hold"}});
    actions.find(QLatin1StringView("hair.hold"))
        ->setToolTip(tr("Paints directions and gel so that the active group's hair, inside the selection if there is "
                        "one, stays as it lies now"));
    actions.add(*this, {{"hair.scale", tr("Scal&e the hair…"), {}, [&dialogs] { dialogs.showScaleHair(); }}});
    actions.find(QLatin1StringView("hair.scale"))
        ->setToolTip(tr("Makes all hair of the active group longer, denser or more widely curled by a percentage; a "
                        "map's range alone changes no hair"));
    addCuts(actions, session, dialogs, exchange);
    addSeparator();
    actions.add(*this,
                {{"hair.addGroup", tr("&Add hair group…"), {}, [&sidebar] { sidebar.askWhatGrows(); }, "group-add"},
                 {.id = "hair.face",
                  .text = tr("&Brows and lashes"),
                  .run = [this] { m_faceHair.toggle(); },
                  .on = [this] { return m_faceHair.shown(); }},
                 {.id = "hair.removeGroup",
                  .text = tr("Remo&ve hair group"),
                  .run = [&sidebar] { sidebar.hair().removeGroup(); },
                  .enabled = [&session] { return session.document().committed().groups.size() > 1; }}});
    addSeparator();
    actions.add(
        *this,
        {{"hair.findStyle",
          tr("Fi&nd a style"),
          {QKeySequence::Find},
          [&workspace] { workspace.findStyle(); },
          "search"},
         {"hair.saveStyle", tr("&Save style…"), {}, [&exchange] { exchange.styles().save(); }},
         {"hair.importStyles", tr("Import st&yles…"), {}, [&exchange] { exchange.styles().importStyles(); }, "import"},
         {"hair.exportStyles",
          tr("E&xport my styles…"),
          {},
          [&exchange] { exchange.styles().exportOwn(); },
          "export"}});
}

void HairMenu::addWeather(ActionSet& actions, Session& session, view::HeadView& head, WindowDialogs& dialogs)
{
    const model::Document& document = session.document();
    actions.add(
        *this,
        {{.id = "hair.wind",
          .text = tr("&Wind blows"),
          .keys = {Qt::Key_W},
          .run = [&session] { session.toggleWind(); },
          .icon = "wind",
          .on = [&document] { return document.project().wind.enabled; }},
         {"hair.windDialog", tr("W&ind settings…"), {Qt::SHIFT | Qt::Key_W}, [&dialogs] { dialogs.showWind(); }},
         {"hair.lightDialog", tr("&Light…"), {Qt::SHIFT | Qt::Key_L}, [&dialogs] { dialogs.showLight(); }, "light"},
         {.id = "hair.weather",
          .text = tr("Wind and lig&ht by keys"),
          .keys = {Qt::Key_F7},
          .run = [&head] { head.setWeatherShown(!head.weatherShown()); },
          .icon = "weather",
          .on = [&head] { return head.weatherShown(); }}});
}

void HairMenu::addSkin(ActionSet& actions, Session& session)
{
    QMenu* menu = addMenu(tr("S&kin tone"));
    model::Document& document = session.document();
    for (const model::SkinLook& look : model::skinLooks()) {
        const QByteArray id = QByteArray("hair.skin.") + look.id;
        actions.add(*menu, {{.id = id,
                             .text = look.titleText(),
                             .run = [&document, tone = look.tone] { document.push(setSkinCommand(document, tone)); },
                             .on = [&document, tone = look.tone] { return document.project().skin == tone; },
                             .enabled =
                                 [&document, tone = look.tone] {
                                     const auto& head = document.project().head;
                                     return tone != model::SkinTone::Own || (head && head->texture);
                                 }}});
    }
}

void HairMenu::addSimulation(ActionSet& actions, Session& session)
{
    actions.add(*this, {{.id = "hair.pause",
                         .text = tr("&Pause"),
                         .keys = {Qt::Key_F8},
                         .run = [&session] { session.setPaused(!session.paused()); },
                         .icon = "pause",
                         .on = [&session] { return session.paused(); }},
                        {"hair.reset",
                         tr("&Reset the simulation"),
                         {Qt::SHIFT | Qt::Key_F8},
                         [&session] { session.resetHair(); },
                         "reset"}});
}

void HairMenu::addWorn(ActionSet& actions, Session& session, view::HeadView& head, WindowDialogs& dialogs,
                       Exchange& exchange)
{
    QMenu* menu = addMenu(tr("&Tie and put on"));
    menu->setToolTipsVisible(true);
    for (const model::WornSpec* offered : wornInMenus()) {
        if (offered == nullptr) {
            if (actions.find(QLatin1StringView("hair.repeatRows")) == nullptr)
                addRows(*menu, actions, dialogs); // After what ties hair.
            menu->addSeparator();
            continue;
        }
        const model::WornSpec& spec = *offered; // A row of a table that lasts.
        const QByteArray id = QByteArray("hair.add") + spec.action;
        actions.add(*menu, {{.id = id,
                             .text = model::wornText(spec.addTitle),
                             .run =
                                 [&head, &exchange, &spec] {
                                     if (spec.ownMesh)
                                         exchange.worn().putOn(head);
                                     else
                                         head.addWorn(spec.kind);
                                 },
                             .enabled =
                                 [&session, &spec] {
                                     const model::Project& project = session.document().project();
                                     return project.head && countOf(project.worn, spec.kind) < spec.limit;
                                 }}});
        actions.find(QLatin1StringView(id))->setToolTip(model::wornText(spec.addHint).arg(spec.limit));
        if (spec.tie != sim::TieForm::Tail)
            continue;
        actions.add(*menu, {{.id = "hair.addTwinTails",
                             .text = tr("T&win tails here"),
                             .run = [&head] { head.addTwinTails(); },
                             .enabled = [&session] { return session.document().project().head != nullptr; }}});
        actions.find(QLatin1StringView("hair.addTwinTails"))
            ->setToolTip(tr("Gathers the active group's hair into two tails, where the pointer was last on the head "
                            "and on the other side, with a parting between them"));
    }
    const auto chosen = [&session]() -> const model::Worn* {
        return session.document().project().wornThing(session.editor().options().chosenWorn());
    };
    actions.add(*this, {{.id = "hair.mirrorWorn",
                         .text = tr("&Copy what is chosen to the other side"),
                         .run = [&head] { head.mirrorWorn(); },
                         .enabled =
                             [chosen, &session] {
                                 const model::Worn* worn = chosen();
                                 return worn != nullptr && !worn->patch &&
                                        countOf(session.document().project().worn, worn->kind) <
                                            wornSpec(worn->kind).limit;
                             }}});
    actions.find(QLatin1StringView("hair.mirrorWorn"))
        ->setToolTip(tr("Puts one like it on the other side of the head; what is painted is painted there"));
    actions.add(*this, {{.id = "hair.removeWorn",
                         .text = tr("Take o&ff what is chosen"),
                         .run = [&head] { head.removeWorn(); },
                         .enabled = [chosen] { return chosen() != nullptr; },
                         .label =
                             [chosen] {
                                 const model::Worn* worn = chosen();
                                 return worn != nullptr ? model::wornText(wornSpec(worn->kind).removeTitle)
                                                        : tr("Take o&ff what is chosen");
                             }}});
}

void HairMenu::addRows(QMenu& menu, ActionSet& actions, WindowDialogs& dialogs)
{
    actions.add(menu,
                {{"hair.repeatRows", tr("Rep&eat between two rows…"), {}, [&dialogs] { dialogs.showRepeatRows(); }}});
    actions.find(QLatin1StringView("hair.repeatRows"))
        ->setToolTip(tr("Paints cornrows between the two that were painted last, or the two that reach into the "
                        "selection"));
}

void HairMenu::addCuts(ActionSet& actions, Session& session, WindowDialogs& dialogs, Exchange& exchange)
{
    QMenu* menu = addMenu(tr("C&ut"));
    menu->setToolTipsVisible(true);
    const auto cut = [&](const char* id, const QString& text, const QString& toolTip, view::HairCut kind) {
        const auto run = [&session, &dialogs, &exchange, kind] {
            view::ToolBox& tools = session.editor().tools();
            tools.commitStroke();
            if (!tools.mayPaint({model::MapKind::Length}))
                return;
            if (auto hair = exchange.hair().currentHair(tr("The hair is not cut: cancelled")))
                dialogs.showCut(kind, std::move(hair));
        };
        actions.add(*menu, {{.id = id, .text = text, .run = run, .icon = "scissors"}});
        actions.find(QLatin1StringView(id))->setToolTip(toolTip);
    };
    cut("hair.trim", tr("&Trim…"), tr("Makes all hair shorter by as much"), view::HairCut::Trim);
    cut("hair.cutToLevel", tr("To a &level…"),
        tr("Ends all hair at one height: ears, jaw, chin, shoulders or any other"), view::HairCut::Level);
    cut("hair.layers", tr("La&yers…"), tr("Cuts hair by its distance from the crown"), view::HairCut::Layers);
    cut("hair.fade", tr("&Fade…"), tr("Cuts hair shorter from the top down to the skin at the sides and the nape"),
        view::HairCut::Fade);
}

void HairMenu::addMotions(ActionSet& actions, Session& session, view::HeadView& head)
{
    QMenu* menu = addMenu(tr("&Move the head"));
    menu->setToolTipsVisible(true);
    const auto motion = [&](const char* id, const QString& text, const QString& toolTip, sim::NeckMotion motion) {
        actions.add(*menu, {{.id = id,
                             .text = text,
                             .run = [&head, motion] { head.moveHead(motion); },
                             .enabled = [&session] { return !session.paused(); }}});
        actions.find(QLatin1StringView(id))->setToolTip(toolTip);
    };
    motion("hair.nod", tr("&Nod"), tr("Twice down and up, so that the hair swings"), sim::NeckMotion::Nod);
    motion("hair.shake", tr("&Shake"), tr("Twice to both sides, so that the hair swings"), sim::NeckMotion::Shake);
    motion("hair.turn", tr("&Turn"), tr("Slowly to one side and the other, so that the hair swings"),
           sim::NeckMotion::Turn);
}

} // namespace hairpaint::app
