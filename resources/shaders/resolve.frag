// Averages a pixel's samples in linear light: hair where hair is nearest, else the head, else the background.
// SAMPLES_X and SAMPLES_Y are defined by the program. Out: sRGB as encoded.
layout(std430, binding = 0) readonly buffer Samples { uint samples[]; };
layout(binding = 0) uniform sampler2D headColour;
layout(binding = 2) uniform sampler2D skinShade; // What is left of the skin's light under the hair.
uniform int shadeCell;                           // Pixels across a texel of it; 0 where no hair throws a shadow.
in vec3 backgroundSrgb;
layout(location = 0) out vec4 srgb;

// The square root of the linear colour of one sample, squared again.
vec3 colourOf(uint value, ivec2 at, float shade)
{
    if ((value & kColourMask) != kHeadColour)
        return unpackColour(value);
    if (value == kEmptySample)
        return backgroundSrgb * (backgroundSrgb * (backgroundSrgb * 0.305306011 + 0.682171111) + 0.012522878);
    vec3 c = texelFetch(headColour, at, 0).rgb;
    return c * c * shade;
}

void main()
{
    ivec2 corner = ivec2(gl_FragCoord.xy) * ivec2(SAMPLES_X, SAMPLES_Y);
    int first = corner.y * int(target.x) + corner.x;
    float shade = 1.0;
    if (shadeCell > 0)
        shade = texture(skinShade, gl_FragCoord.xy / vec2(textureSize(skinShade, 0) * shadeCell)).x;
    uint a = samples[first];
#if SAMPLES_X == 1
    srgb.rgb = a == kEmptySample ? backgroundSrgb : fastSrgb(colourOf(a, corner, shade));
    srgb.a = dot(srgb.rgb, vec3(0.25, 0.5, 0.25)); // What smooth.frag looks at.
#else
    uint b = samples[first + 1];
#if SAMPLES_Y == 1
    uint c = b;
    uint d = b;
#else
    uint c = samples[first + int(target.x)];
    uint d = samples[first + int(target.x) + 1];
#endif
    srgb = vec4(backgroundSrgb, 1.0);
    if ((a & b & c & d) != kEmptySample) {
        vec3 sum = colourOf(a, corner, shade) + colourOf(b, corner + ivec2(1, 0), shade);
#if SAMPLES_Y == 2
        sum = 0.5 * (sum + colourOf(c, corner + ivec2(0, 1), shade) + colourOf(d, corner + ivec2(1, 1), shade));
#endif
        srgb.rgb = fastSrgb(0.5 * sum);
    }
#endif
}
