// The comb: lays hair along the pointer's path over the skin, lifts it, smooths it, ruffles it, lays a whorl, or holds
// it.
#include "model/maps/compositor.h"
#include "model/tools/combing/hold.h"
#include "model/tools/combing/hold_stroke.h"
#include "model/tools/combing/whorl.h"
#include "model/tools/live_edit.h"
#include "model/tools/lying/comb_field.h"
#include "model/tools/lying/evened_hair.h"
#include "model/tools/lying/fallen_hair.h"
#include "model/tools/lying/restyled_hair.h"
#include "model/tools/picker_tool.h"
#include "model/tools/skin_stroke.h"
#include "model/tools/tool_list.h"
#include "sim/groom/direction_texel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace hairpaint::model {

namespace {

constexpr std::array kCombKinds{
    ToolChoice::Item{.icon = "comb", .title = QT_TRANSLATE_NOOP("ToolOptions", "Comb along the stroke")},
    ToolChoice::Item{.icon = "comb-lift",
                     .title = QT_TRANSLATE_NOOP("ToolOptions", "Lift or lay, the way hair lies"),
                     .step = QT_TRANSLATE_NOOP("Tool", "Lift hair"),
                     .hint = QT_TRANSLATE_NOOP(
                         "Tool", "Drag over hair to lift it, with a Lift below zero to lay it; its direction stays")},
    ToolChoice::Item{.icon = "comb-smooth",
                     .title = QT_TRANSLATE_NOOP("ToolOptions", "Smooth"),
                     .step = QT_TRANSLATE_NOOP("Tool", "Comb hair smooth"),
                     .hint = QT_TRANSLATE_NOOP("Tool", "Drag over hair to lay it as its neighbours lie")},
    ToolChoice::Item{.icon = "comb-noise",
                     .title = QT_TRANSLATE_NOOP("ToolOptions", "Ruffle"),
                     .step = QT_TRANSLATE_NOOP("Tool", "Ruffle hair"),
                     .hint = QT_TRANSLATE_NOOP("Tool", "Drag over hair to ruffle it")},
    ToolChoice::Item{.icon = "comb-whorl",
                     .title = QT_TRANSLATE_NOOP("ToolOptions", "Whorl: a spiral around the pointer"),
                     .step = QT_TRANSLATE_NOOP("Tool", "Lay a whorl"),
                     .hint = QT_TRANSLATE_NOOP(
                         "Tool", "Press where hair is to turn in a whorl as large as the ring; drag to move it")},
    ToolChoice::Item{
        .icon = "comb-hold",
        .title = QT_TRANSLATE_NOOP("ToolOptions", "Hold as it lies now, with gel"),
        .step = kHoldStep,
        .hint = QT_TRANSLATE_NOOP("Tool", "Drag over hair to hold it as it lies now, with at least that much gel")},
};
constexpr ToolOption kCombKind{
    .key = "comb",
    .kind =
        ToolChoice{.entries = kCombKinds,
                   .read = [](const ToolSettings& settings) { return static_cast<int>(settings.comb); },
                   .write = [](ToolSettings& settings, int index) { settings.comb = static_cast<CombKind>(index); }}};
constexpr ToolOption kCombFlatness{
    .key = "flatness",
    .label = kFlatnessLabel,
    .hint = kFlatnessHint,
    .kind = kFlatness,
    .isShown =
        [](const ToolSettings& settings) { return settings.comb != CombKind::Hold && settings.comb != CombKind::Lift; },
    .isUsed =
        [](const ToolSettings& settings) {
            return settings.comb != CombKind::Smooth && settings.comb != CombKind::Noise;
        }};
constexpr ToolOption kLift{
    .key = "lift",
    .label = QT_TRANSLATE_NOOP("ToolOptions", "Lift"),
    .hint =
        QT_TRANSLATE_NOOP("ToolOptions", "How far hair is raised from where it lies; below zero it is laid flatter"),
    .kind = ToolNumber{.field = &ToolSettings::lift, .least = -100.0, .standard = 50.0},
    .isShown = [](const ToolSettings& settings) { return settings.comb == CombKind::Lift; }};
constexpr ToolOption kHoldGel{.key = "hold_gel",
                              .label = QT_TRANSLATE_NOOP("ToolOptions", "Gel at least"),
                              .hint = QT_TRANSLATE_NOOP("ToolOptions", "The gel that keeps held hair as it lies"),
                              .kind = ToolNumber{.field = &ToolSettings::holdGel, .standard = 50.0},
                              .isShown = [](const ToolSettings& settings) { return settings.comb == CombKind::Hold; }};
constexpr std::array kCombOptions{&kCombKind,     &kSizeOption, &kHardnessOption, &kOpacityOption,
                                  &kCombFlatness, &kLift,       &kHoldGel,        &kTouchOption};

constexpr float kJumpM = 0.03F; ///< Points further apart than this, and than the dabs, are no motion.
/// Hair that is combed further than so many times its standing length from its root turns the less there: the rest
/// hangs, and a root that is turned to the side would send all of it to the other side of the head.
constexpr float kTurnsOfStanding = 2.0F;
const glm::vec3 kAcross(-1.0F, 1.0F, 1.0F); ///< Reflects Hd.

constexpr ToolTraits kComb{
    .id = ToolId::Comb,
    .name = "comb",
    .title = QT_TRANSLATE_NOOP("Tool", "Comb"),
    .purpose = QT_TRANSLATE_NOOP("Tool", "Lays, lifts, smooths or swirls hair where it is drawn along."),
    .hint = QT_TRANSLATE_NOOP("Tool",
                              "Drag to lay hair along the stroke; Shift+click for a straight line from the last point"),
    .key = Qt::Key_C,
    .options = kCombOptions,
    .hasRing = true,
    .map = MapKind::Direction,
    .alsoPaints =
        [](const ToolSettings& settings) {
            return settings.comb == CombKind::Hold ? std::optional(MapKind::Gel) : std::nullopt;
        },
    .demo = &kCombDemo,
    .worksOnHair = [](const ToolSettings& settings) { return settings.comb != CombKind::Whorl; }};

class CombTool : public Tool
{
public:
    [[nodiscard]] const ToolTraits& traits() const override { return kComb; }

