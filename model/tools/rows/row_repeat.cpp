// Lines between two rows by curves that leave either along the skin, dabbed as a brush would.
#include "model/tools/rows/row_repeat.h"

#include "model/patches/patch_shape.h"
#include "model/tools/row_number.h"
#include "model/tools/strokes/dab_shape.h"
#include "model/tools/strokes/mirror.h"
#include "model/tools/strokes/selection.h"
#include "sim/groom/patch_labels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace hairpaint::model {

namespace {

constexpr int kJoints = 33;              ///< Joints between two rows.
constexpr int kSteps = 16;               ///< Steps of a joint.
constexpr float kPartingFraction = 0.2F; ///< Of the room that a row has, at least.
constexpr float kLeastWidthM = 0.0015F;  ///< Where rows would be narrower there are none.
constexpr float kDabSpacing = 0.125F;    ///< Of a dab's diameter.
constexpr std::uint32_t kFewestTexels = 6;
constexpr float kMiddleM = 0.005F; ///< A row nearer to the middle of the head is on neither side.

/// `at`: 0..1 along the row.
sim::SurfacePoint pointOf(const sim::Skin& skin, const sim::BraidRow& row, float at)
{
    return skin.nearest(onRow(row, at * row.lengthM, 0.0F));
}

/// From `a` to `b` over the skin, evenly: a cubic curve that leaves either in the plane of the skin, brought to it.
std::vector<glm::vec3> joint(const sim::Skin& skin, const sim::SurfacePoint& a, const sim::SurfacePoint& b)
{
    const glm::vec3 across = b.positionHd - a.positionHd;
    const auto along = [&across](glm::vec3 normal) {
        const glm::vec3 flat = across - normal * glm::dot(across, normal);
        const float length = glm::length(flat);
        return length > 1e-6F ? flat * (glm::length(across) / length) : across;
    };
    const glm::vec3 leave = along(a.normalHd);
    const glm::vec3 arrive = along(b.normalHd);
    std::vector<glm::vec3> points;
    for (int step = 0; step <= kSteps; ++step) {
        const float t = static_cast<float>(step) / static_cast<float>(kSteps);
        const float t2 = t * t;
        const float t3 = t2 * t;
        const glm::vec3 at = a.positionHd * (2.0F * t3 - 3.0F * t2 + 1.0F) + leave * (t3 - 2.0F * t2 + t) +
                             b.positionHd * (3.0F * t2 - 2.0F * t3) + arrive * (t3 - t2);
        points.push_back(skin.nearest(at).positionHd);
    }
    return points;
}

/// The points at these parts of a line's length, and how long the line is.
std::pair<std::vector<glm::vec3>, float> divided(const std::vector<glm::vec3>& line, int parts)
{
    std::vector<float> upTo(line.size(), 0.0F);
    for (std::size_t i = 1; i < line.size(); ++i)
        upTo[i] = upTo[i - 1] + glm::distance(line[i], line[i - 1]);
    std::vector<glm::vec3> points;
    std::size_t at = 0;
    for (int part = 1; part < parts; ++part) {
        const float wantedM = upTo.back() * static_cast<float>(part) / static_cast<float>(parts);
        while (at + 2 < line.size() && upTo[at + 1] <= wantedM)
            ++at;
        const float t = std::clamp((wantedM - upTo[at]) / std::max(upTo[at + 1] - upTo[at], 1e-9F), 0.0F, 1.0F);
        points.push_back(line[at] + (line[at + 1] - line[at]) * t);
    }
    return {std::move(points), upTo.back()};
}

/// Whether the begin of one lies at the end of the other.
bool runOpposite(const sim::BraidRow& a, const sim::BraidRow& b)
{
    const auto far = [](glm::vec3 x, glm::vec3 y) { return glm::distance(x, y); };
    return far(a.pointsHd.front(), b.pointsHd.back()) + far(a.pointsHd.back(), b.pointsHd.front()) <
           far(a.pointsHd.front(), b.pointsHd.front()) + far(a.pointsHd.back(), b.pointsHd.back());
}

float meanX(const sim::BraidRow& row)
{
    float sum = 0.0F;
    for (const glm::vec3& point : row.pointsHd)
        sum += point.x;
    return sum / static_cast<float>(row.pointsHd.size());
}

bool lieOnBothSides(const sim::BraidRow& a, const sim::BraidRow& b)
{
    const float one = meanX(a);
    const float other = meanX(b);
    return std::abs(one) > kMiddleM && std::abs(other) > kMiddleM && (one < 0.0F) != (other < 0.0F);
}

/// The course of a painted strip, through points of it that are chosen evenly. None off the skin.
std::optional<sim::BraidRow> rowOf(const sim::Skin& skin, const sim::PatchLabels& labels, std::size_t patch)
{
    const std::optional<PatchShape> shape = shapeOf(labels, patch);
    if (!shape || shape->points.empty())
        return std::nullopt;
    std::vector<glm::vec3> strip;
    for (const sim::SurfacePoint& point : shape->points)
        strip.push_back(point.positionHd);
    // Texels come in lines; taken at random they lie evenly to all sides. The same seed: the same rows each time.
    std::minstd_rand random(1);
    for (std::size_t i = strip.size() - 1; i > 0; --i)
        std::swap(strip[i], strip[random() % (i + 1)]);
    strip.resize(std::min(strip.size(), sim::kMostRowPoints));
    const glm::vec3 tangentHd = shape->points.front().dPduHd;
    return sim::rowAlong(skin, strip, tangentHd / std::max(glm::length(tangentHd), 1e-9F));
}

bool reachesInto(const sim::PatchLabels& labels, std::size_t patch, const std::vector<sim::TexelRect>& selected,
                 const sim::TiledRaster& map)
{
    for (const auto& [index, part] : labels.patches()[patch].parts) {
        const sim::TexelRect rect = map.tileRect(index);
        std::size_t texel = 0;
        for (int y = rect.y0; y < rect.y1; ++y)
            for (int x = rect.x0; x < rect.x1; ++x, ++texel)
                if (labels.tile(index).parts[texel] == part && contains(selected, x, y))
                    return true;
    }
    return false;
}

} // namespace

