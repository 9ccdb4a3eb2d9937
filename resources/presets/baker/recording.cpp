// Plays a user's actions: see the header.
#include "recording.h"

#include "model/document/gather_command.h"
#include "model/document/group_commands.h"
#include "model/document/layer_commands.h"
#include "model/document/scene_commands.h"
#include "model/files/head_file.h"
#include "model/files/project_file.h"
#include "model/growth/face_hair.h"
#include "model/styles/hair_kinds.h"
#include "sim/base/rounded.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace hairpaint::presets {

namespace {

constexpr int kMapSize = 512;
constexpr float kMouseStepM = 0.004F;     ///< Distance of two events of a drag.
constexpr float kLevelStepDegrees = 7.5F; ///< Angle between points along a height.
constexpr float kOverStepM = 0.012F;      ///< Distance between points over the head.
constexpr float kHighM = 0.5F;            ///< Height above everything.
constexpr double kBetweenClicksSeconds = 2.0;

glm::vec3 between(glm::vec3 before, glm::vec3 from, glm::vec3 to, glm::vec3 after, float fraction)
{
    // Catmull and Rom's spline.
    const float t = fraction;
    return 0.5F * (2.0F * from + (to - before) * t + (2.0F * before - 5.0F * from + 4.0F * to - after) * (t * t) +
                   (3.0F * from - before - 3.0F * to + after) * (t * t * t));
}

} // namespace

PaintValue scalar(float value)
{
    PaintValue paint;
    paint.scalar = value;
    return paint;
}

PaintValue colour(QRgb value)
{
    PaintValue paint;
    paint.colour = QColor::fromRgb(value);
    return paint;
}

PaintValue entry(int index)
{
    PaintValue paint;
    paint.index = index;
    return paint;
}

PaintValue upright()
{
    PaintValue paint;
    paint.direction = glm::vec2(0.0F);
    return paint;
}

model::HairGroup grownHair(QLatin1StringView kind)
{
    const std::span<const model::HairKind> kinds = model::hairKinds();
    const auto found =
        std::ranges::find_if(kinds, [&](const auto& one) { return kind == QLatin1StringView(one.name); });
    return *model::grownHair(*found, model::defaultHead());
}

Recording::Recording(model::HairGroup grown, const sim::GroupSettings& settings) : m_document(model::newProject())
{
    m_settings.fillTolerance = 1.0F;
    m_settings.pressureSize = false;
    const model::Id bare = group().id;
    grown.settings = settings;
    push(addGroupCommand(m_document, std::move(grown)));
    push(removeGroupCommand(m_document, bare));
    for (const model::MapSpec& spec : model::mapSpecs())
        if (spec.kind != MapKind::Density) // Its partings are a millimetre wide.
            push(resizeMapCommand(m_document, group().id, spec.kind, kMapSize));
}

model::Preset Recording::preset(const QString& name) const
{
    model::Preset preset = model::presetFrom(m_document.committed(), name);
    preset.steps = m_steps;
    return preset;
}

sim::SurfacePoint Recording::around(float degrees, float heightM) const
{
    const float angle = degrees * std::numbers::pi_v<float> / 180.0F;
    const sim::Skin& skin = *m_document.project().head->skin;
    return *skin.pick({.originHd = {0.0F, heightM, kAxisForwardM},
                       .directionHd = {sim::sinRounded(angle), 0.0F, sim::cosRounded(angle)}});
}

Recording::Points Recording::along(std::span<const Seen> line) const
{
    Points points;
    points.reserve(line.size());
    for (const Seen& seen : line)
        points.push_back(around(seen.degrees, seen.heightM));
    return points;
}

sim::SurfacePoint Recording::above(float leftM, float forwardM) const
{
    const sim::Skin& skin = *m_document.project().head->skin;
    return *skin.pick({.originHd = {leftM, kHighM, forwardM}, .directionHd = {0.0F, -1.0F, 0.0F}});
}

sim::SurfacePoint Recording::outward(glm::vec3 fromHd, glm::vec3 directionHd) const
{
    return *m_document.project().head->skin->pick({.originHd = fromHd, .directionHd = glm::normalize(directionHd)});
}

