// Beards, in groups of their own.
#include "model/styles/hair_kinds.h"
#include "styles.h"

#include <algorithm>
#include <string_view>

namespace hairpaint::presets {

namespace {

sim::GroupSettings beardSettings(float greatestLengthM)
{
    const std::span<const model::HairKind> kinds = model::hairKinds();
    sim::GroupSettings settings = settingsOf(greatestLengthM, 0.06F, 0.004F);
    std::ranges::find_if(kinds, [](const auto& kind) {
        return std::string_view(kind.name) == "Beard";
    })->apply(settings);
    settings.greatestLengthM = greatestLengthM;
    return settings;
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
                        // Shaved beside the mouth and along the jaw.
                        for (const float heightM : {0.0F, -0.02F, -0.04F, -0.06F, -0.08F})
                            user.erase(MapKind::Density, {.sizeM = 0.03F, .hardness = 0.9F},
                                       user.level(heightM, 33.0F, 100.0F));
                    },
                .kind = "Beard"};
    return style;
}

} // namespace hairpaint::presets