/// A painted row.
struct RowRepeat::Found
{
    std::uint16_t number = 0;
    sim::BraidRow row;
};

std::vector<RowLine> linesBetween(const sim::Skin& skin, const sim::BraidRow& a, const sim::BraidRow& b, int count)
{
    std::vector<RowLine> lines(static_cast<std::size_t>(count));
    const bool isOpposite = runOpposite(a, b);
    const int parts = count + 1;
    for (int i = 0; i < kJoints; ++i) {
        const float at = static_cast<float>(i) / static_cast<float>(kJoints - 1);
        const auto [points, lengthM] =
            divided(joint(skin, pointOf(skin, a, at), pointOf(skin, b, isOpposite ? 1.0F - at : at)), parts);
        const float roomM = (1.0F - kPartingFraction) * lengthM / static_cast<float>(parts);
        for (std::size_t k = 0; k < points.size(); ++k) {
            const float t = static_cast<float>(k + 1) / static_cast<float>(parts);
            lines[k].push_back({.positionHd = skin.nearest(points[k]).positionHd,
                                .widthM = std::min(std::lerp(a.widthM, b.widthM, t), roomM)});
        }
    }
    return lines;
}

RowRepeat::RowRepeat(const ToolContext& context, const QString& text)
    : m_head(context.document.project().head), m_mirror(context.mirror)
{
    const HairGroup* group = context.document.project().group(context.target.group);
    if (group == nullptr || m_head == nullptr || !m_edit.begin(context, text)) {
        m_problem = QCoreApplication::translate("RowRepeat", "The braid map of this group has no layer to paint on.");
        return;
    }
    m_edit.setText(text);
    m_map = context.document.resolvedNow(context.target.group, MapKind::Braid);
    sim::PatchLabels labels;
    labels.update(m_map, std::make_shared<const sim::SkinIslands>(m_head->skin, m_map->size()));
    const bool isSelected = !context.selection.rectangles().empty();
    const std::vector<sim::TexelRect> selected = selectedTexels(context.selection, m_map->size());
    std::vector<Found> rows;
    for (std::size_t patch = 0; patch < labels.patches().size(); ++patch) {
        const sim::Patch& one = labels.patches()[patch];
        if (!isRow(one.kind) || one.texels < kFewestTexels ||
            (isSelected && !reachesInto(labels, patch, selected, *m_map)))
            continue;
        if (auto row = rowOf(*m_head->skin, labels, patch))
            rows.push_back({.number = one.kind, .row = std::move(*row)});
    }
    if (rows.size() < 2) {
        m_problem = isSelected ? QCoreApplication::translate(
                                     "RowRepeat", "Fewer than two cornrows reach into the selection: select two.")
                               : QCoreApplication::translate("RowRepeat",
                                                             "There are fewer than two cornrows: paint two strips of "
                                                             "Cornrow on the braid map first.");
    } else if (isSelected && rows.size() > 2) {
        m_problem = QCoreApplication::translate("RowRepeat",
                                                "More than two cornrows reach into the selection: select two of them.");
    } else if (const auto two = chosen(rows)) {
        m_rows = {(*two)[0].row, (*two)[1].row};
        m_mirror = m_mirror && !lieOnBothSides(m_rows[0], m_rows[1]);
        m_numbers = newRowNumbers(group->map(MapKind::Braid), kMostRowsBetween);
        return;
    } else {
        m_problem =
            QCoreApplication::translate("RowRepeat", "Which two of the cornrows? Select an area that two reach into.");
    }
    m_edit.cancel();
}

