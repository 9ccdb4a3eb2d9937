// A head, and hair of every kind on it.
#include "tests/rendering/golden_scenes.h"

#include "sim/base/rounded.h"
#include "tests/rendering/hand_made_hair.h"
#include "view/rendering/card_set.h"

#include <array>
#include <cmath>
#include <vector>

namespace hairpaint::testing {

namespace {

using rendering::Scene;

Scene ballWith(const BallHair& hair, const sim::GroupSettings& settings = {})
{
    Scene scene = emptyScene();
    scene.head = makeBall(kBall);
    scene.hair = makeFrame(hairOnBall(kBall, hair), settings);
    return scene;
}

Scene bareHead()
{
    Scene scene = emptyScene();
    scene.head = makeBall(kBall);
    return scene;
}

Scene longDark()
{
    return ballWith({.hairs = 6000, .lengthM = 0.25F});
}

Scene shortBlond()
{
    return ballWith(
        {.hairs = 8000, .lengthM = 0.04F, .stiffness = 0.9F, .rootColour = 0xFF5C9CC0U, .tipColour = 0xFF9AD0EEU});
}

Scene ringlets()
{
    return ballWith({.hairs = 3000,
                     .lengthM = 0.2F,
                     .turns = 8.0F,
                     .curlRadiusM = 0.006F,
                     .rootColour = 0xFF20306AU,
                     .tipColour = 0xFF3050A0U});
}

Scene dyedAndShiny()
{
    sim::GroupSettings settings;
    settings.material.shine = 1.0F;
    settings.material.roughness = 0.15F;
    settings.material.tipAlpha = 1.0F;
    settings.material.colourVariation = 0.4F;
    return ballWith({.hairs = 6000, .lengthM = 0.15F, .rootColour = 0xFF8A2A10U, .tipColour = 0xFFB060F0U}, settings);
}

Scene litFromBehind()
{
    Scene scene = longDark();
    scene.light.directionWo = glm::normalize(glm::vec3(0.3F, 0.4F, -1.0F));
    return scene;
}

Scene plaits()
{
    std::vector<HandMadeStrand> strands;
    for (int i = 0; i < 300; ++i) {
        const float x = (i % 3 == 0 ? -0.04F : i % 3 == 1 ? 0.0F : 0.04F);
        HandMadeStrand strand = straightStrand({x, 0.09F, 0.0F}, {x, -0.1F, 0.0F}, 0xFF284468U, 12);
        const float turn = static_cast<float>(i) * 2.399963F;
        const float radius = std::sqrt(static_cast<float>(i % 100) / 100.0F);
        strand.style.braid = i % 3 == 0   ? sim::BraidKind::Plait
                             : i % 3 == 1 ? sim::BraidKind::Twist
                                          : sim::BraidKind::Loc;
        strand.style.wisp = static_cast<std::uint8_t>(i / 3 % (i % 3 == 1 ? 2 : 3));
        strand.style.braidRadiusM = 0.012F;
        strand.style.braidTurns = 4.0F;
        strand.style.wispOffset = {radius * sim::cosRounded(turn), radius * sim::sinRounded(turn)};
        strand.style.width = 6.0F;
        strands.push_back(strand);
    }
    Scene scene = emptyScene();
    scene.hair = makeFrame(strands);
    return scene;
}

/// Strips of hair drawn as stripes, which get lighter toward their tips, over hair that they stand for.
Scene cards()
{
    constexpr int kSide = 64;
    constexpr int kStrips = 26;
    constexpr int kSegments = 6;
    rendering::CardTexture atlas{.side = kSide, .texels = {}};
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x)
            atlas.texels.emplace_back(70 + 2 * y, 40 + 2 * y, 20 + y, x % 16 < 11 ? 255 : 0);
    auto set = std::make_shared<rendering::CardSet>();
    for (int strip = 0; strip < kStrips; ++strip) {
        const float around = 6.2831853F * static_cast<float>(strip) / kStrips;
        const glm::vec3 side = glm::vec3(sim::cosRounded(around), 0.0F, -sim::sinRounded(around));
        const glm::vec3 out = glm::vec3(sim::sinRounded(around), 0.0F, sim::cosRounded(around));
        for (int i = 0; i <= kSegments; ++i) {
            const float part = static_cast<float>(i) / kSegments;
            const float down = 1.9F * part;
            const glm::vec3 normal = sim::sinRounded(down) * out + glm::vec3(0.0F, sim::cosRounded(down), 0.0F);
            const glm::vec3 middle = 1.2F * kBall * normal;
            for (const float right : {-1.0F, 1.0F})
                set->corners.push_back({.positionHd = middle + right * 0.012F * side,
                                        .normalHd = normal,
                                        .uv = {0.5F + 0.5F * right, part}});
            if (i == kSegments)
                continue;
            const auto at = static_cast<std::uint32_t>(set->corners.size()) - 2;
            set->triangles.emplace_back(at, at + 2, at + 1);
            set->triangles.emplace_back(at + 1, at + 2, at + 3);
        }
    }
    set->levels = rendering::withSmallerLevels(std::move(atlas));
    rendering::tellHairOfCorners(*set);
    Scene scene = longDark();
    scene.cards = std::move(set);
    return scene;
}

} // namespace

std::span<const GoldenScene> goldenScenes()
{
    static const std::array scenes{GoldenScene{"head", bareHead},
                                   GoldenScene{"long-dark", longDark},
                                   GoldenScene{"short-blond", shortBlond},
                                   GoldenScene{"ringlets", ringlets},
                                   GoldenScene{"dyed-and-shiny", dyedAndShiny},
                                   GoldenScene{"lit-from-behind", litFromBehind},
                                   GoldenScene{"plaits", plaits},
                                   GoldenScene{"cards", cards}};
    return scenes;
}

} // namespace hairpaint::testing
