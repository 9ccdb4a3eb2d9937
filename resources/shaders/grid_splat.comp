// Adds the hair's area to the voxels of both opacity grids. Each point is moved by up to half a voxel at random (the same
// for the same strand), which over many strands is a smooth splat for the price of one. One invocation a strand.
layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly buffer Strands { DrawnStrand strands[]; };
layout(std430, binding = 2) readonly buffer Skeletons { float skeletons[]; };
layout(std430, binding = 3) buffer Voxels { uint voxels[]; };

uniform uint strandCount;
uniform uint strandStep; // Every how many-th strand is splatted.
uniform int nodes;
uniform int gridSide;
uniform float weight; // Voxel units for a metre of hair.

vec3 node(uint slot, int k)
{
    uint x = nodeIndex(slot, k, nodes);
    return vec3(skeletons[x], skeletons[x + kStrandLanes], skeletons[x + 2u * kStrandLanes]);
}

// Voxels of the eye's grid; w: distance along the view, m.
vec4 eyeVoxels(vec3 wo)
{
    vec4 clip = projectionFromWo * vec4(wo, 1.0);
    return vec4(inEyeGrid(vec3(clip.xy / max(clip.w, 1e-3), clip.w)) * float(gridSide), clip.w);
}

void main()
{
    uint strand = gl_GlobalInvocationID.x * strandStep;
    if (strand >= strandCount)
        return;
    uint slot = strands[strand].slot;
    vec3 a = node(slot, 0);
    for (int k = 1; k < nodes; ++k) {
        vec3 b = node(slot, k);
        float lengthM = distance(a, b);
        vec3 from0 = (gridFromWo[0] * vec4(a, 1.0)).xyz * float(gridSide);
        vec3 to0 = (gridFromWo[0] * vec4(b, 1.0)).xyz * float(gridSide);
        vec4 seenA = eyeVoxels(a);
        vec4 seenB = eyeVoxels(b);
        vec3 from1 = seenA.xyz;
        vec3 to1 = seenB.xyz;
        int steps = clamp(int(min(max(distance(from0, to0), distance(from1, to1)), 31.0)) + 1, 1, 32);
        float area = lengthM * weight / float(steps);
        uint add = uint(area + 0.5);
        // A column widens with the distance. What no ray of the picture meets hides nothing.
        float nearer = 2.0 * eyeGrid[1].w / max(seenA.w + seenB.w, 1e-2);
        vec2 middle = 0.5 * (from1.xy + to1.xy);
        bool met = all(greaterThan(middle, vec2(0.0))) && all(lessThan(middle, vec2(gridSide))) && min(seenA.w, seenB.w) > 0.01;
        uint addSeen = met ? uint(min(area * nearer * nearer, 1e6) + 0.5) : 0u;
        for (int n = 0; n < steps; ++n) {
            uint random = hashOf(slot * 64u + uint(k * 8 + n));
            vec3 jitter = vec3(random & 0x3FFu, (random >> 10) & 0x3FFu, (random >> 20) & 0x3FFu) * (1.0 / 1024.0) - 0.5;
            float t = (float(n) + 0.5) / float(steps);
            ivec3 at = clamp(ivec3(mix(from0, to0, t) + jitter), ivec3(0), ivec3(gridSide - 1));
            atomicAdd(voxels[(at.z * gridSide + at.y) * gridSide + at.x], add);
            at = ivec3(clamp(mix(from1, to1, t) + jitter, vec3(0.0), vec3(gridSide - 1)));
            atomicAdd(voxels[((gridSide + at.z) * gridSide + at.y) * gridSide + at.x], addSeen);
        }
        a = b;
    }
}
