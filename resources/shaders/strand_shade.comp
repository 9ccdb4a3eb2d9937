// Lights each point of the strands and projects it to samples.
// Kajiya and Kay 1989 with two highlights shifted along the hair (Marschner et al. 2003), light falling through the coat
// by the opacity grid. A strand's width says how many samples it covers; what is left over of a sample is decided by the
// strand's own number, so that thin hair neither flickers nor turns to dust. One invocation a point.
layout(local_size_x = 64) in;

struct Style
{
    float lengthM, turns, curlRadiusM, phase;
    uint rootColour, tipColour;
    float widthM, detail;
    uint braid;
    float braidRadiusM, braidStart, braidTurns;
    float placeX, placeY, variation;
    uint tangentHd;
};
layout(std430, binding = 0) readonly buffer Strands { uvec2 strands[]; };
layout(std430, binding = 1) readonly buffer Styles { Style styles[]; };
layout(std430, binding = 2) readonly buffer Points { vec4 pointsWo[]; };
// x, y in Sp; distance, negative at a strand's last point; colour in 19 bits, width in samples / 256 in 13.
layout(std430, binding = 3) writeonly buffer Projected { uvec4 projected[]; };
layout(binding = 0) uniform sampler3D opacity; // Area of hair between the light and a place over the area it covers.

uniform uint firstStrand;
uniform uint pointCount;
uniform float widening;   // 1 / share of the hairs drawn.
uniform float leastWidth; // Samples that the thinnest hair covers, and the widest.
uniform float greatestWidth;
uniform vec4 material;    // Shine, roughness, alpha at root and tip.
uniform float variationScale;

vec3 colourFromBytes(uint bits)
{
    return linearFromSrgb(unpackUnorm4x8(bits).rgb);
}

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= pointCount)
        return;
    vec4 self = pointsWo[i];
    uint strand = floatBitsToUint(self.w);
    uvec2 place = strands[strand];
    uint base = strands[firstStrand].y;
    uint first = place.y - base;
    uint last = strands[strand + 1u].y - base - 1u;
    uint slot = place.x;
    float s = float(i - first) / float(last - first);
    vec3 position = self.xyz;
    vec3 along = pointsWo[min(i + 1u, last)].xyz - pointsWo[max(i, first + 1u) - 1u].xyz;
    vec3 tangent = along * inversesqrt(max(dot(along, along), 1e-20));

    vec4 clip = projectionFromWo * vec4(position, 1.0);
    if (clip.w < 0.01) {
        projected[i] = uvec4(0u, 0u, 0u, 0xFFFFFFFFu);
        return;
    }
    vec2 placeSp = (clip.xy / clip.w * 0.5 + 0.5) * target.xy;

    // Thickness is measured across the walk's main direction, so slanted strands need more.
    vec4 clipAlong = projectionFromWo * vec4(tangent, 0.0);
    vec2 alongSp = (clipAlong.xy - clip.xy / clip.w * clipAlong.w) * target.xy;
    vec2 steep = abs(alongSp);
    float slant = length(steep) / max(max(steep.x, steep.y), 1e-12);
    uint random = hashOf(slot * 2654435761u + 12345u);
    float alpha = mix(material.z, material.w, s * s);
    float width = max(styles[slot].widthM * gridSize.w / clip.w, leastWidth) * widening * alpha;
    width = min(width, greatestWidth) * min(slant, 1.42) + float(random & 0xFFFFu) * (1.0 / 65536.0);

    vec3 view = normalize(eyeWo.xyz - position);
    vec3 light = lightWo.xyz;
    float variation = styles[slot].variation * variationScale;
    vec3 hair = mix(colourFromBytes(styles[slot].rootColour), colourFromBytes(styles[slot].tipColour), s);
    hair *= exp2(variation * 1.8);

    // Light that reaches this place through the other hair.
    vec3 gridPlace = (gridFromWo * vec4(position, 1.0)).xyz;
    float above = texture(opacity, gridPlace).x;
    float direct = exp2(-above * 0.55);
    float around = exp2(-above * 0.16);

    vec3 outward = position - headWo.xyz;
    outward = outward * inversesqrt(dot(outward, outward) + 1e-8);
    float facing = dot(outward, light);
    float hemisphere = 0.6 + 0.4 * outward.y;

    float tl = dot(tangent, light);
    float tv = dot(tangent, view);
    float sl = sqrt(max(1.0 - tl * tl, 0.0));
    float sv = sqrt(max(1.0 - tv * tv, 0.0));
    // Only the part of the coat that faces the light; softly, since light scatters round.
    float wrap = clamp(facing * 0.6 + 0.4, 0.0, 1.0);
    float diffuse = mix(sl, clamp(facing * 0.5 + 0.5, 0.0, 1.0), 0.4) * wrap;

    float roughness = material.y;
    float sum = tl + tv;
    float narrow = 1.0 / (0.04 + 0.55 * roughness * roughness);
    float a = sum + 0.10; // Toward the root.
    float b = sum - 0.22 + variation;
    float first1 = exp2(-a * a * narrow * 4.0);
    float second = exp2(-b * b * narrow);
    float lobe = material.x * wrap * sl;

    vec3 lit = hair * (diffuse * 1.15 * direct * lightColour.rgb + lightWo.w * hemisphere * around);
    lit += lobe * direct * lightColour.rgb * (first1 * 0.22 + second * 1.3 * hair);
    lit = lit / (1.0 + 0.25 * max(lit.r, max(lit.g, lit.b)));

    uint colour = packColour(lit, float(random >> 16) * (1.0 / 65536.0));
    uint widthBits = uint(clamp(width * 256.0, 0.0, 8190.0));
    float distanceM = i == last ? -clip.w : clip.w;
    projected[i] = uvec4(floatBitsToUint(placeSp.x), floatBitsToUint(placeSp.y), floatBitsToUint(distanceM),
                         colour | (widthBits << 19));
}
