// Walks each strand's skeleton and adds curl and braid by sim/groom/curve_formula.inl, as sim/groom/strand_curve.h does
// on the CPU. In: skeletons, Wo, m. Out: points, Wo, m; w holds the strand's number as bits. One invocation a strand.
layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly buffer Strands { DrawnStrand strands[]; }; // One more at the end.
layout(std430, binding = 1) readonly buffer Styles { PackedStyle styles[]; };
layout(std430, binding = 2) readonly buffer Skeletons { float skeletons[]; }; // [slots / 16][nodes][3][16]
layout(std430, binding = 3) writeonly buffer Points { vec4 pointsWo[]; };

// As in sim/groom/groom.h.

uniform uint firstStrand;
uniform uint strandCount;
uniform int nodes;
uniform int isCoiled; // Curls by sim::CurlSettings, else by equation 1.
uniform vec4 coil;    // Its inStepFromM, switchbacksPerM, skips, flatness,
uniform vec2 uncoil;  // uncoil and straightM.
uniform float taperM; // StrandMaterial::taperM of the group.

vec3 node(uint slot, int k)
{
    uint x = nodeIndex(slot, k, nodes);
    return vec3(skeletons[x], skeletons[x + kStrandLanes], skeletons[x + 2u * kStrandLanes]);
}

vec3 unpackDirection(uint bits)
{
    vec2 e = unpackSnorm2x16(bits);
    vec3 v = vec3(e, 1.0 - abs(e.x) - abs(e.y));
    if (v.z < 0.0)
        v.xy = (1.0 - abs(v.yx)) * vec2(v.x >= 0.0 ? 1.0 : -1.0, v.y >= 0.0 ? 1.0 : -1.0);
    return normalize(v);
}

// The arithmetic that the formula is written in.
#define Num float
#define Vec3 vec3
#define Flag bool
#define CURVE_FUNCTION
#define least min
#define most max
#define clamped clamp
#define mixed mix
#define root sqrt
#define floored floor
#define sinOf sin
#define cosOf cos
#define vec3Of vec3

float over(float x, float constant)
{
    return x / constant;
}

bool everywhere(bool flag)
{
    return flag;
}

float select(bool yes, float a, float b)
{
    return yes ? a : b;
}

vec3 select(bool yes, vec3 a, vec3 b)
{
    return yes ? a : b;
}

vec3 unitOf(vec3 v, float squared)
{
    return v * inversesqrt(squared);
}

vec3 reflectedIn(vec3 v, vec3 axis, float squared)
{
    return v - axis * (2.0 * dot(axis, v) / squared);
}

#include "sim/groom/curve_formula.inl"

// At fraction q of a braid of so many metres.
vec3 braidedOffsetAt(uint slot, float q, float metres)
{
    uint braid = styles[slot].braid;
    BraidedHair hair;
    hair.radiusM = styles[slot].braidRadiusM;
    hair.turns = styles[slot].braidTurns;
    hair.begun = styles[slot].phase;
    hair.wispX = styles[slot].wispOffsetX;
    hair.wispY = styles[slot].wispOffsetY;
    hair.chance = styles[slot].variation;
    hair.taper = float((braid >> 16) & 0xFFu) / 255.0;
    hair.tied = float(braid >> 24) / 255.0;
    return braidedOffset(hair, float(braid & 0xFFu), float((braid >> 8) & 15u), q, metres);
}

