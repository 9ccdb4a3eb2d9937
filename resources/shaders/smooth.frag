// Softens the stairs of a picture with one sample a pixel: each pixel is averaged along the line or edge that runs through
// it, found as the direction in which the brightness around it changes least (the structure tensor's minor axis).
layout(binding = 0) uniform sampler2D rough; // sRGB as encoded, and its luma; sampled bilinearly.
layout(binding = 3) uniform sampler2D hairSeen; // Hair covers as much as it should: only what is bare has stairs.
uniform int anyHair;
layout(location = 0) out vec4 srgb;

const float kLeastContrast = 0.0006; // Sum of squares of the differences from the neighbours; less is a smooth surface.

void main()
{
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec2 texel = 1.0 / vec2(textureSize(rough, 0));
    vec2 here = gl_FragCoord.xy * texel;
    srgb = vec4(texelFetch(rough, at, 0).rgb, 1.0);
    if (anyHair > 0 && texelFetch(hairSeen, at, 0).a < 0.5)
        return;
    // The lumas of four pixels: upper left, upper right, lower right, lower left.
    vec4 low = textureGather(rough, here - 0.5 * texel, 3);
    vec4 high = textureGather(rough, here + 0.5 * texel, 3);
    float centre = low.y;
    vec4 direct = vec4(low.xz, high.xz) - centre;
    if (dot(direct, direct) < kLeastContrast)
        return;
    float west = low.x;
    float south = low.z;
    float southWest = low.w;
    float north = high.x;
    float northEast = high.y;
    float east = high.z;
    float northWest = textureGather(rough, here + vec2(-0.5, 0.5) * texel, 3).x;
    float southEast = textureGather(rough, here + vec2(0.5, -0.5) * texel, 3).z;
    // Gradients at the pixel's four corners: between them they see a line of one pixel, which a difference across it misses.
    vec4 right = vec4(centre + south - west - southWest, east + southEast - centre - south,
                      centre + north - west - northWest, east + northEast - centre - north);
    vec4 up = vec4(west + centre - southWest - south, centre + east - south - southEast, northWest + north - west - centre,
                   north + northEast - centre - east);
    float xx = dot(right, right);
    float yy = dot(up, up);
    float xy = dot(right, up);
    float spread = sqrt((xx - yy) * (xx - yy) + 4.0 * xy * xy);
    float coherence = spread / max(xx + yy, 1e-9);
    vec2 across = xx >= yy ? vec2(xx - yy + spread, 2.0 * xy) : vec2(2.0 * xy, yy - xx + spread);
    vec2 along = vec2(-across.y, across.x) * inversesqrt(max(dot(across, across), 1e-12));
    vec3 near = texture(rough, here - along * texel).rgb + texture(rough, here + along * texel).rgb;
    vec3 far = texture(rough, here - 2.2 * along * texel).rgb + texture(rough, here + 2.2 * along * texel).rgb;
    srgb.rgb = mix(srgb.rgb, 0.28 * srgb.rgb + 0.22 * near + 0.14 * far, coherence);
}