    void press(const ToolEvent& event, ToolContext& context) override;
    void move(const ToolEvent& event, ToolContext& context) override
    {
        if (!active())
            return;
        if (m_hold.active())
            m_hold.moveTo(event, context);
        else if (context.settings.comb == CombKind::Whorl)
            stamp(event, context);
        else
            combTo(event, context);
    }
    void release(const ToolEvent& event, ToolContext& context) override;
    void cancel(ToolContext& /*context*/) override
    {
        m_hold.cancel();
        m_edit.cancel();
        drop();
    }
    void commit(ToolContext& /*context*/) override
    {
        m_hold.commit();
        m_edit.commit();
        drop();
    }
    [[nodiscard]] bool active() const override { return m_edit.active() || m_hold.active(); }

private:
    void combTo(const ToolEvent& event, ToolContext& context);
    void stamp(const ToolEvent& event, const ToolContext& context);
    void layWhorl(const Whorl& whorl, const ToolSettings& settings);
    void follow(const BrushSample& sample, const ToolContext& context);
    void combHair(const ToolEvent& event, const ToolContext& context);
    void dab(const BrushSample& sample, const ToolContext& context);
    void lay(const Dab& dab, glm::vec3 strokeHd, const sim::SkinFrame& centre, const ToolSettings& settings,
             float pressure);
    void setReach(const Dab& dab);
    [[nodiscard]] glm::vec2 along(glm::vec2 uv, glm::vec3 strokeHd, const sim::SkinFrame& centre);
    [[nodiscard]] glm::vec2 uvOf(int x, int y) const;
    [[nodiscard]] sim::RasterTilePtr painted(int tile, const sim::RasterTilePtr& before);
    void drop();

