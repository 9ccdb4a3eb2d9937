// Averages a pixel's samples in linear light: hair where hair is nearest, else the head, else the background.
// SAMPLES_X and SAMPLES_Y are defined by the program. Out: sRGB as encoded.
layout(std430, binding = 0) readonly buffer Samples { uint samples[]; };
layout(binding = 0) uniform sampler2D headColour;
layout(binding = 1) uniform sampler2D headDepth;
layout(binding = 2) uniform sampler3D opacityToLight;
layout(binding = 3) uniform sampler3D opacityToEye;
uniform bool shaded; // Whether there is hair that throws shadows.
in vec3 backgroundSrgb;
layout(location = 0) out vec4 srgb;

float skinShade = 1.0;

// Hair's shadow on the skin at a sample.
float shadeOfHair(ivec2 at)
{
    vec2 place = (vec2(at) + 0.5) / target.xy;
    vec4 wo = woFromProjection * vec4(vec3(place, texelFetch(headDepth, at, 0).x) * 2.0 - 1.0, 1.0);
    wo /= wo.w;
    float above = texture(opacityToLight, (gridFromWo[0] * wo).xyz).x;
    float before = texture(opacityToEye, (gridFromWo[1] * wo).xyz).x;
    return (0.35 + 0.65 * exp2(-0.6 * above)) * (0.4 + 0.6 * exp2(-0.8 * before));
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

bool isHead(uint value)
{
    return value != kEmptySample && (value & kColourMask) == kHeadColour;
}

void main()
{
    ivec2 corner = ivec2(gl_FragCoord.xy) * ivec2(SAMPLES_X, SAMPLES_Y);
    int first = corner.y * int(target.x) + corner.x;
    uint a = samples[first];
    if (shaded && isHead(a))
        skinShade = shadeOfHair(corner);
#if SAMPLES_X == 1
    srgb = vec4(a == kEmptySample ? backgroundSrgb : fastSrgb(colourOf(a, corner)), 1.0);
#else
    uint b = samples[first + 1];
#if SAMPLES_Y == 1
    srgb = vec4(backgroundSrgb, 1.0);
    if ((a & b) != kEmptySample)
        srgb.rgb = fastSrgb(0.5 * (colourOf(a, corner) + colourOf(b, corner + ivec2(1, 0))));
#else
    uint c = samples[first + int(target.x)];
    uint d = samples[first + int(target.x) + 1];
    srgb = vec4(backgroundSrgb, 1.0);
    if ((a & b & c & d) != kEmptySample)
        srgb.rgb = fastSrgb(0.25 * (colourOf(a, corner) + colourOf(b, corner + ivec2(1, 0))
                                    + colourOf(c, corner + ivec2(0, 1)) + colourOf(d, corner + ivec2(1, 1))));
#endif
#endif
}
