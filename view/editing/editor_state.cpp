// Targets, tools and the running stroke.
#include "view/editing/editor_state.h"

#include "model/values/names.h"
#include "view/look/value_text.h"

#include <algorithm>
#include <utility>

namespace hairpaint::view {

using model::Change;
using model::MapKind;

namespace {

/// The Length brush is ready with 15 cm.
model::ToolSettings startSettings(const model::Project& project)
{
    model::ToolSettings settings;
    const float greatest = project.groups.empty() ? 0.3F : project.groups.front().settings.greatestLengthM;
    settings.value(MapKind::Length).scalar = std::clamp(0.15F / greatest, 0.05F, 1.0F);
    return settings;
}

} // namespace

EditorState::EditorState(model::Document& document, QObject* parent)
    : QObject(parent), m_document(document), m_tools(model::makeTools()),
      m_toolSettings(startSettings(document.project()))
{
    if (!document.project().groups.empty())
        m_activeGroup = document.project().groups.front().id;
    if (const sim::GroupSettings* settings = knownSettings())
        m_amounts.take(*settings, m_toolSettings);
    connect(&document, &model::Document::changed, this, &EditorState::onDocumentChanged);
    connect(&document, &model::Document::refused, this, &EditorState::refused);
    connect(&document, &model::Document::editSteppedBack, this, &EditorState::overlayChanged);
    connect(&document, &model::Document::editEnded, this, &EditorState::overlayChanged);
    connect(&m_selection, &model::Selection::changed, this, &EditorState::overlayChanged);
}

EditorState::~EditorState() = default;

bool EditorState::setActiveGroup(model::Id group)
{
    if (group == m_activeGroup || m_document.project().group(group) == nullptr)
        return false;
    commitStroke();
    m_activeGroup = group;
    followAmounts(false);
    Q_EMIT targetChanged();
    return true;
}

bool EditorState::setActiveMap(MapKind map)
{
    m_mapBeforeTool.reset();
    if (map == m_activeMap)
        return false;
    commitStroke();
    m_activeMap = map;
    Q_EMIT targetChanged();
    return true;
}

model::Id EditorState::activeLayer(MapKind map) const
{
    const model::HairGroup* group = m_document.project().group(m_activeGroup);
    if (group == nullptr || group->map(map).layers.empty())
        return 0;
    for (const model::LayerAddress& address : m_activeLayers) {
        if (address.group == m_activeGroup && address.map == map &&
            m_document.project().layer(address.group, address.map, address.layer) != nullptr)
            return address.layer;
    }
    return group->map(map).layers.back().id;
}

bool EditorState::setActiveLayer(model::Id layer)
{
    if (layer == activeLayer() || m_document.project().layer(m_activeGroup, m_activeMap, layer) == nullptr)
        return false;
    commitStroke();
    std::erase_if(m_activeLayers, [this](const model::LayerAddress& address) {
        return address.group == m_activeGroup && address.map == m_activeMap;
    });
    m_activeLayers.push_back({.group = m_activeGroup, .map = m_activeMap, .layer = layer});
    Q_EMIT targetChanged();
    return true;
}

model::LayerAddress EditorState::target() const
{
    return {.group = m_activeGroup, .map = m_activeMap, .layer = activeLayer()};
}

std::size_t EditorState::toolIndex(model::ToolId id) const
{
    const auto found = std::ranges::find_if(m_tools, [id](const auto& tool) { return tool->id() == id; });
    return static_cast<std::size_t>(found - m_tools.begin());
}

bool EditorState::setActiveTool(model::ToolId id)
{
    const std::size_t index = toolIndex(id);
    if (index == m_activeTool)
        return false;
    commitStroke();
    m_previousTool = m_activeTool;
    m_activeTool = index;
    takeToolsMap();
    Q_EMIT activeToolChanged();
    Q_EMIT overlayChanged();
    return true;
}

void EditorState::takeToolsMap()
{
    const std::optional<MapKind> before = m_mapBeforeTool;
    if (const std::optional<MapKind> map = activeTool().map()) {
        const MapKind left = m_activeMap;
        m_mapBeforeTool = setActiveMap(*map) ? before.value_or(left) : before;
    } else if (before) {
        setActiveMap(*before);
    }
}

bool EditorState::layingHair() const
{
    return stroking() && activeTool().map() == MapKind::Direction;
}

void EditorState::toggleTool(model::ToolId id)
{
    if (!setActiveTool(id))
        setActiveTool(m_tools[m_previousTool]->id());
}

bool EditorState::setToolSettings(const model::ToolSettings& settings)
{
    if (settings == m_toolSettings)
        return false;
    const model::ToolSettings before = std::exchange(m_toolSettings, settings);
    if (const sim::GroupSettings* group = knownSettings())
        m_amounts.takeChanges(*group, before, m_toolSettings);
    Q_EMIT toolSettingsChanged();
    if (!activeTool().pending())
        return true;
    if (const QString reason = refusalOnOthers(); !reason.isEmpty())
        Q_EMIT refused(reason);
    withTool([](model::Tool& tool, model::ToolContext& toolContext) { tool.settingsChanged(toolContext); });
    return true;
}

const sim::GroupSettings* EditorState::knownSettings() const
{
    const model::HairGroup* group = m_document.project().group(m_activeGroup);
    return group != nullptr ? &group->settings : nullptr;
}

const sim::GroupSettings& EditorState::activeSettings() const
{
    static const sim::GroupSettings none;
    const sim::GroupSettings* known = knownSettings();
    return known != nullptr ? *known : none;
}

void EditorState::putBack(const HeldSettings& held)
{
    setToolSettings(held.settings);
    m_amounts = held.amounts;
    followAmounts(false); // The range may be another one by now.
}

void EditorState::followAmounts(bool tell)
{
    const sim::GroupSettings* settings = knownSettings();
    if (settings == nullptr)
        return;
    const model::ToolSettings before = m_toolSettings;
    const std::vector<MapKind> beyond = m_amounts.putOn(*settings, m_toolSettings);
    if (before == m_toolSettings)
        return;
    Q_EMIT toolSettingsChanged();
    if (tell && std::ranges::find(beyond, m_activeMap) != beyond.end()) {
        const model::MapSpec& spec = model::mapSpec(m_activeMap);
        Q_EMIT told(tr("%1 is painted with %2 now: this group's range ends there.")
                        .arg(spec.titleText(), valueText(*settings, spec, m_toolSettings.value(m_activeMap))));
    }
}

bool EditorState::setOption(bool& option, bool value)
{
    if (option == value)
        return false;
    option = value;
    Q_EMIT viewOptionsChanged();
    return true;
}

bool EditorState::setMirror(bool mirror)
{
    return setOption(m_mirror, mirror);
}

bool EditorState::setNightPaper(bool night)
{
    return setOption(m_nightPaper, night);
}

bool EditorState::setWireframe(bool shown)
{
    return setOption(m_wireframe, shown);
}

bool EditorState::setCollidersShown(bool shown)
{
    return setOption(m_collidersShown, shown);
}

model::Id EditorState::chosenWorn() const
{
    const model::Worn* worn = m_document.project().wornThing(m_chosenWorn);
    const bool seen = worn != nullptr && (m_collidersShown || wornSpec(worn->kind).drawn());
    return seen ? m_chosenWorn : 0;
}

bool EditorState::setChosenWorn(model::Id id)
{
    if (id == m_chosenWorn)
        return false;
    m_chosenWorn = id;
    Q_EMIT viewOptionsChanged();
    return true;
}

bool EditorState::setDirectionsShown(bool shown)
{
    return setOption(m_directionsShown, shown);
}

template<typename Call>
void EditorState::withTool(const Call& call)
{
    model::Tool& tool = activeTool();
    const bool hadOverlay = !tool.overlay().empty();
    const model::ToolSettings before = m_toolSettings;
    model::ToolContext toolContext = context();
    const bool worked = std::exchange(m_toolWorks, true);
    call(tool, toolContext);
    m_toolWorks = worked;
    if (before != m_toolSettings) {
        if (const sim::GroupSettings* group = knownSettings())
            m_amounts.takeChanges(*group, before, m_toolSettings);
        Q_EMIT toolSettingsChanged();
    }
    if (hadOverlay || !tool.overlay().empty())
        Q_EMIT overlayChanged();
}

std::vector<sim::SurfacePoint> EditorState::ringPoints() const
{
    if (!m_hover || !m_hover->point || !activeTool().traits().hasRing)
        return {};
    std::vector<sim::SurfacePoint> points{*m_hover->point};
    const std::shared_ptr<const model::Head>& head = m_document.project().head;
    if (m_mirror && head && head->skin) {
        if (const std::optional<sim::SurfacePoint> twin = head->skin->mirrored(*m_hover->point))
            points.push_back(*twin);
    }
    return points;
}

std::vector<model::OverlayShape> EditorState::overlay() const
{
    std::vector<model::OverlayShape> shapes = activeTool().overlay();
    for (QPolygonF& outline : m_selection.outlines())
        shapes.push_back({.uvOutline = std::move(outline), .closed = true, .marching = true});
    return shapes;
}

void EditorState::setHover(const std::optional<Hover>& hover)
{
    if (!hover && !m_hover)
        return;
    m_hover = hover;
    Q_EMIT hoverChanged();
    if (!activeTool().pending())
        return;
    model::ToolEvent event{.area = model::Area::Head};
    if (hover)
        event = {.area = hover->area, .uv = hover->uv, .point = hover->point, .pixelM = hover->pixelM};
    withTool([&event](model::Tool& tool, model::ToolContext& toolContext) { tool.hover(event, toolContext); });
}

QString EditorState::refusal(bool picks) const
{
    const model::HairGroup* group = m_document.project().group(m_activeGroup);
    if (group == nullptr)
        return tr("There is no hair group to paint on; add one in the Hair panel.");
    if (picks || !activeTool().traits().paints)
        return {};
    QString reason = refusalOn(*group, m_activeMap);
    return reason.isEmpty() ? refusalOnOthers() : reason;
}

QString EditorState::refusalOnOthers() const
{
    const model::HairGroup* group = m_document.project().group(m_activeGroup);
    const std::optional<MapKind> map = activeTool().alsoPaints(m_toolSettings);
    const QString reason = group != nullptr && map ? refusalOn(*group, *map) : QString();
    //: %1: a map's name; %2: a sentence that says why nothing can be painted on it.
    return reason.isEmpty() ? QString() : tr("%1: %2").arg(model::mapSpec(*map).titleText(), reason);
}

QString EditorState::refusalWithCtrl(const model::ToolEvent& event) const
{
    const model::HairGroup* group = m_document.project().group(m_activeGroup);
    const std::optional<MapKind> map = activeTool().paintsWithCtrl(event.area);
    if (group == nullptr || !map || !event.modifiers.testFlag(Qt::ControlModifier))
        return {};
    const QString reason = refusalOn(*group, *map);
    return reason.isEmpty() ? QString() : tr("%1: %2").arg(model::mapSpec(*map).titleText(), reason);
}

QString EditorState::refusalOn(const model::HairGroup& group, MapKind map) const
{
    const model::Layer* layer = m_document.project().layer(group.id, map, activeLayer(map));
    if (layer == nullptr)
        return tr("This map has no layer to paint on; add one in the Layers panel.");
    if (!group.visible)
        return tr("“%1” is hidden; show the group to paint on it.").arg(model::shownName(group.name));
    if (!layer->visible)
        return tr("“%1” is hidden; show the layer to paint on it.").arg(model::shownName(layer->name));
    if (layer->locked)
        return tr("“%1” is locked; unlock the layer to paint on it.").arg(model::shownName(layer->name));
    return {};
}

bool EditorState::mayPaint(std::initializer_list<MapKind> maps)
{
    const model::HairGroup* group = m_document.project().group(m_activeGroup);
    QString reason = group == nullptr ? refusal(false) : QString();
    for (const MapKind map : maps)
        if (group != nullptr && reason.isEmpty())
            if (const QString onMap = refusalOn(*group, map); !onMap.isEmpty())
                reason = tr("%1: %2").arg(model::mapSpec(map).titleText(), onMap);
    if (!reason.isEmpty())
        Q_EMIT refused(reason);
    return reason.isEmpty();
}

void EditorState::press(const model::ToolEvent& event)
{
    // With Ctrl every painting tool picks the value under the pointer.
    const bool picks = event.modifiers.testFlag(Qt::ControlModifier) && activeTool().picksWithCtrl(event.area);
    if (activeTool().map())
        takeToolsMap();
    // Somebody else's edit ends before it is asked what there is to paint on.
    if (!picks && activeTool().traits().paints && !stroking())
        m_document.endEdit();
    QString reason = refusal(picks);
    if (reason.isEmpty())
        reason = refusalWithCtrl(event);
    if (!reason.isEmpty()) {
        Q_EMIT refused(reason);
        return;
    }
    m_saidOfCtrl = false;
    m_strokeTarget = target();
    withTool([&event](model::Tool& tool, model::ToolContext& toolContext) { tool.press(event, toolContext); });
}

void EditorState::move(const model::ToolEvent& event)
{
    if (!stroking())
        return;
    if (const QString reason = m_saidOfCtrl ? QString() : refusalWithCtrl(event); !reason.isEmpty()) {
        m_saidOfCtrl = true;
        Q_EMIT refused(reason); // The rest of the drag goes on.
    }
    withTool([&event](model::Tool& tool, model::ToolContext& toolContext) { tool.move(event, toolContext); });
}

void EditorState::release(const model::ToolEvent& event)
{
    if (stroking())
        withTool([&event](model::Tool& tool, model::ToolContext& toolContext) { tool.release(event, toolContext); });
}

void EditorState::cancelStroke()
{
    if (stroking())
        withTool([](model::Tool& tool, model::ToolContext& toolContext) { tool.cancel(toolContext); });
}

void EditorState::commitStroke()
{
    if (stroking())
        withTool([](model::Tool& tool, model::ToolContext& toolContext) { tool.commit(toolContext); });
}

bool EditorState::toolKey(Qt::Key key, Qt::KeyboardModifiers modifiers)
{
    if (key == Qt::Key_Escape && stroking()) {
        cancelStroke();
        return true;
    }
    if ((key == Qt::Key_Return || key == Qt::Key_Enter) && stroking()) {
        commitStroke();
        return true;
    }
    bool used = false;
    withTool([&](model::Tool& tool, model::ToolContext& toolContext) { used = tool.key(key, modifiers, toolContext); });
    return used;
}

bool EditorState::stroking() const
{
    return activeTool().active();
}

void EditorState::onDocumentChanged(const Change& change)
{
    if (change.aspect == Change::Aspect::Texels && !change.preview && !m_toolWorks &&
        (change.group != m_activeGroup || change.map != m_activeMap)) {
        // What a tool paints is looked at already, so this is an undo or an import: show what changed.
        if (m_document.project().group(change.group) != nullptr) {
            m_activeGroup = change.group;
            m_activeMap = change.map;
            m_mapBeforeTool.reset();
            followAmounts(false);
            Q_EMIT targetChanged();
        }
        return;
    }
    if (change.aspect == Change::Aspect::Settings && change.group == m_activeGroup)
        followAmounts(!change.preview);
    const bool listsChanged = change.aspect == Change::Aspect::LayerList ||
                              change.aspect == Change::Aspect::GroupList || change.aspect == Change::Aspect::Everything;
    if (!listsChanged)
        return;
    const model::Project& project = m_document.project();
    if (project.group(m_activeGroup) == nullptr)
        m_activeGroup = project.groups.empty() ? 0 : project.groups.front().id;
    if (change.aspect == Change::Aspect::Everything) {
        m_activeLayers.clear();
        m_selection.setRectangle(std::nullopt);
    }
    if (change.aspect != Change::Aspect::LayerList)
        followAmounts(!change.preview);
    Q_EMIT targetChanged();
}

model::ToolContext EditorState::context()
{
    return {.document = m_document,
            .target = m_strokeTarget,
            .settings = m_toolSettings,
            .selection = m_selection,
            .mirror = m_mirror,
            .activeLayer = [this](MapKind map) { return activeLayer(map); },
            .hair = m_hair};
}

} // namespace hairpaint::view
