// Hairstyles carried from head to head.
#pragma once

#include "model/project/project.h"
#include "model/styles/preset.h"
#include "model/values/progress.h"

#include <memory>
#include <optional>
#include <vector>

namespace hairpaint::model {

/// Whether both heads have what a style can be carried by: skin and landmarks. Where not, or where they are one head,
/// maps are taken as they lie.
[[nodiscard]] bool canCarry(const std::shared_ptr<const Head>& from, const std::shared_ptr<const Head>& to);

/// The groups as they look on another head: every layer of every map lies at the corresponding uv of its layout
/// (UvCorrespondence), with its names, opacities and sizes; a map of one value stays so. Directions are told in the new
/// head's frames. Numbers that count on the scalp count as many there; greatest and shortest length, the spacing and
/// the radius of braids grow with a head that is larger or smaller by 3 % or more, so that hair ends at the same
/// landmarks and there are as many braids. None where progress stops it.
/// Unchanged where the style can't be carried. Any thread.
[[nodiscard]] std::optional<std::vector<HairGroup>> carriedGroups(std::vector<HairGroup> groups,
                                                                  const std::shared_ptr<const Head>& from,
                                                                  const std::shared_ptr<const Head>& to,
                                                                  const Progress& progress = {});

/// The style on another head, likewise.
[[nodiscard]] std::optional<Preset> carriedPreset(Preset preset, const std::shared_ptr<const Head>& to,
                                                  const Progress& progress = {});

} // namespace hairpaint::model
