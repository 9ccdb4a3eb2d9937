// Styles that clippers and scissors leave short.
#include "strokes.h"
#include "styles.h"

#include <array>
#include <utility>

namespace hairpaint::presets {

namespace {

/// Lanes of the comb from the temple along the ridge, and above it, around to the back and down.
constexpr std::array<Recording::Seen, 10> kAlongRidge{{{40.0F, 0.064F},
                                                       {60.0F, 0.061F},
                                                       {80.0F, 0.057F},
                                                       {100.0F, 0.053F},
                                                       {118.0F, 0.048F},
                                                       {132.0F, 0.040F},
                                                       {142.0F, 0.028F},
                                                       {148.0F, 0.010F},
                                                       {150.0F, -0.010F},
                                                       {150.0F, -0.030F}}};
constexpr std::array<Recording::Seen, 10> kAboveRidge{{{37.0F, 0.078F},
                                                       {55.0F, 0.076F},
                                                       {80.0F, 0.073F},
                                                       {105.0F, 0.070F},
                                                       {130.0F, 0.065F},
                                                       {148.0F, 0.055F},
                                                       {160.0F, 0.040F},
                                                       {164.0F, 0.020F},
                                                       {165.0F, 0.000F},
                                                       {165.0F, -0.030F}}};

/// From the forehead over the head and down its back.
void slickBack(Recording& user, float flatness)
{
    const Ring ring{.sizeM = 0.04F};
    user.comb(flatness, ring, user.along(kAlongRidge));
    user.comb(flatness, ring, user.along(kAboveRidge));
    for (const float leftM : {0.05F, 0.034F, 0.017F, 0.0F}) {
        Recording::Points lane = user.overHead(leftM, 0.078F - 0.4F * leftM, -0.085F + 0.5F * leftM);
        if (leftM == 0.0F)
            for (const float heightM : {0.05F, 0.03F, 0.01F, -0.01F, -0.03F})
                lane.push_back(user.around(180.0F, heightM));
        user.comb(flatness, ring, lane);
    }
}

/// The sides' lanes of the comb, from the temple back and down above the ear, and from behind it to the nape.
constexpr std::array<Recording::Seen, 8> kUpperSide{{{52.0F, 0.052F},
                                                     {66.0F, 0.047F},
                                                     {82.0F, 0.041F},
                                                     {98.0F, 0.034F},
                                                     {114.0F, 0.024F},
                                                     {128.0F, 0.010F},
                                                     {138.0F, -0.008F},
                                                     {143.0F, -0.032F}}};
constexpr std::array<Recording::Seen, 7> kLowerSide{{{60.0F, 0.036F},
                                                     {76.0F, 0.029F},
                                                     {92.0F, 0.022F},
                                                     {108.0F, 0.011F},
                                                     {122.0F, -0.004F},
                                                     {131.0F, -0.024F},
                                                     {135.0F, -0.046F}}};

/// So that the sides meet what is combed back over them.
void slickSides(Recording& user, float flatness)
{
    const Ring ring{.sizeM = 0.035F};
    user.comb(flatness, ring, user.along(kLowerSide));
    user.comb(flatness, ring, user.along(kUpperSide));
}

} // namespace

Style mohawk()
{
    Style style{.id = "gelled-mohawk",
                .name = "Gelled mohawk",
                .tags = {QStringLiteral("short"), QStringLiteral("gelled")},
                .settings = settingsOf(0.15F, 0.10F, 0.0F),
                .record = [](Recording& user) {
                    Recording::Points crest = user.overHead(0.0F, 0.075F, -0.085F);
                    for (const float heightM : {0.05F, 0.03F, 0.01F, -0.01F, -0.03F, -0.05F, -0.065F})
                        crest.push_back(user.around(180.0F, heightM));
                    const Ring ring{.sizeM = 0.037F, .hardness = 0.9F};
                    user.setLayerOpacity(MapKind::Density, 0.95F);
                    user.addLayer(MapKind::Density, model::BlendMode::Multiply);
                    user.fill(MapKind::Density, scalar(0.58F));
                    user.erase(MapKind::Density, ring, crest);
                    user.fill(MapKind::Colour, colour(0xFF2A221E));
                    user.brush(MapKind::Colour, colour(0xFF186E66), ring, crest);
                    user.fill(MapKind::Length, user.length(0.003F));
                    user.brush(MapKind::Length, user.length(0.115F), ring, crest);
                    // Lower and lower down the back.
                    const Recording::Points last(crest.end() - 6, crest.end());
                    for (std::size_t i = 0; i + 1 < last.size(); ++i)
                        user.brush(MapKind::Length, user.length(0.106F - 0.010F * static_cast<float>(i)),
                                   {.sizeM = ring.sizeM, .hardness = 0.7F}, {last[i], last[i + 1]});
                    user.brush(MapKind::Clump, scalar(0.85F), ring, crest);
                    user.fill(MapKind::Gel, scalar(1.0F));
                    // Wider, so that what is long at its edge stands too.
                    user.brush(MapKind::Direction, upright(), {.sizeM = 0.048F, .hardness = 0.9F}, crest);
                }};
    style.settings.material.tipAlpha = 0.8F;
    return style;
}

Style buzzCut()
{
    Style style{.id = "buzz-cut",
                .name = "Buzz cut",
                .tags = {QStringLiteral("short"), QStringLiteral("straight")},
                .settings = settingsOf(0.03F, 0.06F, 0.0F),
                .record = [](Recording& user) {
                    user.setLayerOpacity(MapKind::Density, 0.95F);
                    user.fill(MapKind::Colour, colour(0xFF3A2B22));
                    user.fill(MapKind::Length, user.length(0.009F));
                    fade(user, 0.0015F, 0.008F);
                }};
    style.settings.nodesPerHair = 4;
    style.settings.material.widthM = 100e-6F; // Stubble is thick against its length.
    style.settings.material.tipAlpha = 0.6F;
    style.settings.material.shine = 0.3F;
    return style;
}

Style slickedUndercut()
{
    Style style{.id = "slicked-undercut",
                .name = "Slicked undercut",
                .tags = {QStringLiteral("short"), QStringLiteral("gelled")},
                .settings = settingsOf(0.15F, 0.05F, 0.004F),
                .record = [](Recording& user) {
                    const Recording::Points top = aroundTop(user);
                    user.setLayerOpacity(MapKind::Density, 0.95F);
                    user.fill(MapKind::Colour, colour(0xFF2C1D14));
                    user.fill(MapKind::Length, user.length(0.006F));
                    fade(user, 0.003F, 0.006F);
                    user.setMirror(false);
                    user.polygon(MapKind::Length, user.length(0.105F), top);
                    user.polygon(MapKind::Clump, scalar(0.45F), top);
                    user.polygon(MapKind::Gel, scalar(0.8F), top);
                    user.setMirror(true);
                    taperBack(user, 0.006F, 0.085F);
                    slickSides(user, 0.9F);
                    slickBack(user, 0.95F);
                }};
    // Wet and combed: what strays is little.
    style.settings.variation.flyaways = 0.004F;
    style.settings.variation.crossing = 0.04F;
    style.settings.nodesPerHair = 10;
    style.settings.material.shine = 0.7F;
    style.settings.material.roughness = 0.3F;
    style.settings.material.tipAlpha = 0.7F;
    return style;
}

Style quiff()
{
    Style style{.id = "quiff",
                .name = "Quiff",
                .tags = {QStringLiteral("short"), QStringLiteral("gelled")},
                .settings = settingsOf(0.15F, 0.06F, 0.010F),
                .record = [](Recording& user) {
                    user.setLayerOpacity(MapKind::Density, 0.95F);
                    user.fill(MapKind::Colour, colour(0xFF493829));
                    graduate(user, 0.014F, 0.05F);
                    fade(user, 0.004F, 0.014F);
                    front(user, MapKind::Length, user.length(0.072F), 0.06F);
                    user.setMirror(false);
                    user.polygon(MapKind::Clump, scalar(0.4F), aroundTop(user));
                    user.polygon(MapKind::Gel, scalar(0.4F), aroundTop(user));
                    user.setMirror(true);
                    front(user, MapKind::Gel, scalar(0.7F), 0.07F);
                    slickSides(user, 0.9F);
                    slickBack(user, 0.92F);
                    // Ever further up toward the front.
                    for (const auto& [flatness, toForwardM] :
                         {std::pair(0.75F, 0.020F), std::pair(0.55F, 0.042F), std::pair(0.30F, 0.056F)})
                        for (const float leftM : {0.034F, 0.017F, 0.0F})
                            user.comb(flatness, {.sizeM = 0.035F, .hardness = 0.2F},
                                      user.overHead(leftM, 0.079F - 0.3F * leftM, toForwardM - 0.3F * leftM));
                }};
    style.settings.nodesPerHair = 8;
    style.settings.material.shine = 0.55F;
    style.settings.material.tipAlpha = 0.7F;
    return style;
}

Style sidePart()
{
    Style style{.id = "side-part",
                .name = "Side part",
                .tags = {QStringLiteral("short"), QStringLiteral("straight")},
                .settings = settingsOf(0.15F, 0.05F, 0.006F),
                .record = [](Recording& user) {
                    constexpr float kPartM = 0.030F; // On the head's left.
                    user.setLayerOpacity(MapKind::Density, 0.95F);
                    user.fill(MapKind::Colour, colour(0xFF564334));
                    graduate(user, 0.016F, 0.08F);
                    fade(user, 0.004F, 0.016F);
                    front(user, MapKind::Length, user.length(0.075F), 0.05F);
                    user.fill(MapKind::Curl, scalar(0.02F));
                    user.fill(MapKind::Clump, scalar(0.25F));
                    user.setMirror(false);
                    user.polygon(MapKind::Gel, scalar(0.35F), aroundTop(user));
                    user.part({.reachM = 0.12F, .flatness = 0.98F}, user.overHead(kPartM, 0.06F, -0.06F));
                }};
    style.settings.nodesPerHair = 10;
    style.settings.material.shine = 0.6F;
    style.settings.material.tipAlpha = 0.7F;
    return style;
}

Style frenchCrop()
{
    Style style{.id = "french-crop",
                .name = "French crop",
                .tags = {QStringLiteral("short"), QStringLiteral("straight")},
                .settings = settingsOf(0.10F, 0.05F, 0.008F),
                .record = [](Recording& user) {
                    user.setLayerOpacity(MapKind::Density, 0.95F);
                    user.fill(MapKind::Colour, colour(0xFF33241C));
                    graduate(user, 0.010F, 0.040F);
                    fade(user, 0.003F, 0.010F);
                    front(user, MapKind::Length, user.length(0.042F), 0.04F);
                    user.fill(MapKind::Curl, scalar(0.03F));
                    user.setMirror(false);
                    user.polygon(MapKind::Clump, scalar(0.5F), aroundTop(user));
                }};
    style.settings.greatestCurlRadiusM = 0.008F;
    style.settings.nodesPerHair = 8;
    style.settings.material.tipAlpha = 0.6F;
    return style;
}

} // namespace hairpaint::presets
