// Beards and brows, in groups of their own.
#include "model/styles/hair_kinds.h"
#include "styles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace hairpaint::presets {

namespace {

/// As hair of that kind has them.
sim::GroupSettings settingsOfKind(std::string_view name, float greatestLengthM)
{
    const std::span<const model::HairKind> kinds = model::hairKinds();
    sim::GroupSettings settings = settingsOf(greatestLengthM, 0.06F, 0.004F);
    std::ranges::find_if(kinds, [name](const auto& kind) { return kind.name == name; })->apply(settings);
    settings.greatestLengthM = greatestLengthM;
    return settings;
}

sim::GroupSettings beardSettings(float greatestLengthM)
{
    return settingsOfKind("Beard", greatestLengthM);
}

} // namespace

namespace {

using Seen = Recording::Seen;

/// The upper lip from its middle outward, cut so that hair ends at the mouth.
void trimMoustache(Recording& user, float lengthM)
{
    Recording::Points lip;
    for (const float leftM : {0.0F, 0.008F, 0.016F, 0.022F})
        lip.push_back(user.outward({leftM, -0.0545F - 0.15F * leftM, 0.0F}, {0.0F, 0.0F, 1.0F}));
    user.brush(MapKind::Length, user.length(lengthM), {.sizeM = 0.020F, .hardness = 0.7F}, lip);
}

/// Under the jaw, where it meets the neck.
void trimUnderJaw(Recording& user, float lengthM)
{
    Recording::Points corner;
    for (const float leftM : {0.0F, 0.012F, 0.024F, 0.036F, 0.046F})
        corner.push_back(user.outward({leftM, -0.09F, 0.02F - 0.4F * leftM}, {0.0F, -0.6F, 0.8F}));
    user.brush(MapKind::Length, user.length(lengthM), {.sizeM = 0.024F, .hardness = 0.4F}, corner);
    Recording::Points throat;
    for (const float degrees : {20.0F, 32.0F, 44.0F, 56.0F, 68.0F})
        throat.push_back(user.outward({0.0F, -0.08F, 0.015F},
                                      {0.0F, -std::cos(glm::radians(degrees)), std::sin(glm::radians(degrees))}));
    user.brush(MapKind::Length, user.length(lengthM), {.sizeM = 0.036F, .hardness = 0.4F}, throat);
}

constexpr std::array<Seen, 2> kHead{{{7.0F, 0.0195F}, {7.5F, 0.025F}}};
constexpr std::array<Seen, 3> kTail{{{30.0F, 0.026F}, {35.0F, 0.023F}, {40.0F, 0.018F}}};

/// Up at the nose, outward above the eye, down at the temple.
void combBrow(Recording& user)
{
    const Ring ring{.sizeM = 0.008F, .hardness = 0.5F};
    user.comb(0.93F, {.sizeM = 0.016F, .hardness = 0.5F},
              user.along(std::array<Seen, 5>{
                  {{11.0F, 0.0225F}, {17.0F, 0.0255F}, {23.0F, 0.027F}, {30.0F, 0.0255F}, {42.0F, 0.018F}}}));
    user.comb(0.9F, ring,
              user.along(std::array<Seen, 4>{{{10.0F, 0.016F}, {15.0F, 0.021F}, {21.0F, 0.025F}, {27.0F, 0.026F}}}));
    user.comb(0.8F, ring, user.along(std::array<Seen, 3>{{{6.0F, 0.013F}, {7.0F, 0.020F}, {9.5F, 0.027F}}}));
}

} // namespace

Style stubble()
{
    Style style{.id = "stubble",
                .name = "Stubble",
                .tags = {QStringLiteral("face"), QStringLiteral("beard")},
                .settings = beardSettings(0.02F),
                .record =
                    [](Recording& user) {
                        user.setLayerOpacity(MapKind::Density, 0.8F);
                        user.fill(MapKind::Colour, colour(0xFF2C201A));
                        user.fill(MapKind::Length, user.length(0.003F));
                    },
                .kind = "Beard"};
    style.settings.nodesPerHair = 4;
    return style;
}

Style fullBeard()
{
    Style style{.id = "full-beard",
                .name = "Full beard",
                .tags = {QStringLiteral("face"), QStringLiteral("beard")},
                .settings = beardSettings(0.08F),
                .record =
                    [](Recording& user) {
                        user.fill(MapKind::Colour, colour(0xFF3A281E));
                        user.fill(MapKind::Length, user.length(0.030F));
                        // Short at the ears, long at the chin.
                        user.bands(MapKind::Length,
                                   {{0.01F, user.length(0.006F)},
                                    {-0.01F, user.length(0.008F)},
                                    {-0.03F, user.length(0.013F)},
                                    {-0.05F, user.length(0.020F)}},
                                   35.0F, 85.0F);
                        trimUnderJaw(user, 0.008F);
                        trimMoustache(user, 0.009F);
                        user.fill(MapKind::Curl, scalar(0.10F));
                    },
                .kind = "Beard"};
    style.settings.greatestCurlRadiusM = 0.006F;
    return style;
}

Style goatee()
{
    Style style{.id = "goatee",
                .name = "Goatee",
                .tags = {QStringLiteral("face"), QStringLiteral("beard")},
                .settings = beardSettings(0.05F),
                .record =
                    [](Recording& user) {
                        user.fill(MapKind::Colour, colour(0xFF4A3020));
                        user.fill(MapKind::Length, user.length(0.014F));
                        trimUnderJaw(user, 0.006F);
                        trimMoustache(user, 0.008F);
                        // Shaved beside the mouth and along the jaw.
                        for (const float heightM : {0.0F, -0.02F, -0.04F, -0.06F, -0.08F})
                            user.erase(MapKind::Density, {.sizeM = 0.03F, .hardness = 0.9F},
                                       user.level(heightM, 33.0F, 100.0F));
                    },
                .kind = "Beard"};
    return style;
}

Style brows()
{
    Style style{.id = "brows",
                .name = "Full brows",
                .tags = {QStringLiteral("face")},
                .settings = settingsOfKind("Brows", 0.012F),
                .record =
                    [](Recording& user) {
                        user.fill(MapKind::Colour, colour(0xFF2A1E18));
                        user.fill(MapKind::Length, user.length(0.0075F));
                        // Thinner and shorter to both ends.
                        user.brush(MapKind::Length, user.length(0.005F), {.sizeM = 0.016F, .hardness = 0.2F},
                                   user.along(kTail));
                        user.brush(MapKind::Density, scalar(0.4F), {.sizeM = 0.008F, .hardness = 0.1F},
                                   user.along(kHead));
                        combBrow(user);
                    },
                .kind = "Brows"};
    style.settings.nodesPerHair = 4;
    return style;
}

} // namespace hairpaint::presets
