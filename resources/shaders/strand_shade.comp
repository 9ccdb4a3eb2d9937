// Lights each point of the strands and projects it to samples. A strand's width says how much of the samples it covers;
// where fewer hairs stand for all, those of the highest order thin out to nothing. One invocation a point.
layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly buffer Strands { DrawnStrand strands[]; };
layout(std430, binding = 1) readonly buffer Styles { PackedStyle styles[]; };
layout(std430, binding = 2) readonly buffer Points { vec4 pointsWo[]; };
layout(std430, binding = 3) writeonly buffer Projected { uvec4 projected[]; };
// Area of hair between a point and the light, the eye, over the area it covers.
layout(binding = 0) uniform sampler3D opacityToLight;
layout(binding = 1) uniform sampler3D opacityToEye;

uniform uint firstStrand;
uniform uint firstProjected; // Where the first of these points goes.
uniform uint pointCount;
uniform float fraction;      // Fraction of the hairs that are drawn; they are widened to cover as much.
uniform float deepFraction;  // Fraction of those that is left where others hide them.
uniform float undrawnCoverings;
uniform bool inEveryColumn;  // Those must lie in each of the columns around, not only interpolated between them.
uniform vec4 material;       // Shine, roughness, alpha at root and tip.
uniform float taperM;        // Length over which a hair thins out to its tip, m; 0: over all of it.
uniform vec2 tipFromOver;    // StrandMaterial::tipFrom and tipOver; see sim::tipMixOf().
uniform float groupWidthM;   // Diameter of a hair whose width is 1.
uniform float variationScale;
uniform float sectionAxes;    // Longest over shortest diameter of a fibre's section; 1 where it is round.
// rendering::CoatAxis in the light's grid and the eye's.
uniform vec4 lightCoatMiddle, lightCoatDown, lightCoatPerDown;
uniform vec4 eyeCoatMiddle, eyeCoatDown, eyeCoatPerDown;
uniform float outOfCoatVoxels;

// As the software renderer has them.
const float kDeepFrom = 0.3; // Coverings of hair in front from which on fewer hairs are drawn, and as few as may be.
const float kDeepTo = 1.6;
const float kGreatestWidth = 24.0; // Greatest width, samples: wider strands would look like straw.
const float kMostSlant = 1.42;
const float kFadingPart = 0.15;
const float kNearestDrawnM = 0.01;
const float kSharpestTip = 1e-3; // Least fraction of the length over which the colour changes.

// The arithmetic that the formula is written in.
#define Num float
#define CURVE_FUNCTION
#define root sqrt
#define cosOf cos
#include "sim/groom/fibre_formula.inl"
#undef root

vec3 colourFromBytes(uint bits)
{
    return linearFromSrgb(unpackUnorm4x8(bits).rgb);
}

// A position in a grid, moved across its z out of the coat where that faces the light, or the eye, or stands steep: as
// grid_lookup_inl.h has it.
vec3 outOfCoat(vec3 position, vec3 middle, vec3 down, vec3 perDown, float voxel)
{
    const float kFacesAway = 3.0; // One over the cosine from which on nothing is moved.
    vec3 d = position - middle;
    vec3 away = d - down * max(dot(d, perDown), 0.0);
    float per = inversesqrt(max(dot(away, away), 1e-12));
    float part = clamp(1.0 - away.z * per * kFacesAway, 0.0, 1.0);
    return position + vec3(away.xy * (per * part * outOfCoatVoxels * voxel), 0.0);
}

