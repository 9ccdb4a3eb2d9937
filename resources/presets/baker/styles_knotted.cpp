// Styles of knots all over the head.
#include "model/project/hair_types.h"
#include "strokes.h"
#include "styles.h"

#include <array>
#include <utility>
#include <vector>

namespace hairpaint::presets {

namespace {

using Seen = Recording::Seen;
using model::WornKind;

/// What parts the head into fifteen sections.
std::vector<Recording::Points> partings(const Recording& user)
{
    constexpr std::array<Seen, 9> kRing{{{30.0F, 0.066F},
                                         {44.0F, 0.064F},
                                         {60.0F, 0.060F},
                                         {80.0F, 0.057F},
                                         {100.0F, 0.055F},
                                         {120.0F, 0.052F},
                                         {140.0F, 0.049F},
                                         {160.0F, 0.046F},
                                         {180.0F, 0.045F}}};
    constexpr std::array<Seen, 5> kBehindEar{
        {{112.0F, 0.053F}, {113.0F, 0.035F}, {113.0F, 0.015F}, {113.0F, -0.01F}, {113.0F, -0.05F}}};
    constexpr std::array<Seen, 5> kBack{
        {{113.0F, 0.0F}, {130.0F, -0.004F}, {147.0F, -0.007F}, {164.0F, -0.009F}, {180.0F, -0.010F}}};
    constexpr std::array<Seen, 6> kDown{
        {{180.0F, 0.047F}, {180.0F, 0.02F}, {180.0F, 0.0F}, {180.0F, -0.025F}, {180.0F, -0.05F}, {180.0F, -0.10F}}};
    std::vector<Recording::Points> lines{user.along(kRing), user.along(kBehindEar), user.along(kBack),
                                         user.along(kDown)};
    Recording::Points column = user.overHead(0.025F, 0.085F, -0.085F);
    column.push_back(user.around(163.0F, 0.046F));
    lines.push_back(std::move(column));
    for (const float forwardM : {0.032F, -0.026F}) {
        Recording::Points row;
        const std::vector<float> lefts = evenly(0.0F, 0.06F, 0.012F);
        row.reserve(lefts.size() + 1);
        for (const float leftM : lefts)
            row.push_back(user.above(leftM, forwardM));
        row.push_back(user.around(forwardM > 0.0F ? 60.0F : 104.0F, 0.056F));
        lines.push_back(std::move(row));
    }
    return lines;
}

/// The middles of the sections of the head's left and of its middle.
Recording::Points knots(const Recording& user)
{
    return {user.above(0.0F, 0.052F),   user.above(0.0F, 0.002F),    user.around(180.0F, 0.082F),
            user.above(0.044F, 0.042F), user.above(0.050F, 0.002F),  user.around(146.0F, 0.076F),
            user.around(86.0F, 0.037F), user.around(147.0F, 0.022F), user.around(148.0F, -0.035F)};
}

} // namespace

Style bantuKnots()
{
    Style style{.id = "bantu-knots",
                .name = "Bantu knots",
                .tags = {QStringLiteral("short"), QStringLiteral("coily"), QStringLiteral("tied")},
                .settings = settingsOf(0.25F, 0.05F, 0.003F),
                .record = [](Recording& user) {
                    user.setLayerOpacity(MapKind::Density, 0.95F);
                    user.fill(MapKind::Colour, colour(0xFF17110F));
                    user.fill(MapKind::Length, user.length(0.20F));
                    user.polygon(MapKind::Accessory, entry(kBun), aroundLeft(user, 0.0F));
                    user.brush(MapKind::Accessory, entry(kBun), {.sizeM = 0.006F, .hardness = 1.0F}, overMiddle(user));
                    for (const Recording::Points& line : partings(user)) {
                        user.erase(MapKind::Accessory, {.sizeM = 0.003F, .hardness = 1.0F}, line);
                        user.erase(MapKind::Density, {.sizeM = 0.0046F, .hardness = 1.0F}, line);
                        // What still grows there is in no knot.
                        user.brush(MapKind::Length, user.length(0.01F), {.sizeM = 0.006F, .hardness = 1.0F}, line);
                    }
                    shaveDownTheBack(user);
                    for (const sim::SurfacePoint& point : knots(user)) {
                        user.gather(WornKind::Bun, point);
                        constexpr float kMiddleM = 0.001F;
                        if (point.positionHd.x > kMiddleM)
                            user.gather(WornKind::Bun, user.outward({0.0F, point.positionHd.y, point.positionHd.z},
                                                                    {-1.0F, 0.0F, 0.0F}));
                    }
                    user.setWorn(WornKind::Bun, [](model::Worn& tie) {
                        tie.colour = 0xFF17110F;
                        tie.shape.semiAxesM = glm::vec3(0.006F);
                        tie.tightness = 0.9F;
                        tie.coilRadiusM = 0.017F;
                        tie.shape.centreHd -= tie.shape.rotation * glm::vec3(0.0F, 0.0F, 0.005F); // On the skin.
                    });
                }};
    style.settings.variation.partGapM = 0.0F;
    style.settings.variation.flyaways = 0.004F;
    style.settings.variation.length = style.settings.variation.mostShorterM = 0.0F; // No end sticks out of a knot.
    style.settings.nodesPerHair = 24;
    style.settings.material.shine = 0.35F;
    style.settings.material.scalpTint = 0.45F; // Partings stay bare.
    return style;
}

} // namespace hairpaint::presets