Recording::Points Recording::level(float heightM, float fromDegrees, float toDegrees) const
{
    const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(toDegrees - fromDegrees) / kLevelStepDegrees)));
    Points points;
    points.reserve(static_cast<std::size_t>(steps) + 1);
    for (int i = 0; i <= steps; ++i)
        points.push_back(around(
            fromDegrees + (toDegrees - fromDegrees) * static_cast<float>(i) / static_cast<float>(steps), heightM));
    return points;
}

Recording::Points Recording::overHead(float leftM, float fromForwardM, float toForwardM) const
{
    const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(toForwardM - fromForwardM) / kOverStepM)));
    Points points;
    points.reserve(static_cast<std::size_t>(steps) + 1);
    for (int i = 0; i <= steps; ++i)
        points.push_back(above(leftM, fromForwardM + (toForwardM - fromForwardM) * static_cast<float>(i) /
                                                         static_cast<float>(steps)));
    return points;
}

PaintValue Recording::length(float lengthM) const
{
    return scalar(lengthM / group().settings.greatestLengthM);
}

void Recording::setLayerOpacity(MapKind map, float opacity)
{
    const model::Layer& layer = group().map(map).layers.back();
    model::LayerProperties properties = model::propertiesOf(layer);
    properties.opacity = opacity;
    push(setLayerPropertiesCommand(m_document, {.group = group().id, .map = map, .layer = layer.id}, properties,
                                   QStringLiteral("Opacity")));
}

void Recording::addLayer(MapKind map, model::BlendMode blend)
{
    push(addLayerCommand(m_document, group().id, map, QStringLiteral("Layer 2")));
    const model::Layer& layer = group().map(map).layers.back();
    model::LayerProperties properties = model::propertiesOf(layer);
    properties.blend = blend;
    push(setLayerPropertiesCommand(m_document, {.group = group().id, .map = map, .layer = layer.id}, properties,
                                   QStringLiteral("Blend mode")));
}

void Recording::fill(MapKind map, const PaintValue& value)
{
    m_settings.value(map) = value;
    m_settings.opacity = 1.0F;
    ++m_actions;
    tell(model::ToolId::Fill, map);
    click(model::ToolId::Fill, map, above(0.0F, 0.0F));
}

void Recording::brush(MapKind map, const PaintValue& value, const Ring& ring, const Points& points)
{
    use(ring);
    m_settings.value(map) = value;
    drag(model::ToolId::Brush, map, points);
}

void Recording::erase(MapKind map, const Ring& ring, const Points& points)
{
    use(ring);
    drag(model::ToolId::Eraser, map, points);
}

void Recording::bands(MapKind map, const std::vector<Band>& bands, float fromDegrees, float toDegrees)
{
    for (std::size_t i = 0; i < bands.size(); ++i) {
        const Points points = level(bands[i].heightM, fromDegrees, toDegrees);
        const Points next = level(bands[i + 1 < bands.size() ? i + 1 : i - 1].heightM, fromDegrees, toDegrees);
        std::vector<float> apartM(points.size());
        for (std::size_t point = 0; point < points.size(); ++point)
            apartM[point] = glm::distance(points[point].positionHd, next[point].positionHd);
        // Not the widest distance: beside an ear the band would be as wide as the ear stands off.
        std::ranges::sort(apartM);
        brush(map, bands[i].value, {.sizeM = 2.0F * apartM[apartM.size() * 3 / 4], .hardness = 0.0F}, points);
    }
}

void Recording::polygon(MapKind map, const PaintValue& value, const Points& outline)
{
    m_settings.value(map) = value;
    m_settings.opacity = 1.0F;
    m_settings.shape = model::ShapeKind::Polygon;
    drag(model::ToolId::Shape, map, outline);
}

void Recording::rectangle(MapKind map, const PaintValue& value, glm::vec2 fromUv, glm::vec2 toUv)
{
    m_settings.value(map) = value;
    m_settings.opacity = 1.0F;
    m_settings.shape = model::ShapeKind::Rectangle;
    ++m_actions;
    tell(model::ToolId::Shape, map);
    model::ToolContext now = context(map);
    model::Tool& shape = tool(model::ToolId::Shape);
    shape.press({.area = model::Area::Paint, .uv = fromUv}, now);
    shape.move({.area = model::Area::Paint, .uv = toUv}, now);
    shape.release({.area = model::Area::Paint, .uv = toUv}, now);
}

