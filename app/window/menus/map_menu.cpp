// The Map menu: see the header.
#include "app/window/menus/map_menu.h"

#include "app/window/physical_keys.h"
#include "model/document/layer_commands.h"

#include <QMessageBox>

namespace hairpaint::app {

MapMenu::MapMenu(const QString& title, ActionSet& actions, Session& session, view::LayersPanel& layers, Jobs& jobs,
                 QWidget* parent)
    : QMenu(title, parent), m_session(session), m_jobs(jobs)
{
    addMaps(actions);
    addSeparator();
    addLayers(actions, layers);
    addSeparator();
    addSizes(*addMenu(tr("Map &size")));
}

void MapMenu::addMaps(ActionSet& actions)
{
    view::EditorState& editor = m_session.editor();
    for (const model::MapSpec& spec : model::mapSpecs()) {
        const QByteArray id = QByteArray("map.") + spec.id;
        const PhysicalKey digit = digitKey(static_cast<int>(spec.kind) + 1);
        actions.add(
            *this, {{.id = id,
                     .text = spec.titleText(),
                     .keys = digit == PhysicalKey::Other ? QList<QKeySequence>() : QList<QKeySequence>{usualKey(digit)},
                     .run = [&editor, kind = spec.kind] { editor.target().setMap(kind); },
                     .on = [&editor, kind = spec.kind] { return editor.target().map() == kind; }}});
    }
}

void MapMenu::addLayers(ActionSet& actions, view::LayersPanel& layers)
{
    actions.add(
        *this, {{"map.addLayer",
                 tr("&Add layer"),
                 {Qt::CTRL | Qt::SHIFT | Qt::Key_N},
                 [&layers] { layers.addLayer(); },
                 "add"},
                {"map.removeLayer", tr("&Remove layer"), {}, [&layers] { layers.removeLayer(); }, "remove"},
                {"map.layerUp", tr("Layer &up"), {Qt::CTRL | Qt::Key_PageUp}, [&layers] { layers.moveLayer(1); }, "up"},
                {"map.layerDown",
                 tr("Layer &down"),
                 {Qt::CTRL | Qt::Key_PageDown},
                 [&layers] { layers.moveLayer(-1); },
                 "down"}});
}

void MapMenu::addSizes(QMenu& menu)
{
    menu.setObjectName(QStringLiteral("mapSizeMenu"));
    for (int size = sim::TiledRaster::kSmallestSize; size <= sim::TiledRaster::kLargestSize; size *= 2) {
        QAction* action = menu.addAction(tr("%1 × %1").arg(size), this, [this, size] { resizeMap(size); });
        action->setCheckable(true);
        action->setData(size);
    }
    connect(&menu, &QMenu::aboutToShow, &menu, [this, &menu] { tickSize(menu); });
}

void MapMenu::tickSize(const QMenu& menu) const
{
    const view::EditorState& editor = m_session.editor();
    const model::HairGroup* group = m_session.document().project().group(editor.target().group());
    for (QAction* action : menu.actions()) {
        action->setEnabled(group != nullptr);
        action->setChecked(group != nullptr && group->map(editor.target().map()).size == action->data().toInt());
    }
}

void MapMenu::resizeMap(int size)
{
    model::Document& document = m_session.document();
    document.endEdit();
    const model::LayerAddress target = m_session.editor().target().address();
    const auto run = [this](const QString& doing, const auto& work) {
        const auto done = m_jobs.await<bool>({.text = doing, .whenCancelled = tr("The map keeps its size: cancelled")},
                                             [&work](const model::Progress& progress) {
                                                 work(progress);
                                                 return model::Result<bool>(true);
                                             });
        if (done && !*done)
            QMessageBox::warning(parentWidget()->window(), tr("Hair Paint"), done->error().message);
        return done && *done;
    };
    document.push(model::resizeMapCommand(document, target.group, target.map, size, run));
}

} // namespace hairpaint::app
