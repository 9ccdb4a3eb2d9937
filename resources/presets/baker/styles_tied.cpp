// Styles whose hair goes through ties.
#include "model/project/hair_types.h"
#include "strokes.h"
#include "styles.h"

#include <array>
#include <vector>

namespace hairpaint::presets {

namespace {

using model::WornKind;

/// Settings for hair that is drawn taut to its tie: few hairs stray.
sim::GroupSettings tautSettings(float greatestLengthM)
{
    sim::GroupSettings settings = settingsOf(greatestLengthM, 0.05F, 0.006F);
    settings.variation.partGapM = 0.0F;
    settings.variation.flyaways = 0.006F;
    settings.nodesPerHair = 16;
    settings.material.shine = 0.6F;
    return settings;
}

/// What is tied half up: from the temples rising to the back of the crown.
Recording::Points aroundUpper(const Recording& user)
{
    constexpr std::array<Recording::Seen, 11> kLeft{{{0.0F, 0.056F},
                                                     {18.0F, 0.056F},
                                                     {34.0F, 0.054F},
                                                     {46.0F, 0.050F},
                                                     {60.0F, 0.054F},
                                                     {76.0F, 0.058F},
                                                     {96.0F, 0.061F},
                                                     {120.0F, 0.062F},
                                                     {140.0F, 0.060F},
                                                     {160.0F, 0.058F},
                                                     {180.0F, 0.057F}}};
    std::vector<Recording::Seen> line(kLeft.begin(), kLeft.end());
    for (std::size_t i = kLeft.size() - 1; i-- > 0;)
        line.push_back({-kLeft[i].degrees, kLeft[i].heightM});
    return user.along(line);
}

/// Ties of that colour and radius, which draw hair less than taut.
void setTies(Recording& user, WornKind kind, QRgb value, float radiusM, float coilRadiusM = 0.0F)
{
    constexpr float kTightness = 0.75F;
    user.setWorn(kind, [=](model::Worn& tie) {
        tie.colour = value;
        tie.shape.semiAxesM = glm::vec3(radiusM);
        tie.tightness = kTightness;
        tie.coilRadiusM = coilRadiusM;
    });
}

/// Long hair of one colour, all of it in one ponytail.
void tieAll(Recording& user, QRgb value, const sim::SurfacePoint& tie)
{
    user.setLayerOpacity(MapKind::Density, 0.85F);
    user.fill(MapKind::Colour, colour(value));
    user.fill(MapKind::Length, user.length(0.40F));
    user.fill(MapKind::Curl, scalar(1.0F));
    user.gather(WornKind::Ponytail, tie);
}

/// Sideburns are too short for a tie behind the ears: drawn there they would stand off over them.
void cutSideburns(Recording& user)
{
    user.brush(MapKind::Length, user.length(0.010F), {.sizeM = 0.016F, .hardness = 1.0F},
               {user.around(68.0F, -0.010F), user.around(73.0F, 0.005F), user.around(77.0F, 0.020F),
                user.around(77.0F, 0.036F)});
}

void waveSlightly(sim::GroupSettings& settings, float pitchM)
{
    model::setHairType(settings, model::hairType("2A"));
    settings.curl.diameterM = 0.03F;
    settings.curl.pitchM = pitchM;
}

} // namespace

Style highPonytail()
{
    Style style{.id = "high-ponytail",
                .name = "High ponytail",
                .tags = {QStringLiteral("long"), QStringLiteral("straight"), QStringLiteral("tied")},
                .settings = tautSettings(0.50F),
                .record = [](Recording& user) {
                    tieAll(user, 0xFF7E5C3A, user.above(0.0F, -0.072F));
                    setTies(user, WornKind::Ponytail, 0xFF2A2426, 0.017F);
                }};
    waveSlightly(style.settings, 0.24F);
    return style;
}

Style lowPonytail()
{
    Style style{.id = "low-ponytail",
                .name = "Low ponytail",
                .tags = {QStringLiteral("long"), QStringLiteral("straight"), QStringLiteral("tied")},
                .settings = tautSettings(0.45F),
                .record = [](Recording& user) {
                    tieAll(user, 0xFF2A1E1A, user.around(180.0F, -0.03F));
                    setTies(user, WornKind::Ponytail, 0xFF8A1C30, 0.016F);
                }};
    waveSlightly(style.settings, 0.24F);
    return style;
}

Style lowBun()
{
    Style style{.id = "low-bun",
                .name = "Low bun",
                .tags = {QStringLiteral("long"), QStringLiteral("straight"), QStringLiteral("tied")},
                .settings = tautSettings(0.70F),
                .record = [](Recording& user) {
                    user.setLayerOpacity(MapKind::Density, 0.85F);
                    user.fill(MapKind::Colour, colour(0xFF4A2C1C));
                    user.fill(MapKind::Length, user.length(0.66F));
                    cutSideburns(user);
                    user.fill(MapKind::Clump, scalar(0.3F));
                    user.gather(WornKind::Bun, user.around(180.0F, -0.022F));
                    setTies(user, WornKind::Bun, 0xFF3A2418, 0.014F, 0.032F);
                }};
    style.settings.nodesPerHair = 24;
    style.settings.variation.length = style.settings.variation.mostShorterM = 0.0F; // No end sticks out of the coil.
    return style;
}

Style halfUp()
{
    Style style{.id = "half-up",
                .name = "Half-up with bow",
                .tags = {QStringLiteral("long"), QStringLiteral("wavy"), QStringLiteral("tied")},
                .settings = tautSettings(0.50F),
                .record = [](Recording& user) {
                    user.setLayerOpacity(MapKind::Density, 0.85F);
                    user.fill(MapKind::Colour, colour(0xFF74502E));
                    cutToLine(user, -0.22F, 0.12F);
                    user.fill(MapKind::Curl, scalar(1.0F));
                    user.setMirror(false);
                    user.polygon(MapKind::Accessory, entry(kPonytail), aroundUpper(user));
                    user.setMirror(true);
                    user.gather(WornKind::Ponytail, user.around(180.0F, 0.066F));
                    setTies(user, WornKind::Ponytail, 0xFF7A1830, 0.011F);
                    user.setWorn(WornKind::Ponytail, [](model::Worn& tie) {
                        // It leaves downward, close to the hair that hangs loose.
                        constexpr float kDownRad = 1.1F;
                        tie.tightness = 0.4F;
                        tie.shape.rotation *= glm::angleAxis(kDownRad, glm::vec3(1.0F, 0.0F, 0.0F));
                    });
                    user.wear(WornKind::Bow, user.around(180.0F, 0.070F));
                    user.setWorn(WornKind::Bow, [](model::Worn& bow) {
                        bow.colour = 0xFF7A1830;
                        bow.shape.semiAxesM *= 1.15F;
                        // On the hair that the tie gathers.
                        bow.shape.centreHd += bow.shape.rotation * glm::vec3(0.0F, 0.0F, 0.016F);
                    });
                }};
    waveSlightly(style.settings, 0.2F);
    return style;
}

Style twinTails()
{
    Style style{.id = "twin-tails",
                .name = "Twin tails",
                .tags = {QStringLiteral("long"), QStringLiteral("straight"), QStringLiteral("tied")},
                .settings = tautSettings(0.45F),
                .record = [](Recording& user) {
                    user.setLayerOpacity(MapKind::Density, 0.85F);
                    user.fill(MapKind::Colour, colour(0xFF8A6038));
                    user.fill(MapKind::Length, user.length(0.38F));
                    user.fill(MapKind::Curl, scalar(1.0F));
                    user.fill(MapKind::Clump, scalar(0.35F));
                    user.polygon(MapKind::Accessory, entry(kPonytail), aroundLeft(user, 0.0F));
                    outToHairline(user, MapKind::Accessory, entry(kPonytail));
                    // Skin between the two, or they would be one.
                    user.erase(MapKind::Accessory, {.sizeM = 0.002F, .hardness = 1.0F}, overMiddle(user));
                    shaveMiddle(user, 0.0044F);
                    // So far back that tails fall behind the shoulders: on top of one they would bend and spread.
                    for (const float degrees : {130.0F, -130.0F})
                        user.gather(WornKind::Ponytail, user.around(degrees, 0.056F));
                    setTies(user, WornKind::Ponytail, 0xFFC23A5A, 0.013F);
                }};
    waveSlightly(style.settings, 0.24F);
    return style;
}

Style topKnot()
{
    Style style{.id = "top-knot",
                .name = "Top knot with undercut",
                .tags = {QStringLiteral("short"), QStringLiteral("straight"), QStringLiteral("tied")},
                .settings = tautSettings(0.50F),
                .record = [](Recording& user) {
                    const Recording::Points top = aroundTop(user);
                    user.setLayerOpacity(MapKind::Density, 0.95F);
                    user.fill(MapKind::Colour, colour(0xFF33231A));
                    user.fill(MapKind::Length, user.length(0.007F));
                    fade(user, 0.003F, 0.007F);
                    user.setMirror(false);
                    user.polygon(MapKind::Length, user.length(0.45F), top);
                    user.polygon(MapKind::Accessory, entry(kBun), top);
                    // No long hair at its edge stays loose.
                    user.brush(MapKind::Accessory, entry(kBun), {.sizeM = 0.010F, .hardness = 1.0F}, top);
                    user.setMirror(true);
                    user.gather(WornKind::Bun, user.around(180.0F, 0.086F));
                    setTies(user, WornKind::Bun, 0xFF1E1815, 0.010F, 0.026F);
                }};
    style.settings.nodesPerHair = 24;
    style.settings.variation.length = style.settings.variation.mostShorterM = 0.0F; // No end sticks out of the coil.
    return style;
}

Style fishtail()
{
    Style style{.id = "fishtail",
                .name = "Fishtail plait",
                .tags = {QStringLiteral("long"), QStringLiteral("braided"), QStringLiteral("tied")},
                .settings = tautSettings(0.50F),
                .record = [](Recording& user) {
                    user.setLayerOpacity(MapKind::Density, 0.8F);
                    user.fill(MapKind::Colour, colour(0xFF6E3E22));
                    user.fill(MapKind::Length, user.length(0.46F));
                    user.fill(MapKind::Frizz, scalar(0.1F));
                    cutSideburns(user);
                    user.fill(MapKind::Braid, entry(kFishtail));
                    // Over the shoulder.
                    user.gather(WornKind::Ponytail, user.around(138.0F, -0.03F));
                    setTies(user, WornKind::Ponytail, 0xFF5A2E16, 0.010F);
                }};
    style.settings.braidRadiusM = 0.013F;
    style.settings.braidTaper = 0.4F;
    return style;
}

} // namespace hairpaint::presets
