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

struct BuiltInHead
{
    std::string_view name;  ///< In project files; a row is frozen once a file may name it.
    const char* title = ""; ///< To be translated in context "Heads".
    sim::HeadLandmarks landmarks;
    HeadRegions regions;
    /// Cranium, face, jaw, neck, shoulders, chest: their union lies within about 2 mm of the scalp. Printed by
    /// hairpaint_bust_generator --colliders; many overlap, only their union counts.
    std::span<const sim::Ellipsoid> colliders;
    double scalpFraction = 1.0; ///< Of the skin's area, 0..1.
};

/// The default first.
[[nodiscard]] std::span<const BuiltInHead* const> builtInHeads();

/// Null for a name that none of them has.
[[nodiscard]] const BuiltInHead* findBuiltInHead(std::string_view name);

/// The rows.
[[nodiscard]] const BuiltInHead& bust1();
[[nodiscard]] const BuiltInHead& bust2();

} // namespace hairpaint::heads
