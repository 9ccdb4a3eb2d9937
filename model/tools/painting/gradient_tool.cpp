// Linear and radial gradients over the map or the selection, live while they are dragged.
#include "model/maps/compositor.h"
#include "model/maps/texel_ops.h"
#include "model/tools/live_edit.h"
#include "model/tools/picker_tool.h"
#include "model/tools/strokes/mirror.h"
#include "model/tools/tool_list.h"
#include "model/values/texel_math.h"
#include "sim/base/parallel.h"
#include "sim/base/rounded.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hairpaint::model {

namespace {

constexpr std::array kGradientKinds{
    ToolChoice::Item{"gradient-linear", QT_TRANSLATE_NOOP("ToolOptions", "Linear gradient")},
    ToolChoice::Item{"gradient-radial", QT_TRANSLATE_NOOP("ToolOptions", "Radial gradient")},
};
constexpr ToolOption kGradientKind{
    .key = "gradient",
    .kind = ToolChoice{
        .entries = kGradientKinds,
        .read = [](const ToolSettings& settings) { return static_cast<int>(settings.gradient); },
        .write = [](ToolSettings& settings, int index) { settings.gradient = static_cast<GradientKind>(index); }}};
constexpr std::array kGradientOptions{&kValueOption, &kGradientKind, &kOpacityOption};

/// The line from a point (0) to another (1), in texels.
struct Ramp
{
    glm::vec2 startTx{0.0F};
    glm::vec2 alongTx{0.0F}; ///< From start to end; linear: over its squared length.
    float perTx = 0.0F;      ///< Radial: 1 / radius.
    GradientKind kind = GradientKind::Linear;

    Ramp(GradientKind gradient, glm::vec2 start, glm::vec2 end) : startTx(exact(start)), kind(gradient)
    {
        const glm::vec2 displacement = exact(end) - startTx;
        alongTx = displacement / std::max(glm::dot(displacement, displacement), 1e-6F);
        perTx = 1.0F / std::max(glm::length(displacement), 1e-3F);
    }
    /// To 1/64 of a texel, so that offsets are exact and a mirrored ramp gives the same values to the last bit.
    static glm::vec2 exact(glm::vec2 tx) { return glm::round(tx * 64.0F) / 64.0F; }
    [[nodiscard]] float at(glm::vec2 tx) const
    {
        const glm::vec2 offset = tx - startTx;
        const float fraction = kind == GradientKind::Linear ? glm::dot(offset, alongTx) : glm::length(offset) * perTx;
        return std::clamp(fraction, 0.0F, 1.0F);
    }
};

/// What a gradient lays on texels: the first value turning into the second; where both are equal, into nothing.
struct GradientPaint
{
    sim::Texel first{}, second{};
    sim::Texel twinFirst{}, twinSecond{}; ///< The two values of the mirrored ramp.
    std::vector<Ramp> ramps;              ///< The mirrored one too; the nearest to its start counts.
    std::uint16_t opacity = 65535;
};

constexpr ToolTraits kGradient{
    .id = ToolId::Gradient,
    .name = "gradient",
    .title = QT_TRANSLATE_NOOP("Tool", "Gradient"),
    .purpose = QT_TRANSLATE_NOOP("Tool", "Paints from the first value to the second, along a line or around a point."),
    .hint = QT_TRANSLATE_NOOP("Tool", "Drag from the first value to the second; Shift keeps to steps of 45 degrees"),
    .key = Qt::Key_G,
    .options = kGradientOptions,
    .demo = &kGradientDemo};

class GradientTool : public Tool
{
    Q_DECLARE_TR_FUNCTIONS(Tool)
public:
    [[nodiscard]] const ToolTraits& traits() const override { return kGradient; }

    void press(const ToolEvent& event, ToolContext& context) override
    {
        if (picksInstead(event, context) || active() || (event.area == Area::Head && !event.point))
            return;
        if (m_edit.begin(context, title())) {
            m_startUv = m_endUv = event.uv;
            m_start = event.point;
        }
    }
    void move(const ToolEvent& event, ToolContext& context) override
    {
        if (!active() || (event.area == Area::Head && !event.point))
            return;
        m_endUv = event.uv;
        if (event.modifiers.testFlag(Qt::ShiftModifier))
            m_endUv = m_startUv + constrained(event.uv - m_startUv);
        show(context);
    }
    void release(const ToolEvent& event, ToolContext& context) override
    {
        move(event, context);
        commit(context);
    }
    void cancel(ToolContext& /*context*/) override { m_edit.cancel(); }
    void commit(ToolContext& /*context*/) override { m_edit.commit(); }
    [[nodiscard]] bool active() const override { return m_edit.active(); }
    [[nodiscard]] std::vector<OverlayShape> overlay() const override
    {
        if (!active())
            return {};
        QPolygonF line;
        line << QPointF(m_startUv.x, m_startUv.y) << QPointF(m_endUv.x, m_endUv.y);
        return {{.uvOutline = line, .closed = false}};
    }

private:
    static glm::vec2 constrained(glm::vec2 displacement)
    {
        constexpr float kStep = 0.785398163F;
        const float angle = std::round(sim::atan2Rounded(displacement.y, displacement.x) / kStep) * kStep;
        const glm::vec2 direction(sim::cosRounded(angle), sim::sinRounded(angle));
        return direction * glm::dot(displacement, direction);
    }

