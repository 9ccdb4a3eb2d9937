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
    if (a.w == 0xFFFFFFFFu || b.w == 0xFFFFFFFFu || distanceA < 0.0 || max(a.w, b.w) < (128u << 20))
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
    float width0 = float(a.w >> 20);
    float width1 = float(b.w >> 20);
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
    float inverse = 1.0 / max(to.x - from.x, 1e-6);
    float acrossStep = (to.y - from.y) * inverse;
    // Line n of the strand's thickness; kept inside the picture in both directions.
    float offset = float(gl_GlobalInvocationID.y);
    float thick = floor(max(width0, width1) * (1.0 / 128.0));
    if (offset >= thick)
        return;
    from.y += offset - 0.5 * (thick - 1.0);
    vec2 inside = vec2(0.0, size.x);
    if (abs(acrossStep) > 1e-9) {
        vec2 cut = from.x + (vec2(0.0, size.y - 0.001) - from.y) / acrossStep;
        inside = vec2(max(inside.x, min(cut.x, cut.y)), min(inside.y, max(cut.x, cut.y)));
    } else if (from.y < 0.0 || from.y >= size.y)
        return;
    int begin = int(ceil(clamp(from.x, inside.x, inside.y) - 0.5));
    int end = int(ceil(clamp(to.x, inside.x, inside.y) - 0.5));
    float t = float(begin) + 0.5 - from.x;
    float across = from.y + t * acrossStep;
    float keyStep = (distanceB - distanceA) * inverse * depthRange.y;
    float key = (distanceA - depthRange.x) * depthRange.y + t * keyStep;
    float lumaStep = (luma1 - luma0) * inverse;
    float luma = luma0 + t * lumaStep + 0.5;
    float widthStep = (width1 - width0) * inverse;
    // The strand ends where it is too thin for this line of samples.
    float least = (offset + 1.0) * 128.0;
    if (abs(widthStep) > 1e-9) {
        float cut = from.x + (least - width0) / widthStep;
        if (widthStep < 0.0)
            end = min(end, int(ceil(cut - 0.5)));
        else
            begin = max(begin, int(ceil(cut - 0.5)));
    } else if (width0 < least)
        return;
    t = float(begin) + 0.5 - from.x;
    across = clamp(from.y + t * acrossStep, 0.0, size.y - 0.01);
    key = clamp((distanceA - depthRange.x) * depthRange.y + t * keyStep, 0.0, kDepthKeys - 1.0);
    luma = luma0 + t * lumaStep + 0.5;
    uint chroma = a.w & 0xFFF00u;
    int row = begin * strideMain;
    for (int x = begin; x < end; ++x) {
        uint value = (uint(max(key, 0.0)) << kDepthShift) | chroma | uint(luma);
        int at = row + int(across) * strideAcross;
        if (value < samples[at])
            atomicMin(samples[at], value);
        across += acrossStep;
        key += keyStep;
        luma += lumaStep;
        row += strideMain;
    }
}
