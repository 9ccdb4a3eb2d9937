// What can be done with texels of each kind: one row a kind, of functions over runs of texels.
// Any thread. Errors: none; the functions over runs neither allocate nor throw.
#pragma once

#include "model/project/blend_modes.h"
#include "model/project/map_spec.h"

#include <QString>

#include <cstddef>
#include <span>

namespace hairpaint::model {

/// What is laid on the texels of a tile. Where `values` is set it holds [64][64][valueChannels], else `value` is laid
/// everywhere.
struct TilePaint
{
    sim::Texel value{};
    const std::uint16_t* values = nullptr;
    std::uint16_t opacity = 65535;
    bool erase = false;
};

/// Layers' texels are value channels, then coverage; maps' are value channels alone.
struct TexelOps
{
    TexelKind kind;
    bool continuous; ///< Values between two values mean something between.

    /// Lays paint on a tile's texels, or takes coverage away (see paintTile). `mask`: [64][64].
    void (*lay)(std::uint16_t* layer, const std::uint16_t* mask, const TilePaint& paint);
    void (*erase)(const MapSpec& spec, std::uint16_t* layer, const std::uint16_t* mask, std::uint16_t opacity);
    /// Lays a layer's texels over a map's (see resolveTexel). The first is used for all where `layerStep` is 0.
    void (*blend)(BlendMode mode, const std::uint16_t* layer, std::size_t layerStep, std::uint16_t opacity,
                  std::uint16_t* map, std::size_t count);
    /// Values from `first` (a fraction of 0) to `second` (65535).
    void (*mix)(const sim::Texel& first, const sim::Texel& second, std::span<const std::uint16_t> fractions,
                std::uint16_t* values);

    /// Values that lie `step` channels apart as [count][3] encoded colours, on white or night paper.
    void (*toColours)(const MapSpec& spec, bool nightPaper, const std::uint16_t* values, std::size_t step,
                      std::size_t count, std::uint16_t* colours);
    /// The same as [count] greys that fromGreys reads as the same values; null where a grey can't tell them.
    void (*toGreys)(const MapSpec& spec, const std::uint16_t* values, std::size_t step, std::size_t count,
                    std::uint16_t* greys);
    /// Converts in the same buffer: red, green, blue, alpha as a layer's texels, by the map's colours or by grey as the
    /// value.
    void (*fromColours)(const MapSpec& spec, std::span<sim::Texel> texels);
    void (*fromGreys)(const MapSpec& spec, std::span<sim::Texel> texels);

    /// A map's texel as what the user paints with, and back.
    PaintValue (*paintValue)(const sim::Texel& texel);
    sim::Texel (*texel)(const PaintValue& value);
    QString (*text)(const sim::GroupSettings& settings, const MapSpec& spec, const PaintValue& value);
    std::uint16_t (*greatest)(const MapSpec& spec); ///< Value that a channel may have.
};

[[nodiscard]] const TexelOps& texelOps(TexelKind kind);
[[nodiscard]] inline const TexelOps& texelOps(const MapSpec& spec)
{
    return texelOps(spec.texel);
}

/// What is painted as a map's texel, without coverage.
[[nodiscard]] sim::Texel texelOf(const MapSpec& spec, const PaintValue& value);
/// One map texel's colour.
[[nodiscard]] QRgb colourOfTexel(const MapSpec& spec, const sim::Texel& texel, bool nightPaper);

} // namespace hairpaint::model
