// A ball whose hair is tied.
#pragma once

#include "groom_reading.h"
#include "sim/groom/gathered_path.h"
#include "sim/groom/strand_curve.h"
#include "sim/motion/simulation.h"
#include "tests/support/painted_ball.h"

#include <cmath>
#include <functional>

namespace hairpaint::test::tied {

using namespace hairpaint::sim;

inline constexpr float kBallM = 0.1F;
inline constexpr float kRingM = 0.008F;
inline constexpr float kStandsM = 0.01F; ///< Height of the ring over the skin.

inline Tie tieAt(std::uint16_t number, glm::vec3 direction, glm::vec3 through = {0.0F, 0.3F, -1.0F})
{
    const glm::vec3 out = glm::normalize(direction);
    return {.number = number,
            .pointHd = out * (kBallM + kStandsM),
            .directionHd = glm::normalize(through),
            .radiusM = kRingM};
}

/// A ball whose upper half, and some, is gathered behind the crown.
inline GroomInput tiedBall(int hairs = 6000, float lengthM = 0.4F)
{
    GroomInput input = paintedBall(hairs, 400);
    GroomInput::Group& group = input.groups.front();
    group.settings.greatestLengthM = lengthM;
    group.ties = {tieAt(1, {0.0F, 0.6F, -0.8F})};
    group.gathered = mapOfTexel(1, {0});
    paintSquare(group.gathered, {0.0F, 0.45F}, {1.0F, 1.0F}, 1);
    return input;
}

inline std::shared_ptr<const Groom> groomed(const GroomInput& input)
{
    return GroomBuilder().update(input).grooms.front();
}

template<typename Visit>
void forEachGathered(const Groom& groom, const Visit& visit)
{
    forEachHair(groom, [&](std::uint32_t slot, const StrandStyle& style) {
        const StrandChunk& chunk = *groom.chunks[chunkOf(slot)];
        if (chunk.gathered[inChunk(slot)])
            visit(slot, style, chunk.tailed[inChunk(slot)]);
    });
}

inline std::vector<glm::vec3> drawn(const Groom& groom, std::uint32_t slot, std::span<const glm::vec3> nodes,
                                    int segments = 84)
{
    std::vector<glm::vec3> points;
    evaluateStrand(nodes, frameTangentHd(groom, slot), groom.style(slot), segments, points, coilsOf(groom.settings));
    return points;
}

inline std::vector<glm::vec3> restNodes(const Groom& groom, std::uint32_t slot)
{
    std::vector<glm::vec3> nodes;
    nodes.reserve(static_cast<std::size_t>(groom.nodes));
    for (int node = 0; node < groom.nodes; ++node)
        nodes.push_back(restNode(groom, slot, node));
    return nodes;
}

inline std::vector<glm::vec3> frameNodes(const GroupFrame& frame, std::uint32_t slot)
{
    std::vector<glm::vec3> nodes(static_cast<std::size_t>(frame.groom->nodes));
    frame.groom->blocks().read(frame.positions, frame.groom->frameStrand(slot), nodes);
    return nodes;
}

inline float lengthOfLine(std::span<const glm::vec3> points)
{
    float length = 0.0F;
    for (std::size_t i = 1; i < points.size(); ++i)
        length += glm::length(points[i] - points[i - 1]);
    return length;
}

/// Length of a taut string over the ball to a point above it, m: along a great circle, then straight.
inline float tautOverBall(glm::vec3 root, glm::vec3 end)
{
    const float angle = std::acos(std::clamp(glm::dot(glm::normalize(root), glm::normalize(end)), -1.0F, 1.0F));
    const float height = glm::length(end);
    const float straight = std::acos(kBallM / height);
    if (angle <= straight)
        return glm::length(root - end);
    return kBallM * (angle - straight) + std::sqrt(height * height - kBallM * kBallM);
}

inline GroupFrame frameOf(const Simulation& simulation)
{
    StrandFrame frame;
    simulation.writeFrame(frame);
    return std::move(frame.groups.front());
}

} // namespace hairpaint::test::tied