void main()
{
    uint strand = gl_GlobalInvocationID.x;
    if (strand >= strandCount)
        return;
    strand += firstStrand;
    uint slot = strands[strand].slot;
    uint base = strands[firstStrand].firstPoint;
    uint first = strands[strand].firstPoint - base;
    int segments = int(strands[strand + 1u].firstPoint - strands[strand].firstPoint) - 1;

    float turns = styles[slot].turns;
    float radius = styles[slot].curlRadiusM;
    float phase = styles[slot].phase;
    float braidStart = styles[slot].braidStart;
    bool isBraided = (styles[slot].braid & 0xFFu) != 0u && braidStart < 1.0;
    bool isCurled = turns > 0.0 && radius > 0.0;
    bool isFrizzy = styles[slot].frizzM > 0.0;
    Frizz frizz = frizzOf(styles[slot].frizzM, styles[slot].lengthM);
    vec3 rootTangent = mat3(woFromHd) * unpackDirection(styles[slot].tangentHd);
    float perTaper = perTaperOf(styles[slot].lengthM, taperM);

    int k = 0;
    vec3 p1 = node(slot, 0);
    vec3 p2 = node(slot, 1);
    vec3 p0 = beyond(p1, p2);
    vec3 p3 = nodes > 2 ? node(slot, 2) : beyond(p2, p1);
    if ((styles[slot].braid & kTautBit) != 0u)
        p0 = beyondBent(p1, p2, p3);
    vec3 lastPoint = p1;
    vec3 lastTangent = normalize(p2 - p0);
    vec3 reference = across(rootTangent, lastTangent);
    int sharedNode = int(braidStart * float(nodes - 1) + 0.5) + 1; // The node from which on all hairs of a braid run alike.
    bool isFramed = !isBraided || sharedNode > nodes - 1;          // As it will be.
    for (int j = 0; j <= segments; ++j) {
        float s = fractionOf(j, segments, perTaper);
        float u = s * float(nodes - 1);
        int segment = min(int(u), nodes - 2);
        while (k < segment) {
            ++k;
            p0 = p1;
            p1 = p2;
            p2 = p3;
            p3 = k + 2 < nodes ? node(slot, k + 2) : beyond(p2, p1);
        }
        float t = u - float(k);
        Span span = spanOf(p0, p1, p2, p3);
        vec3 point = positionAt(span, t);
        vec3 derivative = derivativeAt(span, t);
        vec3 tangent = tangentOf(derivative, lastTangent);

        if (!isFramed && u >= float(sharedNode)) {
            isFramed = true;
            vec3 to = node(slot, sharedNode);
            vec3 onward = sharedNode < nodes - 1 ? node(slot, sharedNode + 1) - node(slot, sharedNode - 1)
                                              : 2.0 * (to - node(slot, sharedNode - 1));
            lastPoint = to;
            lastTangent = tangentOf(onward, lastTangent);
            reference = across(rootTangent, lastTangent);
        }
        reference = carried(reference, lastPoint, lastTangent, point, tangent);
        lastPoint = point;
        lastTangent = tangent;

        float gathered = 1.0 + u - braidStart * float(nodes - 1);
        if (isBraided && gathered > 0.0) {
            vec3 first = u < float(sharedNode) ? across(rootTangent, tangent) : reference;
            float metres = braidLength(length(derivative), float(nodes - 1), braidStart);
            vec3 offset = braidedOffsetAt(slot, braidFraction(s, braidStart), metres) * gatheredPart(gathered);
            point += first * offset.x + tangent * offset.y + cross(first, tangent) * offset.z;
        } else if (isCurled) {
            float curled = curledFraction(s, braidStart);
            vec3 offset;
            if (isCoiled != 0)
                offset = coilOffset(CoiledHair(turns, radius, phase, styles[slot].variation,
                                               styles[slot].lengthM * (1.0 - braidStart)),
                                    CoilTraits(coil.x, coil.y, coil.z, coil.w, uncoil.x, uncoil.y), curled);
            else
                offset = curlOffset(curlAngle(phase, turns, curled)) * curlRadius(radius, curled);
            point += reference * offset.x + cross(tangent, reference) * offset.y + tangent * offset.z;
        }
        if (isFrizzy) {
            vec3 offset = frizzOffset(frizz, styles[slot].variation, s);
            point += reference * offset.x + cross(tangent, reference) * offset.y;
        }
        pointsWo[first + uint(j)] = vec4(point, uintBitsToFloat(strand));
    }
}
