// Measures how skeletons bend on the picture.
#include "view/rendering/gl/smooth_segments.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace hairpaint::rendering {
namespace {

constexpr std::size_t kBlocksMeasured = 64;
constexpr float kMostBends = 0.98F; ///< Fraction of the measured bends that are drawn round enough.
constexpr float kNearestM = 0.05F;
constexpr std::array kSteps{1, 2, 3, 4, 6, 8, 12, 16};

int steppedUp(float wanted)
{
    for (const int step : kSteps)
        if (static_cast<float>(step) >= wanted)
            return step;
    return kSteps.back();
}

} // namespace

SegmentsWanted segmentsWanted(const sim::GroupFrame& group, const FrameConstants& constants, float toleranceSp)
{
    const sim::Groom& groom = *group.groom;
    const auto nodes = static_cast<std::size_t>(groom.nodes);
    const sim::StrandBlocks layout = groom.blocks();
    const auto perM = [&](glm::vec3 wo) {
        return constants.gridSize.z / std::max((constants.projectionFromWo * glm::vec4(wo, 1.0F)).w, kNearestM);
    };
    std::size_t blocks = 0;
    group.forEachPositionedBlock([&](std::size_t) { ++blocks; });
    const std::size_t step = std::max<std::size_t>(1, blocks / kBlocksMeasured);
    std::size_t number = 0;
    std::vector<float> bends; // Twice the distance of a node from the middle of its neighbours, samples.
    float nearest = 0.0F;
    group.forEachPositionedBlock([&](std::size_t block) {
        if (number++ % step != 0)
            return;
        for (std::size_t strand = block * sim::kLanes; strand < (block + 1) * sim::kLanes; ++strand) {
            const auto node = [&](std::size_t k) { return layout.node(group.positions, strand, k); };
            if (node(0) == glm::vec3(0.0F))
                continue;
            nearest = std::max(nearest, perM(node(nodes - 1)));
            for (std::size_t k = 1; k + 1 < nodes; ++k)
                bends.push_back(glm::length(node(k - 1) - 2.0F * node(k) + node(k + 1)) * perM(node(k)));
        }
    });
    SegmentsWanted wanted{.ofStraightHair = groom.nodes - 1, .curlFactor = 1};
    if (!bends.empty()) {
        const auto most =
            bends.begin() + static_cast<std::ptrdiff_t>(static_cast<float>(bends.size() - 1) * kMostBends);
        std::nth_element(bends.begin(), most, bends.end());
        // n segments of a span whose ends have second differences d lie d / 8 n^2 beside it.
        wanted.ofStraightHair *= steppedUp(std::sqrt(*most / (8.0F * toleranceSp)));
    }
    float radiusM = 0.0F;
    for (const auto& chunk : groom.chunks)
        if (chunk)
            for (std::size_t slot = 0; slot < sim::kChunkSlots; slot += sim::kLanes)
                radiusM = std::max(
                    radiusM,
                    std::max(
                        {chunk->styles[slot].frizzM,
                         chunk->styles[slot].turns > 0.0F ? chunk->styles[slot].curlRadiusM : 0.0F,
                         chunk->styles[slot].braid != sim::BraidKind::None ? chunk->styles[slot].braidRadiusM : 0.0F}));
    // The chord of an eighth of a circle lies 0.077 of its radius inside it.
    constexpr float kChord = 0.077F;
    wanted.curlFactor = std::min(steppedUp(std::sqrt(radiusM * nearest * kChord / toleranceSp)), 4);
    return wanted;
}

} // namespace hairpaint::rendering
