// Inputs for grooms in tests: maps of plain values, and dabs on them.
#pragma once

#include "sim/groom/groom_input.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>

namespace hairpaint::test {

/// 0..1 as a texel's channel.
inline std::uint16_t channelOf(float value)
{
    return static_cast<std::uint16_t>(std::lround(std::clamp(value, 0.0F, 1.0F) * 65535.0F));
}

inline std::shared_ptr<const sim::TiledRaster> uniformMap(float value, int size = 512)
{
    return std::make_shared<const sim::TiledRaster>(size, 1, sim::Texel{channelOf(value)});
}

inline std::shared_ptr<const sim::TiledRaster> uniformColour(glm::vec3 value, int size = 512)
{
    return std::make_shared<const sim::TiledRaster>(
        size, 3, sim::Texel{channelOf(value.x), channelOf(value.y), channelOf(value.z)});
}

inline std::shared_ptr<const sim::TiledRaster> indexMap(std::uint16_t index, int size = 512)
{
    return std::make_shared<const sim::TiledRaster>(size, 1, sim::Texel{index});
}

/// The map with `texel` at every texel whose centre lies within `radius` of `centre`, both in uv.
inline std::shared_ptr<const sim::TiledRaster> withDab(const std::shared_ptr<const sim::TiledRaster>& map,
                                                       glm::vec2 centre, float radius, sim::Texel texel)
{
    auto painted = std::make_shared<sim::TiledRaster>(*map);
    const auto size = static_cast<float>(map->size());
    const glm::vec2 centreTx(centre.x * size - 0.5F, (1.0F - centre.y) * size - 0.5F);
    const float radiusTx = radius * size;
    const auto first = [&](float middle) { return std::max(static_cast<int>(std::ceil(middle - radiusTx)), 0); };
    const auto last = [&](float middle) {
        return std::min(static_cast<int>(std::floor(middle + radiusTx)), map->size() - 1);
    };
    for (int y = first(centreTx.y); y <= last(centreTx.y); ++y)
        for (int x = first(centreTx.x); x <= last(centreTx.x); ++x)
            if (glm::length(glm::vec2(x, y) - centreTx) <= radiusTx)
                painted->setTexel(x, y, texel);
    return painted;
}

/// Left half one value, right half another.
inline std::shared_ptr<const sim::TiledRaster> halves(float left, float right)
{
    auto map = std::make_shared<sim::TiledRaster>(512, 1, sim::Texel{channelOf(left)});
    for (int tile = 0; tile < map->tileCount(); ++tile)
        if (map->tileRect(tile).x0 >= 256)
            map->setUniform(tile, {channelOf(right)});
    return map;
}

/// Grows with u from 0 to 1.
inline std::shared_ptr<const sim::TiledRaster> ramp()
{
    auto map = std::make_shared<sim::TiledRaster>(512, 1);
    for (int y = 0; y < 512; ++y)
        for (int x = 0; x < 512; ++x)
            map->setTexel(x, y, {channelOf((static_cast<float>(x) + 0.5F) / 512.0F)});
    return map;
}

/// One group with uniform maps: full density, brown, else what maps are where nothing is painted.
inline sim::GroomInput::Group uniformGroup(int id = 1)
{
    sim::GroomInput::Group group;
    group.id = id;
    for (const sim::MapRule& rule : sim::kMapRules)
        group.maps[rule.slot] = std::make_shared<const sim::TiledRaster>(512, rule.channels, rule.defaultValue);
    group.maps[sim::MapSlot::Density] = uniformMap(1.0F);
    group.maps[sim::MapSlot::Colour] = uniformColour({0.3F, 0.2F, 0.1F});
    group.maps[sim::MapSlot::TipColour] = group.maps[sim::MapSlot::Colour];
    return group;
}

inline sim::GroomInput inputOf(std::shared_ptr<const sim::Skin> skin, sim::GroomInput::Group group = uniformGroup())
{
    sim::GroomInput input;
    input.skin = std::move(skin);
    input.groups.push_back(std::move(group));
    return input;
}

} // namespace hairpaint::test
