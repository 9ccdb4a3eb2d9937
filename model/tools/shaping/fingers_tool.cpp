// Fingers: hair is puffed up, pinched together, spread out or smoothed where they go.
#include "model/tools/picker_tool.h"
#include "model/tools/shaping/finger_maps.h"
#include "model/tools/skin_stroke.h"
#include "model/tools/tool_list.h"

#include <algorithm>
#include <array>
#include <utility>

namespace hairpaint::model {

namespace {

constexpr std::array kFingerKinds{
    ToolChoice::Item{.icon = "finger-puff",
                     .title = QT_TRANSLATE_NOOP("ToolOptions", "Puff: lift hair off the skin"),
                     .step = QT_TRANSLATE_NOOP("Tool", "Puff hair")},
    ToolChoice::Item{.icon = "finger-pinch",
                     .title = QT_TRANSLATE_NOOP("ToolOptions", "Pinch: gather hair in a lock along the stroke"),
                     .step = QT_TRANSLATE_NOOP("Tool", "Pinch hair"),
                     .hint = QT_TRANSLATE_NOOP(
                         "Tool", "Drag along hair to pinch it together in a lock; a click gathers it to a point")},
    ToolChoice::Item{.icon = "finger-spread",
                     .title = QT_TRANSLATE_NOOP("ToolOptions", "Spread: part hairs and locks from each other"),
                     .step = QT_TRANSLATE_NOOP("Tool", "Spread hair"),
                     .hint =
                         QT_TRANSLATE_NOOP("Tool", "Drag along hair to spread it, away from the middle of the stroke")},
    ToolChoice::Item{
        .icon = "finger-smooth",
        .title = QT_TRANSLATE_NOOP("ToolOptions", "Smooth: even out how hair lies, is long and curls"),
        .step = QT_TRANSLATE_NOOP("Tool", "Smooth hair"),
        .hint = QT_TRANSLATE_NOOP("Tool", "Drag over hair to make its direction, length, curl and frizz more even")},
};
constexpr ToolOption kFingerKind{
    .key = "fingers",
    .kind = ToolChoice{
        .entries = kFingerKinds,
        .read = [](const ToolSettings& settings) { return static_cast<int>(settings.fingers); },
        .write = [](ToolSettings& settings, int index) { settings.fingers = static_cast<FingerKind>(index); }}};
constexpr ToolOption kFingerStrength{
    .key = "finger_strength",
    .label = QT_TRANSLATE_NOOP("ToolOptions", "Strength"),
    .hint = QT_TRANSLATE_NOOP("ToolOptions", "How much a stroke does; pen pressure makes it less, another stroke more"),
    .kind = ToolNumber{.field = &ToolSettings::fingerStrength, .standard = 50.0}};
constexpr std::array kFingerOptions{&kFingerKind, &kSizeOption, &kHardnessOption, &kFingerStrength, &kTouchOption};

constexpr float kLeastFingerPressure = 0.05F;
const glm::vec3 kOtherSide(-1.0F, 1.0F, 1.0F); ///< Reflects Hd.

constexpr ToolTraits kFingers{
    .id = ToolId::Fingers,
    .name = "fingers",
    .title = QT_TRANSLATE_NOOP("Tool", "Fingers"),
    .purpose = QT_TRANSLATE_NOOP("Tool", "Puffs, pinches, spreads or smooths hair where it is drawn over."),
    .hint = QT_TRANSLATE_NOOP("Tool", "Drag over hair to puff it up; it gets the gel that keeps it"),
    .key = Qt::Key_R,
    .options = kFingerOptions,
    .hasRing = true,
    .map = MapKind::Direction,
    .alsoPaints = [](const ToolSettings& settings) -> std::optional<MapKind> {
        switch (settings.fingers) {
        case FingerKind::Puff:
            return MapKind::Gel;
        case FingerKind::Pinch:
        case FingerKind::Spread:
            return MapKind::Clump;
        case FingerKind::Smooth:
            break;
        }
        return std::nullopt;
    },
    .demo = &kFingersDemo,
    .worksOnHair = [](const ToolSettings&) { return true; }};

class FingersTool : public Tool
{
public:
    [[nodiscard]] const ToolTraits& traits() const override { return kFingers; }

    void press(const ToolEvent& event, ToolContext& context) override;
    void move(const ToolEvent& event, ToolContext& context) override
    {
        if (active())
            goTo(event, context);
    }
    void release(const ToolEvent& event, ToolContext& context) override;
    void cancel(ToolContext& /*context*/) override
    {
        m_maps.cancel();
        m_stroke.end();
    }
    void commit(ToolContext& /*context*/) override
    {
        m_maps.commit();
        m_stroke.end();
    }
    [[nodiscard]] bool active() const override { return m_maps.active(); }

private:
    void goTo(const ToolEvent& event, ToolContext& context);
    void overSkin(const BrushSample& sample, const ToolContext& context);
    void overHair(const ToolEvent& event, const ToolContext& context);

