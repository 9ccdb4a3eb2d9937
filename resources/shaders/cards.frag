// A texel of a card, where it is hair. Out: square root of the held light; alpha 1.
layout(binding = 0) uniform sampler2D atlas; // sRGB as encoded, and alpha.
uniform float cutoff;
in vec2 uv;
in vec3 light;
layout(location = 0) out vec4 rootColour;

void main()
{
    // The level that has about a texel a sample, by area.
    vec2 across = dFdx(uv);
    vec2 up = dFdy(uv);
    float texels = abs(across.x * up.y - across.y * up.x) * float(textureSize(atlas, 0).x * textureSize(atlas, 0).x);
    vec4 texel = textureLod(atlas, uv, max(floor(0.5 * log2(max(texels, 1e-6)) + 0.5), 0.0));
    if (texel.a < cutoff)
        discard;
    rootColour = vec4(sqrt(heldLight(linearFromSrgb(texel.rgb) * light)), 1.0);
}
