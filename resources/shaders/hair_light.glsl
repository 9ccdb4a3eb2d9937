// Light on a point of a hair: scattered once by the hair itself, many times by the coat, and held back by the hair and
// the head in its path. view/rendering/light/ says the same, formula by formula, with the sources.

// Angles of the light and the eye, both seen from the fibre; inclinations are measured from the plane across it.
struct FibreAngles
{
    float sinI, cosI;
    float sinO, cosO;
    float cosPhi;
    float cosD; // Cosine of half the difference of the inclinations.
};

float cosineOf(float sine)
{
    return sqrt(max(1.0 - sine * sine, 1e-6));
}

FibreAngles fibreAngles(float sinI, float sinO, float cosO, float lightDotEye)
{
    float cosI = cosineOf(sinI);
    float cosines = cosI * cosO;
    float sines = sinI * sinO;
    return FibreAngles(sinI, cosI, sinO, cosO, clamp((lightDotEye - sines) / cosines, -1.0, 1.0),
                       sqrt(max(0.5 * (cosines + sines) + 0.5, 1e-4)));
}

// exp(-x) for x from 0 on.
float absorbed(float x)
{
    float a = 1.0 / (1.0 + x * (1.0 / 8.0 + x * (1.0 / 128.0)));
    a *= a;
    a *= a;
    return a * a;
}

vec3 absorbed(vec3 x)
{
    return vec3(absorbed(x.r), absorbed(x.g), absorbed(x.b));
}

// Optical depth of a fibre whose coat looks as `colour`.
vec3 fibreDepth(vec3 colour)
{
    vec3 root = log(clamp(colour, 0.001, 0.999)) * (1.0 / 5.8877);
    return root * root * 1.8526;
}

// Lobes R, TT, TRT along twice the sine of the half angle.
struct FibreShape
{
    vec3 shift;
    vec3 exponent;
    vec3 peak;
};

const float kScaleTiltRad = 0.045;
const float kCosinePowerPeak = 0.8103764;

FibreShape fibreShape(float roughness)
{
    vec3 deviation = (0.02 + 0.18 * roughness) * vec3(1.0, 0.8, 1.8);
    return FibreShape(vec3(-2.0, 1.0, 4.0) * kScaleTiltRad, -0.72134752 / (deviation * deviation), 0.39894228 / deviation);
}

const float kNormalReflectance = 0.0465206;

float reflectance(float cosine)
{
    float a = 1.0 - cosine;
    float square = a * a;
    return kNormalReflectance + (1.0 - kNormalReflectance) * (square * square * a);
}

float meanReflectance(float c)
{
    float integral =
        1.0 +
        c * (-3.92699082 + c * (6.66666667 + c * (-5.89048623 + c * (2.66666667 - c * 0.49087385))));
    return kNormalReflectance + (1.0 - kNormalReflectance) * integral;
}

struct FibreLobes
{
    float r;
    vec3 tt, trt;
    vec3 through;
};

float eighthPower(float x)
{
    x = max(x, 0.05);
    x *= x;
    x *= x;
    return x * x;
}

FibreLobes marschner(FibreShape shape, FibreAngles at, vec3 depth, float jitter, float sharpness)
{
    float perCosD = 1.0 / at.cosD;
    vec3 off = ((at.sinI + at.sinO) * perCosD + jitter - shape.shift) * sharpness;
    vec3 longitudinal = exp2(max(off * off * shape.exponent, -20.0)) * shape.peak * (perCosD * sharpness);
    float toward = 0.5 + 0.5 * at.cosPhi;
    float cosHalf = sqrt(toward);
    float sinSquare = 1.0 - at.cosD * at.cosD;
    float path = 1.0 + sinSquare * (0.186 + sinSquare * 0.123);
    float reflected = meanReflectance(at.cosD);
    float entered = (1.0 - reflected) * (1.0 - reflected) * kCosinePowerPeak;
    FibreLobes lobes;
    lobes.through = absorbed(depth * path);
    lobes.r = longitudinal.x * reflectance(at.cosD * cosHalf) * cosHalf * 0.25;
    lobes.tt = lobes.through * (longitudinal.y * entered * eighthPower(0.5 - 0.5 * at.cosPhi));
    lobes.trt = lobes.through * lobes.through * (longitudinal.z * entered * reflected * eighthPower(toward));
    return lobes;
}

float powerOf(float x, float power)
{
    return exp2(log2(max(x, 1e-30)) * power);
}

// Highlights in the light's colour and in the hair's.
vec2 kajiyaKay(FibreAngles at, float exponent)
{
    const vec2 kSines = vec2(0.0898785, -0.1790296);
    const vec2 kCosines = vec2(0.9959527, 0.9838437);
    vec2 sine = at.sinI * kCosines + at.cosI * kSines;
    vec2 cosine = at.cosI * kCosines - at.sinI * kSines;
    vec2 mirrored = clamp(cosine * at.cosO - sine * at.sinO, 0.0, 1.0);
    return vec2(powerOf(mirrored.x, exponent), powerOf(mirrored.y, exponent * 0.25));
}

// Diffuse, specular.
vec2 illuminatedLine(FibreAngles at, float exponent)
{
    return vec2(powerOf(at.cosI, 4.8), powerOf(max(at.cosI * at.cosO - at.sinI * at.sinO, 0.0), exponent));
}

