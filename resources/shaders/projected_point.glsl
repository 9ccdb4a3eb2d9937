// A strand's point as the picture has it, in four numbers: x, y in samples; distance along the view and width; light, and
// whether the strand ends there.

// Samples in a unit of the width's 16 bits, as the software renderer has them.
const float kWidthUnit = 1.0 / 1900.0;
const uint kLastPoint = 1u << 30;

uint packedDepth(uint depth, float widthSp)
{
    return depth | uint(min(widthSp * (1.0 / kWidthUnit) + 0.5, 65535.0)) << 16;
}

float packedWidthOf(uvec4 point)
{
    return float(point.z >> 16) * kWidthUnit;
}

float packedDepthOf(uvec4 point)
{
    return float(point.z & 0xFFFFu);
}

// Square roots of the light's part of the most, ten bits each.
uint packedLight(vec3 light, bool last)
{
    uvec3 bits = uvec3(sqrt(clamp(light * (1.0 / kMostLight), 0.0, 1.0)) * 1023.0 + 0.5);
    return bits.r | bits.g << 10 | bits.b << 20 | (last ? kLastPoint : 0u);
}

vec3 packedLightOf(uvec4 point)
{
    vec3 held = vec3(uvec3(point.w, point.w >> 10, point.w >> 20) & 0x3FFu) * (1.0 / 1023.0);
    return held * held * kMostLight;
}
