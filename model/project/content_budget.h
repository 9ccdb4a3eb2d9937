// How much a document may hold: the same for editing, saving and opening, so that what can be made can be saved.
#pragma once

#include "model/project/project.h"

#include <QString>

namespace hairpaint::model {

inline constexpr int kMostGroups = 256;
inline constexpr int kMostLayersInMap = 256;
inline constexpr int kMostLayers = 4096;
inline constexpr qint64 kMostTexels = qint64{1} << 32;         ///< Texels of all layers together.
inline constexpr qint64 kMostDistinctTexels = qint64{1} << 29; ///< The same; equal layers of one value count once.
inline constexpr std::size_t kMostHeldBytes = std::size_t{1} << 30U; ///< Bytes of the tiles that are not of one value.

enum class ContentExcess : std::uint8_t
{
    None,
    Groups, ///< Too many groups, or layers in a map or in all.
    Texels  ///< Too many texels, or bytes of them.
};

/// What keeps these groups from being saved. Layers that are painted in count as differing.
[[nodiscard]] ContentExcess excessOf(const std::vector<HairGroup>& groups);
/// What keeps `after` from replacing `before`: where that is too large already, making it smaller step by
/// step must be possible, so what is too much may be as much as it was.
[[nodiscard]] ContentExcess excessOver(const std::vector<HairGroup>& before, const std::vector<HairGroup>& after);
/// Whether there are too many groups or layers.
[[nodiscard]] bool countsExceed(const std::vector<HairGroup>& groups);
/// Whether painting alone, without another layer, could make them too much.
[[nodiscard]] bool paintingMayExceed(const std::vector<HairGroup>& groups);
/// A sentence that tells the excess and what helps; empty for None.
[[nodiscard]] QString excessText(ContentExcess excess);

} // namespace hairpaint::model
