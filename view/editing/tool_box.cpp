// Tools, their settings and the running stroke.
#include "view/editing/tool_box.h"

#include "model/tools/tool_list.h"
#include "view/editing/edit_target.h"
#include "view/editing/view_options.h"
#include "view/look/value_text.h"

#include <algorithm>
#include <utility>

namespace hairpaint::view {

using model::MapKind;

ToolBox::ToolBox(EditTarget& target, const ViewOptions& options, QObject* parent)
    : QObject(parent), m_target(target), m_options(options), m_tools(model::makeTools()), m_settings(startSettings())
{
    m_active = m_previous = index(with(&model::ToolTraits::isFirst));
    if (const sim::GroupSettings* group = m_target.knownSettings())
        m_amounts.take(*group, m_settings);
    model::Document& document = target.document();
    connect(&document, &model::Document::refused, this, &ToolBox::refused);
    connect(&document, &model::Document::editSteppedBack, this, &ToolBox::overlayChanged);
    connect(&document, &model::Document::editEnded, this, &ToolBox::overlayChanged);
    connect(&document, &model::Document::changed, this, [this](const model::Change& change) {
        if (change.aspect == model::Change::Aspect::Everything)
            m_selection.setRectangle(std::nullopt);
    });
    connect(&target, &EditTarget::aboutToChange, this, &ToolBox::commitStroke);
    connect(&target, &EditTarget::mapChosen, this, [this] { m_mapBeforeTool.reset(); });
    connect(&target, &EditTarget::rangesChanged, this, &ToolBox::followAmounts);
    connect(&m_selection, &model::Selection::changed, this, &ToolBox::overlayChanged);
}

ToolBox::~ToolBox() = default;

std::size_t ToolBox::index(model::ToolId id) const
{
    const auto found = std::ranges::find_if(m_tools, [id](const auto& tool) { return tool->id() == id; });
    return static_cast<std::size_t>(found - m_tools.begin());
}

model::ToolId ToolBox::with(bool model::ToolTraits::*trait) const
{
    return (*std::ranges::find_if(m_tools, [trait](const auto& tool) { return tool->traits().*trait; }))->id();
}

bool ToolBox::choose(model::ToolId id)
{
    const std::size_t chosen = index(id);
    if (chosen == m_active)
        return false;
    commitStroke();
    m_previous = m_active;
    m_active = chosen;
    takeToolsMap();
    Q_EMIT activeChanged();
    Q_EMIT overlayChanged();
    return true;
}

void ToolBox::toggle(model::ToolId id)
{
    if (!choose(id))
        choose(m_tools[m_previous]->id());
}

void ToolBox::takeToolsMap()
{
    const std::optional<MapKind> before = m_mapBeforeTool;
    if (const std::optional<MapKind> map = active().map()) {
        const MapKind left = m_target.map();
        m_mapBeforeTool = m_target.setMap(*map) ? before.value_or(left) : before;
    } else if (before) {
        m_target.setMap(*before);
    }
}

bool ToolBox::layingHair() const
{
    return stroking() && active().map() == MapKind::Direction;
}

/// The Length brush is ready with 15 cm.
model::ToolSettings ToolBox::startSettings() const
{
    model::ToolSettings settings;
    const sim::GroupSettings* group = m_target.knownSettings();
    settings.value(MapKind::Length).scalar =
        std::clamp(0.15F / (group != nullptr ? group->greatestLengthM : 0.3F), 0.05F, 1.0F);
    return settings;
}

bool ToolBox::setSettings(const model::ToolSettings& settings)
{
    if (settings == m_settings)
        return false;
    const model::ToolSettings before = std::exchange(m_settings, settings);
    if (const sim::GroupSettings* group = m_target.knownSettings())
        m_amounts.takeChanges(*group, before, m_settings);
    Q_EMIT settingsChanged();
    if (!active().pending())
        return true;
    if (const QString reason = refusalOnOthers(); !reason.isEmpty())
        Q_EMIT refused(reason);
    withTool([](model::Tool& tool, model::ToolContext& toolContext) { tool.settingsChanged(toolContext); });
    return true;
}

void ToolBox::putBack(const HeldSettings& held)
{
    setSettings(held.settings);
    m_amounts = held.amounts;
    followAmounts(false); // The range may be another one by now.
}

void ToolBox::followAmounts(bool tell)
{
    const sim::GroupSettings* group = m_target.knownSettings();
    if (group == nullptr)
        return;
    const model::ToolSettings before = m_settings;
    const std::vector<MapKind> beyond = m_amounts.putOn(*group, m_settings);
    if (before == m_settings)
        return;
    Q_EMIT settingsChanged();
    if (tell && std::ranges::find(beyond, m_target.map()) != beyond.end()) {
        const model::MapSpec& spec = model::mapSpec(m_target.map());
        Q_EMIT told(tr("%1 is painted with %2 now: this group's range ends there.")
                        .arg(spec.titleText(), valueText(*group, spec, m_settings.value(m_target.map()))));
    }
}

template<typename Call>
void ToolBox::withTool(const Call& call)
{
    model::Tool& tool = active();
    const bool hadOverlay = !tool.overlay().empty() || !guides().empty();
    const model::ToolSettings before = m_settings;
    model::ToolContext toolContext = context();
    const bool held = m_target.hold(true);
    call(tool, toolContext);
    m_target.hold(held);
    if (before != m_settings) {
        if (const sim::GroupSettings* group = m_target.knownSettings())
            m_amounts.takeChanges(*group, before, m_settings);
        Q_EMIT settingsChanged();
    }
    if (hadOverlay || !tool.overlay().empty() || !guides().empty())
        Q_EMIT overlayChanged();
}

std::vector<model::OverlayShape> ToolBox::overlay() const
{
    std::vector<model::OverlayShape> shapes = active().overlay();
    for (QPolygonF& outline : m_selection.outlines())
        shapes.push_back({.uvOutline = std::move(outline), .closed = true, .marching = true});
    return shapes;
}

QString ToolBox::refusalOnOthers() const
{
    const std::optional<MapKind> map = active().alsoPaints(m_settings);
    return map && m_target.knownSettings() != nullptr ? m_target.refusalOfOther(*map) : QString();
}

QString ToolBox::refusalWithCtrl(model::Area area, Qt::KeyboardModifiers modifiers) const
{
    const std::optional<MapKind> map = active().paintsWithCtrl(area);
    const bool paints = map && modifiers.testFlag(Qt::ControlModifier) && m_target.knownSettings() != nullptr;
    return paints ? m_target.refusalOfOther(*map) : QString();
}

bool ToolBox::mayPaint(std::initializer_list<MapKind> maps)
{
    for (const MapKind map : maps)
        if (const QString reason = m_target.refusalOfOther(map); !reason.isEmpty()) {
            Q_EMIT refused(reason);
            return false;
        }
    return true;
}

bool ToolBox::mayStart(model::Area area, Qt::KeyboardModifiers modifiers)
{
    // With Ctrl every painting tool picks the value under the pointer.
    const bool picks = modifiers.testFlag(Qt::ControlModifier) && active().picksWithCtrl(area);
    const bool paints = !picks && active().traits().paints;
    if (active().map())
        takeToolsMap();
    // Somebody else's edit ends before it is asked what there is to paint on.
    if (paints && !stroking())
        m_target.document().endEdit();
    QString reason = paints || m_target.knownSettings() == nullptr ? m_target.refusal() : QString();
    if (reason.isEmpty() && paints)
        reason = refusalOnOthers();
    if (reason.isEmpty())
        reason = refusalWithCtrl(area, modifiers);
    if (!reason.isEmpty()) {
        Q_EMIT refused(reason);
        return false;
    }
    m_saidOfCtrl = false;
    m_strokeTarget = m_target.address();
    return true;
}

/// Once in a stroke, which goes on.
void ToolBox::tellOfCtrl(model::Area area, Qt::KeyboardModifiers modifiers)
{
    const QString reason = m_saidOfCtrl ? QString() : refusalWithCtrl(area, modifiers);
    if (reason.isEmpty())
        return;
    m_saidOfCtrl = true;
    Q_EMIT refused(reason);
}

void ToolBox::press(const model::ToolEvent& event)
{
    if (active().pictureHandler() != nullptr && !event.modifiers.testFlag(Qt::ControlModifier)) {
        Q_EMIT refused(tr("%1: draw over the hair in the 3D area.").arg(active().title()));
        return;
    }
    if (mayStart(event.area, event.modifiers))
        withTool([&event](model::Tool& tool, model::ToolContext& toolContext) { tool.press(event, toolContext); });
}

void ToolBox::move(const model::ToolEvent& event)
{
    if (!stroking())
        return;
    tellOfCtrl(event.area, event.modifiers);
    withTool([&event](model::Tool& tool, model::ToolContext& toolContext) { tool.move(event, toolContext); });
}

void ToolBox::release(const model::ToolEvent& event)
{
    if (stroking())
        withTool([&event](model::Tool& tool, model::ToolContext& toolContext) { tool.release(event, toolContext); });
}

model::PictureLine ToolBox::pictureLine() const
{
    const model::PictureHandler* hand = active().pictureHandler();
    return hand != nullptr ? hand->pictureLine() : model::PictureLine();
}

std::vector<model::GuideStrand> ToolBox::guides() const
{
    const model::HairHandler* hand = active().hairHandler();
    return hand != nullptr ? hand->guides() : std::vector<model::GuideStrand>();
}

void ToolBox::press(const model::HairEvent& event)
{
    model::HairHandler* hand = active().hairHandler();
    if (hand != nullptr && mayStart(model::Area::Head, event.modifiers))
        withTool([&](model::Tool&, model::ToolContext& toolContext) { hand->pressHair(event, toolContext); });
}

void ToolBox::move(const model::HairEvent& event)
{
    model::HairHandler* hand = active().hairHandler();
    if (hand == nullptr || !stroking())
        return;
    tellOfCtrl(model::Area::Head, event.modifiers);
    withTool([&](model::Tool&, model::ToolContext& toolContext) { hand->moveHair(event, toolContext); });
}

void ToolBox::release(const model::HairEvent& event)
{
    model::HairHandler* hand = active().hairHandler();
    if (hand != nullptr && stroking())
        withTool([&](model::Tool&, model::ToolContext& toolContext) { hand->releaseHair(event, toolContext); });
}

void ToolBox::hover(const std::optional<model::GrabbedHair>& hair)
{
    model::HairHandler* hand = active().hairHandler();
    if (hand == nullptr || stroking())
        return;
    const bool showed = !guides().empty();
    m_strokeTarget = m_target.address();
    model::ToolContext toolContext = context();
    hand->hoverHair(hair, toolContext);
    if (showed || !guides().empty())
        Q_EMIT overlayChanged();
}

void ToolBox::press(const model::PictureEvent& event)
{
    model::PictureHandler* hand = active().pictureHandler();
    if (hand != nullptr && mayStart(model::Area::Head, event.modifiers))
        withTool([&](model::Tool&, model::ToolContext& toolContext) { hand->pressPicture(event, toolContext); });
}

void ToolBox::move(const model::PictureEvent& event)
{
    model::PictureHandler* hand = active().pictureHandler();
    if (hand == nullptr || !stroking())
        return;
    withTool([&](model::Tool&, model::ToolContext& toolContext) { hand->movePicture(event, toolContext); });
    Q_EMIT overlayChanged();
}

void ToolBox::release(const model::PictureEvent& event)
{
    model::PictureHandler* hand = active().pictureHandler();
    if (hand == nullptr || !stroking())
        return;
    withTool([&](model::Tool&, model::ToolContext& toolContext) { hand->releasePicture(event, toolContext); });
    Q_EMIT overlayChanged();
    if (const std::vector<model::CutPiece> pieces = hand->takeCutOff(); !pieces.empty())
        Q_EMIT hairCutOff(pieces);
}

void ToolBox::hover(const std::optional<model::ToolEvent>& event)
{
    if (active().pending())
        withTool([&event](model::Tool& tool, model::ToolContext& toolContext) {
            tool.hover(event.value_or(model::ToolEvent{.area = model::Area::Head}), toolContext);
        });
}

void ToolBox::cancelStroke()
{
    if (stroking())
        withTool([](model::Tool& tool, model::ToolContext& toolContext) { tool.cancel(toolContext); });
}

void ToolBox::commitStroke()
{
    if (stroking())
        withTool([](model::Tool& tool, model::ToolContext& toolContext) { tool.commit(toolContext); });
}

bool ToolBox::key(Qt::Key key, Qt::KeyboardModifiers modifiers)
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

model::ToolContext ToolBox::context()
{
    return {.document = m_target.document(),
            .target = m_strokeTarget,
            .settings = m_settings,
            .selection = m_selection,
            .mirror = m_options.mirror(),
            .activeLayer = [this](MapKind map) { return m_target.layer(map); },
            .hair = m_hair,
            .seen = m_seen};
}

} // namespace hairpaint::view
