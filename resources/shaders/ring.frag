// A brush ring, where the skin is as far from its centre as its radius: white with a dark edge outside; inside, the hair
// fades so that the skin shows. Drawn over the picture, inside a scissor around the ring.
// SAMPLES_X and SAMPLES_Y are defined by the program. Out: sRGB as encoded, alpha premultiplied.
layout(binding = 0) uniform sampler2D headColour;
layout(binding = 1) uniform sampler2D headDepth;
uniform int ring;
layout(location = 0) out vec4 srgb;

float fromCentreM(ivec2 at)
{
    return distance(unprojected(vec2(at) + 0.5, texelFetch(headDepth, at, 0).x), ringWo[ring].xyz);
}

vec4 over(vec4 below, vec3 colour, float alpha)
{
    return mix(below, vec4(colour, 1.0), alpha);
}

void main()
{
    ivec2 at = ivec2(gl_FragCoord.xy) * ivec2(SAMPLES_X, SAMPLES_Y);
    vec4 centre = projectionFromWo * vec4(ringWo[ring].xyz, 1.0);
    float radiusM = ringWo[ring].w;
    float d = fromCentreM(at);
    vec2 slope = vec2(fromCentreM(at + ivec2(SAMPLES_X, 0)), fromCentreM(at + ivec2(0, SAMPLES_Y))) - d;
    float metrePerPixel = centre.w * float(SAMPLES_Y) / gridSize.z;
    float pixels = (d - radiusM) / clamp(length(slope), 0.15 * metrePerPixel, 3.0 * metrePerPixel);
    vec3 skin = texelFetch(headColour, at, 0).rgb;
    vec4 laid = vec4(0.0);
    laid = over(laid, fastSrgb(skin * skin), pixels < 0.0 ? 0.55 : 0.0);
    laid = over(laid, vec3(0.06), 0.75 * clamp(1.7 - abs(pixels - 1.4), 0.0, 1.0));
    laid = over(laid, vec3(0.97), clamp(1.5 - abs(pixels), 0.0, 1.0));
    srgb = texelFetch(headDepth, at, 0).x < 1.0 ? laid : vec4(0.0);
}
