// Neck, shoulders and chest, cut like a display piece: the arms by leaning planes, the chest by a bowl.
#include "bust_shape.h"
#include "sdf_primitives.h"

namespace hairpaint::heads {

namespace {

// Collar bones and the notch between them.
float collarRelief(const MirroredPoint& p)
{
    const float x = p.folded.x;
    const float t = std::clamp((x - 0.014F) / 0.115F, 0.0F, 1.0F);
    const float bone = -0.1985F + 0.012F * t + 0.004F * std::sin(glm::radians(360.0F) * t);
    const float front = smoothStep(-0.050F, 0.000F, p.plain.z);
    const float boneSpan = smoothStep(0.006F, 0.024F, x) * (1.0F - smoothStep(0.080F, 0.125F, x));
    const float hollowSpan = smoothStep(0.028F, 0.050F, x) * (1.0F - smoothStep(0.085F, 0.120F, x));
    float relief = 0.0030F * bell(p.plain.y - bone, 0.0085F) * boneSpan * front;
    relief -= 0.0016F * bell(p.plain.y - bone - 0.018F, 0.0110F) * hollowSpan * front;
    return relief - 0.0035F * bell(p.plain, {0.0F, -0.1950F, 0.0160F}, {0.0110F, 0.0110F, 0.0300F});
}

} // namespace

float joinNeck(float d, const MirroredPoint& p)
{
    // Column, the muscle from behind the ear to the collar bone, throat, the two cords of the nape.
    float neck = roundCone(p.plain, {0.0F, -0.0400F, -0.0240F}, {0.0F, -0.1850F, -0.0450F}, 0.0515F, 0.0560F);
    neck = smoothMin(
        neck, roundCone(p.soft, {0.0490F, -0.0300F, -0.0220F}, {0.0110F, -0.1920F, 0.0100F}, 0.0100F, 0.0080F), 0.026F);
    neck = smoothMin(neck, roundCone(p.plain, {0.0F, -0.1050F, 0.0060F}, {0.0F, -0.1800F, -0.0020F}, 0.0150F, 0.0160F),
                     0.030F);
    neck = smoothMin(neck,
                     roundCone(p.soft, {0.0180F, -0.0350F, -0.0560F}, {0.0210F, -0.1500F, -0.0620F}, 0.0180F, 0.0220F),
                     0.026F);
    return smoothMin(d, neck, 0.026F);
}

float joinTrunk(float d, const MirroredPoint& p)
{
    if (p.plain.y > -0.080F)
        return d;
    // Ribcage, the muscles from the neck to the shoulders, the chest, the shoulders themselves.
    float trunk = ellipsoid(p.plain, {0.0F, -0.2650F, -0.0440F}, {0.1180F, 0.0950F, 0.0760F});
    trunk = smoothMin(trunk,
                      roundCone(p.soft, {0.0150F, -0.1480F, -0.0640F}, {0.1240F, -0.2160F, -0.0520F}, 0.0220F, 0.0330F),
                      0.060F);
    trunk = smoothMin(trunk,
                      roundCone(p.soft, {0.0350F, -0.2220F, -0.0080F}, {0.1200F, -0.2200F, -0.0380F}, 0.0280F, 0.0320F),
                      0.050F);
    trunk = smoothMin(trunk,
                      roundCone(p.soft, {0.1320F, -0.2200F, -0.0460F}, {0.1360F, -0.3000F, -0.0440F}, 0.0370F, 0.0340F),
                      0.045F);
    const glm::vec3 outward = glm::normalize(glm::vec3(1.0F, -0.28F, 0.0F));
    trunk = smoothMax(trunk, glm::dot(p.soft - glm::vec3(0.1420F, -0.2200F, 0.0F), outward), 0.026F);
    trunk = smoothMax(trunk, ellipsoid(p.plain, {0.0F, -0.1700F, -0.0420F}, {0.1850F, 0.1560F, 0.1300F}), 0.026F);
    d = smoothMin(d, trunk, 0.045F);
    return d - collarRelief(p);
}

} // namespace hairpaint::heads
