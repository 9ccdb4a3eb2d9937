// Averages a pixel's samples in linear light: hair where hair is nearest, else the head, else the background.
// SAMPLES_X and SAMPLES_Y are defined by the program. Out: sRGB as encoded.
layout(std430, binding = 0) readonly buffer Samples { uint samples[]; };
layout(binding = 0) uniform sampler2D headColour;
layout(binding = 2) uniform sampler2D skinShade; // What is left of the skin's light under the hair.
uniform int shadeCell;                           // Pixels across a texel of it; 0 where no hair throws a shadow.
in vec3 backgroundSrgb;
layout(location = 0) out vec4 srgb;

// One sample's light; w: 1, or 0 where only the background is seen.
vec4 lightOf(uint value, ivec2 at, float shade)
{
    if ((value & kColourMask) != kHeadColour)
        return vec4(lightHeld(unpackColour(value)), 1.0);
    if (value == kEmptySample)
        return vec4(0.0);
    vec3 c = texelFetch(headColour, at, 0).rgb;
    return vec4(lightHeld(c * c) * shade, 1.0);
}

// Only the scene's light is toned; the background is the screen's own colour.
vec3 shown(vec4 light)
{
    return fastSrgb(toneOf(light.rgb / max(light.w, 1e-6)) * light.w + linearFromSrgb(backgroundSrgb) * (1.0 - light.w));
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
    srgb.rgb = a == kEmptySample ? backgroundSrgb : shown(lightOf(a, corner, shade));
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
        vec4 sum = lightOf(a, corner, shade) + lightOf(b, corner + ivec2(1, 0), shade);
#if SAMPLES_Y == 2
        sum = 0.5 * (sum + lightOf(c, corner + ivec2(0, 1), shade) + lightOf(d, corner + ivec2(1, 1), shade));
#endif
        srgb.rgb = shown(0.5 * sum);
    }
#endif
}
