// Lays the hair of a tile over it, from the nearest on, with the coverage it has: sorts the tile's segments by depth,
// then has each invocation see to one sample until nothing can be seen through there. One workgroup a tile.
layout(local_size_x = 8, local_size_y = 8) in;

layout(std430, binding = 0) readonly buffer Projected { uvec4 projected[]; };
layout(std430, binding = 1) readonly buffer Counts { uint counts[]; };
layout(std430, binding = 2) readonly buffer Begins { uint begins[]; };
layout(std430, binding = 3) readonly buffer Entries { uvec2 entries[]; };
layout(std430, binding = 4) coherent buffer Sorted { uvec2 sorted[]; };
layout(binding = 2) uniform sampler2D headDepth;
layout(binding = 3) uniform sampler2D wornMask; // 1 where what is worn is seen.
layout(rgba16f, binding = 0) writeonly uniform image2D hairSeen; // Light; what is left to see through.

uniform ivec2 tiles;
uniform int firstRow;  // First row of tiles.
uniform uint capacity; // Number of entries that there is room for.
uniform float opaque;  // A sample counts as opaque where less than this is left to see through.

const uint kLanes = 64u;
const uint kBins = 512u;
// Depth below the skin to which hair is shown: hair that lies flat dips in here and there.
const float kSkinDepthM = 0.015;
// What is worn hides the hair that it presses down.
const float kWornDepthM = 0.0005;

shared uint bins[kBins];
shared uint sums[kLanes];
shared uint nearest;
shared uint farthest;
shared uint open;
// Segments along their main direction: begin and end, position across it and its slope;
shared vec4 lines[kLanes];
shared vec4 widthsAndDepths[kLanes]; // width, depth and their slopes;
shared vec4 lights[kLanes];          // light; w: 1 where the main direction is up;
shared vec4 lightSteps[kLanes];

bool isBefore(uvec2 a, uvec2 b)
{
    return a.x < b.x || (a.x == b.x && a.y < b.y);
}

// Shell's sort with Ciura's gaps: most bins hold a few, but hair may well lie all at one depth.
void sortBin(uint begin, uint end)
{
    const uint kGaps[8] = uint[](701u, 301u, 132u, 57u, 23u, 10u, 4u, 1u);
    for (int g = 0; g < 8; ++g) {
        uint gap = kGaps[g];
        for (uint i = begin + gap; i < end; ++i) {
            uvec2 entry = sorted[i];
            uint to = i;
            for (; to >= begin + gap && isBefore(entry, sorted[to - gap]); to -= gap)
                sorted[to] = sorted[to - gap];
            sorted[to] = entry;
        }
    }
}

// Sorts by depth, and where that is equal by number, so that the same scene gives the same picture.
void sortEntries(uint first, uint count, uint lane)
{
    if (lane == 0u) {
        nearest = 0xFFFFu;
        farthest = 0u;
    }
    for (uint b = lane; b < kBins; b += kLanes)
        bins[b] = 0u;
    barrier();
    uint low = 0xFFFFu;
    uint high = 0u;
    for (uint i = lane; i < count; i += kLanes) {
        uint depth = entries[first + i].x;
        low = min(low, depth);
        high = max(high, depth);
    }
    atomicMin(nearest, low);
    atomicMax(farthest, high);
    barrier();
    uint shift = 0u;
    while (((farthest - nearest) >> shift) >= kBins)
        ++shift;
    for (uint i = lane; i < count; i += kLanes)
        atomicAdd(bins[(entries[first + i].x - nearest) >> shift], 1u);
    barrier();
    uint own = lane * (kBins / kLanes);
    uint sum = 0u;
    for (uint b = 0u; b < kBins / kLanes; ++b)
        sum += bins[own + b];
    sums[lane] = sum;
    barrier();
    for (uint step = 1u; step < kLanes; step *= 2u) {
        uint before = lane >= step ? sums[lane - step] : 0u;
        barrier();
        sums[lane] += before;
        barrier();
    }
    uint begin = sums[lane] - sum;
    uint ownBegin = begin;
    for (uint b = 0u; b < kBins / kLanes; ++b) {
        uint inBin = bins[own + b];
        bins[own + b] = begin;
        begin += inBin;
    }
    barrier();
    for (uint i = lane; i < count; i += kLanes) {
        uvec2 entry = entries[first + i];
        sorted[first + atomicAdd(bins[(entry.x - nearest) >> shift], 1u)] = entry;
    }
    memoryBarrierBuffer();
    barrier();
    // Each bin now holds its end.
    for (uint b = 0u; b < kBins / kLanes; ++b) {
        uint end = bins[own + b];
        sortBin(first + ownBegin, first + end);
        ownBegin = end;
    }
    memoryBarrierBuffer();
    barrier();
}