/// The two that were painted last, and where a mirrored stroke painted two at once those that lie nearest. None where
/// more than two were painted as one.
std::optional<std::array<RowRepeat::Found, 2>> RowRepeat::chosen(const std::vector<Found>& rows)
{
    if (rows.size() == 2)
        return std::array{rows[0], rows[1]};
    std::uint16_t last = 0;
    std::uint16_t before = 0;
    for (const Found& one : rows)
        last = std::max(last, one.number);
    for (const Found& one : rows)
        if (one.number < last)
            before = std::max(before, one.number);
    if (before == 0)
        return std::nullopt;
    constexpr float kSureFraction = 0.9F; // Of two pairs that lie as near, the first.
    std::optional<std::array<Found, 2>> nearest;
    float nearestM = std::numeric_limits<float>::max();
    std::array<int, 2> counts{};
    for (const Found& a : rows) {
        counts[0] += a.number == before ? 1 : 0;
        counts[1] += a.number == last ? 1 : 0;
        if (a.number != before)
            continue;
        for (const Found& b : rows) {
            if (b.number != last)
                continue;
            const float awayM =
                glm::distance(a.row.pointsHd[a.row.pointsHd.size() / 2], b.row.pointsHd[b.row.pointsHd.size() / 2]);
            if (awayM < kSureFraction * nearestM) {
                nearestM = awayM;
                nearest = std::array{a, b};
            }
        }
    }
    return counts[0] <= 2 && counts[1] <= 2 ? nearest : std::nullopt;
}

int RowRepeat::fittingCount() const
{
    if (!m_problem.isEmpty())
        return 1;
    const float apartM =
        divided(joint(*m_head->skin, pointOf(*m_head->skin, m_rows[0], 0.5F), pointOf(*m_head->skin, m_rows[1], 0.5F)),
                1)
            .second;
    const float eachM =
        std::max(0.5F * (m_rows[0].widthM + m_rows[1].widthM), kLeastWidthM) / (1.0F - kPartingFraction);
    return std::clamp(static_cast<int>(apartM / eachM) - 1, 1, kMostRowsBetween);
}

void RowRepeat::show(int count)
{
    if (!m_edit.active())
        return;
    StrokeBuffer buffer(m_edit.size(), m_edit.spec().valueChannels);
    const std::vector<RowLine> lines = linesBetween(*m_head->skin, m_rows[0], m_rows[1], count);
    for (std::size_t k = 0; k < lines.size(); ++k)
        paint(lines[k], m_numbers[k], buffer);
    m_edit.replace(buffer.takeDirty(), [&](int index, const sim::RasterTilePtr& before) {
        MaskTile mask = *buffer.mask(index);
        const sim::TexelRect rect = m_map->tileRect(index);
        std::size_t texel = 0;
        for (int y = rect.y0; y < rect.y1; ++y)
            for (int x = rect.x0; x < rect.x1; ++x, ++texel)
                if (isRow(m_map->texel(x, y)[0]))
                    mask[texel] = 0;
        return paintTile(m_edit.spec(), before, mask, {.values = buffer.values(index), .opacity = 65535});
    });
}

void RowRepeat::paint(const RowLine& line, std::uint16_t number, StrokeBuffer& buffer) const
{
    const sim::Skin& skin = *m_head->skin;
    const int size = m_edit.size();
    const sim::Texel value{number, 0, 0, 0};
    const auto add = [&](const Dab& dab) {
        for (const sim::TexelRect& clip : m_edit.clips())
            buffer.add(dab, clip, value);
    };
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const float widthM = std::min(line[i].widthM, line[i + 1].widthM);
        if (widthM < kLeastWidthM)
            continue;
        const float lengthM = glm::distance(line[i].positionHd, line[i + 1].positionHd);
        const int steps = std::max(1, static_cast<int>(std::ceil(lengthM / (kDabSpacing * widthM))));
        for (int step = 0; step <= steps; ++step) {
            const float t = static_cast<float>(step) / static_cast<float>(steps);
            const sim::SurfacePoint at = skin.nearest(glm::mix(line[i].positionHd, line[i + 1].positionHd, t));
            const float radiusM = 0.5F * std::lerp(line[i].widthM, line[i + 1].widthM, t);
            const Dab dab = dabAt(SkinMetric::at(at), at.uv, radiusM, size);
            add(dab);
            if (!m_mirror)
                continue;
            if (m_head->builtIn)
                add(mirroredInU(dab, size));
            else if (const auto other = skin.mirrored(at))
                add(dabAt(SkinMetric::at(*other), other->uv, radiusM, size));
        }
    }
}

} // namespace hairpaint::model
