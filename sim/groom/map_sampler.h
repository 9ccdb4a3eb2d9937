// Reads one map at many roots.
#pragma once

#include "sim/groom/direction_texel.h"
#include "sim/groom/map_slot.h"

#include <optional>
#include <utility>

namespace hairpaint::sim {

/// A map that is the same everywhere is not looked up; the values have the same bits as if it were.
class MapSampler
{
public:
    explicit MapSampler(const MapRaster& raster) : m_raster(raster.get()), m_uniform(raster->uniformValue())
    {
        if (m_uniform)
            m_uniformValue = raster->sampleBilinear(glm::vec2(0.5F));
    }

    /// Whether both read the very same raster.
    [[nodiscard]] bool sameAs(const MapSampler& other) const { return m_raster == other.m_raster; }
    [[nodiscard]] bool isUniform() const { return m_uniform.has_value(); }
    [[nodiscard]] float scalar(glm::vec2 uv) const { return m_uniform ? m_uniformValue.x : m_raster->sampleScalar(uv); }
    [[nodiscard]] glm::vec4 channels(glm::vec2 uv) const
    {
        return m_uniform ? m_uniformValue : m_raster->sampleBilinear(uv);
    }
    /// The direction map's vector, in the frame of the root at uv.
    [[nodiscard]] DirectionVector vector(glm::vec2 uv) const
    {
        return m_uniform ? directionOf(*m_uniform) : directionAt(*m_raster, uv);
    }
    [[nodiscard]] std::uint16_t index(glm::vec2 uv) const
    {
        return m_uniform ? (*m_uniform)[0] : m_raster->sampleNearest(uv)[0];
    }

private:
    const TiledRaster* m_raster;
    std::optional<Texel> m_uniform;
    glm::vec4 m_uniformValue{0.0F};
};

/// All maps of a group, which must outlive it.
class MapSamplers
{
public:
    explicit MapSamplers(const GroupMaps& maps) : MapSamplers(maps, std::make_index_sequence<kMapSlotCount>()) {}
    [[nodiscard]] const MapSampler& operator[](MapSlot slot) const { return m_samplers[indexOf(slot)]; }

private:
    template<std::size_t... index>
    MapSamplers(const GroupMaps& maps, std::index_sequence<index...>)
        : m_samplers{MapSampler(maps[kMapRules[index].slot])...}
    {}

    std::array<MapSampler, kMapSlotCount> m_samplers;
};

} // namespace hairpaint::sim