    LiveEdit m_edit;
    HoldStroke m_hold; ///< Runs instead of it.
    std::optional<StrokeBuffer> m_masks;
    std::optional<CombField> m_field;
    SkinStroke m_stroke;
    std::optional<OverHair> m_overHair;    ///< Where the stroke was over hair last.
    std::optional<FallenHair> m_before;    ///< How hair lay when the stroke began.
    std::optional<ToolEvent> m_last;       ///< Where the next straight line starts; kept between strokes.
    std::optional<BrushSample> m_previous; ///< The last point that lay on the skin.
    bool m_waits = false;                  ///< That point has no dab yet: its direction is not known.
    glm::vec2 m_reachUv{0.0F}; ///< The distance of the neighbours that the present dab evens out; see eveningReachUv().
    std::uint16_t m_opacity = 65535;
};

void CombTool::press(const ToolEvent& event, ToolContext& context)
{
    if (picksInstead(event, context))
        return;
    const Head* head = SkinStroke::headFor(context);
    if (head == nullptr || active())
        return;
    if (context.settings.comb == CombKind::Hold) {
        if (m_hold.begin(context, stepFor(context.settings)))
            m_hold.moveTo(event, context);
        return;
    }
    if (!m_edit.begin(context, title()))
        return;
    m_edit.setText(stepFor(context.settings));
    m_stroke.look(*head);
    m_before.emplace(context, *m_stroke.frames, m_edit.size());
    m_masks.emplace(m_edit.size());
    m_field.emplace(m_edit.size());
    m_stroke.begin(*head, context, m_edit.size());
    m_overHair.reset();
    m_opacity = unit16(context.settings.opacity);
    m_previous.reset();
    m_waits = false;
    if (context.settings.comb == CombKind::Whorl)
        return stamp(event, context);
    if (event.modifiers.testFlag(Qt::ShiftModifier) && m_last && m_last->point) {
        m_last->pressure = event.pressure;
        m_stroke.path->standAt(*m_last);
        m_previous = BrushSample{.uv = m_last->point->uv,
                                 .point = m_last->point,
                                 .metric = SkinMetric::at(*m_last->point),
                                 .pressure = event.pressure};
    }
    combTo(event, context);
}

void CombTool::release(const ToolEvent& event, ToolContext& context)
{
    if (!active())
        return;
    if (m_hold.active() || context.settings.comb == CombKind::Whorl)
        return commit(context);
    // A pen's last event has no pressure left; it still says where the stroke ends.
    ToolEvent end = event;
    if (m_last && !event.hair)
        end.pressure = m_last->pressure;
    combTo(end, context);
    commit(context);
}

void CombTool::drop()
{
    m_masks.reset();
    m_field.reset();
    m_stroke.end();
    m_before.reset();
}

void CombTool::combTo(const ToolEvent& event, ToolContext& context)
{
    if (event.hair) {
        m_stroke.path->lift();
        m_previous.reset();
        combHair(event, context);
    } else {
        m_stroke.roots->lift();
        m_overHair.reset();
        m_stroke.path->moveTo(event, [&](const BrushSample& sample) { follow(sample, context); });
        if (event.area == Area::Paint || event.point)
            m_last = event;
    }
    m_edit.update(m_masks->takeDirty(),
                  [this](int index, const sim::RasterTilePtr& tile) { return painted(index, tile); });
}

/// The whorl where the pointer is, and only there; off the skin where it was last.
void CombTool::stamp(const ToolEvent& event, const ToolContext& context)
{
    if (!event.point)
        return;
    const ToolSettings& settings = context.settings;
    m_masks.emplace(m_edit.size());
    m_field.emplace(m_edit.size());
    const Whorl whorl{.centre = *event.point, .radiusM = 0.5F * settings.brushSizeM, .flatness = settings.flatness};
    layWhorl(whorl, settings);
    // A whorl near the middle of the head is one.
    if (context.mirror)
        if (const auto other = context.document.project().head->skin->mirrored(*event.point);
            other && glm::distance(other->positionHd, event.point->positionHd) > whorl.radiusM)
            layWhorl({.centre = *other, .radiusM = whorl.radiusM, .flatness = whorl.flatness, .clockwise = false},
                     settings);
    m_edit.replace(m_masks->takeDirty(),
                   [this](int index, const sim::RasterTilePtr& tile) { return painted(index, tile); });
}

void CombTool::layWhorl(const Whorl& whorl, const ToolSettings& settings)
{
    const int size = m_edit.size();
    Dab dab = dabAt(SkinMetric::at(whorl.centre), whorl.centre.uv, whorl.radiusM, size);
    dab.hardness = settings.hardness;
    for (const sim::TexelRect& clip : m_edit.clips())
        m_masks->add(dab, clip);
    const sim::SkinFrame centre = sim::SkinFrame::at(whorl.centre);
    m_field->add(dab, [&](int x, int y) -> std::optional<glm::vec2> {
        const glm::vec2 uv = uvOf(x, y);
        const glm::vec3 directionHd = whorl.directionHd(uv - whorl.centre.uv);
        const float length = glm::length(directionHd);
        return length > 0.0F ? along(uv, directionHd / length, centre) * length : glm::vec2(0.0F);
    });
}

/// The centre of a texel.
glm::vec2 CombTool::uvOf(int x, int y) const
{
    const auto size = static_cast<float>(m_edit.size());
    return {(static_cast<float>(x) + 0.5F) / size, 1.0F - (static_cast<float>(y) + 0.5F) / size};
}

/// The first point waits until the second tells the stroke's direction.
void CombTool::follow(const BrushSample& sample, const ToolContext& context)
{
    if (!sample.point)
        return m_previous.reset();
    const ToolSettings& settings = context.settings;
    if (settings.comb != CombKind::Lay) {
        dab(sample, context);
        return;
    }
    const glm::vec3 motionHd = m_previous ? sample.point->positionHd - m_previous->point->positionHd : glm::vec3(0.0F);
    const float moved = glm::length(motionHd);
    if (!m_previous || moved > std::max(kJumpM, settings.brushSizeM)) {
        m_previous = sample;
        m_stroke.heading.reset();
        m_waits = true;
        return;
    }
    if (!m_stroke.heading.turn(motionHd, settings.brushSizeM))
        return;
    if (std::exchange(m_waits, false))
        dab(*m_previous, context);
    m_previous = sample;
    dab(sample, context);
}

/// Strands that the pointer passes lie along its path from their roots on.
void CombTool::combHair(const ToolEvent& event, const ToolContext& context)
{
    const ToolSettings& settings = context.settings;
    const std::optional<OverHair> last = std::exchange(m_overHair, event.hair);
    if (settings.comb == CombKind::Lay) {
        if (!last) {
            m_stroke.heading.reset();
            return m_stroke.roots->standAt(*event.hair);
        }
        if (!m_stroke.heading.turn(event.hair->positionHd - last->positionHd, settings.brushSizeM))
            return;
    }
    const RootDabs::Shape shape{.sizeM = settings.brushSizeM, .hardness = settings.hardness, .twinRoots = true};
    const glm::vec3 strokeHd = m_stroke.heading.orNone();
    const HairGroup* group = context.document.project().group(context.target.group);
    const float turnsM = group != nullptr ? kTurnsOfStanding * group->settings.physics.stiffnessM : kJumpM;
    for (RootDab& one : m_stroke.roots->moveTo(*event.hair, context, shape, settings.comb != CombKind::Lay)) {
        if (settings.comb == CombKind::Lay) {
            const float turned =
                std::min(turnsM / std::max(glm::distance(one.seenHd, one.root.positionHd), 1e-6F), 1.0F);
            one.dab.strength *= turned * turned;
            if (one.twin)
                one.twin->strength = one.dab.strength;
        }
        setReach(dabAt(SkinMetric::at(one.root), one.root.uv, 0.5F * settings.brushSizeM, m_edit.size()));
        lay(one.dab, strokeHd, sim::SkinFrame::at(one.root), settings, event.pressure);
        if (one.twin && one.twinRoot)
            lay(*one.twin, strokeHd * kAcross, sim::SkinFrame::at(*one.twinRoot), settings, event.pressure);
    }
}

void CombTool::dab(const BrushSample& sample, const ToolContext& context)
{
    const ToolSettings& settings = context.settings;
    const int size = m_edit.size();
    Dab dab = dabAt(sample.metric, sample.uv, 0.5F * settings.brushSizeM, size);
    dab.hardness = settings.hardness;
    setReach(dab);
    const glm::vec3 strokeHd = m_stroke.heading.orNone();
    lay(dab, strokeHd, sim::SkinFrame::at(*sample.point), settings, sample.pressure);
    if (!context.mirror)
        return;
    const Head& head = *context.document.project().head;
    const auto other = head.skin->mirrored(*sample.point);
    if (!other)
        return;
    Dab twin = head.builtIn ? mirroredInU(dab, size)
                            : dabAt(SkinMetric::at(*other), other->uv, 0.5F * settings.brushSizeM, size);
    twin.hardness = dab.hardness;
    setReach(twin);
    lay(twin, strokeHd * kAcross, sim::SkinFrame::at(*other), settings, sample.pressure);
}

void CombTool::lay(const Dab& dab, glm::vec3 strokeHd, const sim::SkinFrame& centre, const ToolSettings& settings,
                   float pressure)
{
    for (const sim::TexelRect& clip : m_edit.clips())
        m_masks->add(dab, clip);
    const float flatness = settings.flatness * std::clamp(pressure, 0.0F, 1.0F);
    m_field->add(dab, [&](int x, int y) -> std::optional<glm::vec2> {
        const glm::vec2 uv = uvOf(x, y);
        return settings.comb == CombKind::Lay ? along(uv, strokeHd, centre) * flatness
                                              : restyled(*m_before, *m_stroke.frames, uv, m_reachUv, settings);
    });
}

void CombTool::setReach(const Dab& dab)
{
    m_reachUv = eveningReachUv(dab, m_edit.size());
}

/// Unit, in the texel's frame. Off the skin, where hair never stands but values bleed in from, in the dab's.
glm::vec2 CombTool::along(glm::vec2 uv, glm::vec3 strokeHd, const sim::SkinFrame& centre)
{
    constexpr float kSteep = 0.1F;
    const sim::SkinFrame frame = m_stroke.frames->at(uv).value_or(centre);
    glm::vec2 direction = frame.fromHd(strokeHd);
    if (glm::length(direction) < kSteep)
        direction = centre.fromHd(strokeHd);
    const float length = glm::length(direction);
    return length > 0.0F ? direction / length : glm::vec2(0.0F);
}

sim::RasterTilePtr CombTool::painted(int tile, const sim::RasterTilePtr& before)
{
    const std::vector<std::uint16_t> values = m_field->values(tile);
    const StrokeBuffer::MaskTile& mask = *m_masks->mask(tile);
    m_before->look(tile);
    return paintTile(m_edit.spec(), m_before->under(tile, before, mask), mask,
                     {.values = values.data(), .opacity = m_opacity});
}

} // namespace

std::unique_ptr<Tool> makeCombTool()
{
    return std::make_unique<CombTool>();
}

} // namespace hairpaint::model
