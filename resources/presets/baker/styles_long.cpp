// Styles that fall over the shoulders or to the chin.
#include "model/project/hair_types.h"
#include "strokes.h"
#include "styles.h"

#include <array>

namespace hairpaint::presets {

namespace {

/// From the face over the head and behind the ears.
void combBack(Recording& user)
{
    constexpr std::array<Recording::Seen, 7> kOverEar{{{45.0F, 0.062F},
                                                       {58.0F, 0.058F},
                                                       {74.0F, 0.052F},
                                                       {92.0F, 0.044F},
                                                       {108.0F, 0.030F},
                                                       {120.0F, 0.008F},
                                                       {126.0F, -0.02F}}};
    constexpr std::array<Recording::Seen, 7> kAtEar{{{52.0F, 0.040F},
                                                     {64.0F, 0.036F},
                                                     {78.0F, 0.030F},
                                                     {94.0F, 0.026F},
                                                     {108.0F, 0.012F},
                                                     {116.0F, -0.010F},
                                                     {120.0F, -0.035F}}};
    constexpr std::array<Recording::Seen, 5> kBeforeEar{
        {{60.0F, 0.012F}, {68.0F, 0.014F}, {76.0F, 0.020F}, {90.0F, 0.022F}, {106.0F, 0.004F}}};
    const Ring ring{.sizeM = 0.03F, .hardness = 0.5F};
    user.comb(0.95F, ring, user.along(kBeforeEar));
    user.comb(0.95F, ring, user.along(kAtEar));
    user.comb(0.95F, ring, user.along(kOverEar));
    for (const float leftM : {0.055F, 0.042F, 0.028F, 0.014F, 0.0F})
        user.comb(0.93F, ring, user.overHead(leftM, 0.080F - 4.0F * leftM * leftM, -0.085F + 0.3F * leftM));
}

} // namespace

Style longStraight()
{
    Style style{.id = "long-straight",
                .name = "Long straight",
                .tags = {QStringLiteral("long"), QStringLiteral("straight")},
                .settings = settingsOf(0.50F, 0.05F, 0.008F),
                .record = [](Recording& user) {
                    user.setLayerOpacity(MapKind::Density, 0.85F);
                    user.fill(MapKind::Colour, colour(0xFF443229));
                    cutToLine(user, -0.26F, 0.12F);
                    user.fill(MapKind::Curl, scalar(0.06F));
                    user.fill(MapKind::Clump, scalar(0.30F));
                    partInTheMiddle(user, {});
                }};
    // Its slight wave keeps its length where hair is cut short.
    style.settings.turnsMode = sim::TurnsMode::PerLength;
    style.settings.turnsPerLengthM = 0.40F;
    style.settings.greatestCurlRadiusM = 0.010F;
    style.settings.nodesPerHair = 12;
    style.settings.material.shine = 0.6F;
    return style;
}

Style bob()
{
    Style style{.id = "bob",
                .name = "Bob",
                .tags = {QStringLiteral("medium"), QStringLiteral("straight")},
                .settings = settingsOf(0.25F, 0.055F, 0.010F),
                .record = [](Recording& user) {
                    user.setLayerOpacity(MapKind::Density, 0.9F);
                    user.fill(MapKind::Colour, colour(0xFF1E191B));
                    cutToLine(user, -0.085F, 0.10F);
                    user.fill(MapKind::Clump, scalar(0.25F));
                    // Shaved below, as in an undercut: hair from lower roots that ended at the line would be short
                    // enough to stand off.
                    for (const float heightM : {0.0F, -0.025F, -0.05F, -0.075F})
                        user.erase(MapKind::Density, {.sizeM = 0.03F, .hardness = 0.9F}, user.level(heightM, 75.0F));
                    partInTheMiddle(user, {});
                    combOffFace(user);
                }};
    style.settings.nodesPerHair = 10;
    style.settings.material.shine = 0.75F;
    style.settings.material.roughness = 0.28F;
    style.settings.material.tipAlpha = 0.7F;
    return style;
}

Style twoPlaits()
{
    Style style{.id = "two-plaits",
                .name = "Two plaits",
                .tags = {QStringLiteral("long"), QStringLiteral("braided")},
                .settings = settingsOf(0.40F, 0.04F, 0.006F),
                .record = [](Recording& user) {
                    user.setLayerOpacity(MapKind::Density, 0.7F);
                    user.fill(MapKind::Colour, colour(0xFF6A4C2E));
                    user.fill(MapKind::Length, user.length(0.28F));
                    user.fill(MapKind::Frizz, scalar(0.1F));
                    // A side is a region; the parting between them stays free.
                    user.polygon(MapKind::Braid, entry(kPlait), aroundLeft(user, 0.0F));
                    outToHairline(user, MapKind::Braid, entry(kPlait));
                    user.erase(MapKind::Braid, {.sizeM = 0.0028F, .hardness = 1.0F}, overMiddle(user));
                    shaveMiddle(user, 0.0048F);
                    // The plaits leave the head forward, to hang before the shoulders of any body.
                    constexpr std::array<Recording::Seen, 5> kForward{
                        {{112.0F, 0.075F}, {102.0F, 0.062F}, {92.0F, 0.052F}, {82.0F, 0.042F}, {72.0F, 0.03F}}};
                    user.comb(0.95F, {.sizeM = 0.045F, .hardness = 0.6F}, user.along(kForward));
                }};
    style.settings.braidSpacingM = 0.6F;
    style.settings.braidRadiusM = 0.0105F;
    style.settings.nodesPerHair = 16;
    return style;
}

Style splitDye()
{
    Style style{.id = "split-dye",
                .name = "Split dye",
                .tags = {QStringLiteral("medium"), QStringLiteral("wavy"), QStringLiteral("coloured")},
                .settings = settingsOf(0.34F, 0.05F, 0.014F),
                .record = [](Recording& user) {
                    user.setLayerOpacity(MapKind::Density, 0.85F);
                    user.setMirror(false);
                    user.fill(MapKind::Colour, colour(0xFF221C22));
                    user.rectangle(MapKind::Colour, colour(0xFFA0245C), {0.5F, 0.0F}, {1.0F, 1.0F});
                    user.setMirror(true);
                    cutToLine(user, -0.155F, 0.09F);
                    user.fill(MapKind::Curl, scalar(1.0F));
                    user.fill(MapKind::Clump, scalar(0.3F));
                    // A clean parting, so that neither colour strays into the other; no lock has hair of both sides.
                    Recording::Points middle = user.overHead(0.0F, 0.074F, -0.085F);
                    for (const float heightM : {0.05F, 0.02F})
                        middle.push_back(user.around(180.0F, heightM));
                    user.brush(MapKind::Clump, scalar(0.0F), {.sizeM = 0.03F, .hardness = 0.4F}, middle);
                    user.part({.flatness = 0.93F, .gapM = 0.002F}, middle);
                }};
    model::setHairType(style.settings, model::hairType("2C"));
    style.settings.curl.gather = 0.4F;
    style.settings.variation.parting = 0.0F;
    style.settings.variation.partGapM = 0.0F;
    style.settings.locks.ragged = 0.0F;
    style.settings.nodesPerHair = 12;
    return style;
}

Style headband()
{
    Style style{.id = "headband-long",
                .name = "Headband with long hair",
                .tags = {QStringLiteral("long"), QStringLiteral("straight"), QStringLiteral("tied")},
                .settings = settingsOf(0.50F, 0.05F, 0.0045F),
                .record = [](Recording& user) {
                    user.setLayerOpacity(MapKind::Density, 0.85F);
                    user.fill(MapKind::Colour, colour(0xFF9A7446));
                    cutToLine(user, -0.25F, 0.12F);
                    user.fill(MapKind::Curl, scalar(1.0F));
                    user.fill(MapKind::Clump, scalar(0.3F));
                    combBack(user);
                    user.wear(model::WornKind::Headband, user.above(0.0F, 0.022F));
                    user.setWorn(model::WornKind::Headband, [](model::Worn& band) {
                        // Its ends go behind the ears.
                        constexpr float kBackRad = 0.2F;
                        band.shape.rotation *= glm::angleAxis(kBackRad, glm::vec3(1.0F, 0.0F, 0.0F));
                        band.colour = 0xFF8A1428;
                        band.sheen = 0.3F;
                    });
                }};
    model::setHairType(style.settings, model::hairType("2A"));
    style.settings.curl.diameterM = 0.03F;
    style.settings.curl.pitchM = 0.22F;
    style.settings.curl.straightM = 0.08F;
    style.settings.variation.flyaways = 0.002F;
    style.settings.variation.crossing = 0.02F;
    style.settings.nodesPerHair = 14;
    style.settings.variation.partGapM = 0.0F;
    style.settings.material.shine = 0.65F;
    return style;
}

} // namespace hairpaint::presets
