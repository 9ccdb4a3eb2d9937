// A ball of a head with uniform maps, and dabs on them, for tests of groom, simulation and worker.
#pragma once

#include "sim/groom/groom_input.h"
#include "tests/support/test_heads.h"

#include <algorithm>
#include <memory>

namespace hairpaint::test {

inline std::shared_ptr<const sim::TiledRaster> mapOfTexel(int channels, sim::Texel value, int size = 256)
{
    return std::make_shared<const sim::TiledRaster>(size, channels, value);
}

/// One group on a ball of 0.1 m with its ellipsoid and skin: about `hairs` hairs of 20 cm, `basisHairs` of them solved.
inline sim::GroomInput paintedBall(int hairs, int basisHairs)
{
    sim::GroomInput input;
    const auto skin = std::make_shared<const sim::Skin>(makeBallHead());
    input.skin = skin;
    input.colliders.push_back({glm::vec3(0.0F), glm::vec3(0.1F), glm::quat(1.0F, 0.0F, 0.0F, 0.0F)});
    static const auto distances = sim::DistanceGrid::make(skin->mesh()); // Every such ball has these.
    input.distances = distances;
    sim::GroomInput::Group group;
    group.id = 1;
    group.settings.greatestDensityPerM2 = static_cast<float>((hairs + 0.5) / skin->areaM2());
    group.settings.greatestLengthM = 0.2F;
    group.settings.basisHairs = basisHairs;
    for (const sim::MapRule& rule : sim::kMapRules)
        group.maps[rule.slot] = mapOfTexel(rule.channels, rule.defaultValue);
    group.maps[sim::MapSlot::Density] = mapOfTexel(1, {65535});
    group.maps[sim::MapSlot::Length] = mapOfTexel(1, {65535});
    group.maps[sim::MapSlot::Colour] = mapOfTexel(3, {20000, 12000, 8000});
    input.groups.push_back(group);
    return input;
}

/// `value` in a square of uv.
inline void paintSquare(std::shared_ptr<const sim::TiledRaster>& map, glm::vec2 lowUv, glm::vec2 highUv,
                        std::uint16_t value)
{
    auto painted = std::make_shared<sim::TiledRaster>(*map);
    const auto texel = [&](float fraction) {
        return std::clamp(static_cast<int>(fraction * static_cast<float>(painted->size())), 0, painted->size());
    };
    for (int y = texel(1.0F - highUv.y); y < texel(1.0F - lowUv.y); ++y) {
        for (int x = texel(lowUv.x); x < texel(highUv.x); ++x)
            painted->setTexel(x, y, {value});
    }
    map = std::move(painted);
}

} // namespace hairpaint::test
