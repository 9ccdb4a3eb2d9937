// Ribbons along plane curves.
#include "model/bodies/ribbon_bow.h"

#include "model/bodies/swept_body.h"
#include "sim/base/deterministic.h"

#include <cmath>
#include <numbers>

namespace hairpaint::model {

namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kThick = 0.022F; ///< Half of the ribbon's thickness, in parts of the bow's reach.
constexpr int kCorners = 10;

/// Out from the knot and back to it, wider on its round end.
void addLoop(sim::HeadMesh& mesh, glm::vec3 at, float scale, float to)
{
    constexpr int kSteps = 40;
    std::vector<RibbonPoint> points;
    for (int i = 0; i <= kSteps; ++i) {
        const float t = 0.03F + 0.94F * static_cast<float>(i) / kSteps;
        const float out = 0.5F * (1.0F - sim::cosDet(2.0F * kPi * t));
        const float open = sim::sinDet(2.0F * kPi * t);
        points.push_back(
            {.centre = at + scale * glm::vec3(to * out, 0.16F * out, 0.14F + 0.2F * open * (0.35F + 0.65F * out)),
             .across = {0.0F, 1.0F, 0.12F * to},
             .halfWidth = scale * (0.1F + 0.24F * out)});
    }
    addRibbon(mesh, points, kThick * scale, kCorners);
}

/// Down from the knot, in a shallow wave.
HangingPart addTail(sim::HeadMesh& mesh, glm::vec3 at, float scale, float to)
{
    constexpr int kSteps = 20;
    std::vector<RibbonPoint> points;
    for (int i = 0; i <= kSteps; ++i) {
        const float t = static_cast<float>(i) / kSteps;
        points.push_back({.centre = at + scale * glm::vec3(to * (0.04F + 0.42F * t), -0.05F - 0.85F * t,
                                                           0.1F + 0.05F * sim::sinDet(5.0F * t)),
                          .across = {1.0F, 0.3F * to, 0.0F},
                          .halfWidth = scale * (0.07F + 0.09F * t)});
    }
    const auto first = static_cast<std::uint32_t>(mesh.positionsHd.size());
    addRibbon(mesh, points, kThick * scale, kCorners);
    return {.first = first, .sections = kSteps + 1, .corners = kCorners};
}

void addKnot(sim::HeadMesh& mesh, glm::vec3 at, float scale)
{
    constexpr int kSteps = 12;
    std::vector<SweptSection> sections;
    for (int i = 0; i <= kSteps; ++i) {
        const float t = 2.0F * static_cast<float>(i) / kSteps - 1.0F;
        const float round = std::sqrt(1.0F - 0.72F * t * t);
        sections.push_back({.centre = at + scale * glm::vec3(0.0F, 0.15F * t, 0.16F),
                            .side = {1.0F, 0.0F, 0.0F},
                            .up = {0.0F, 0.0F, 1.0F},
                            .halfSide = 0.13F * scale * round,
                            .halfUp = 0.14F * scale * round});
    }
    addSwept(mesh, sections, false, 20);
}

} // namespace

std::array<HangingPart, 2> addRibbonBow(sim::HeadMesh& mesh, glm::vec3 at, float scale)
{
    std::array<HangingPart, 2> tails;
    for (std::size_t side = 0; side < tails.size(); ++side) {
        const float to = side == 0 ? -1.0F : 1.0F;
        addLoop(mesh, at, scale, to);
        tails.at(side) = addTail(mesh, at, scale, to);
    }
    addKnot(mesh, at, scale);
    return tails;
}

} // namespace hairpaint::model
