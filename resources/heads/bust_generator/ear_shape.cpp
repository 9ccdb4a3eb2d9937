// The ear: a plate with a bowl (concha), on whose outer face ridges (helix, antihelix with its two legs) and hollows
// are raised and sunk, in the ear's own frame.
//
// Ridges displace the distance instead of being tubes of their own: tubes undercut, and the mesh folds in the undercut.
#include <array>
#include <span>
#include <vector>

#include "bust_shape.h"
#include "sdf_primitives.h"

namespace hairpaint::heads {

namespace {

struct Bead
{
    glm::vec2 position; // x backwards, y up
    float height;       // m, negative for a furrow
};

// From inside the bowl up the front, over the top and down the back to the lobe.
constexpr std::array<Bead, 12> helix = {{{{-0.0040F, -0.0012F}, 0.0002F},
                                         {{-0.0105F, 0.0010F}, 0.0016F},
                                         {{-0.0135F, 0.0085F}, 0.0021F},
                                         {{-0.0115F, 0.0180F}, 0.0024F},
                                         {{-0.0060F, 0.0245F}, 0.0026F},
                                         {{0.0020F, 0.0270F}, 0.0027F},
                                         {{0.0095F, 0.0240F}, 0.0027F},
                                         {{0.0138F, 0.0160F}, 0.0027F},
                                         {{0.0147F, 0.0055F}, 0.0026F},
                                         {{0.0132F, -0.0060F}, 0.0020F},
                                         {{0.0085F, -0.0170F}, 0.0011F},
                                         {{0.0040F, -0.0230F}, 0.0004F}}};
constexpr std::array<Bead, 5> furrow = {{{{-0.0020F, 0.0222F}, -0.0006F},
                                         {{0.0060F, 0.0205F}, -0.0015F},
                                         {{0.0108F, 0.0120F}, -0.0019F},
                                         {{0.0115F, 0.0020F}, -0.0019F},
                                         {{0.0090F, -0.0090F}, -0.0006F}}};
constexpr std::array<Bead, 6> antihelix = {{{{-0.0065F, -0.0165F}, 0.0020F},
                                            {{0.0005F, -0.0160F}, 0.0019F},
                                            {{0.0058F, -0.0095F}, 0.0025F},
                                            {{0.0073F, 0.0000F}, 0.0029F},
                                            {{0.0060F, 0.0080F}, 0.0027F},
                                            {{0.0050F, 0.0165F}, 0.0013F}}};
constexpr std::array<Bead, 3> lowerLeg = {
    {{{0.0060F, 0.0075F}, 0.0023F}, {{0.0000F, 0.0102F}, 0.0022F}, {{-0.0065F, 0.0108F}, 0.0013F}}};

// Catmull-Rom through the beads, so that a ridge shows no corners.
std::vector<Bead> smoothed(std::span<const Bead> beads)
{
    constexpr int steps = 8;
    std::vector<Bead> fine;
    for (std::size_t i = 0; i + 1 < beads.size(); ++i) {
        const glm::vec2 p1 = beads[i].position;
        const glm::vec2 p2 = beads[i + 1].position;
        const glm::vec2 p0 = i > 0 ? beads[i - 1].position : p1;
        const glm::vec2 p3 = i + 2 < beads.size() ? beads[i + 2].position : p2;
        for (int k = 0; k < steps; ++k) {
            const float t = static_cast<float>(k) / static_cast<float>(steps);
            const glm::vec2 bend = t * (2.0F * p0 - 5.0F * p1 + 4.0F * p2 - p3 + t * (3.0F * (p1 - p2) + p3 - p0));
            fine.push_back({p1 + 0.5F * t * (p2 - p0 + bend), glm::mix(beads[i].height, beads[i + 1].height, t)});
        }
    }
    fine.push_back(beads.back());
    return fine;
}

// The height (or depth) of the ridge at the given position.
float ridge(const glm::vec2& position, std::span<const Bead> beads, float width)
{
    float strongest = 0.0F;
    for (std::size_t i = 0; i + 1 < beads.size(); ++i) {
        const glm::vec2 along = beads[i + 1].position - beads[i].position;
        const glm::vec2 from = position - beads[i].position;
        const float t = std::clamp(glm::dot(from, along) / glm::dot(along, along), 0.0F, 1.0F);
        const float height =
            glm::mix(beads[i].height, beads[i + 1].height, t) * bell(glm::length(from - along * t), width);
        if (std::abs(height) > std::abs(strongest))
            strongest = height;
    }
    return strongest;
}

constexpr float scale = 0.95F; // of the ear's own lengths

// Leaning back by 7 degrees, the lobe's position in front adding as much; rear edge 33 degrees away from the head's
// middle plane. In the ear's own lengths.
glm::vec3 toEar(const glm::vec3& folded)
{
    const glm::vec3 q = turnedX(folded - glm::vec3(0.0725F, -0.0140F, -0.0100F), 7.0F);
    const float c = std::cos(glm::radians(33.0F));
    const float s = std::sin(glm::radians(33.0F));
    return glm::vec3(s * q.x - c * q.z, q.y, c * q.x + s * q.z) / scale;
}

float ear(const glm::vec3& e)
{
    float d = ellipsoid(e, {0.0005F, 0.0010F, -0.0012F}, {0.0172F, 0.0290F, 0.0062F});
    d = smoothMin(d, ellipsoid(e, {-0.0055F, -0.0255F, -0.0003F}, {0.0078F, 0.0090F, 0.0044F}), 0.007F);
    d = smoothMax(d, -ellipsoid(e, {-0.0040F, -0.0055F, 0.0062F}, {0.0088F, 0.0112F, 0.0082F}), 0.005F);
    const float outside = smoothStep(-0.0065F, 0.0030F, e.z);
    static const std::vector<Bead> rim = smoothed(helix);
    static const std::vector<Bead> groove = smoothed(furrow);
    static const std::vector<Bead> fold = smoothed(antihelix);
    const glm::vec2 position(e);
    d -= outside * (ridge(position, rim, 0.0034F) + ridge(position, groove, 0.0024F));
    d -= outside * std::max(ridge(position, fold, 0.0030F), ridge(position, lowerLeg, 0.0025F));
    d = smoothMin(d, ellipsoid(e, {-0.0132F, -0.0070F, 0.0026F}, {0.0040F, 0.0062F, 0.0042F}), 0.005F);
    // The root that ties the shell to the skull.
    return smoothMin(d, ellipsoid(e, {-0.0035F, -0.0035F, -0.0095F}, {0.0130F, 0.0265F, 0.0105F}), 0.010F);
}

} // namespace

float joinEar(float d, const MirroredPoint& p, float growth)
{
    const glm::vec3& f = p.folded;
    if (growth <= 0.0F || f.x < 0.040F || f.y > 0.050F || f.y < -0.080F || std::abs(f.z + 0.01F) > 0.060F)
        return d;
    const glm::vec3 e = toEar(f);
    float shape = growth > 0.5F ? ear(e) : 0.0F;
    if (growth < 1.0F) {
        const float slide = -0.030F * (1.0F - smoothStep(0.0F, 0.5F, growth));
        const float block = ellipsoid(e, {-0.0010F, -0.0010F, -0.0060F + slide}, {0.0185F, 0.0320F, 0.0145F});
        const float blend = std::clamp((growth - 0.5F) * 2.0F, 0.0F, 1.0F);
        shape = growth > 0.5F ? block + (shape - block) * blend : block;
    }
    return smoothMin(d, scale * shape, 0.006F);
}

} // namespace hairpaint::heads
