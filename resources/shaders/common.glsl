// What every shader of the renderer shares: the frame's constants and the packing of samples; strands are laid out in
// strand_layout.glsl.
// Spaces: Wo world, m; Sp samples of the picture, x right, y up, samplesPerPixel in each direction.

layout(std140, binding = 0) uniform Frame
{
    mat4 projectionFromWo;
    mat4 woFromProjection;
    mat4 woFromHd;
    mat4 gridFromWo[2];     // Wo -> 0..1 in the opacity grids; z runs away from the light, from the eye.
    vec4 eyeWo;
    vec4 keyWo;             // Toward the key light, unit; w: how hair scatters light, as rendering::Scattering.
    vec4 keyColour;         // Linear, intensity included, as all lights.
    vec4 fillWo;            // The fill beside the eye,
    vec4 fillColour;
    vec4 rimWo;             // the light behind the head.
    vec4 rimColour;
    vec4 around[9];         // Irradiance over pi of the surroundings, as rendering::Irradiance.
    vec4 headWo;            // Centre; w: radius of the skull, m; 0 where there is no head.
    vec4 depthRange;        // Distance along the view of key 0, keys a metre; then c0, c1 of linearDepth.
    vec4 target;            // Samples across and up, samples a pixel across and up.
    vec4 gridSize;          // Area in m2 of a voxel of either grid, seen along z; samples that a metre covers at 1 m;
                            // w: fraction of its light that skin keeps under dense hair.
    vec4 background[2];     // sRGB as encoded: in the middle of the picture, and how much it rises to the top.
    vec4 ringWo[2];         // Centre; w: radius, 0 where there is no ring.
    vec4 neckTurn;          // From the head's frame to the shoulders': x, y, z, w of a quaternion; w >= 0.
    vec4 neckPivotHd;       // What it turns about; w: height above which nothing does.
    vec4 neckReach;         // How much of the turn a metre further down takes part.
    vec4 skin[3];           // Linear colours of skin, lips, lids; w: how far light scatters, depth of grain, sheen; 0..1.
    vec4 eyeGrid[2];        // rendering::EyeGrid: low, sectionM2; per, middleM.
};

// Where the x of a skeleton's node is; y and z follow kStrandLanes apart.
uint nodeIndex(uint slot, int node, int nodes)
{
    return ((slot / kStrandLanes) * uint(nodes) + uint(node)) * 3u * kStrandLanes + slot % kStrandLanes;
}

const float kPi = 3.14159265;

// Position of a point in the grid away from the eye, 0..1. `seen`: the point's normalised device x and y, and its
// distance along the view.
vec3 inEyeGrid(vec3 seen)
{
    return (seen - eyeGrid[0].xyz) * eyeGrid[1].xyz;
}

// Distances along the view in 16 bits. As many as there are keys of depthRange, times what those lack.
const float kDepthsPerKey = 65535.0 / 4095.0;

float depthOf(float distanceM)
{
    return (distanceM - depthRange.x) * depthRange.y * kDepthsPerKey;
}

// Distance along the view from a depth buffer's value.
float linearDepth(float depth)
{
    return depthRange.z / (depthRange.w - (2.0 * depth - 1.0));
}

// The position of a sample whose depth buffer holds `depth`.
vec3 unprojected(vec2 atSp, float depth)
{
    vec4 wo = woFromProjection * vec4(vec3(atSp / target.xy, depth) * 2.0 - 1.0, 1.0);
    return wo.xyz / wo.w;
}

vec3 linearFromSrgb(vec3 c)
{
    return c * (c * (c * 0.305306011 + 0.682171111) + 0.012522878);
}

// sRGB by a polynomial of the light's square root; within 1/1300 of the standard's curve.
vec3 fastSrgb(vec3 c)
{
    c = clamp(c, 0.0, 1.0);
    vec3 s = sqrt(c);
    vec3 bent = (((-0.309565892 * s + 0.842780549) * s - 0.944855478) * s + 1.447898657) * s;
    return max(bent - 0.037004691, 12.92 * min(c, 0.0031));
}

uint hashOf(uint x)
{
    x ^= x >> 16;
    x *= 0x7FEB352Du;
    x ^= x >> 15;
    x *= 0x846CA68Bu;
    return x ^ (x >> 16);
}

float unitHash(uint x)
{
    return float(hashOf(x) >> 8) * (1.0 / 16777216.0);
}

// A strand's length over its taper's, at least 1.
float perTaperOf(float lengthM, float taperM)
{
    return taperM > 0.0 ? max(lengthM / taperM, 1.0) : 1.0;
}

// Fraction of the strand at point j of so many segments: evenly, but the point before the tip is not before the taper's
// begin.
float fractionOf(int j, int segments, float perTaper)
{
    float s = float(j) / float(segments);
    return perTaper > 1.0 && segments > 2 && j + 1 == segments ? max(s, 1.0 - 1.0 / perTaper) : s;
}
