// Filled rectangles, ellipses and polygons.
#include "model/maps/compositor.h"
#include "model/maps/texel_ops.h"
#include "model/tools/live_edit.h"
#include "model/tools/painting/shape_mask.h"
#include "model/tools/picker_tool.h"
#include "model/tools/row_number.h"
#include "model/tools/strokes/mirror.h"
#include "model/tools/tool_list.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hairpaint::model {

namespace {

constexpr std::array kShapeKinds{
    ToolChoice::Item{"shape-rectangle", QT_TRANSLATE_NOOP("ToolOptions", "Rectangle")},
    ToolChoice::Item{"shape-ellipse", QT_TRANSLATE_NOOP("ToolOptions", "Ellipse")},
    ToolChoice::Item{"shape-polygon", QT_TRANSLATE_NOOP("ToolOptions", "Polygon")},
};
constexpr ToolOption kShapeKind{
    .key = "shape",
    .kind =
        ToolChoice{.entries = kShapeKinds,
                   .read = [](const ToolSettings& settings) { return static_cast<int>(settings.shape); },
                   .write = [](ToolSettings& settings, int index) { settings.shape = static_cast<ShapeKind>(index); },
                   .standard = static_cast<int>(ShapeKind::Ellipse)}};
constexpr std::array kShapeOptions{&kValueOption, &kShapeKind, &kOpacityOption};

constexpr int kEllipseCorners = 128;
constexpr float kFreehandStepUv = 0.004F;
constexpr float kCloseUv = 0.012F; ///< A click this near the first corner closes a polygon.

glm::vec2 squared(glm::vec2 extent)
{
    const float side = std::max(std::abs(extent.x), std::abs(extent.y));
    return {std::copysign(side, extent.x), std::copysign(side, extent.y)};
}

constexpr ToolTraits kShape{
    .id = ToolId::Shape,
    .name = "shape",
    .title = QT_TRANSLATE_NOOP("Tool", "Shape"),
    .purpose = QT_TRANSLATE_NOOP("Tool", "Paints filled rectangles, ellipses and polygons."),
    .hint = QT_TRANSLATE_NOOP(
        "Tool", "Drag a filled shape; Shift makes it a square or a circle; polygons: click corner by corner"),
    .key = Qt::Key_U,
    .options = kShapeOptions};

/// Rectangles and ellipses are dragged from corner to corner. Polygons are clicked corner by corner, or drawn by
/// dragging; a click near the first corner, or on the last one again, closes them.
class ShapeTool : public Tool
{
    Q_DECLARE_TR_FUNCTIONS(Tool)
public:
    [[nodiscard]] const ToolTraits& traits() const override { return kShape; }
    [[nodiscard]] QString hint() const override
    {
        return m_kind == ShapeKind::Polygon && active()
                   ? tr("Click corner by corner; click the first one to close; Backspace takes one back")
                   : Tool::hint();
    }

    void press(const ToolEvent& event, ToolContext& context) override;
    void move(const ToolEvent& event, ToolContext& context) override;
    void release(const ToolEvent& event, ToolContext& context) override;
    void hover(const ToolEvent& event, ToolContext& context) override;
    bool key(Qt::Key key, Qt::KeyboardModifiers modifiers, ToolContext& context) override;
    void cancel(ToolContext& /*context*/) override { m_edit.cancel(); }
    void commit(ToolContext& /*context*/) override { m_edit.commit(); }
    [[nodiscard]] bool active() const override { return m_edit.active(); }
    [[nodiscard]] bool pending() const override { return active() && !m_pressed; }
    [[nodiscard]] std::vector<OverlayShape> overlay() const override;

private:
    [[nodiscard]] QPolygonF outlineUv() const;
    void show(const ToolContext& context);
    /// Takes back a polygon's last corner; false where it has no more than its first.
    bool stepBack(const ToolContext& context);

