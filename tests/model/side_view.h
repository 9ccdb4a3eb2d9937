// The hair of a document seen from its left side, from far away: what tools ask of the picture, answered strand by
// strand.
#pragma once

#include "model/tools/strokes/seen_hair.h"
#include "sim/groom/strand_curve.h"
#include "sim/motion/simulation.h"

#include <QLineF>

#include <algorithm>
#include <optional>

namespace hairpaint::test {

/// The hair of a document in motion.
struct LiveHair
{
    sim::Simulation simulation = {};

    /// A frame of the hair once it has settled.
    [[nodiscard]] std::shared_ptr<const sim::StrandFrame> settled(const sim::GroomInput& input, double seconds = 3.0)
    {
        simulation.setInput(input);
        simulation.settle(seconds);
        auto frame = std::make_shared<sim::StrandFrame>();
        simulation.writeFrame(*frame);
        return frame;
    }
};

/// Whether both styles are equal, byte for byte.
inline bool isSame(const sim::StrandStyle& a, const sim::StrandStyle& b)
{
    return std::ranges::equal(std::as_bytes(std::span(&a, 1)), std::as_bytes(std::span(&b, 1)));
}

/// A drawn strand's points, Hd; the head stands where it is.
inline std::vector<glm::vec3> drawnPoints(const sim::GroupFrame& hair, std::uint32_t slot)
{
    const sim::Groom& groom = *hair.groom;
    std::vector<glm::vec3> nodes(static_cast<std::size_t>(groom.nodes)), points;
    groom.blocks().read(hair.positions, groom.frameStrand(slot), nodes);
    const sim::CurlSettings* coils = sim::coilsOf(groom.settings);
    sim::evaluateStrand(nodes, sim::frameTangentHd(groom, slot), groom.style(slot),
                        4 * sim::segmentsOf(groom.style(slot), groom.nodes, coils), points, coils);
    return points;
}

/// A view of the first group: z to the left, y up, 2 px a mm; strands with roots of x < 0 are on the far side.
class SideView : public model::SeenHair
{
public:
    static constexpr double kPxPerM = 2000.0;
    explicit SideView(std::shared_ptr<const sim::StrandFrame> frame) : m_frame(std::move(frame)) {}

    [[nodiscard]] static QPointF seen(glm::vec3 positionHd)
    {
        return {-static_cast<double>(positionHd.z) * kPxPerM, -static_cast<double>(positionHd.y) * kPxPerM};
    }
    [[nodiscard]] std::vector<model::SeenStrand> under(QPointF /*centre*/, double /*radiusPx*/) const override
    {
        return {};
    }
    /// Where each strand is nearest to the pointer's way.
    [[nodiscard]] std::vector<model::SeenStrand> passed(QPointF from, QPointF to, double radiusPx) const override
    {
        const auto apartPx = [from, to](QPointF point) {
            const QPointF way = to - from;
            const double square = QPointF::dotProduct(way, way);
            const double along =
                square > 0.0 ? std::clamp(QPointF::dotProduct(point - from, way) / square, 0.0, 1.0) : 0.0;
            return QLineF(from + way * along, point).length();
        };
        std::vector<model::SeenStrand> met;
        const sim::GroupFrame& hair = m_frame->groups.front();
        for (std::uint32_t slot = 0; slot < hair.groom->roots->count(); ++slot) {
            if (!hair.isPositioned(slot))
                continue;
            const std::vector<glm::vec3> points = drawnPoints(hair, slot);
            const auto nearest =
                std::ranges::min_element(points, {}, [&](glm::vec3 point) { return apartPx(seen(point)); });
            const double apart = apartPx(seen(*nearest)) / radiusPx;
            if (apart > 1.0)
                continue;
            const auto first =
                std::ranges::find_if(points, [&](glm::vec3 point) { return apartPx(seen(point)) <= radiusPx; });
            const sim::RootSet& roots = *hair.groom->roots;
            met.push_back(
                {.rootUv = roots.uv[slot],
                 .rootHd = roots.positionHd[slot],
                 .positionHd = *nearest,
                 .fraction = static_cast<float>(nearest - points.begin()) / static_cast<float>(points.size() - 1),
                 .firstFraction = static_cast<float>(first - points.begin()) / static_cast<float>(points.size() - 1),
                 .apart = static_cast<float>(apart),
                 .slot = slot});
        }
        return met;
    }
    [[nodiscard]] std::vector<model::SeenStrand> crossing(std::span<const QPointF> line,
                                                          bool throughSkin) const override
    {
        return metBy(throughSkin, [line](QPointF from, QPointF to) -> std::optional<double> {
            for (std::size_t i = 1; i < line.size(); ++i) {
                QPointF at;
                if (QLineF(from, to).intersects(QLineF(line[i - 1], line[i]), &at) == QLineF::BoundedIntersection)
                    return QLineF(from, at).length() / std::max(QLineF(from, to).length(), 1e-9);
            }
            return std::nullopt;
        });
    }
    [[nodiscard]] std::vector<model::SeenStrand> inside(const QPolygonF& lasso, bool throughSkin) const override
    {
        return metBy(throughSkin, [&lasso](QPointF from, QPointF to) -> std::optional<double> {
            for (const double part : {0.0, 0.5, 1.0})
                if (lasso.containsPoint(from + (to - from) * part, Qt::OddEvenFill))
                    return part;
            return std::nullopt;
        });
    }
    [[nodiscard]] std::shared_ptr<const SeenHair> held() const override { return std::make_shared<SideView>(m_frame); }
    [[nodiscard]] const sim::GroupFrame* hair() const override { return &m_frame->groups.front(); }

private:
    template<class Meets>
    [[nodiscard]] std::vector<model::SeenStrand> metBy(bool throughSkin, const Meets& meets) const
    {
        std::vector<model::SeenStrand> met;
        const sim::GroupFrame& hair = m_frame->groups.front();
        for (std::uint32_t slot = 0; slot < hair.groom->roots->count(); ++slot) {
            if (!hair.isPositioned(slot) || (!throughSkin && hair.groom->roots->positionHd[slot].x < 0.0F))
                continue;
            const std::vector<glm::vec3> points = drawnPoints(hair, slot);
            model::SeenStrand strand{.slot = slot};
            bool found = false;
            for (std::size_t i = 1; i < points.size(); ++i) {
                const float stepM = glm::distance(points[i - 1], points[i]);
                if (!found) {
                    if (const auto part = meets(seen(points[i - 1]), seen(points[i]))) {
                        found = true;
                        strand.fraction = (static_cast<float>(i - 1) + static_cast<float>(*part)) /
                                          static_cast<float>(points.size() - 1);
                        strand.alongM = strand.lengthM + stepM * static_cast<float>(*part);
                        strand.positionHd = points[i - 1] + (points[i] - points[i - 1]) * static_cast<float>(*part);
                    }
                }
                strand.lengthM += stepM;
            }
            if (found)
                met.push_back(strand);
        }
        return met;
    }

    std::shared_ptr<const sim::StrandFrame> m_frame;
};

} // namespace hairpaint::test
