// Finds the tiles that the segments between projected points touch: counts them, then enters each where tile_scan.comp
// has made room for it. One invocation a segment.
layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly buffer Projected { uvec4 projected[]; };
layout(std430, binding = 1) buffer Counts { uint counts[]; };           // [tiles] number of entries.
layout(std430, binding = 2) readonly buffer Begins { uint begins[]; };  // All entries; then each tile's first.
// Depth in the tile, and number of the segment's first point.
layout(std430, binding = 3) writeonly buffer Entries { uvec2 entries[]; };

uniform uint pointCount;
uniform uint firstPoint; // Since no more than 65535 workgroups are promised, points come in runs.
uniform ivec2 tiles;
uniform float tileSp;
uniform uint capacity;   // Number of entries that there is room for; 0: only count.

void enter(int tile, float depth, uint segment)
{
    uint number = atomicAdd(counts[tile], 1u);
    if (capacity == 0u)
        return;
    uint at = begins[tile + 1] + number;
    if (at < capacity)
        entries[at] = uvec2(uint(clamp(depth, 0.0, 65535.0)), segment);
}

void main()
{
    uint i = firstPoint + gl_GlobalInvocationID.x;
    if (i + 1u >= pointCount)
        return;
    uvec4 a = projected[i];
    uvec4 b = projected[i + 1u];
    float widest = max(packedWidthOf(a), packedWidthOf(b));
    if ((a.w & kLastPoint) != 0u || widest <= kWidthUnit)
        return;
    vec2 from = uintBitsToFloat(a.xy);
    vec2 to = uintBitsToFloat(b.xy);
    float reach = 1.0 + 0.5 * widest;
    vec2 low = min(from, to) - reach;
    vec2 high = max(from, to) + reach;
    // False for what is not a number.
    if (!(all(greaterThan(high, vec2(0.0))) && all(lessThan(low, target.xy))))
        return;
    ivec2 first = ivec2(clamp(low, vec2(0.0), target.xy - 1.0) / tileSp);
    ivec2 last = ivec2(clamp(high, vec2(0.0), target.xy - 1.0) / tileSp);
    vec2 span = to - from;
    bool steep = abs(span.y) > abs(span.x);
    float mainFrom = steep ? from.y : from.x;
    float mainLength = steep ? span.y : span.x;
    float perMain = abs(mainLength) > 1e-3 ? 1.0 / mainLength : 0.0;
    float depth = packedDepthOf(a);
    float depthRise = packedDepthOf(b) - depth;
    // Distance of a tile's middle from the segment's line within which the tile is touched, times the segment's
    // length.
    float side = (abs(span.x) + abs(span.y)) * (0.5 * tileSp + reach);
    for (int y = first.y; y <= last.y; ++y)
        for (int x = first.x; x <= last.x; ++x) {
            vec2 aside = (vec2(x, y) + 0.5) * tileSp - from;
            if (abs(aside.x * span.y - aside.y * span.x) > side)
                continue;
            // Depth in the middle of the part that lies in the tile.
            float edge = float(steep ? y : x) * tileSp;
            vec2 ends = (clamp(vec2(mainFrom, mainFrom + mainLength), edge, edge + tileSp) - mainFrom) * perMain;
            enter(y * tiles.x + x, depth + depthRise * clamp(0.5 * (ends.x + ends.y), 0.0, 1.0), i);
        }
}
