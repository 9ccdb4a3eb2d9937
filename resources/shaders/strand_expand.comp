// Walks each strand's skeleton by Catmull-Rom in its rotation-minimising frame (double reflection, Wang et al. 2008) and
// adds curl (Hernandez and Rudomin 2004, equation 1) and braid (equation 3). sim/groom/strand_curve.h says the same for the CPU.
// In: skeletons, Wo, m. Out: points, Wo, m; w holds the strand's number as bits. One invocation a strand.
layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly buffer Strands { DrawnStrand strands[]; }; // One more at the end.
layout(std430, binding = 1) readonly buffer Styles { PackedStyle styles[]; };
layout(std430, binding = 2) readonly buffer Skeletons { float skeletons[]; }; // [slots / 16][nodes][3][16]
layout(std430, binding = 3) writeonly buffer Points { vec4 pointsWo[]; };

// As in sim/groom/groom.h; the curve's numbers are those of sim/groom/curve_constants.h.
const uint kTwist = 2u;
const uint kLoc = 3u;

uniform uint firstStrand;
uniform uint strandCount;
uniform int nodes;

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

vec3 perpendicular(vec3 reference, vec3 tangent)
{
    vec3 v = reference - tangent * dot(reference, tangent);
    float length2 = dot(v, v);
    if (length2 > 1e-8)
        return v * inversesqrt(length2);
    v = abs(tangent.x) < 0.7 ? vec3(1, 0, 0) : vec3(0, 1, 0);
    return normalize(v - tangent * dot(v, tangent));
}

