// Averages a pixel's samples in linear light: hair, the head as far as it is seen through that, the background.
// SAMPLES_X and SAMPLES_Y are defined by the program. Out: sRGB as encoded.
layout(binding = 0) uniform sampler2D headColour; // Alpha 0 where there is no head.
layout(binding = 2) uniform sampler2D skinShade;  // What is left of the skin's light under the hair.
layout(binding = 3) uniform sampler2D hairSeen;  // As strand_tile.comp leaves it.
uniform int shadeCell; // Pixels across a texel of skinShade; 0 where there is no hair at all.
uniform float opaque;  // As strand_tile.comp has it.
in vec3 backgroundSrgb;
layout(location = 0) out vec4 srgb;

// What is left of each colour in a shade: light spreads under the skin into it, red furthest.
vec3 colouredShade(float shade)
{
    float spread = skin[0].w;
    return shade + spread * vec3(0.35 * (sqrt(shade) - shade), 0.0, -0.2 * shade * (1.0 - shade));
}

// One sample's light; w: what is not the background's.
vec4 lightOf(ivec2 at, vec3 shade)
{
    vec4 seen = vec4(0.0, 0.0, 0.0, 1.0); // w: what is left to see through.
    if (shadeCell > 0) {
        seen = texelFetch(hairSeen, at, 0);
        // What is opaque shows nothing behind; what it lacks is the hair's own.
        if (seen.w < opaque)
            seen = vec4(seen.rgb / (1.0 - seen.w), 0.0);
    }
    vec4 head = texelFetch(headColour, at, 0);
    seen.rgb += lightHeld(head.rgb * head.rgb) * (shade * seen.w * head.a);
    return vec4(seen.rgb, 1.0 - seen.w * (1.0 - head.a));
}

void main()
{
    ivec2 corner = ivec2(gl_FragCoord.xy) * ivec2(SAMPLES_X, SAMPLES_Y);
    vec3 shade = vec3(1.0);
    if (shadeCell > 0)
        shade = colouredShade(texture(skinShade, gl_FragCoord.xy / vec2(textureSize(skinShade, 0) * shadeCell)).x);
    vec4 light = vec4(0.0);
    for (int y = 0; y < SAMPLES_Y; ++y)
        for (int x = 0; x < SAMPLES_X; ++x)
            light += lightOf(corner + ivec2(x, y), shade);
    light *= 1.0 / float(SAMPLES_X * SAMPLES_Y);
    srgb.rgb = backgroundSrgb;
    // Only the scene's light is toned; the background is the screen's own colour.
    if (light.w > 0.0)
        srgb.rgb = fastSrgb(toneOf(light.rgb / max(light.w, 1e-6)) * light.w + linearFromSrgb(backgroundSrgb) * (1.0 - light.w));
    srgb.a = dot(srgb.rgb, vec3(0.25, 0.5, 0.25)); // What smooth.frag looks at.
}