    [[nodiscard]] GradientPaint paintOf(const ToolContext& context) const
    {
        const MapSpec& spec = m_edit.spec();
        const auto size = static_cast<float>(m_edit.size());
        const auto texel = [size](glm::vec2 uv) { return glm::vec2(uv.x, 1.0F - uv.y) * size; };
        const GradientKind kind = context.settings.gradient;
        GradientPaint paint{.first = texelOf(spec, context.settings.value(spec.kind)),
                            .second = texelOf(spec, context.settings.secondValue(spec.kind)),
                            .ramps = {Ramp(kind, texel(m_startUv), texel(m_endUv))},
                            .opacity = unit16(context.settings.opacity)};
        paint.twinFirst = paint.first;
        paint.twinSecond = paint.second;
        if (context.mirror) {
            const Head* head = context.document.project().head.get();
            paint.twinFirst = mirroredValue(spec, paint.first, head, m_start);
            paint.twinSecond = mirroredValue(spec, paint.second, head, m_start);
            const std::optional<glm::vec2> start = mirroredUv(head, m_startUv);
            const std::optional<glm::vec2> end = mirroredUv(head, m_endUv);
            if (start && end)
                paint.ramps.emplace_back(kind, texel(*start), texel(*end));
        }
        return paint;
    }

    void show(ToolContext& context)
    {
        const GradientPaint paint = paintOf(context);
        std::vector<int> tiles;
        if (m_startUv != m_endUv)
            tiles = tilesIn(m_edit.before(), m_edit.clips());
        // Each tile by itself, so several threads may make them; shown in order afterwards.
        std::vector<sim::RasterTilePtr> made(tiles.size());
        sim::parallelFor(tiles.size(), 4, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                made[i] = makeTile(tiles[i], paint);
        });
        m_edit.replace(tiles, [&](int index, const sim::RasterTilePtr& /*before*/) {
            return made[static_cast<std::size_t>(std::ranges::lower_bound(tiles, index) - tiles.begin())];
        });
    }

    [[nodiscard]] sim::RasterTilePtr makeTile(int index, const GradientPaint& paint) const
    {
        const MapSpec& spec = m_edit.spec();
        const auto channels = static_cast<std::size_t>(spec.valueChannels);
        const bool fades = paint.first == paint.second;
        StrokeBuffer::MaskTile mask{};
        StrokeBuffer::MaskTile fractions{};
        std::vector<bool> isTwin(sim::kTileTexels);
        std::vector<std::uint16_t> values(sim::kTileTexels * channels);
        const sim::TexelRect rect = m_edit.before().tileRect(index);
        const auto paintTexel = [&](int x, int y) {
            const auto texel = static_cast<std::size_t>(y - rect.y0) * kTile + static_cast<std::size_t>(x - rect.x0);
            const glm::vec2 centre(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
            float fraction = paint.ramps.front().at(centre);
            if (paint.ramps.size() > 1) {
                const float other = paint.ramps.back().at(centre);
                isTwin[texel] = other < fraction;
                fraction = std::min(fraction, other);
            }
            fractions[texel] = unit16(fraction);
            mask[texel] = fades ? static_cast<std::uint16_t>(65535 - fractions[texel]) : std::uint16_t{65535};
        };
        for (const sim::TexelRect& clip : m_edit.clips()) {
            const sim::TexelRect part = shared(rect, clip);
            for (int y = part.y0; y < part.y1; ++y)
                for (int x = part.x0; x < part.x1; ++x)
                    paintTexel(x, y);
        }
        texelOps(spec).mix(paint.first, paint.second, fractions, values.data());
        if (paint.twinFirst != paint.first || paint.twinSecond != paint.second) {
            std::vector<std::uint16_t> twins(values.size());
            texelOps(spec).mix(paint.twinFirst, paint.twinSecond, fractions, twins.data());
            for (std::size_t i = 0; i < values.size(); ++i)
                if (isTwin[i / channels])
                    values[i] = twins[i];
        }
        return paintTile(spec, m_edit.before().tile(index), mask, {.values = values.data(), .opacity = paint.opacity});
    }

    LiveEdit m_edit;
    glm::vec2 m_startUv{0.0F}, m_endUv{0.0F};
    std::optional<sim::SurfacePoint> m_start;
};

} // namespace

std::unique_ptr<Tool> makeGradientTool()
{
    return std::make_unique<GradientTool>();
}

} // namespace hairpaint::model