// Along the frame's first axis, the strand and the third, at fraction q of a braid of so many metres: equation 3 for the
// wisp of a plait, a circle for that of a twist, and the hair's place in the wisp, of which a loc has one; in the end the
// wisps are tied and open into a tuft.
vec3 braidedOffset(uint slot, uint braid, float q, float metres)
{
    uint kind = braid & 0xFFu;
    float wisp = float((braid >> 8) & 3u);
    float turns = styles[slot].braidTurns;
    float tuft = kind == kLoc ? 0.0 : max(q - (1.0 - kTuftFraction), 0.0) / kTuftFraction;
    float tied = kind == kLoc ? 0.0 : smoothstep(1.0 - kTuftFraction - kTieFraction, 1.0 - kTuftFraction, q);
    float r = styles[slot].braidRadiusM * mix(kBraidFirstFraction, 1.0, min(q * turns / kBraidEaseTurns, 1.0));
    float angle = 2.0 * kPi * (turns * q + wisp / (kind == kTwist ? 2.0 : 3.0));
    float swing = kind == kTwist ? 1.0 : 2.0;
    float pathR = (kind == kLoc ? 0.0 : kind == kTwist ? kTwistFraction : 1.0) * r * mix(1.0, kTieBraidFraction, tied) * (1.0 - tuft);
    float wispFraction = kind == kLoc ? kLocWispFraction : kind == kTwist ? kTwistWispFraction : kWispRadiusFraction;
    float wispR = r * wispFraction *
                  (mix(1.0, kTieWispFraction, tied) + (kTuftWispFraction - kTieWispFraction) * tuft * (2.0 - tuft));
    // A hair's place in the wisp lies across the wisp's own path, so that wisps are round.
    float perFraction = pathR * turns * 2.0 * kPi;
    vec3 along = normalize(vec3(-sin(angle) * perFraction, max(metres, 1e-6), swing * cos(swing * angle) * perFraction));
    float aside = length(along.yz);
    vec2 wispOffset = vec2(styles[slot].wispOffsetX, styles[slot].wispOffsetY);
    vec2 place = wispOffset * wispR;
    float shorter = metres * kTuftFraction * kTuftUneven * tuft * dot(wispOffset, wispOffset);
    // Along the braid they have the room that their number leaves.
    float room = metres * (kind == kTwist ? kTwistRoomTurns : kPlaitRoomTurns) / max(turns, 1e-3);
    float squash = min(1.0, room / max(wispR, 1e-6));
    return vec3(cos(angle), 0.0, sin(swing * angle)) * pathR +
           vec3(place.x * aside, -(place.x * along.x * along.y + place.y * along.z) / aside * squash - shorter,
                (place.y * along.y - place.x * along.x * along.z) / aside);
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
    uint braid = styles[slot].braid;
    float braidStart = styles[slot].braidStart;
    bool isBraided = (braid & 0xFFu) != 0u && braidStart < 1.0;
    bool isCurled = turns > 0.0 && radius > 0.0;
    vec3 rootTangent = mat3(woFromHd) * unpackDirection(styles[slot].tangentHd);
    float inverseSegments = 1.0 / float(segments);

    int k = 0;
    vec3 p1 = node(slot, 0);
    vec3 p2 = node(slot, 1);
    vec3 p0 = 2.0 * p1 - p2;
    vec3 p3 = nodes > 2 ? node(slot, 2) : 2.0 * p2 - p1;
    vec3 lastPoint = p1;
    vec3 lastTangent = normalize(p2 - p0);
    vec3 reference = perpendicular(rootTangent, lastTangent);
    int sharedNode = int(braidStart * float(nodes - 1) + 0.5) + 1; // The node from which on all hairs of a braid run alike.
    bool isFramed = !isBraided || sharedNode > nodes - 1;          // As it will be.
    for (int j = 0; j <= segments; ++j) {
        float s = float(j) * inverseSegments;
        float u = s * float(nodes - 1);
        int segment = min(int(u), nodes - 2);
        while (k < segment) {
            ++k;
            p0 = p1;
            p1 = p2;
            p2 = p3;
            p3 = k + 2 < nodes ? node(slot, k + 2) : 2.0 * p2 - p1;
        }
        float t = u - float(k);
        vec3 c1 = 0.5 * (p2 - p0);
        vec3 c2 = p0 - 2.5 * p1 + 2.0 * p2 - 0.5 * p3;
        vec3 c3 = 0.5 * (p3 - p0) + 1.5 * (p1 - p2);
        vec3 point = p1 + t * (c1 + t * (c2 + t * c3));
        vec3 tangent = c1 + t * (2.0 * c2 + 3.0 * t * c3);
        float length2 = dot(tangent, tangent);
        tangent = length2 > 1e-16 ? tangent * inversesqrt(length2) : lastTangent;

        if (!isFramed && u >= float(sharedNode)) {
            isFramed = true;
            vec3 to = node(slot, sharedNode);
            vec3 onward = sharedNode < nodes - 1 ? node(slot, sharedNode + 1) - node(slot, sharedNode - 1)
                                              : 2.0 * (to - node(slot, sharedNode - 1));
            lastPoint = to;
            lastTangent = dot(onward, onward) > 1e-16 ? normalize(onward) : lastTangent;
            reference = perpendicular(rootTangent, lastTangent);
        }
        vec3 v1 = point - lastPoint;
        float d1 = dot(v1, v1);
        if (d1 > 1e-16) {
            vec3 r = reference - v1 * (2.0 * dot(v1, reference) / d1);
            vec3 tl = lastTangent - v1 * (2.0 * dot(v1, lastTangent) / d1);
            vec3 v2 = tangent - tl;
            float d2 = dot(v2, v2);
            reference = d2 > 1e-16 ? r - v2 * (2.0 * dot(v2, r) / d2) : r;
        }
        lastPoint = point;
        lastTangent = tangent;

        float gathered = 1.0 + u - braidStart * float(nodes - 1);
        if (isBraided && gathered > 0.0) {
            vec3 across = u < float(sharedNode) ? perpendicular(rootTangent, tangent) : reference;
            float metres = sqrt(length2) * float(nodes - 1) * (1.0 - braidStart);
            float q = max(s - braidStart, 0.0) / (1.0 - braidStart);
            vec3 offset = braidedOffset(slot, braid, q, metres) * min(gathered, 1.0);
            point += across * offset.x + tangent * offset.y + cross(across, tangent) * offset.z;
        } else if (isCurled) {
            float angle = phase + 2.0 * kPi * turns * s;
            float c = cos(angle);
            float n = sin(angle);
            float r = radius * min(1.0, s / kCurlEaseFraction);
            point += r * (c * reference + n * cross(tangent, reference) + c * n * tangent);
        }
        pointsWo[first + uint(j)] = vec4(point, uintBitsToFloat(strand));
    }
}
