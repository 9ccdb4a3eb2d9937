// Sums the tiles' counts, so that each tile has a range for its entries, and clears them. One workgroup.
layout(local_size_x = 256) in;

layout(std430, binding = 1) buffer Counts { uint counts[]; };
layout(std430, binding = 2) writeonly buffer Begins { uint begins[]; }; // All entries; then each tile's first.

uniform uint tileCount;

shared uint sums[256];

void main()
{
    uint lane = gl_LocalInvocationID.x;
    uint each = (tileCount + 255u) / 256u;
    uint first = min(lane * each, tileCount);
    uint end = min(first + each, tileCount);
    uint sum = 0u;
    for (uint i = first; i < end; ++i)
        sum += counts[i];
    sums[lane] = sum;
    barrier();
    for (uint step = 1u; step < 256u; step *= 2u) {
        uint before = lane >= step ? sums[lane - step] : 0u;
        barrier();
        sums[lane] += before;
        barrier();
    }
    uint begin = sums[lane] - sum;
    for (uint i = first; i < end; ++i) {
        uint count = counts[i];
        counts[i] = 0u;
        begins[i + 1u] = begin;
        begin += count;
    }
    if (lane == 255u)
        begins[0] = sums[255];
}
