// What two settings of format version 1 did to hair, painted.
// Any thread. Errors: none but std::bad_alloc.
#pragma once

#include "model/project/project.h"

#include <functional>
#include <optional>
#include <span>

namespace hairpaint::model {

/// A group's `physics.parting`, `physics.sweep_back` and `physics.body`.
struct FormerCombing
{
    float parting = 0.6F;   ///< 0..1: how far long loose hair is combed to its own side of the middle.
    float sweepBack = 0.3F; ///< 0..1: how far it is combed away from the face.
    float body = 0.15F;     ///< 0..1: how firmly it kept its shape, and so stood.
};

/// Paints them, for each group that has one, as its direction map's only layer, "Parting and sweep back" (512 texels a
/// side): hair that is long and loose lies along them, other hair stands upright. Groups for which the project has no
/// room stay as they are. False where `goesOn` returns false.
[[nodiscard]] bool paintFormerCombing(Project& project, std::span<const std::optional<FormerCombing>> groups,
                                      const std::function<bool()>& goesOn = {});

} // namespace hairpaint::model