// Light left of 1 behind fibres: w that met none, rgb with what was scattered forward.
vec4 passedThrough(float crossed, vec3 depth)
{
    float direct = absorbed(crossed * 0.75);
    return vec4(direct + (1.0 - direct) * 0.7 * absorbed(crossed * (depth + 0.07)), direct);
}

// Fraction of a far light that passes the head: an umbra of its size with a soft edge.
float besideHead(vec3 fromHead, float radiusM, vec3 toward)
{
    float along = dot(fromHead, toward);
    float off = sqrt(max(dot(fromHead, fromHead) - along * along, 0.0));
    float r = max(radiusM, 1e-4);
    return 1.0 - (1.0 - smoothstep(0.5 * r, 1.3 * r, off)) * smoothstep(0.0, 0.8 * r, -along);
}

struct HairPoint
{
    vec3 position;
    vec3 tangent;
    vec3 colour;
    vec3 depth;
    float turned; // turnedBy() of this hair.
    float towardKey, towardEye, towardRim;
    float shine;     // This hair's factor on the group's shine.
    float sharpness; // Sharpness of its highlights over the group's.
};

// By how much a fibre's lobes stand elsewhere than those of its neighbours; see hair_light_inl.h.
float turnedBy(float variation)
{
    const float kMost = 0.12;
    float pair = variation * 2.0;
    return (pair - floor(pair + 0.5)) * (2.0 * kMost);
}

// White of a highlight that hairs of a coat show, bounded where light grazes them; see hair_light_inl.h.
float drawnGloss(float white, float cosPhi)
{
    return white / (1.0 + white * (1.0 - cosPhi) * 6.0);
}

const float kCoat = 1.1; // Makes up for the light that the coat's own shade takes, see hair_light_inl.h.
const int kMarschner = 0;
const int kKajiyaKay = 1;
const int kAll = 0; // Lobes that a light needs.
const int kBack = 1;
const int kForward = 2;

// open: nothing of the head stands right behind it, so that light goes on through it to the eye.
vec3 lightOf(int lobeSet, vec3 toward, vec3 lampColour, HairPoint point, vec3 view, vec3 normal, float sinO, float open,
             vec4 passed, float shine, float roughness)
{
    const float kForwardPart = 0.5;
    FibreAngles at = fibreAngles(dot(point.tangent, toward), sinO, cosineOf(sinO), dot(toward, view));
    float wrap = clamp(dot(normal, toward) * 0.62 + 0.38, 0.0, 1.0);
    float facing = 0.1 + 0.9 * wrap * wrap;
    float deviation = 0.02 + 0.18 * roughness;
    float exponent = point.sharpness * point.sharpness / (deviation * deviation);
    shine *= point.shine;
    int scattering = int(keyWo.w);
    vec3 lit;
    if (scattering == kMarschner) {
        FibreLobes lobes = marschner(fibreShape(roughness), at, point.depth, point.turned, point.sharpness);
        float front = shine * passed.w * kPi;
        lit = point.colour * passed.rgb * ((0.35 + 0.65 * at.cosI) * facing * kCoat) +
              drawnGloss(lobes.r * front * (0.3 + 0.7 * wrap) * (lobeSet == kForward ? kForwardPart : 1.0), at.cosPhi);
        if (lobeSet != kBack)
            lit += lobes.tt * lobes.through * lobes.through * lobes.through * passed.rgb * (open * kPi * kForwardPart);
        if (lobeSet != kForward)
            lit += lobes.trt * front;
    } else if (scattering == kKajiyaKay) {
        vec2 highlights = kajiyaKay(at, exponent) * shine * passed.w * wrap;
        lit = point.colour * passed.rgb * (at.cosI * facing * kCoat) + highlights.x * 0.15 +
              point.colour * (highlights.y * 0.5);
    } else {
        vec2 line = illuminatedLine(at, exponent);
        lit = point.colour * passed.rgb * (line.x * facing * kCoat) + line.y * shine * passed.w * 0.25;
    }
    return lit * lampColour;
}

vec3 hairLight(HairPoint point, float shine, float roughness)
{
    vec3 view = eyeWo.xyz - point.position;
    view *= inversesqrt(max(dot(view, view), 1e-20));
    vec3 fromHead = point.position - headWo.xyz;
    vec3 outward = fromHead * inversesqrt(dot(fromHead, fromHead) + 1e-8);
    vec3 normal = normalize(outward * 1.3 - point.tangent * dot(outward, point.tangent));
    float sinO = dot(point.tangent, view);
    float open = besideHead(fromHead, headWo.w, -view);
    vec4 fromKey = passedThrough(point.towardKey, point.depth);
    vec4 fromEye = passedThrough(point.towardEye, point.depth);
    vec4 fromRim = passedThrough(point.towardRim, point.depth);
    vec3 lit = irradianceAt(normal) * point.colour * fromEye.rgb * kCoat;
    lit += lightOf(kBack, fillWo.xyz, fillColour.rgb, point, view, normal, sinO, open, fromEye, shine, roughness);
    float keyLeft = besideHead(fromHead, headWo.w, keyWo.xyz);
    if (keyLeft > 0.0)
        lit += keyLeft *
               lightOf(kAll, keyWo.xyz, keyColour.rgb, point, view, normal, sinO, open, fromKey, shine, roughness);
    float rimLeft = besideHead(fromHead, headWo.w, rimWo.xyz);
    if (rimLeft > 0.0)
        lit += rimLeft *
               lightOf(kForward, rimWo.xyz, rimColour.rgb, point, view, normal, sinO, open, fromRim, shine, roughness);
    return lit;
}
