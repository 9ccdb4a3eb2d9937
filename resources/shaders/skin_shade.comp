// The hair's shadow on the skin, from both opacity grids. Soft as it is, one sample stands for a cell of pixels; where the
// cell's middle misses the head, one of its corners may hit it. One invocation a cell.
layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 1) uniform sampler2D headDepth;
layout(binding = 2) uniform sampler3D opacityToLight;
layout(binding = 3) uniform sampler3D opacityToEye;
layout(r8, binding = 0) writeonly uniform image2D skinShade;

uniform int shadeCell; // Pixels across a cell.

const vec2 kCellPoints[5] = vec2[](vec2(0.5), vec2(0.1, 0.1), vec2(0.9, 0.1), vec2(0.1, 0.9), vec2(0.9, 0.9));

// Light that comes through the hair. What is blended between neighbours is the light, not the hair: a plait holds so much
// of it that the least part of its voxel would be dark, as a stub of shade beside and below it.
float lightThrough(sampler3D opacity, vec3 position, float strength)
{
    ivec3 size = textureSize(opacity, 0);
    vec3 at = position * vec3(size) - 0.5;
    ivec3 low = ivec3(floor(at));
    vec3 part = at - vec3(low);
    float light = 0.0;
    for (int i = 0; i < 8; ++i) {
        ivec3 corner = ivec3(i & 1, (i >> 1) & 1, i >> 2);
        vec3 weights = mix(1.0 - part, part, vec3(corner));
        ivec3 voxel = low + corner;
        voxel.z = clamp(voxel.z, 0, size.z - 1); // Behind the grid the last layer's sum goes on.
        bool beside = any(lessThan(voxel.xy, ivec2(0))) || any(greaterThanEqual(voxel.xy, size.xy));
        float hair = beside ? 0.0 : texelFetch(opacity, voxel, 0).x;
        light += weights.x * weights.y * weights.z * exp2(-strength * hair);
    }
    return light;
}

void main()
{
    ivec2 cell = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(cell, imageSize(skinShade))))
        return;
    vec2 at = vec2(0.0);
    float depth = 1.0;
    for (int i = 4; i >= 0; --i) {
        vec2 position = min(floor((vec2(cell) + kCellPoints[i]) * float(shadeCell) * target.zw), target.xy - 1.0);
        float here = texelFetch(headDepth, ivec2(position), 0).x;
        at = here < 1.0 ? position + 0.5 : at;
        depth = here < 1.0 ? here : depth;
    }
    vec4 wo = vec4(unprojected(at, depth), 1.0);
    float fromLight = lightThrough(opacityToLight, (gridFromWo[0] * wo).xyz, 0.6);
    vec4 clip = projectionFromWo * wo;
    float toEye = lightThrough(opacityToEye, inEyeGrid(vec3(clip.xy / clip.w, clip.w)), 2.0);
    // The light falls on the side of the head that is turned toward it; the other has no shadow to get.
    vec2 side = wo.xz - headWo.xz;
    float lit = smoothstep(-0.3, 0.2, dot(side, keyWo.xz) * inversesqrt(dot(side, side) + 1e-4));
    float shade = (1.0 - 0.65 * lit * (1.0 - fromLight)) * mix(gridSize.w, 1.0, toEye);
    imageStore(skinShade, cell, vec4(depth < 1.0 ? shade : 1.0));
}
