// The parting: a curve over the skin whose points can be edited until it is kept.
#include "model/tools/parting/part_edit.h"
#include "model/tools/picker_tool.h"
#include "model/tools/tool_list.h"

#include <algorithm>
#include <array>
#include <utility>

namespace hairpaint::model {

namespace {

constexpr ToolOption kReach{.key = "part_reach",
                            .label = QT_TRANSLATE_NOOP("ToolOptions", "Reach"),
                            .hint = QT_TRANSLATE_NOOP("ToolOptions", "How far to either side the part lays hair"),
                            .kind = ToolNumber{.field = &ToolSettings::partReachM,
                                               .unit = ToolNumber::Unit::Centimetres,
                                               .least = 1.0,
                                               .greatest = 20.0,
                                               .standard = 10.0,
                                               .decimals = 1}};
constexpr ToolOption kPartFlatness{
    .key = "flatness", .label = kFlatnessLabel, .hint = kFlatnessHint, .kind = kFlatness};
constexpr ToolOption kGap{.key = "part_gap",
                          .label = QT_TRANSLATE_NOOP("ToolOptions", "Gap"),
                          .hint =
                              QT_TRANSLATE_NOOP("ToolOptions", "How wide a line of skin shows; 0 leaves every hair"),
                          .kind = ToolNumber{.field = &ToolSettings::partGapM,
                                             .unit = ToolNumber::Unit::Millimetres,
                                             .greatest = 10.0,
                                             .standard = 1.0,
                                             .decimals = 1,
                                             .exponent = 2.0}};
constexpr ToolOption kZigzag{
    .key = "part_zigzag",
    .label = QT_TRANSLATE_NOOP("ToolOptions", "Zigzag"),
    .hint = QT_TRANSLATE_NOOP("ToolOptions", "How far the part runs to and fro; 0 leaves it straight"),
    .kind = ToolNumber{
        .field = &ToolSettings::partZigzagM, .unit = ToolNumber::Unit::Millimetres, .greatest = 10.0, .decimals = 1}};
constexpr std::array kPartOptions{&kReach, &kPartFlatness, &kGap, &kZigzag};

constexpr float kGrabPx = 9.0F;              ///< So near to a point, or to the curve, a press takes hold of it.
constexpr float kDrawnPointsM = 0.02F;       ///< Between points of a curve that is drawn by dragging.
constexpr float kLastPointM = 0.006F;        ///< A drag's last piece is no shorter than this.
constexpr double kDoubleClickSeconds = 0.45; ///< Between two presses of a pen.
constexpr float kJumpUv = 0.05F;             ///< Neighbours of the curve further apart lie on two islands.

constexpr ToolTraits kPart{.id = ToolId::Part,
                           .name = "part",
                           .title = QT_TRANSLATE_NOOP("Tool", "Part"),
                           .purpose = QT_TRANSLATE_NOOP("Tool", "Parts the hair along a line."),
                           .key = Qt::Key_P,
                           .options = kPartOptions,
                           .map = MapKind::Direction,
                           .alsoPaints =
                               [](const ToolSettings& settings) {
                                   return settings.partGapM > 0.0F ? std::optional(MapKind::Density) : std::nullopt;
                               },
                           .demo = &kPartDemo};

/// Points are added at the curve's end, or where the curve is pressed; they can be dragged as long as it is not kept.
/// Partings ignore mirror painting: one in the middle would be parted twice.
class PartTool : public Tool
{
    Q_DECLARE_TR_FUNCTIONS(Tool)
public:
    [[nodiscard]] const ToolTraits& traits() const override { return kPart; }
    [[nodiscard]] QString hint() const override;

    void press(const ToolEvent& event, ToolContext& context) override;
    void move(const ToolEvent& event, ToolContext& context) override;
    void release(const ToolEvent& event, ToolContext& context) override;
    void hover(const ToolEvent& event, ToolContext& context) override;
    bool key(Qt::Key key, Qt::KeyboardModifiers modifiers, ToolContext& context) override;
    void settingsChanged(ToolContext& context) override
    {
        if (active())
            show(context);
    }
    void cancel(ToolContext& /*context*/) override { m_edit.cancel(); }
    void commit(ToolContext& /*context*/) override { m_edit.commit(); }
    [[nodiscard]] bool active() const override { return m_edit.active(); }
    [[nodiscard]] bool pending() const override { return active() && m_hold == Hold::None; }
    [[nodiscard]] std::vector<OverlayShape> overlay() const override;

private:
    using Points = std::vector<sim::SurfacePoint>;
    enum class Hold
    {
        None,
        Point,  ///< m_held follows the pointer.
        Drawing ///< The curve goes on where the pointer goes.
    };