void Recording::comb(float flatness, const Ring& ring, const Points& points)
{
    use(ring);
    m_settings.flatness = flatness;
    drag(model::ToolId::Comb, MapKind::Direction, points);
}

void Recording::part(const Parting& parting, const Points& points)
{
    m_settings.partReachM = parting.reachM;
    m_settings.partGapM = parting.gapM;
    m_settings.flatness = parting.flatness;
    ++m_actions;
    tell(model::ToolId::Part, MapKind::Direction);
    for (const sim::SurfacePoint& point : points)
        click(model::ToolId::Part, MapKind::Direction, point);
    model::ToolContext now = context(MapKind::Direction);
    tool(model::ToolId::Part).commit(now);
}

void Recording::gather(model::WornKind kind, const sim::SurfacePoint& point)
{
    addStep(m_steps, {}, QLatin1StringView(model::wornSpec(kind).id));
    push(gatherCommand(m_document, group().id, model::wornSpec(kind), point, {}));
}

void Recording::wear(model::WornKind kind, const sim::SurfacePoint& point)
{
    addStep(m_steps, {}, QLatin1StringView(model::wornSpec(kind).id));
    push(addWornCommand(m_document, makeWorn(model::wornSpec(kind), point, group().id)));
}

void Recording::setWorn(model::WornKind kind, const std::function<void(model::Worn&)>& set)
{
    ++m_actions;
    model::EditSession session = m_document.begin({.text = model::wornText(model::wornSpec(kind).lookStep)});
    session.preview({.aspect = model::Change::Aspect::Environment}, [&](model::Project& project) {
        for (model::Worn& worn : project.worn)
            if (worn.kind == kind)
                set(worn);
    });
    session.commit();
}

const model::HairGroup& Recording::group() const
{
    return m_document.project().groups.front();
}

void Recording::push(model::CommandPtr command)
{
    ++m_actions;
    m_document.push(std::move(command));
}

void Recording::tell(model::ToolId id, MapKind map)
{
    addStep(m_steps, QLatin1StringView(tool(id).name()), QLatin1StringView(model::mapSpec(map).id));
}

model::ToolContext Recording::context(MapKind map)
{
    return {.document = m_document,
            .target = {.group = group().id, .map = map, .layer = group().map(map).layers.back().id},
            .settings = m_settings,
            .selection = m_selection,
            .mirror = m_mirror};
}

model::Tool& Recording::tool(model::ToolId id)
{
    return **std::ranges::find_if(m_tools, [id](const auto& one) { return one->id() == id; });
}

void Recording::use(const Ring& ring)
{
    m_settings.brushSizeM = ring.sizeM;
    m_settings.hardness = ring.hardness;
    m_settings.opacity = ring.opacity;
}

void Recording::click(model::ToolId id, MapKind map, const sim::SurfacePoint& point)
{
    model::ToolContext now = context(map);
    m_seconds += kBetweenClicksSeconds;
    tool(id).press(eventAt(point), now);
    tool(id).release(eventAt(point), now);
}

void Recording::drag(model::ToolId id, MapKind map, const Points& points)
{
    const sim::Skin& skin = *m_document.project().head->skin;
    model::ToolContext now = context(map);
    model::Tool& used = tool(id);
    ++m_actions;
    tell(id, map);
    m_seconds += kBetweenClicksSeconds;
    used.press(eventAt(points.front()), now);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const auto point = [&](std::size_t index) { return points[std::min(index, points.size() - 1)].positionHd; };
        const glm::vec3 from = point(i);
        const glm::vec3 to = point(i + 1);
        const auto steps = static_cast<int>(std::ceil(glm::distance(from, to) / kMouseStepM));
        for (int step = 1; step <= steps; ++step) {
            const float fraction = static_cast<float>(step) / static_cast<float>(steps);
            used.move(eventAt(skin.nearest(between(point(i > 0 ? i - 1 : 0), from, to, point(i + 2), fraction))), now);
        }
    }
    used.release(eventAt(points.back()), now);
}

model::ToolEvent Recording::eventAt(const sim::SurfacePoint& point) const
{
    return {.area = model::Area::Head, .uv = point.uv, .point = point, .seconds = m_seconds};
}

} // namespace hairpaint::presets