    LiveEdit m_edit;
    ShapeKind m_kind = ShapeKind::Ellipse;
    std::optional<sim::SurfacePoint> m_start; ///< Where it was begun,
    sim::Texel m_value{};                     ///< and what it paints.
    std::vector<glm::vec2> m_corners;         ///< uv; of a rectangle or ellipse: start and end.
    std::optional<glm::vec2> m_hoverUv;       ///< Where a pending polygon's next corner would be.
    bool m_freehand = false;
    bool m_pressed = false;
};

void ShapeTool::press(const ToolEvent& event, ToolContext& context)
{
    if (picksInstead(event, context) || (event.area == Area::Head && !event.point))
        return;
    m_freehand = false;
    m_hoverUv.reset();
    if (!active()) {
        const sim::Texel value = strokeTexel(context, event);
        // What the context refers to outlives the edit; the context itself does not.
        if (!m_edit.begin(context, title(), [this, kept = ToolContext(context)] { return stepBack(kept); }))
            return;
        m_pressed = true;
        m_kind = context.settings.shape;
        m_corners = {event.uv};
        m_start = event.point;
        m_value = value;
        if (m_kind != ShapeKind::Polygon)
            m_corners.push_back(event.uv);
        return;
    }
    const bool closes = m_corners.size() > 2 && (glm::length(event.uv - m_corners.front()) < kCloseUv ||
                                                 glm::length(event.uv - m_corners.back()) < kFreehandStepUv);
    if (closes) {
        commit(context);
        return;
    }
    m_pressed = true;
    m_corners.push_back(event.uv);
    show(context);
}

void ShapeTool::move(const ToolEvent& event, ToolContext& context)
{
    if (!active() || (event.area == Area::Head && !event.point))
        return;
    if (m_kind == ShapeKind::Polygon) {
        if (glm::length(event.uv - m_corners.back()) < kFreehandStepUv)
            return;
        m_freehand = true;
        m_corners.push_back(event.uv);
    } else {
        const glm::vec2 extent = event.uv - m_corners.front();
        m_corners.back() = m_corners.front() + (event.modifiers.testFlag(Qt::ShiftModifier) ? squared(extent) : extent);
    }
    show(context);
}

void ShapeTool::release(const ToolEvent& event, ToolContext& context)
{
    if (!active())
        return;
    move(event, context);
    m_pressed = false;
    if (m_kind != ShapeKind::Polygon || (m_freehand && m_corners.size() > 2))
        commit(context);
}

void ShapeTool::hover(const ToolEvent& event, ToolContext& /*context*/)
{
    m_hoverUv.reset();
    if (pending() && (event.area == Area::Paint || event.point))
        m_hoverUv = event.uv;
}

bool ShapeTool::key(Qt::Key key, Qt::KeyboardModifiers /*modifiers*/, ToolContext& context)
{
    return (key == Qt::Key_Backspace || key == Qt::Key_Delete) && pending() && stepBack(context);
}

bool ShapeTool::stepBack(const ToolContext& context)
{
    if (m_kind != ShapeKind::Polygon || m_pressed || m_corners.size() < 2)
        return false;
    m_corners.pop_back();
    show(context);
    return true;
}

std::vector<OverlayShape> ShapeTool::overlay() const
{
    if (!active())
        return {};
    OverlayShape shape{.uvOutline = outlineUv(), .closed = m_kind != ShapeKind::Polygon || m_corners.size() > 2};
    if (!pending())
        return {shape};
    shape.uvHandles = shape.uvOutline;
    std::vector<OverlayShape> shapes{std::move(shape)};
    if (m_hoverUv) {
        QPolygonF next;
        next << QPointF(m_corners.back().x, m_corners.back().y) << QPointF(m_hoverUv->x, m_hoverUv->y);
        shapes.push_back({.uvOutline = std::move(next), .closed = false});
    }
    return shapes;
}

QPolygonF ShapeTool::outlineUv() const
{
    QPolygonF outline;
    if (m_kind == ShapeKind::Polygon) {
        for (const glm::vec2& corner : m_corners)
            outline << QPointF(corner.x, corner.y);
        return outline;
    }
    const glm::dvec2 a(m_corners.front());
    const glm::dvec2 b(m_corners.back());
    if (m_kind == ShapeKind::Rectangle) {
        outline << QPointF(a.x, a.y) << QPointF(b.x, a.y) << QPointF(b.x, b.y) << QPointF(a.x, b.y);
        return outline;
    }
    const glm::dvec2 centre = 0.5 * (a + b);
    const glm::dvec2 radius = 0.5 * glm::abs(b - a);
    for (int i = 0; i < kEllipseCorners; ++i) {
        const double angle = 2.0 * 3.14159265358979323846 * i / kEllipseCorners;
        outline << QPointF(centre.x + radius.x * std::cos(angle), centre.y + radius.y * std::sin(angle));
    }
    return outline;
}

void ShapeTool::show(const ToolContext& context)
{
    const int size = m_edit.size();
    const auto inTexels = [size](const QPolygonF& uv) {
        QPolygonF tx;
        for (const QPointF& point : uv)
            tx << QPointF(point.x() * size, (1.0 - point.y()) * size);
        return tx;
    };
    StrokeBuffer buffer(size);
    // Vectors are others on the other side, which has a mask of its own then.
    StrokeBuffer otherSide(size);
    StrokeBuffer& twinBuffer = m_edit.spec().texel == TexelKind::Vector ? otherSide : buffer;
    const QPolygonF outline = outlineUv();
    const ShapeMask mask(inTexels(outline), size);
    const auto add = [&](StrokeBuffer& to, const ShapeMask& shape, bool mirrored) {
        for (const sim::TexelRect& clip : m_edit.clips())
            shape.addTo(to, clip, mirrored);
    };
    add(buffer, mask, false);
    const Head* head = context.document.project().head.get();
    if (context.mirror && (head == nullptr || head->builtIn)) {
        add(twinBuffer, mask, true);
    } else if (context.mirror) {
        QPolygonF twin;
        for (const QPointF& point : outline)
            if (const auto uv = mirroredUv(head, glm::vec2(point.x(), point.y())))
                twin << QPointF(uv->x, uv->y);
        if (twin.size() == outline.size())
            add(twinBuffer, ShapeMask(inTexels(twin), size), false);
    }
    const TilePaint paint{.value = m_value, .opacity = unit16(context.settings.opacity)};
    TilePaint twinPaint = paint;
    twinPaint.value = mirroredValue(m_edit.spec(), paint.value, head, m_start);
    std::vector<int> tiles = buffer.takeDirty();
    for (const int index : otherSide.takeDirty())
        if (!std::ranges::binary_search(tiles, index))
            tiles.insert(std::ranges::lower_bound(tiles, index), index);
    m_edit.replace(tiles, [&](int index, const sim::RasterTilePtr& before) {
        sim::RasterTilePtr tile = before;
        if (const StrokeBuffer::MaskTile* twin = otherSide.mask(index))
            tile = paintTile(m_edit.spec(), tile, *twin, twinPaint);
        if (const StrokeBuffer::MaskTile* own = buffer.mask(index))
            tile = paintTile(m_edit.spec(), tile, *own, paint);
        return tile;
    });
}

} // namespace

std::unique_ptr<Tool> makeShapeTool()
{
    return std::make_unique<ShapeTool>();
}

} // namespace hairpaint::model
