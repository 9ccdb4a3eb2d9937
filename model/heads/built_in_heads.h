// The heads that come with the program: a row each. Their meshes are resources of the same names.
//
// Head space: metres, y up, face toward +z, origin at the head's centre. Everything is symmetric in x. Constants: any
// thread, no errors.
#pragma once

#include "model/heads/head_regions.h"
#include "sim/skin/ellipsoid.h"
#include "sim/skin/head_landmarks.h"

#include <span>
#include <string_view>

namespace hairpaint::heads {

/// One built-in head; model/files/head_file.h reads its mesh and skin.
struct HeadRow
{
    std::string_view name;  ///< In project files; a row is frozen once a file may name it.
    const char* title = ""; ///< To be translated in context "Heads".
    sim::HeadLandmarks landmarks;
    HeadRegions regions;
    /// Cranium, face, jaw, neck, shoulders, chest: their union lies within about 2 mm of the scalp. Printed by
    /// hairpaint_bust_generator --colliders; many overlap, only their union counts.
    std::span<const sim::Ellipsoid> colliders;
    double scalpFraction = 1.0; ///< Fraction of the skin's area that the scalp covers, 0..1.
};

/// The default first.
[[nodiscard]] std::span<const HeadRow* const> headRows();

/// Null for a name that none of them has.
[[nodiscard]] const HeadRow* findHeadRow(std::string_view name);

[[nodiscard]] const HeadRow& bust1();
[[nodiscard]] const HeadRow& bust2();

} // namespace hairpaint::heads
