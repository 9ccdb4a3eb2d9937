// Cards as a binary glTF in memory.
#pragma once

#include "model/exporting/cards/hair_cards.h"
#include "sim/skin/ellipsoid.h"

#include <QByteArray>

#include <span>

namespace hairpaint::model {

/// `pngs`: one a kind of image; those that are embedded are used. `colliders`: Hd, for the bones.
[[nodiscard]] QByteArray cardGlb(const CurveSet& curves, const HairCards& cards,
                                 std::span<const sim::Ellipsoid> colliders, std::span<const QByteArray> pngs);

} // namespace hairpaint::model
