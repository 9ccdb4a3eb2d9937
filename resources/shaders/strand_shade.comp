// Lights each point of the strands and projects it to samples.
// A strand's width says how many samples it covers; what is left over of a sample is decided by the
// strand's own number, so that thin hair neither flickers nor turns to dust. One invocation a point.
layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly buffer Strands { DrawnStrand strands[]; };
layout(std430, binding = 1) readonly buffer Styles { PackedStyle styles[]; };
layout(std430, binding = 2) readonly buffer Points { vec4 pointsWo[]; };
// x, y in Sp; distance, negative at a strand's last point; colour in 20 bits, width in samples / 128 in 12.
layout(std430, binding = 3) writeonly buffer Projected { uvec4 projected[]; };
// Area of hair between a place and the light, the eye, over the area it covers.
layout(binding = 0) uniform sampler3D opacityToLight;
layout(binding = 1) uniform sampler3D opacityToEye;

uniform uint firstStrand;
uniform uint pointCount;
uniform float widening;   // 1 / fraction of the hairs drawn.
uniform float leastWidth; // Samples that the thinnest hair covers, and the widest.
uniform float greatestWidth;
uniform vec4 material;    // Shine, roughness, alpha at root and tip.
uniform float groupWidthM; // Diameter of a hair whose width is 1.
uniform float variationScale;

// Coverings of hair in front, seen by the eye: from where on strands stay as thin as they are, and are not drawn at all.
const float kHiddenFrom = 3.0;
const float kHiddenTo = 10.0;
const float kUndrawn = 16.0;

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
    uint base = strands[firstStrand].firstPoint;
    uint first = strands[strand].firstPoint - base;
    uint last = strands[strand + 1u].firstPoint - base - 1u;
    uint slot = strands[strand].slot;
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
    float ownWidth = styles[slot].width * groupWidthM * gridSize.z / clip.w;
    float drawnWidth = max(ownWidth, leastWidth);

    float variation = styles[slot].variation * variationScale;
    float lightness = exp2(variation * 3.0);
    vec3 rootColour = colourFromBytes(styles[slot].rootColour) * lightness;
    vec3 tipColour = colourFromBytes(styles[slot].tipColour) * lightness;

    // Light that reaches this place through the other hair: from the light, and from all around on the eye's side.
    // A little before this place, so that a strand does not shade itself.
    vec3 before = vec3(0.0, 0.0, 1.5 / float(textureSize(opacityToLight, 0).z));
    vec3 inEyeGrid = (gridFromWo[1] * vec4(position, 1.0)).xyz;
    float towardEye = texture(opacityToEye, inEyeGrid - before).x;
    float towardKey = texture(opacityToLight, (gridFromWo[0] * vec4(position, 1.0)).xyz - before).x;
    float column = texture(opacityToEye, vec3(inEyeGrid.xy, 1.0)).x;

    // Hair that other hair hides needs no widening, and deep in the coat no drawing.
    float hidden = towardEye * drawnWidth / max(ownWidth, 1e-6);
    float width = drawnWidth * mix(widening, 1.0, smoothstep(kHiddenFrom, kHiddenTo, hidden)) * alpha;
    width = min(width, greatestWidth) * min(slant, 1.42) + float(random & 0xFFFFu) * (1.0 / 65536.0);
    width = hidden < kUndrawn ? width : 0.0;

    // Pigment fades evenly toward the tip.
    HairPoint point = HairPoint(position, tangent, mix(lightShownAs(rootColour), lightShownAs(tipColour), s),
                                mix(fibreDepth(rootColour), fibreDepth(tipColour), s), variation, towardKey, towardEye,
                                max(column - towardEye, 0.0));
    vec3 lit = heldLight(hairLight(point, material.x, material.y));

    uint colour = packColour(lit, unitHash(slot * 257u + (i - first)));
    uint widthBits = uint(clamp(width * 128.0, 0.0, 4094.0));
    float distanceM = i == last ? -clip.w : clip.w;
    projected[i] = uvec4(floatBitsToUint(placeSp.x), floatBitsToUint(placeSp.y), floatBitsToUint(distanceM),
                         colour | (widthBits << 20));
}
