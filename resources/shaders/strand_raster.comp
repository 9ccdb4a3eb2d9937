// Draws the segments between projected points into the sample buffer: one sample a step along the main direction, as many
// across as the strand is wide, the nearest wins. One invocation a segment.
// Triangles a fraction of a pixel wide cost a GPU dearly and software even more; a walk costs what it covers.
layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly buffer Projected { uvec4 projected[]; };
layout(std430, binding = 1) buffer Samples { uint samples[]; };

uniform uint pointCount;

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i + 1u >= pointCount)
        return;
    uvec4 a = projected[i];
    uvec4 b = projected[i + 1u];
    float distanceA = uintBitsToFloat(a.z);
    if (a.w == 0xFFFFFFFFu || b.w == 0xFFFFFFFFu || distanceA < 0.0 || max(a.w, b.w) < (256u << 19))
        return;
    float distanceB = abs(uintBitsToFloat(b.z));
    vec2 from = uintBitsToFloat(a.xy);
    vec2 to = uintBitsToFloat(b.xy);
    bool steep = abs(to.y - from.y) > abs(to.x - from.x);
    vec2 size = target.xy;
    int strideMain = 1;
    int strideAcross = int(size.x);
    if (steep) {
        from = from.yx;
        to = to.yx;
        size = size.yx;
        strideMain = strideAcross;
        strideAcross = 1;
    }
    // Walk upward; the values at both ends follow.
    float luma0 = float(a.w & 0xFFu);
    float luma1 = float(b.w & 0xFFu);
    float width0 = float(a.w >> 19);
    float width1 = float(b.w >> 19);
    if (from.x > to.x) {
        vec2 swap2 = from;
        from = to;
        to = swap2;
        float swap1 = luma0;
        luma0 = luma1;
        luma1 = swap1;
        swap1 = width0;
        width0 = width1;
        width1 = swap1;
        swap1 = distanceA;
        distanceA = distanceB;
        distanceB = swap1;
    }
    int begin = int(ceil(clamp(from.x, 0.0, size.x) - 0.5));
    int end = int(ceil(clamp(to.x, 0.0, size.x) - 0.5));
    float inverse = 1.0 / max(to.x - from.x, 1e-6);
    float t = (float(begin) + 0.5 - from.x) * inverse;
    float across = from.y + t * (to.y - from.y);
    float acrossStep = (to.y - from.y) * inverse;
    float key = ((distanceA + t * (distanceB - distanceA)) - depthRange.x) * depthRange.y;
    float keyStep = (distanceB - distanceA) * inverse * depthRange.y;
    float luma = luma0 + t * (luma1 - luma0) + 0.5;
    float lumaStep = (luma1 - luma0) * inverse;
    float width = (width0 + t * (width1 - width0)) * (1.0 / 256.0);
    float widthStep = (width1 - width0) * inverse * (1.0 / 256.0);
    uint chroma = a.w & 0x7FF00u;
    int height = int(size.y);
    for (int x = begin; x < end; ++x) {
        int thick = int(width);
        int y = int(floor(across - 0.5 * float(thick - 1)));
        uint value = (uint(clamp(key, 0.0, kDepthKeys - 1.0)) << kDepthShift) | chroma | uint(luma);
        for (int n = 0; n < thick; ++n, ++y)
            if (y >= 0 && y < height)
                atomicMin(samples[x * strideMain + y * strideAcross], value);
        across += acrossStep;
        key += keyStep;
        luma += lumaStep;
        width += widthStep;
    }
}
