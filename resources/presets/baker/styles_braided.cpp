// Styles of many braids.
#include "model/project/hair_types.h"
#include "strokes.h"
#include "styles.h"

#include <array>
#include <utility>
#include <vector>

namespace hairpaint::presets {

namespace {

using Seen = Recording::Seen;

/// The sides' cornrows, the highest first: from the temple over the ear and down behind it.
constexpr std::array<Seen, 9> kHighRow{{{53.0F, 0.062F},
                                        {64.0F, 0.070F},
                                        {84.0F, 0.073F},
                                        {104.0F, 0.067F},
                                        {122.0F, 0.053F},
                                        {136.0F, 0.030F},
                                        {142.0F, 0.004F},
                                        {143.0F, -0.022F},
                                        {143.0F, -0.050F}}};
constexpr std::array<Seen, 9> kMiddleRow{{{52.0F, 0.048F},
                                          {66.0F, 0.056F},
                                          {85.0F, 0.059F},
                                          {104.0F, 0.052F},
                                          {118.0F, 0.036F},
                                          {127.0F, 0.014F},
                                          {131.0F, -0.010F},
                                          {132.0F, -0.032F},
                                          {132.0F, -0.050F}}};
constexpr std::array<Seen, 8> kLowRow{{{57.0F, 0.034F},
                                       {71.0F, 0.041F},
                                       {87.0F, 0.044F},
                                       {103.0F, 0.037F},
                                       {113.0F, 0.021F},
                                       {118.0F, 0.001F},
                                       {120.0F, -0.020F},
                                       {121.0F, -0.040F}}};

/// From the hairline back and down to the nape, side by side.
std::vector<Recording::Points> cornrowLines(const Recording& user)
{
    constexpr float kDegreesPerM = 560.0F; // Beside the middle, down the back.
    std::vector<Recording::Points> lines;
    for (const float leftM : {0.0F, 0.0135F, 0.027F, 0.0405F, 0.053F}) {
        Recording::Points line =
            user.overHead(leftM, 0.080F - 0.2F * leftM - 9.5F * leftM * leftM, -0.085F + 0.5F * leftM);
        for (const float heightM : {0.045F, 0.02F, -0.005F, -0.03F, -0.05F})
            line.push_back(user.around(180.0F - kDegreesPerM * leftM, heightM));
        lines.push_back(std::move(line));
    }
    lines.push_back(user.along(kHighRow));
    lines.push_back(user.along(kMiddleRow));
    lines.push_back(user.along(kLowRow));
    return lines;
}

} // namespace

Style boxBraids()
{
    Style style{.id = "box-braids",
                .name = "Box braids",
                .tags = {QStringLiteral("long"), QStringLiteral("braided")},
                .settings = settingsOf(0.40F, 0.05F, 0.006F),
                .record = [](Recording& user) {
                    user.setLayerOpacity(MapKind::Density, 0.85F);
                    user.fill(MapKind::Colour, colour(0xFF1E1512));
                    user.fill(MapKind::Length, user.length(0.34F));
                    user.fill(MapKind::Braid, entry(kPlait));
                    // Off the face: a single braid before it would hide it, and make another outline.
                    partInTheMiddle(user, {});
                    combOffFace(user);
                }};
    style.settings.braidSpacingM = 0.020F;
    style.settings.braidRadiusM = 0.0040F;
    style.settings.braidTie = 0.3F;
    style.settings.nodesPerHair = 16;
    return style;
}

Style cornrows()
{
    Style style{.id = "cornrows",
                .name = "Cornrows",
                .tags = {QStringLiteral("short"), QStringLiteral("braided")},
                .settings = settingsOf(0.20F, 0.05F, 0.004F),
                .record = [](Recording& user) {
                    user.setLayerOpacity(MapKind::Density, 0.95F);
                    user.fill(MapKind::Colour, colour(0xFF1A1311));
                    user.fill(MapKind::Length, user.length(0.10F));
                    user.addLayer(MapKind::Density, model::BlendMode::Multiply);
                    user.fill(MapKind::Density, scalar(0.0F));
                    for (const Recording::Points& row : cornrowLines(user)) {
                        // No root beside the row: a hair of its own would hang over the face.
                        user.brush(MapKind::Braid, entry(kCornrow), {.sizeM = 0.0125F, .hardness = 1.0F}, row);
                        user.erase(MapKind::Density, {.sizeM = 0.0098F, .hardness = 0.95F}, row);
                    }
                }};
    style.settings.braidRadiusM = 0.0046F;
    style.settings.nodesPerHair = 16;
    return style;
}

Style locs()
{
    Style style{.id = "locs",
                .name = "Locs",
                .tags = {QStringLiteral("medium"), QStringLiteral("coily"), QStringLiteral("braided")},
                .settings = settingsOf(0.30F, 0.06F, 0.006F),
                .record = [](Recording& user) {
                    user.setLayerOpacity(MapKind::Density, 0.85F);
                    user.fill(MapKind::Colour, colour(0xFF2A1C14));
                    user.fill(MapKind::Length, user.length(0.22F));
                    user.fill(MapKind::Braid, entry(kLoc));
                    user.fill(MapKind::Frizz, scalar(0.25F));
                    // Off the face: a single loc before it would make another outline.
                    partInTheMiddle(user, {});
                    combOffFace(user);
                }};
    style.settings.braidSpacingM = 0.013F;
    style.settings.braidRadiusM = 0.0040F;
    style.settings.braidTie = 0.0F;
    style.settings.nodesPerHair = 12;
    return style;
}

} // namespace hairpaint::presets
