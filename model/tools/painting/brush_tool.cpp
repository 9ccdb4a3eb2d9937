// The brush and the eraser: a disc on the skin, dabbed along the pointer's path.
#include "model/maps/compositor.h"
#include "model/maps/texel_ops.h"
#include "model/tools/brush_path.h"
#include "model/tools/live_edit.h"
#include "model/tools/painting/tip_starts.h"
#include "model/tools/picker_tool.h"
#include "model/tools/root_dabs.h"
#include "model/tools/row_number.h"
#include "model/tools/strokes/mirror.h"
#include "model/tools/tool_list.h"

#include <algorithm>
#include <array>

namespace hairpaint::model {

namespace {

constexpr ToolOption kPressureSize{
    .key = "pressure_size",
    .label = QT_TRANSLATE_NOOP("ToolOptions", "Pen pressure changes the size"),
    .kind = ToolSwitch{.field = &ToolSettings::pressureSize, .icon = "pressure-size", .standard = true}};
constexpr ToolOption kPressureOpacity{
    .key = "pressure_opacity",
    .label = QT_TRANSLATE_NOOP("ToolOptions", "Pen pressure changes the opacity"),
    .kind = ToolSwitch{.field = &ToolSettings::pressureOpacity, .icon = "pressure-opacity"}};
constexpr std::array kBrushOptions{&kValueOption,  &kSizeOption,      &kHardnessOption, &kOpacityOption,
                                   &kPressureSize, &kPressureOpacity, &kTouchOption};

constexpr float kSpacing = 1.0F / 8.0F; ///< Distance between dabs, as a fraction of their diameter.
constexpr float kLeastPressure = 0.05F; ///< A pen that only just touches still leaves a trace.
constexpr float kLeastStepTx = 0.25F;

constexpr ToolTraits kBrush{
    .id = ToolId::Brush,
    .name = "brush",
    .title = QT_TRANSLATE_NOOP("Tool", "Brush"),
    .purpose = QT_TRANSLATE_NOOP("Tool", "Paints the chosen value on the active map, on the flat map or on the head."),
    .hint = QT_TRANSLATE_NOOP("Tool",
                              "Drag to paint; Shift+click for a straight line from the last point; Ctrl+click picks"),
    .key = Qt::Key_B,
    .options = kBrushOptions,
    .hasRing = true,
    .isFirst = true,
    .worksOnHair = [](const ToolSettings&) { return true; }};
constexpr ToolTraits kEraser{
    .id = ToolId::Eraser,
    .name = "eraser",
    .title = QT_TRANSLATE_NOOP("Tool", "Eraser"),
    .purpose = QT_TRANSLATE_NOOP("Tool", "Takes paint off the active layer, so that what lies below shows again."),
    .hint = QT_TRANSLATE_NOOP("Tool", "Drag to erase; Shift+click for a straight line from the last point"),
    .key = Qt::Key_E,
    .options = ToolOptions(kBrushOptions).subspan(1),
    .hasRing = true,
    .erases = true,
    .worksOnHair = [](const ToolSettings&) { return true; }};

class BrushTool : public Tool
{
    Q_DECLARE_TR_FUNCTIONS(Tool)
public:
    explicit BrushTool(bool erases) : m_erases(erases) {}
    [[nodiscard]] const ToolTraits& traits() const override { return m_erases ? kEraser : kBrush; }

    void press(const ToolEvent& event, ToolContext& context) override;
    void move(const ToolEvent& event, ToolContext& context) override;
    void release(const ToolEvent& event, ToolContext& context) override;
    void cancel(ToolContext& context) override;
    void commit(ToolContext& context) override;
    [[nodiscard]] bool active() const override { return m_edit.active(); }

private:
    void paintTo(const ToolEvent& event, ToolContext& context);
    void paintOnHair(const ToolEvent& event, const ToolContext& context);
    void dab(const BrushSample& sample, const ToolContext& context);
    void add(const Dab& dab, const sim::Texel& value);
    void show();

