// Averages a pixel's samples in linear light: hair where hair is nearest, else the head, else the background; then draws
// the brush rings, where the skin is as far from their centre as their radius, and lets the hair inside them fade.
// SAMPLES_X and SAMPLES_Y are defined by the program. Out: sRGB as encoded.
layout(std430, binding = 0) readonly buffer Samples { uint samples[]; };
layout(binding = 0) uniform sampler2D headColour;
layout(binding = 1) uniform sampler2D headDepth;
layout(binding = 2) uniform sampler3D opacityToLight;
layout(binding = 3) uniform sampler3D opacityToEye;
uniform bool shaded; // Whether there is hair that throws shadows.
uniform bool ringed; // Whether there is a ring.
in vec3 backgroundSrgb;
layout(location = 0) out vec4 srgb;

float skinShade = 1.0;

vec3 skinWo(ivec2 at)
{
    vec2 place = (vec2(at) + 0.5) / target.xy;
    vec4 wo = woFromProjection * vec4(vec3(place, texelFetch(headDepth, at, 0).x) * 2.0 - 1.0, 1.0);
    return wo.xyz / wo.w;
}

// Hair's shadow on the skin at a sample.
float shadeOfHair(ivec2 at)
{
    vec4 wo = vec4(skinWo(at), 1.0);
    float above = texture(opacityToLight, (gridFromWo[0] * wo).xyz).x;
    float before = texture(opacityToEye, (gridFromWo[1] * wo).xyz).x;
    return (0.35 + 0.65 * exp2(-0.6 * above)) * (0.2 + 0.8 * exp2(-2.0 * before));
}

// The square root of the linear colour of one sample, squared again.
vec3 colourOf(uint value, ivec2 at)
{
    if ((value & kColourMask) != kHeadColour)
        return unpackColour(value);
    if (value == kEmptySample)
        return backgroundSrgb * (backgroundSrgb * (backgroundSrgb * 0.305306011 + 0.682171111) + 0.012522878);
    vec3 c = texelFetch(headColour, at, 0).rgb;
    return c * c * skinShade;
}

// sRGB with a ring over it: white with a dark edge outside.
vec3 withRing(vec3 below, vec4 ring, ivec2 at)
{
    vec4 centre = projectionFromWo * vec4(ring.xyz, 1.0);
    vec2 offset = (vec2(at) + 0.5) - (centre.xy / centre.w * 0.5 + 0.5) * target.xy;
    float reach = ring.w * gridSize.z / centre.w * 1.3;
    offset.x *= float(SAMPLES_Y) / float(SAMPLES_X);
    if (ring.w <= 0.0 || dot(offset, offset) > reach * reach + 64.0 || texelFetch(headDepth, at, 0).x >= 1.0)
        return below;
    float d = distance(skinWo(at), ring.xyz);
    vec2 slope = vec2(distance(skinWo(at + ivec2(SAMPLES_X, 0)), ring.xyz), distance(skinWo(at + ivec2(0, SAMPLES_Y)), ring.xyz)) - d;
    float metrePerPixel = centre.w * float(SAMPLES_Y) / gridSize.z;
    float pixels = (d - ring.w) / clamp(length(slope), 0.15 * metrePerPixel, 3.0 * metrePerPixel);
    if (pixels < 0.0) {
        vec3 skin = texelFetch(headColour, at, 0).rgb;
        below = mix(below, fastSrgb(skin * skin), 0.55);
    }
    below = mix(below, vec3(0.06), 0.75 * clamp(1.7 - abs(pixels - 1.4), 0.0, 1.0));
    return mix(below, vec3(0.97), clamp(1.5 - abs(pixels), 0.0, 1.0));
}

bool isHead(uint value)
{
    return value != kEmptySample && (value & kColourMask) == kHeadColour;
}

void main()
{
    ivec2 corner = ivec2(gl_FragCoord.xy) * ivec2(SAMPLES_X, SAMPLES_Y);
    int first = corner.y * int(target.x) + corner.x;
    uint a = samples[first];
#if SAMPLES_X == 1
    if (shaded && isHead(a))
        skinShade = shadeOfHair(corner);
    srgb = vec4(a == kEmptySample ? backgroundSrgb : fastSrgb(colourOf(a, corner)), 1.0);
#else
    uint b = samples[first + 1];
#if SAMPLES_Y == 1
    uint c = b;
    uint d = b;
#else
    uint c = samples[first + int(target.x)];
    uint d = samples[first + int(target.x) + 1];
#endif
    // One place of skin stands for the pixel.
    if (shaded) {
        if (isHead(a))
            skinShade = shadeOfHair(corner);
        else if (isHead(b))
            skinShade = shadeOfHair(corner + ivec2(1, 0));
        else if (isHead(c))
            skinShade = shadeOfHair(corner + ivec2(0, 1));
        else if (isHead(d))
            skinShade = shadeOfHair(corner + ivec2(1, 1));
    }
    srgb = vec4(backgroundSrgb, 1.0);
    if ((a & b & c & d) != kEmptySample) {
        vec3 sum = colourOf(a, corner) + colourOf(b, corner + ivec2(1, 0));
#if SAMPLES_Y == 2
        sum = 0.5 * (sum + colourOf(c, corner + ivec2(0, 1)) + colourOf(d, corner + ivec2(1, 1)));
#endif
        srgb.rgb = fastSrgb(0.5 * sum);
    }
#endif
    if (ringed)
        for (int i = 0; i < 2; ++i)
            srgb.rgb = withRing(srgb.rgb, ringWo[i], corner);
}
