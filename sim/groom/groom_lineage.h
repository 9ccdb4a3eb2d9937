// Which strand of the groom before a basis hair was.
#pragma once

#include "sim/groom/groom.h"

#include <cstdint>
#include <vector>

namespace hairpaint::sim {

inline constexpr std::int32_t kNoOrigin = -1;

/// True where basis hair i of both grooms is the same hair, for every i.
[[nodiscard]] bool sameStrands(const Groom& before, const Groom& after);

/// For each lane of the groom's basis blocks, the index in the groom before, or kNoOrigin. More or fewer candidates on
/// the same skin keep their ranks, so hairs are followed by rank.
[[nodiscard]] std::vector<std::int32_t> originsOf(const Groom& before, const Groom& after);

enum class StrandChange : std::uint8_t
{
    None,
    Gone,    ///< Not wanted any more, or never was.
    Shape,   ///< Same root, another rest shape or another BasisQuantity.
    Arrived, ///< Was not there, or stood elsewhere.
};

/// What happened to basis hair `index`, which was `origin` before (kNoOrigin: nothing).
[[nodiscard]] StrandChange changeOf(const Groom& before, std::int32_t origin, const Groom& after, std::size_t index);

/// Whether a whole block's styles are the same bytes in both; only where sameStrands.
[[nodiscard]] bool sameBlock(const BasisStyles& before, const BasisStyles& after, int nodes, std::size_t block);

} // namespace hairpaint::sim