    bool m_erases;
    bool m_sided = false; ///< The mirrored dabs lay another value.
    LiveEdit m_edit;
    std::optional<StrokeBuffer> m_buffer;
    std::optional<BrushPath> m_path;
    std::optional<RootDabs> m_roots; ///< Where the stroke goes over hair.
    std::optional<TipStarts> m_tips;
    std::optional<ToolEvent> m_last; ///< Where the next straight line starts; kept between strokes.
    TilePaint m_paint;
};

void BrushTool::press(const ToolEvent& event, ToolContext& context)
{
    if (picksInstead(event, context) || active() || !m_edit.begin(context, title()))
        return;
    const Head* head = context.document.project().head.get();
    // Vectors are others on the other side.
    m_sided = context.mirror && m_edit.spec().texel == TexelKind::Vector;
    m_buffer.emplace(m_edit.size(), m_sided ? m_edit.spec().valueChannels : 0);
    m_path.emplace(head != nullptr ? head->skin.get() : nullptr, context.settings.brushSizeM * kSpacing,
                   kLeastStepTx / static_cast<float>(m_edit.size()));
    m_roots.emplace(context, m_edit.size());
    m_tips = TipStarts::in(m_edit, context);
    const bool goesOn = event.modifiers.testFlag(Qt::ShiftModifier) && m_last;
    m_paint = {.value = strokeTexel(context, goesOn ? *m_last : event),
               .opacity = unit16(context.settings.opacity),
               .erase = m_erases};
    if (goesOn) {
        m_last->pressure = event.pressure;
        m_path->standAt(*m_last);
    }
    paintTo(event, context);
}

void BrushTool::move(const ToolEvent& event, ToolContext& context)
{
    if (active())
        paintTo(event, context);
}

void BrushTool::release(const ToolEvent& event, ToolContext& context)
{
    if (!active())
        return;
    // A pen's last event has no pressure left; it still says where the stroke ends.
    ToolEvent end = event;
    if (m_last && !event.hair)
        end.pressure = m_last->pressure;
    paintTo(end, context);
    commit(context);
}

void BrushTool::cancel(ToolContext& /*context*/)
{
    m_edit.cancel();
    m_buffer.reset();
    m_path.reset();
    m_roots.reset();
    m_tips.reset();
}

void BrushTool::commit(ToolContext& /*context*/)
{
    m_edit.commit();
    m_buffer.reset();
    m_path.reset();
    m_roots.reset();
    m_tips.reset();
}

void BrushTool::paintTo(const ToolEvent& event, ToolContext& context)
{
    if (event.hair) {
        m_path->lift();
        paintOnHair(event, context);
    } else {
        m_roots->lift();
        m_path->moveTo(event, [&](const BrushSample& sample) { dab(sample, context); });
        if (event.area == Area::Paint || event.point)
            m_last = event;
    }
    show();
}

void BrushTool::paintOnHair(const ToolEvent& event, const ToolContext& context)
{
    const ToolSettings& settings = context.settings;
    const float pressure = std::clamp(event.pressure, kLeastPressure, 1.0F);
    const bool fades = settings.pressureOpacity && texelOps(m_edit.spec()).continuous;
    const RootDabs::Shape shape{.sizeM = settings.brushSizeM * (settings.pressureSize ? pressure : 1.0F),
                                .hardness = texelOps(m_edit.spec()).continuous ? settings.hardness : 1.0F,
                                .strength = fades ? pressure : 1.0F,
                                .fractions = m_tips.has_value()};
    const Head* head = context.document.project().head.get();
    for (const RootDab& one : m_roots->moveTo(*event.hair, context, shape, true)) {
        add(one.dab, m_paint.value);
        if (one.twin)
            add(*one.twin, mirroredValue(m_edit.spec(), m_paint.value, head, one.root));
        if (m_tips)
            m_tips->add(m_edit, one);
    }
}

void BrushTool::add(const Dab& dab, const sim::Texel& value)
{
    for (const sim::TexelRect& clip : m_edit.clips())
        m_sided ? m_buffer->add(dab, clip, value) : m_buffer->add(dab, clip);
}

void BrushTool::dab(const BrushSample& sample, const ToolContext& context)
{
    const ToolSettings& settings = context.settings;
    const float pressure = std::clamp(sample.pressure, kLeastPressure, 1.0F);
    const float sizeM = settings.brushSizeM * (settings.pressureSize ? pressure : 1.0F);
    m_path->setSpacing(sizeM * kSpacing);

    const int size = m_edit.size();
    Dab dab = dabAt(sample.metric, sample.uv, 0.5F * sizeM, size);
    dab.hardness = settings.hardness;
    dab.strength = settings.pressureOpacity && texelOps(m_edit.spec()).continuous ? pressure : 1.0F;
    add(dab, m_paint.value);
    if (!context.mirror)
        return;
    const Head* head = context.document.project().head.get();
    const sim::Texel twinValue = mirroredValue(m_edit.spec(), m_paint.value, head, sample.point);
    if (head == nullptr || head->builtIn) {
        add(mirroredInU(dab, size), twinValue);
    } else if (sample.point) {
        if (const auto other = head->skin->mirrored(*sample.point)) {
            Dab twin = dabAt(SkinMetric::at(*other), other->uv, 0.5F * sizeM, size);
            twin.hardness = dab.hardness;
            twin.strength = dab.strength;
            add(twin, twinValue);
        }
    }
}

void BrushTool::show()
{
    m_edit.update(m_buffer->takeDirty(), [this](int index, const sim::RasterTilePtr& before) {
        TilePaint paint = m_paint;
        paint.values = m_buffer->values(index);
        return paintTile(m_edit.spec(), before, *m_buffer->mask(index), paint);
    });
    if (m_tips && active())
        m_tips->show(m_edit, m_erases);
}

} // namespace

std::unique_ptr<Tool> makeBrushTool()
{
    return std::make_unique<BrushTool>(false);
}

std::unique_ptr<Tool> makeEraserTool()
{
    return std::make_unique<BrushTool>(true);
}

} // namespace hairpaint::model
