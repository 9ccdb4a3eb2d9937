// Light from all around on a surface with unit normal n; what the short series leaves below 0 is cut.
vec3 irradianceAt(vec3 n)
{
    vec3 e = around[0].rgb + around[1].rgb * n.y + around[2].rgb * n.z + around[3].rgb * n.x + around[4].rgb * (n.x * n.y) +
             around[5].rgb * (n.y * n.z) + around[6].rgb * (3.0 * n.z * n.z - 1.0) + around[7].rgb * (n.x * n.z) +
             around[8].rgb * (n.x * n.x - n.y * n.y);
    return max(e, 0.0);
}

// From the scene's light to the screen's: what is dim stays as it is, what is bright rolls off toward white.
const float kMostLight = 4.0; // What samples hold at most; a white wall in full light is 1.
const float kToneKnee = 0.5;

const float kPaling = 0.5; // How much of its colour the brightest light loses.
const float kMostPainted = 0.875; // What is painted lighter would take too much light to show.

// By the brightest channel, so that no colour changes its hue; what is far too bright pales.
vec3 toneOf(vec3 light)
{
    float brightest = max(max(light.r, light.g), max(light.b, 1e-6));
    float over = max(brightest - kToneKnee, 0.0) / (1.0 - kToneKnee);
    float rolledOff = over / (1.0 + over);
    float shown = min(brightest, kToneKnee) + (1.0 - kToneKnee) * rolledOff;
    float square = rolledOff * rolledOff;
    return mix(light * (shown / brightest), vec3(shown), square * square * kPaling);
}

// Light that toneOf() shows as `shown`.
vec3 lightShownAs(vec3 shown)
{
    float brightest = max(max(shown.r, shown.g), max(shown.b, 1e-6));
    float over = clamp(brightest - kToneKnee, 0.0, kMostPainted - kToneKnee);
    return shown * ((min(brightest, kToneKnee) + over * (1.0 - kToneKnee) / (1.0 - kToneKnee - over)) / brightest);
}

// Light up to kMostLight <-> 0..1, by its brightest channel: dim light keeps its steps.
vec3 heldLight(vec3 light)
{
    float most = max(light.r, max(light.g, light.b));
    return min(light / (1.0 + (1.0 - 1.0 / kMostLight) * most), 1.0);
}

vec3 lightHeld(vec3 held)
{
    float most = max(held.r, max(held.g, held.b));
    return held / (1.0 - (1.0 - 1.0 / kMostLight) * most);
}