// Before a point between the columns around, in the one with the least.
float inColumnWithLeast(vec3 position)
{
    int side = textureSize(opacityToEye, 0).x;
    vec3 at = clamp(position * float(side) - 0.5, 0.0, float(side) - 1.001);
    ivec3 low = ivec3(at);
    float least = 1e9;
    for (int column = 0; column < 4; ++column) {
        ivec3 voxel = low + ivec3(column & 1, column >> 1, 0);
        least = min(least, mix(texelFetch(opacityToEye, voxel, 0).x, texelFetch(opacityToEye, voxel + ivec3(0, 0, 1), 0).x,
                               fract(at.z)));
    }
    return least;
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
    float perTaper = perTaperOf(styles[slot].lengthM, taperM);
    float s = fractionOf(int(i - first), int(last - first), perTaper);
    vec3 position = self.xyz;
    vec3 along = pointsWo[min(i + 1u, last)].xyz - pointsWo[max(i, first + 1u) - 1u].xyz;
    vec3 tangent = along * inversesqrt(max(dot(along, along), 1e-20));

    vec4 clip = projectionFromWo * vec4(position, 1.0);
    vec2 across = clip.xy / max(clip.w, kNearestDrawnM);
    vec2 positionSp = (across * 0.5 + 0.5) * target.xy;

    // Light that reaches this point through the other hair: from the light, and from all around on the eye's side.
    // A little before this point, so that a strand does not shade itself.
    vec3 voxel = vec3(0.0, 0.0, 1.0 / float(textureSize(opacityToLight, 0).z));
    vec3 before = outOfCoatVoxels * voxel;
    vec3 seen = inEyeGrid(vec3(across, clip.w)) - before;
    float inFront = texture(opacityToEye, seen).x;
    // The position moved out of the coat may only lessen the shade.
    float towardEye = min(inFront, texture(opacityToEye, outOfCoat(seen, eyeCoatMiddle.xyz, eyeCoatDown.xyz, eyeCoatPerDown.xyz,
                                                                   voxel.z)).x);
    float further = texture(opacityToEye, seen + voxel).x;
    vec3 lightward = outOfCoat((gridFromWo[0] * vec4(position, 1.0)).xyz - before, lightCoatMiddle.xyz, lightCoatDown.xyz,
                               lightCoatPerDown.xyz, voxel.z);
    float towardKey = texture(opacityToLight, lightward).x;
    float column = texture(opacityToEye, vec3(seen.xy, 1.0)).x;

    // Thickness is measured across the walk's main direction, so slanted strands need more.
    vec4 clipAlong = projectionFromWo * vec4(tangent, 0.0);
    vec2 alongSp = abs((clipAlong.xy - across * clipAlong.w) * target.xy);
    float slant = length(alongSp) / max(max(alongSp.x, alongSp.y), 1e-10);
    float drawn = mix(fraction, fraction * deepFraction, smoothstep(kDeepFrom, kDeepTo, further));
    float kept = clamp((1.0 + kFadingPart - styles[slot].order / drawn) / kFadingPart, 0.0, 1.0);
    float widthM = styles[slot].width * groupWidthM * kept / min(drawn * (1.0 + 0.5 * kFadingPart), 1.0);
    float thinning = max(s * perTaper + (1.0 - perTaper), 0.0);
    float width = widthM * gridSize.z / max(clip.w, kNearestDrawnM) * mix(material.z, material.w, thinning * thinning);
    float glint = 1.0;
    float lean = 0.0;
    if (sectionAxes > 1.0) {
        Section section = sectionAt(sectionAxes, styles[slot].turns, styles[slot].lengthM, styles[slot].phase,
                                    styles[slot].variation, s);
        width *= section.width;
        glint = section.glint;
        lean = section.lean;
    }
    width = min(width, kGreatestWidth) * min(slant, kMostSlant);
    float hiding = inEveryColumn ? inColumnWithLeast(seen) : inFront;
    width = clip.w > kNearestDrawnM && hiding < undrawnCoverings ? width : 0.0;

    // Pigment fades evenly toward the tip.
    float variation = styles[slot].variation;
    float lightness = exp2(variation * variationScale * 3.0);
    vec3 rootColour = colourFromBytes(styles[slot].rootColour) * lightness;
    vec3 tipColour = colourFromBytes(styles[slot].tipColour) * lightness;
    float tipFrom = mix(tipFromOver.x, 1.0, styles[slot].tipStart);
    float tip = clamp((s - tipFrom) / max(tipFromOver.y * (1.0 - tipFrom), kSharpestTip), 0.0, 1.0);
    HairPoint point = HairPoint(position, tangent, mix(lightShownAs(rootColour), lightShownAs(tipColour), tip),
                                mix(fibreDepth(rootColour), fibreDepth(tipColour), tip), turnedBy(variation) + lean, towardKey,
                                towardEye, max(column - inFront, 0.0), styles[slot].shine * glint, styles[slot].sharpness);
    vec3 lit = hairLight(point, material.x, material.y);

    uint depth = uint(clamp(depthOf(clip.w), 0.0, 65535.0));
    projected[firstProjected + i] = uvec4(floatBitsToUint(positionSp.x), floatBitsToUint(positionSp.y), packedDepth(depth, width),
                                          packedLight(lit, i == last));
}
