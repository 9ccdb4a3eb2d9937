// Hair and heads made by hand, so that drawing is tested without groom and solver.
#pragma once

#include "sim/motion/strand_frame.h"
#include "view/rendering/scene.h"

#include <functional>
#include <memory>
#include <vector>

namespace hairpaint::testing {

/// The half axes of the head that most tests draw, m.
inline constexpr glm::vec3 kBall(0.08F, 0.11F, 0.1F);

/// One strand: its style (lengthM is set from the nodes) and its skeleton, Wo, m.
struct HandMadeStrand
{
    sim::StrandStyle style;
    glm::vec3 tangentHd{1.0F, 0.0F, 0.0F};
    std::vector<glm::vec3> nodesWo;
};

/// A frame with one group; every strand's detail is (i + 1/2)/n unless the style's own is below 1.
[[nodiscard]] std::shared_ptr<sim::StrandFrame> makeFrame(const std::vector<HandMadeStrand>& strands,
                                                          const sim::GroupSettings& settings = {}, int groupId = 1);

/// A straight strand of `nodes` nodes.
[[nodiscard]] HandMadeStrand straightStrand(glm::vec3 fromWo, glm::vec3 toWo, std::uint32_t colour, int nodes = 8);

/// An ellipsoid as a head.
[[nodiscard]] std::shared_ptr<const sim::HeadMesh> makeBall(glm::vec3 semiAxesM, int rings = 48);

/// What the hair on makeBall's upper half is like.
struct BallHair
{
    int hairs = 10000;
    float lengthM = 0.25F;
    float turns = 0.0F;
    float curlRadiusM = 0.0F;
    float stiffness = 0.0F; ///< 0 hangs over the ball, 1 stands along the normal.
    std::uint32_t rootColour = 0xFF1B2A3BU;
    std::uint32_t tipColour = 0xFF3A5A80U;
    int nodes = 8;
};
[[nodiscard]] std::vector<HandMadeStrand> hairOnBall(glm::vec3 semiAxesM, const BallHair& hair);

/// Nothing, seen from the front.
[[nodiscard]] rendering::Scene emptyScene();
/// A comb of upright strands before the middle of the picture, 20 cm long.
[[nodiscard]] std::vector<HandMadeStrand> comb(std::uint32_t colour, int count, float halfWidthM = 0.05F,
                                               float widthM = 1e-3F);
/// A material without shine, thinning or variation.
[[nodiscard]] sim::GroupSettings plainSettings();

} // namespace hairpaint::testing
