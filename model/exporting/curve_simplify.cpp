// Divides at the farthest point until none lies too far away.
#include "model/exporting/curve_simplify.h"

namespace hairpaint::model {

namespace {

float squaredFromSegment(const glm::vec3& point, const glm::vec3& from, const glm::vec3& to)
{
    const glm::vec3 along = to - from;
    const float square = glm::dot(along, along);
    const float at = square > 0.0F ? glm::clamp(glm::dot(point - from, along) / square, 0.0F, 1.0F) : 0.0F;
    const glm::vec3 away = point - (from + at * along);
    return glm::dot(away, away);
}

} // namespace

void keptPoints(std::span<const glm::vec3> points, float tolerance, std::vector<std::uint16_t>& kept)
{
    kept.clear();
    if (points.empty())
        return;
    kept.push_back(0);
    // Ends of the pieces to come, the nearest last.
    std::vector<std::uint16_t> ends;
    ends.push_back(static_cast<std::uint16_t>(points.size() - 1));
    while (!ends.empty()) {
        const std::uint16_t begin = kept.back();
        const std::uint16_t end = ends.back();
        float greatest = tolerance * tolerance;
        std::uint16_t farthest = begin;
        for (auto i = static_cast<std::uint16_t>(begin + 1U); i < end; ++i) {
            const float distance = squaredFromSegment(points[i], points[begin], points[end]);
            if (distance > greatest) {
                greatest = distance;
                farthest = i;
            }
        }
        if (farthest != begin) {
            ends.push_back(farthest);
            continue;
        }
        if (end != begin)
            kept.push_back(end);
        ends.pop_back();
    }
}

} // namespace hairpaint::model