    bool begin(const ToolContext& context);
    [[nodiscard]] std::optional<std::size_t> pointNear(const sim::SurfacePoint& point, float withinM) const;
    void draw(const sim::SurfacePoint& point);
    void change(Points points, const ToolContext& context);
    bool stepBack(const ToolContext& context);
    void show(const ToolContext& context);

    PartEdit m_edit;
    Points m_points;
    std::vector<Points> m_past; ///< What undo goes back to, the latest last.
    PartCurve m_curve;
    Hold m_hold = Hold::None;
    std::size_t m_held = 0;
    bool m_moved = false;                                    ///< Since the press.
    std::optional<std::pair<std::size_t, double>> m_clicked; ///< The last press on a point, and when it was.
    std::optional<sim::SurfacePoint> m_hover;                ///< Where a click would add a point.
    std::optional<std::size_t> m_hovered;                    ///< The point under the pointer.
};

QString PartTool::hint() const
{
    if (!active())
        return tr("Click or drag along the part; hair falls to both sides of it");
    if (m_hovered)
        return tr("Drag the point, or double-click it to keep the part; Delete takes the point away");
    return m_points.size() < 2
               ? tr("Click where the part goes on; Esc leaves no trace")
               : tr("Click to go on, drag points or the curve; Enter keeps the part, Esc leaves no trace");
}

bool PartTool::begin(const ToolContext& context)
{
    // What the context refers to outlives the edit; the context itself does not.
    if (!m_edit.begin(context, title(), [this, kept = ToolContext(context)] { return stepBack(kept); }))
        return false;
    m_points.clear();
    m_past.clear();
    m_curve = {};
    m_clicked.reset();
    m_hovered.reset();
    return true;
}

void PartTool::press(const ToolEvent& event, ToolContext& context)
{
    if (picksInstead(event, context) || !event.point || m_hold != Hold::None)
        return;
    m_hover.reset();
    m_moved = false;
    if (!active()) {
        if (!begin(context))
            return;
        m_points = {*event.point};
        m_hold = Hold::Drawing;
        m_clicked = {0, event.seconds};
        return;
    }
    const float withinM = kGrabPx * event.pixelM;
    if (const std::optional<std::size_t> point = pointNear(*event.point, withinM)) {
        const auto before = std::exchange(m_clicked, std::pair(*point, event.seconds));
        if (before && before->first == *point &&
            (event.again || event.seconds - before->second < kDoubleClickSeconds)) {
            commit(context);
            return;
        }
        m_hold = Hold::Point;
        m_held = *point;
        return;
    }
    Points points = m_points;
    const std::optional<PartCurve::Near> near = m_curve.nearest(event.point->positionHd);
    if (near && near->distanceM < withinM) {
        m_hold = Hold::Point;
        m_held = near->point + 1;
        m_moved = true; // It belongs to the same step wherever it is dragged.
        m_clicked.reset();
        points.insert(points.begin() + static_cast<std::ptrdiff_t>(m_held), *event.point);
    } else {
        m_hold = Hold::Drawing;
        points.push_back(*event.point);
        m_clicked = {points.size() - 1, event.seconds};
    }
    change(std::move(points), context);
}

void PartTool::move(const ToolEvent& event, ToolContext& context)
{
    if (!active() || m_hold == Hold::None || !event.point)
        return;
    const sim::SurfacePoint& from = m_hold == Hold::Point ? m_points[m_held] : m_points.back();
    if (!m_moved && glm::distance(from.positionHd, event.point->positionHd) < 0.5F * kGrabPx * event.pixelM)
        return;
    if (m_hold == Hold::Drawing) {
        draw(*event.point);
    } else {
        if (!m_moved)
            m_past.push_back(m_points);
        m_points[m_held] = *event.point;
    }
    m_moved = true;
    m_clicked.reset();
    show(context);
}

/// The last point follows the pointer; now and then it stays and another one follows.
void PartTool::draw(const sim::SurfacePoint& point)
{
    if (!m_moved)
        m_points.push_back(point);
    m_points.back() = point;
    const sim::SurfacePoint& fixed = m_points[m_points.size() - 2];
    if (glm::distance(fixed.positionHd, point.positionHd) > kDrawnPointsM)
        m_points.push_back(point);
}

void PartTool::release(const ToolEvent& event, ToolContext& context)
{
    if (!active() || m_hold == Hold::None)
        return;
    if (m_moved)
        move(event, context);
    const Hold hold = std::exchange(m_hold, Hold::None);
    if (hold != Hold::Drawing || !m_moved || m_points.size() < 3)
        return;
    // Where the drag ended just past a point, that is where it goes.
    const sim::SurfacePoint last = m_points.back();
    if (glm::distance(last.positionHd, m_points[m_points.size() - 2].positionHd) < kLastPointM) {
        m_points.pop_back();
        m_points.back() = last;
        show(context);
    }
}

void PartTool::hover(const ToolEvent& event, ToolContext& /*context*/)
{
    m_hover.reset();
    m_hovered.reset();
    if (!pending() || !event.point)
        return;
    const float withinM = kGrabPx * event.pixelM;
    m_hovered = pointNear(*event.point, withinM);
    const std::optional<PartCurve::Near> near = m_curve.nearest(event.point->positionHd);
    if (!m_hovered && (!near || near->distanceM > withinM))
        m_hover = event.point;
}

bool PartTool::key(Qt::Key key, Qt::KeyboardModifiers /*modifiers*/, ToolContext& context)
{
    if ((key != Qt::Key_Backspace && key != Qt::Key_Delete) || !pending())
        return false;
    if (m_points.size() < 2) {
        cancel(context);
        return true;
    }
    Points points = m_points;
    const auto removed = static_cast<std::ptrdiff_t>(m_hovered.value_or(points.size() - 1));
    points.erase(points.begin() + removed);
    m_hovered.reset();
    change(std::move(points), context);
    return true;
}

std::optional<std::size_t> PartTool::pointNear(const sim::SurfacePoint& point, float withinM) const
{
    std::optional<std::size_t> found;
    float nearestM = withinM;
    for (std::size_t i = 0; i < m_points.size(); ++i) {
        const float distanceM = glm::distance(m_points[i].positionHd, point.positionHd);
        if (distanceM < nearestM) {
            nearestM = distanceM;
            found = i;
        }
    }
    return found;
}

void PartTool::change(Points points, const ToolContext& context)
{
    m_past.push_back(std::exchange(m_points, std::move(points)));
    show(context);
}

bool PartTool::stepBack(const ToolContext& context)
{
    if (m_past.empty())
        return false;
    m_points = std::move(m_past.back());
    m_past.pop_back();
    m_hold = Hold::None;
    m_hovered.reset();
    m_clicked.reset();
    show(context);
    return true;
}

void PartTool::show(const ToolContext& context)
{
    m_curve = PartCurve(m_edit.skin(), m_points);
    m_edit.show(m_curve, m_points, context);
}

/// A curve on the layout, in as many pieces as it crosses islands.
void addOutlines(const PartCurve& curve, std::size_t fromPoint, std::vector<OverlayShape>& shapes)
{
    QPolygonF piece;
    glm::vec2 last(0.0F);
    const auto close = [&] {
        if (piece.size() > 1)
            shapes.push_back({.uvOutline = piece, .closed = false});
        piece.clear();
    };
    for (const PartCurve::Sample& sample : curve.samples()) {
        if (sample.point < fromPoint)
            continue;
        if (!piece.isEmpty() && glm::distance(sample.uv, last) > kJumpUv)
            close();
        last = sample.uv;
        piece << QPointF(last.x, last.y);
    }
    close();
}

std::vector<OverlayShape> PartTool::overlay() const
{
    if (!active())
        return {};
    std::vector<OverlayShape> shapes;
    addOutlines(m_curve, 0, shapes);
    if (m_hover && m_hold == Hold::None) {
        Points points = m_points;
        points.push_back(*m_hover);
        addOutlines(PartCurve(m_edit.skin(), points), m_points.size() - 1, shapes);
    }
    OverlayShape handles{.uvOutline = {}, .closed = false};
    for (const sim::SurfacePoint& point : m_points)
        handles.uvHandles << QPointF(point.uv.x, point.uv.y);
    shapes.push_back(std::move(handles));
    return shapes;
}

} // namespace

std::unique_ptr<Tool> makePartTool()
{
    return std::make_unique<PartTool>();
}

} // namespace hairpaint::model
