// Styles that fall over the shoulders or to the chin.
#include "model/project/hair_types.h"
#include "styles.h"

#include <array>

namespace hairpaint::presets {

namespace {

constexpr int kPlait = 1; ///< In the palette.

/// The left half of the hairline, a few mm out, from the forehead's middle to the nape's and up the back.
constexpr std::array<Recording::Seen, 28> kAroundHairline{
    {{4.0F, 0.067F},    {12.0F, 0.067F},   {24.0F, 0.069F},   {34.0F, 0.068F},   {41.0F, 0.060F},   {45.0F, 0.048F},
     {47.0F, 0.036F},   {52.0F, 0.024F},   {59.0F, 0.012F},   {64.0F, 0.000F},   {65.0F, -0.014F},  {70.0F, -0.022F},
     {76.0F, -0.015F},  {77.0F, 0.000F},   {80.0F, 0.012F},   {88.0F, 0.019F},   {97.0F, 0.016F},   {103.0F, 0.003F},
     {106.0F, -0.018F}, {114.0F, -0.043F}, {136.0F, -0.070F}, {160.0F, -0.080F}, {178.4F, -0.080F}, {178.4F, -0.045F},
     {178.5F, -0.02F},  {178.5F, 0.01F},   {178.5F, 0.04F},   {178.5F, 0.06F}}};

constexpr std::array<Recording::Seen, 8> kDownTheBack{{{180.0F, 0.05F},
                                                       {180.0F, 0.03F},
                                                       {180.0F, 0.01F},
                                                       {180.0F, -0.01F},
                                                       {180.0F, -0.03F},
                                                       {180.0F, -0.05F},
                                                       {180.0F, -0.07F},
                                                       {180.0F, -0.09F}}};

/// Over the middle, from the forehead to behind the crown.
void partInTheMiddle(Recording& user, const Parting& parting)
{
    user.part(parting, user.overHead(0.0F, 0.065F, -0.085F));
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
                    // Off the face and over the ears.
                    for (const float furtherM : {-0.02F, 0.002F})
                        user.comb(0.97F, {.sizeM = 0.03F, .hardness = 0.6F},
                                  {user.above(0.014F, 0.071F + furtherM), user.above(0.034F, 0.057F + furtherM),
                                   user.above(0.047F, 0.044F + furtherM), user.above(0.057F, 0.028F + furtherM),
                                   user.above(0.064F, 0.012F + furtherM)});
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
                    // A side is a region; the parting between them stays free.
                    Recording::Points side = user.overHead(0.0022F, -0.085F, 0.06F);
                    for (const sim::SurfacePoint& point : user.along(kAroundHairline))
                        side.push_back(point);
                    user.polygon(MapKind::Braid, braid(kPlait), side);
                    Recording::Points middle = user.overHead(0.0F, 0.085F, -0.085F);
                    for (const sim::SurfacePoint& point : user.along(kDownTheBack))
                        middle.push_back(point);
                    user.erase(MapKind::Density, {.sizeM = 0.0058F, .hardness = 0.9F}, middle);
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
                    Recording::Points middle = user.overHead(0.0F, 0.065F, -0.085F);
                    for (const float heightM : {0.05F, 0.02F})
                        middle.push_back(user.around(180.0F, heightM));
                    user.brush(MapKind::Clump, scalar(0.0F), {.sizeM = 0.03F, .hardness = 0.4F}, middle);
                    user.part({.flatness = 0.93F, .gapM = 0.0015F}, middle);
                }};
    model::setHairType(style.settings, model::hairType("2C"));
    style.settings.curl.gather = 0.4F;
    style.settings.variation.parting = 0.0F;
    style.settings.variation.partGapM = 0.0F;
    style.settings.locks.ragged = 0.0F;
    style.settings.nodesPerHair = 12;
    return style;
}

} // namespace hairpaint::presets