    FingerMaps m_maps;
    SkinStroke m_stroke;
    std::optional<glm::vec3> m_lastHd; ///< Where the stroke was last, on the skin or over strands.
    float m_pressure = 1.0F;
};

void FingersTool::press(const ToolEvent& event, ToolContext& context)
{
    if (picksInstead(event, context))
        return;
    const Head* head = SkinStroke::headFor(context);
    if (head == nullptr || active())
        return;
    m_stroke.look(*head);
    if (!m_maps.begin(context, stepFor(context.settings), *m_stroke.frames))
        return;
    m_stroke.begin(*head, context, m_maps.size());
    m_lastHd.reset();
    goTo(event, context);
}

void FingersTool::release(const ToolEvent& event, ToolContext& context)
{
    if (!active())
        return;
    // A pen's last event has no pressure left; it still says where the stroke ends.
    ToolEvent end = event;
    end.pressure = m_pressure;
    goTo(end, context);
    commit(context);
}

void FingersTool::goTo(const ToolEvent& event, ToolContext& context)
{
    m_pressure = event.pressure;
    if (event.hair) {
        m_stroke.path->lift();
        overHair(event, context);
    } else {
        m_stroke.roots->lift();
        m_stroke.path->moveTo(event, [&](const BrushSample& sample) { overSkin(sample, context); });
    }
    m_maps.show();
}

void FingersTool::overSkin(const BrushSample& sample, const ToolContext& context)
{
    if (!sample.point) {
        m_lastHd.reset();
        return;
    }
    const ToolSettings& settings = context.settings;
    const std::optional<glm::vec3> last = std::exchange(m_lastHd, sample.point->positionHd);
    if (last)
        m_stroke.heading.turn(sample.point->positionHd - *last, settings.brushSizeM);
    FingerDab one{.dab = dabAt(sample.metric, sample.uv, 0.5F * settings.brushSizeM, m_maps.size()),
                  .centre = *sample.point,
                  .reachM = 0.5F * settings.brushSizeM,
                  .headingHd = m_stroke.heading.orNone()};
    one.dab.hardness = settings.hardness;
    one.dab.strength = std::clamp(sample.pressure, kLeastFingerPressure, 1.0F);
    m_maps.add(one);
    if (!context.mirror)
        return;
    const Head& head = *context.document.project().head;
    const auto other = head.skin->mirrored(*sample.point);
    if (!other)
        return;
    FingerDab twin = one;
    twin.dab = head.builtIn ? mirroredInU(one.dab, m_maps.size())
                            : dabAt(SkinMetric::at(*other), other->uv, one.reachM, m_maps.size());
    twin.dab.hardness = one.dab.hardness;
    twin.dab.strength = one.dab.strength;
    twin.centre = *other;
    twin.headingHd = one.headingHd * kOtherSide;
    m_maps.add(twin);
}

void FingersTool::overHair(const ToolEvent& event, const ToolContext& context)
{
    const ToolSettings& settings = context.settings;
    const float reachM = 0.5F * settings.brushSizeM;
    const glm::vec3 middleHd = event.hair->positionHd;
    if (const std::optional<glm::vec3> last = std::exchange(m_lastHd, middleHd))
        m_stroke.heading.turn(middleHd - *last, settings.brushSizeM);
    const RootDabs::Shape shape{.sizeM = settings.brushSizeM,
                                .hardness = settings.hardness,
                                .strength = std::clamp(event.pressure, kLeastFingerPressure, 1.0F),
                                .twinRoots = true};
    for (const RootDab& one : m_stroke.roots->moveTo(*event.hair, context, shape, true)) {
        FingerDab dab{.dab = one.dab,
                      .centre = one.root,
                      .reachM = reachM,
                      .headingHd = m_stroke.heading.orNone(),
                      .gatherHd = (middleHd - one.seenHd) / reachM};
        m_maps.add(dab);
        if (!one.twin || !one.twinRoot)
            continue;
        dab.dab = *one.twin;
        dab.centre = *one.twinRoot;
        dab.headingHd *= kOtherSide;
        *dab.gatherHd *= kOtherSide;
        m_maps.add(dab);
    }
}

} // namespace

std::unique_ptr<Tool> makeFingersTool()
{
    return std::make_unique<FingersTool>();
}

} // namespace hairpaint::model
