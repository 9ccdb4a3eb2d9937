// Cards as a binary glTF in memory.
#pragma once

#include "model/cards/hair_cards.h"
#include "model/exporting/export_space.h"

#include <QByteArray>

#include <span>

namespace hairpaint::model {

/// A mesh a group and level, named "Scalp_LOD1" where there are several levels: a node of the first names the others by
/// MSFT_lod. With VRMC_springBone 1.0 where there are bones, and with the body as VRMC_vrm 1.0 where there is an
/// avatar. `pngs`: one a kind of image; those that are embedded are used.
[[nodiscard]] QByteArray cardGlb(const CurveSet& curves, const HairCards& cards, const ExportSettings& settings,
                                 std::span<const QByteArray> pngs);

} // namespace hairpaint::model
