// The maps that hair is grown from, and what each is in the groom: one row a map.
#pragma once

#include "sim/base/tiled_raster.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace hairpaint::sim {

/// In the order in which users see the maps.
enum class MapSlot : std::uint8_t
{
    Density,
    Length,
    Curl,
    CurlSize,
    Braid,
    Colour,
    TipColour,
    Clump,
    Gel,
    Direction,
    Frizz,
    Width,
    Gloss,
    TipStart,
    Accessory
};

enum class MapSampling : std::uint8_t
{
    Bilinear,
    Nearest
};

/// What is made anew where a map's value differs.
struct MapEffect
{
    bool hairs = false; ///< Which candidates are hairs, and their rest shapes and styles.
    bool basis = false; ///< The solved hairs' own shapes.
    bool look = false;  ///< Styles alone: what hairs look like, not where they lie.
    friend bool operator==(const MapEffect&, const MapEffect&) = default;
};

struct MapRule
{
    MapSlot slot;
    int channels = 1;
    MapSampling sampling = MapSampling::Bilinear;
    MapEffect effect;
    Texel defaultValue{}; ///< Where nothing is painted.
};

inline constexpr std::array kMapRules{
    MapRule{.slot = MapSlot::Density, .effect = {.hairs = true}},
    MapRule{.slot = MapSlot::Length, .effect = {.hairs = true, .basis = true}, .defaultValue = {32768}},
    MapRule{.slot = MapSlot::Curl, .effect = {.hairs = true}},
    MapRule{.slot = MapSlot::CurlSize, .effect = {.hairs = true}, .defaultValue = {32768}},
    MapRule{.slot = MapSlot::Braid, .sampling = MapSampling::Nearest, .effect = {.hairs = true}},
    MapRule{.slot = MapSlot::Colour,
            .channels = 3,
            .effect = {.look = true},
            .defaultValue = {0x3B3B, 0x2626, 0x1818}}, // Dark brown.
    MapRule{.slot = MapSlot::TipColour,
            .channels = 3,
            .effect = {.look = true},
            .defaultValue = {0x3B3B, 0x2626, 0x1818}}, // What an empty layer holds; where nothing is painted, tips have
                                                       // the colour map's colour.
    MapRule{.slot = MapSlot::Clump, .effect = {.hairs = true}},
    MapRule{.slot = MapSlot::Gel, .effect = {.basis = true}},
    MapRule{.slot = MapSlot::Direction,
            .channels = 2,
            .effect = {.hairs = true, .basis = true},
            .defaultValue = {32768, 32768}}, // Upright; direction_texel.h says how vectors are stored.
    MapRule{.slot = MapSlot::Frizz, .effect = {.look = true}},
    MapRule{.slot = MapSlot::Width, .effect = {.look = true}, .defaultValue = {32768}},
    MapRule{.slot = MapSlot::Gloss, .effect = {.look = true}, .defaultValue = {32768}},
    MapRule{.slot = MapSlot::TipStart, .effect = {.look = true}},
    MapRule{.slot = MapSlot::Accessory, .sampling = MapSampling::Nearest, .effect = {}}, // Only its ties act.
};
inline constexpr std::size_t kMapSlotCount = kMapRules.size();

[[nodiscard]] constexpr std::size_t indexOf(MapSlot slot)
{
    return static_cast<std::size_t>(slot);
}
[[nodiscard]] constexpr const MapRule& ruleOf(MapSlot slot)
{
    return kMapRules[indexOf(slot)];
}

static_assert(
    [] {
        for (std::size_t i = 0; i < kMapSlotCount; ++i)
            if (indexOf(kMapRules[i].slot) != i)
                return false;
        return true;
    }(),
    "rows stand in the order of MapSlot");

using MapRaster = std::shared_ptr<const TiledRaster>;

/// Resolved maps of one group, with the channels of their rules. A scalar's 65535 is 1; braid holds numbers for
/// braidKindOf(); colours are sRGB as encoded; directions as direction_texel.h has them. All are present.
class GroupMaps
{
public:
    [[nodiscard]] MapRaster& operator[](MapSlot slot) { return m_rasters[indexOf(slot)]; }
    [[nodiscard]] const MapRaster& operator[](MapSlot slot) const { return m_rasters[indexOf(slot)]; }
    /// Compares the rasters' pointers, not their texels.
    friend bool operator==(const GroupMaps&, const GroupMaps&) = default;

private:
    std::array<MapRaster, kMapSlotCount> m_rasters;
};

} // namespace hairpaint::sim
