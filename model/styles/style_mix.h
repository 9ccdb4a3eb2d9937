// Hair between two styles.
#pragma once

#include "model/project/project.h"

namespace hairpaint::model {

/// A group between two of its kind: `fraction` 0 is as `from`, 1 as `to`. Lengths, densities and other amounts are
/// mixed as amounts, whatever the ranges of both are; colours as colours, combed directions as vectors; numbers in
/// proportion. What can't be mixed comes from the nearer of both, from `to` at a half: palettes (braids, ties),
/// switches, choices, names, and whether it is shown. Maps of different sizes are mixed at the size of `to`. Ids are
/// those of `to`, but for palettes of `from`. `head`: whose maps tell what unpainted skin shows; may be null. Any
/// thread.
[[nodiscard]] HairGroup mixedGroup(const HairGroup& from, HairGroup to, double fraction, const Head* head);

} // namespace hairpaint::model
