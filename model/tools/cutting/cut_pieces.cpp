// Ends of drawn curves.
#include "model/tools/cutting/cut_pieces.h"

#include "sim/groom/strand_curve.h"

#include <algorithm>

namespace hairpaint::model {

namespace {

/// Range of a whole hair's segments: pieces are seen for half a second.
constexpr int kFewestSegments = 8, kMostSegments = 48;

} // namespace

std::vector<CutPiece> cutPieces(const sim::GroupFrame& hair, const glm::quat& rotation, std::span<const StrandCut> cuts,
                                std::size_t most)
{
    const sim::Groom& groom = *hair.groom;
    const sim::CurlSettings* coils = sim::coilsOf(groom.settings);
    const std::size_t step = std::max<std::size_t>((cuts.size() + most - 1) / std::max<std::size_t>(most, 1), 1);
    std::vector<CutPiece> pieces;
    std::vector<glm::vec3> nodes(static_cast<std::size_t>(groom.nodes));
    std::vector<glm::vec3> points;
    for (std::size_t i = 0; i < cuts.size(); i += step) {
        const std::uint32_t slot = cuts[i].slot;
        const sim::StrandStyle& style = groom.style(slot);
        const int segments = std::clamp(sim::segmentsOf(style, groom.nodes, coils), kFewestSegments, kMostSegments);
        groom.blocks().read(hair.positions, groom.frameStrand(slot), nodes);
        sim::evaluateStrand(nodes, rotation * sim::frameTangentHd(groom, slot), style, segments, points, coils);
        const float along = std::clamp(cuts[i].kept, 0.0F, 1.0F) * static_cast<float>(segments);
        const auto first = std::min(static_cast<std::size_t>(along), points.size() - 2);
        points[first] = glm::mix(points[first], points[first + 1], along - static_cast<float>(first));
        pieces.push_back({.pointsWo = {points.begin() + static_cast<std::ptrdiff_t>(first), points.end()},
                          .colour = style.tipColour});
    }
    return pieces;
}

} // namespace hairpaint::model