void takeSegment(uint number, uint lane)
{
    uvec4 a = projected[number];
    uvec4 b = projected[number + 1u];
    vec2 from = uintBitsToFloat(a.xy);
    vec2 to = uintBitsToFloat(b.xy);
    bool steep = abs(to.y - from.y) > abs(to.x - from.x);
    if (steep) {
        from = from.yx;
        to = to.yx;
    }
    if (from.x > to.x) {
        vec2 position = from;
        from = to;
        to = position;
        uvec4 end = a;
        a = b;
        b = end;
    }
    float inverse = 1.0 / max(to.x - from.x, 1e-6);
    float width = packedWidthOf(a);
    float depth = packedDepthOf(a);
    vec3 light = packedLightOf(a);
    lines[lane] = vec4(from.x, to.x, from.y, (to.y - from.y) * inverse);
    widthsAndDepths[lane] = vec4(width, (packedWidthOf(b) - width) * inverse, depth, (packedDepthOf(b) - depth) * inverse);
    lights[lane] = vec4(light, steep ? 1.0 : 0.0);
    lightSteps[lane] = vec4((packedLightOf(b) - light) * inverse, 0.0);
}

void main()
{
    ivec2 tile = ivec2(gl_WorkGroupID.xy) + ivec2(0, firstRow);
    ivec2 at = tile * 8 + ivec2(gl_LocalInvocationID.xy);
    uint lane = gl_LocalInvocationIndex;
    int number = tile.y * tiles.x + tile.x;
    uint first = min(begins[number + 1], capacity);
    uint count = min(counts[number], capacity - first);
    bool inside = all(lessThan(at, ivec2(target.xy)));
    if (count > 0u)
        sortEntries(first, count, lane);

    float headDepthThere = inside ? texelFetch(headDepth, at, 0).x : 1.0;
    float behind = inside && texelFetch(wornMask, at, 0).x > 0.5 ? kWornDepthM : kSkinDepthM;
    float head = headDepthThere < 1.0 ? depthOf(linearDepth(headDepthThere) + behind) : 1e9;
    vec2 middle = vec2(at) + 0.5;
    vec3 light = vec3(0.0);
    float left = inside ? 1.0 : 0.0;
    for (uint from = 0u; from < count; from += kLanes) {
        barrier();
        if (lane == 0u)
            open = 0u;
        uint held = min(count - from, kLanes);
        if (lane < held)
            takeSegment(sorted[first + from + lane].y, lane);
        barrier();
        if (left >= opaque)
            atomicOr(open, 1u);
        barrier();
        if (open == 0u)
            break;
        for (uint j = 0u; j < held && left >= opaque; ++j) {
            vec4 line = lines[j];
            bool steep = lights[j].w > 0.5;
            float main = steep ? middle.y : middle.x;
            if (main < line.x || main >= line.y)
                continue;
            float along = main - line.x;
            float aside = abs((steep ? middle.x : middle.y) - (line.z + line.w * along));
            vec4 own = widthsAndDepths[j];
            float width = own.x + own.y * along;
            float cover = min(width, 1.0) * clamp(0.5 * (max(width, 1.0) + 1.0) - aside, 0.0, 1.0);
            if (cover <= 0.0 || own.z + own.w * along > head)
                continue;
            light += (lights[j].rgb + lightSteps[j].rgb * along) * (cover * left);
            left -= cover * left;
        }
    }
    if (inside)
        imageStore(hairSeen, at, vec4(light, left));
}
