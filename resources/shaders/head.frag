// Skin, or the clay of a display piece, under lamps and surroundings, with a faint sheen.
// Out: square root of the held light; alpha 1 where there is head.
in vec3 skinHd;
in vec3 skinWo;
in vec3 normalWo;
in vec4 marks; // Sky, lips, lids, blush.
in vec4 tint; // The scalp's tint: linear colour times cover, and cover.
layout(location = 0) out vec4 rootColour;
in vec2 skinUv;
uniform sampler2D skinTexture;
uniform vec4 skinTextured; // x: 1 where it has a texture; y: the least alpha that is drawn.
#ifdef SOLID
layout(location = 1) out float worn; // 1: hair does not show through it.
uniform vec4 solidSkin[3]; // As the frame's, for a body that is worn.
#define skin solidSkin
#endif

float unitNoise(ivec3 cell)
{
    return unitHash(uint(cell.x) * 0x8DA6B343u ^ uint(cell.y) * 0xD8163841u ^ uint(cell.z) * 0xCB1AB31Fu);
}

// Gradient of value noise over cells of one unit.
vec3 noiseGradient(vec3 p)
{
    ivec3 cell = ivec3(floor(p));
    vec3 t = p - vec3(cell);
    vec3 ease = t * t * (3.0 - 2.0 * t);
    vec3 slope = 6.0 * t * (1.0 - t);
    float c[8];
    for (int i = 0; i < 8; ++i)
        c[i] = unitNoise(cell + ivec3(i & 1, (i >> 1) & 1, i >> 2));
    vec4 low = vec4(c[0], c[2], c[4], c[6]);
    vec4 rise = vec4(c[1], c[3], c[5], c[7]) - low;
    vec4 alongX = low + rise * ease.x;
    vec2 y0 = alongX.xz, y1 = alongX.yw;
    vec2 alongY = mix(y0, y1, ease.y);
    vec2 riseX = mix(rise.xz, rise.yw, ease.y);
    return slope * vec3(mix(riseX.x, riseX.y, ease.z), mix(y1.x - y0.x, y1.y - y0.y, ease.z), alongY.y - alongY.x);
}

// Pores and fine lines, as far as the picture can show them: a cell that is smaller than two pixels would only flicker.
vec3 grained(vec3 n, float depth)
{
    const float kCellsM[2] = float[](0.0016, 0.0007);
    const float kSlopes[2] = float[](0.045, 0.09);
    float pixelM = length(fwidth(skinHd));
    vec3 slope = vec3(0.0);
    for (int i = 0; i < 2; ++i) {
        float seen = 1.0 - smoothstep(0.2, 0.5, pixelM / kCellsM[i]);
        if (seen > 0.0)
            slope += seen * kSlopes[i] * noiseGradient(skinHd / kCellsM[i]);
    }
    slope = mat3(woFromHd) * slope * depth;
    return normalize(n - (slope - n * dot(slope, n)));
}

// Sky that reaches a point of which `sky` is open, light thrown back by the skin around it included: Jimenez and others,
// Practical Realtime Strategies for Accurate Indirect Occlusion.
vec3 openness(float sky, vec3 albedo)
{
    vec3 a = 2.0404 * albedo - 0.3324;
    vec3 b = -4.7951 * albedo + 0.6417;
    vec3 c = 2.7552 * albedo + 0.6903;
    return max(vec3(sky), ((sky * a + b) * sky + c) * sky);
}

void main()
{
    vec3 n = normalize(normalWo);
    vec3 v = normalize(eyeWo.xyz - skinWo);
    if (dot(n, v) < 0.0 && !gl_FrontFacing)
        n = -n;
    float scatter = skin[0].w;
    float sheen = skin[2].w;
    vec3 smoothNormal = n;
    n = grained(n, skin[1].w);

    vec3 albedo = mix(skin[0].rgb, skin[1].rgb, 0.35 * marks.w);
    albedo = mix(albedo, skin[2].rgb, marks.z);
    albedo = mix(albedo, skin[1].rgb, marks.y);
    if (skinTextured.x > 0.0) {
        vec4 texel = texture(skinTexture, skinUv);
        if (texel.a < skinTextured.y)
            discard;
        albedo = texel.rgb;
#ifdef SOLID
        albedo *= skin[0].rgb;
#endif
    }
    albedo = albedo * (1.0 - tint.w) + tint.rgb;

    float up = n.y * 0.5 + 0.5;
    vec3 open = openness(marks.x, albedo);
    vec3 ambient = irradianceAt(n) * (0.52 + 0.2 * up);
    vec3 colour = ambient * open * albedo;
    float grazing = pow(1.0 - max(dot(smoothNormal, v), 0.0), 3.0);
    vec3 gloss = ambient * (marks.x * marks.x * 0.06) * grazing * (albedo + 0.3);

    vec3 wrap = 0.16 + scatter * vec3(0.15, 0.03, 0.0);
    float exponent = mix(24.0, 48.0, marks.y);
    vec3 lamps[3] = vec3[](keyWo.xyz, fillWo.xyz, rimWo.xyz);
    vec3 lampColours[3] = vec3[](keyColour.rgb, fillColour.rgb, rimColour.rgb);
    for (int i = 0; i < 3; ++i) {
        vec3 l = lamps[i];
        // Light goes under the skin and comes out beyond the edge of the shadow, red furthest. There pores are filled too.
        vec3 facing = mix(vec3(dot(n, l)), vec3(dot(smoothNormal, l)), scatter * vec3(0.7, 0.4, 0.3));
        vec3 key = clamp((facing + wrap) / (1.0 + wrap), 0.0, 1.0);
        key *= sqrt(key);
        // A fold that is open to half the sky is open to light from right above it alone.
        key *= smoothstep(-0.25, 0.35, dot(smoothNormal, l) + 2.0 * marks.x * marks.x - 1.0);
        colour += albedo * key * 0.85 * lampColours[i];
        vec3 h = normalize(l + v);
        float shine = pow(max(dot(n, h), 0.0), exponent) * (exponent + 8.0) * 0.0011 * clamp(dot(n, l) * 4.0, 0.0, 1.0);
        gloss += lampColours[i] * (marks.x * shine * (1.0 + 4.0 * grazing));
    }
    colour += sheen * gloss;
    rootColour = vec4(sqrt(heldLight(colour)), 1.0);
#ifdef SOLID
    worn = 1.0;
#endif
}
