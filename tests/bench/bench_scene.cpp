// The benchmarks' head, maps and dabs.
#include "bench_scene.h"

#include "sim/groom/direction_texel.h"
#include "tests/support/test_heads.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hairpaint::bench {

namespace {

constexpr int kMapSize = 1024;

std::shared_ptr<const sim::TiledRaster> uniform(int channels, sim::Texel value)
{
    return std::make_shared<const sim::TiledRaster>(kMapSize, channels, value);
}

} // namespace

sim::GroomInput sceneOf(int hairs, int nodes, bool allBasis)
{
    sim::GroomInput input;
    const auto skin = std::make_shared<const sim::Skin>(test::makeBallHead());
    input.skin = skin;
    for (const float y : {0.0F, -0.08F, -0.2F})
        input.colliders.push_back({glm::vec3(0.0F, y, 0.0F), glm::vec3(0.095F, 0.1F, 0.095F), glm::quat(1, 0, 0, 0)});
    sim::GroomInput::Group group;
    group.id = 1;
    group.settings.nodesPerHair = nodes;
    group.settings.greatestDensityPerM2 = static_cast<float>((hairs + 0.5) / skin->areaM2());
    if (allBasis)
        group.settings.basisHairs = hairs;
    constexpr std::uint16_t kFull = 65535;
    for (const sim::MapRule& rule : sim::kMapRules)
        group.maps[rule.slot] = uniform(rule.channels, rule.defaultValue);
    group.maps[sim::MapSlot::Density] = uniform(1, {kFull});
    group.maps[sim::MapSlot::Length] = uniform(1, {52000});
    group.maps[sim::MapSlot::Curl] = uniform(1, {13000});
    group.maps[sim::MapSlot::Colour] = uniform(3, {20000, 12000, 8000});
    group.maps[sim::MapSlot::Clump] = uniform(1, {20000});
    group.maps[sim::MapSlot::Gel] = uniform(1, {9000});
    group.maps[sim::MapSlot::Direction] = uniform(2, sim::texelOfDirection({0.3F, -0.9F}));
    input.groups.push_back(std::move(group));
    input.maxHairs = std::max(hairs, input.maxHairs);
    return input;
}

namespace {

sim::GroomInput withDab(const sim::GroomInput& before, sim::MapSlot map, int number, sim::Texel value)
{
    // On the ball, a square of u x v around the equator covers side^2 * pi/2 of the area: 0.08 is one per cent.
    constexpr int kSide = static_cast<int>(0.08 * kMapSize);
    sim::GroomInput after = before;
    auto raster = std::make_shared<sim::TiledRaster>(*before.groups.front().maps[map]);
    const int x0 = 100 + number * 37 % 700;
    const int y0 = (kMapSize - kSide) / 2;
    for (int y = y0; y < y0 + kSide; ++y) {
        for (int x = x0; x < x0 + kSide; ++x)
            raster->setTexel(x, y, value);
    }
    after.groups.front().maps[map] = std::move(raster);
    return after;
}

} // namespace

sim::GroomInput dabbed(const sim::GroomInput& before, int number)
{
    return withDab(before, sim::MapSlot::Length, number, {static_cast<std::uint16_t>(30000 + number * 997 % 30000)});
}

sim::GroomInput combed(const sim::GroomInput& before, int number)
{
    const float turn = 0.7F * static_cast<float>(number);
    return withDab(before, sim::MapSlot::Direction, number,
                   sim::texelOfDirection(0.9F * glm::vec2(std::cos(turn), std::sin(turn))));
}

} // namespace hairpaint::bench
