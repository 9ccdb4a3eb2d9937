// The face's bones and flesh, and the closed eyes.
#include "bust_shape.h"
#include "sdf_primitives.h"

namespace hairpaint::heads {

namespace {

float jaw(const glm::vec3& soft)
{
    const float body = roundCone(soft, {0.0390F, -0.0640F, 0.0100F}, {0.0085F, -0.0985F, 0.0665F}, 0.0110F, 0.0122F);
    const float ramus = roundCone(soft, {0.0460F, -0.0180F, 0.0020F}, {0.0390F, -0.0640F, 0.0100F}, 0.0120F, 0.0110F);
    return smoothMin(body, ramus, 0.030F);
}

// Soft and rising outward: a frown would shade the eyes.
float browBone(const glm::vec3& soft)
{
    const float inner = roundCone(soft, {0.0080F, 0.0190F, 0.0755F}, {0.0300F, 0.0225F, 0.0705F}, 0.0065F, 0.0070F);
    const float outer = roundCone(soft, {0.0300F, 0.0220F, 0.0710F}, {0.0480F, 0.0120F, 0.0480F}, 0.0070F, 0.0075F);
    return smoothMin(inner, outer, 0.014F);
}

// In the eye's frame x runs outward from the middle of the face, z out of the lid.
glm::vec3 inEye(const MirroredPoint& p)
{
    return turnedY(p.folded - glm::vec3(0.0315F, -0.0005F, 0.0625F), -9.0F);
}

// The lids meet in an arc that hangs below the ball's middle and ends in two corners, the outer a little higher.
// `t` is 1 at the corners.
constexpr float kEyeHalf = 0.0160F;
float slit(float x, float t)
{
    return -0.0056F + 0.0040F * t * t + 0.045F * x;
}

// The crease above the lid runs from kCreaseLow over the slit at the corners to kCreaseRise more in the middle.
constexpr float kCreaseLow = 0.0040F;
constexpr float kCreaseRise = 0.0090F;
float creaseArc(float t)
{
    return std::max(1.0F - 0.75F * t * t, 0.0F);
}

} // namespace

float joinFace(float d, const MirroredPoint& p)
{
    const glm::vec3& soft = p.soft;
    // From the brow to the chin, the jaw, the floor of the mouth.
    d = smoothMin(d, ellipsoid(p.plain, {0.0F, -0.0280F, 0.0300F}, {0.0510F, 0.0730F, 0.0550F}), 0.045F);
    d = smoothMin(d, jaw(soft), 0.040F);
    d = smoothMin(d, ellipsoid(p.plain, {0.0F, -0.0830F, 0.0320F}, {0.0340F, 0.0210F, 0.0430F}), 0.028F);
    // Cheekbone, the arch that runs back from it, the flesh below, the temple.
    d = smoothMin(d, ellipsoid(soft, {0.0390F, -0.0240F, 0.0510F}, {0.0190F, 0.0170F, 0.0200F}), 0.030F);
    d = smoothMin(d, roundCone(soft, {0.0470F, -0.0210F, 0.0410F}, {0.0550F, -0.0120F, 0.0020F}, 0.0085F, 0.0080F),
                  0.030F);
    d = smoothMin(d, ellipsoid(soft, {0.0290F, -0.0560F, 0.0520F}, {0.0220F, 0.0330F, 0.0270F}), 0.034F);
    d = smoothMin(d, ellipsoid(soft, {0.0450F, 0.0180F, 0.0280F}, {0.0165F, 0.0330F, 0.0310F}), 0.034F);
    // Chin, muzzle, brow, the hollow of the eye socket.
    d = smoothMin(d, ellipsoid(p.plain, {0.0F, -0.0965F, 0.0720F}, {0.0160F, 0.0130F, 0.0135F}), 0.030F);
    d = smoothMin(d, ellipsoid(p.plain, {0.0F, -0.0660F, 0.0600F}, {0.0300F, 0.0270F, 0.0285F}), 0.028F);
    d = smoothMin(d, browBone(soft), 0.032F);
    const glm::vec3 socket = turnedY(soft - glm::vec3(0.0335F, -0.0020F, 0.0870F), -22.0F);
    return smoothMax(d, -ellipsoid(socket, glm::vec3(0.0F), {0.0185F, 0.0104F, 0.0106F}), 0.026F);
}

float joinEyes(float d, const MirroredPoint& p)
{
    if (p.folded.z < 0.030F || std::abs(p.folded.y) > 0.045F)
        return d;
    const glm::vec3 q = inEye(p);
    const float ball = ellipsoid(q, glm::vec3(0.0F), {0.0162F, 0.0142F, 0.0142F});
    d = smoothMin(d, ball, 0.0100F);

    const float x = q.x;
    const float t = x / kEyeHalf;
    const float above = q.y - slit(x, t);
    const float inFront = smoothStep(0.0F, 0.004F, q.z);
    const float along = (1.0F - smoothStep(0.0130F, 0.0178F, std::abs(x))) * inFront;
    d += 0.0010F * bell(above, 0.0014F) * along;
    // The upper lid lies over the lower one, its edge a little thicker.
    d -= 0.0006F * bell(above - 0.0028F, 0.0024F) * along;
    // The crease above the lid, and a trace of one below.
    const float creaseFade = (1.0F - smoothStep(0.0110F, 0.0190F, std::abs(x))) * inFront;
    d += 0.0011F * bell(above - kCreaseLow - kCreaseRise * creaseArc(t), 0.0017F) * creaseFade;
    d += 0.0003F * bell(above + 0.0068F, 0.0028F) * creaseFade;
    // The inner corner is a small pit that points at the nose.
    return d + 0.0008F * bell(q, {-0.0170F, -0.0030F, 0.0075F}, {0.0034F, 0.0026F, 0.0060F});
}

float lidsFraction(const MirroredPoint& p)
{
    const glm::vec3 q = inEye(p);
    if (q.z < 0.0F || std::abs(q.y) > 0.030F)
        return 0.0F;
    const float t = q.x / kEyeHalf;
    const float above = q.y - slit(q.x, t);
    const float upper = 1.0F - smoothStep(0.3F, 1.15F, above / (kCreaseLow + kCreaseRise * creaseArc(t)));
    const float lower = 1.0F - smoothStep(0.0F, 0.0050F, -above);
    return std::min(upper, lower) * (1.0F - smoothStep(0.0120F, 0.0195F, std::abs(q.x)));
}

} // namespace hairpaint::heads
