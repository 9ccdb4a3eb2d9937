// Hair groups as JSON, shared by projects and presets. Keys, ranges and defaults: hairpaint_format.md.
#pragma once

#include "model/project/content_budget.h"
#include "model/values/sentences.h"

#include <QJsonArray>

namespace hairpaint::model {

inline constexpr Id kGreatestNextId = 2'000'000'000; ///< Ids of files lie below it.

/// An id above those of all groups and layers.
[[nodiscard]] Id nextIdOf(const std::vector<HairGroup>& groups);
/// Whether a file can hold these ids and the counter.
[[nodiscard]] bool idsFit(const std::vector<HairGroup>& groups, Id nextId);
/// Gives groups and layers the ids from 1 on: for a document whose counter has come to its end.
void renumber(std::vector<HairGroup>& groups, Id& nextId);

[[nodiscard]] QJsonArray groupsToJson(const std::vector<HairGroup>& groups);

/// Groups whose layers have no texels yet: each raster is one tile of the empty texel, to be replaced. Maps that the
/// file lacks get an empty layer, whose id is 0 for the caller to set. Every id is checked to be unique and below
/// `nextId`.
[[nodiscard]] Checked<std::vector<HairGroup>> groupsFromJson(const QJsonArray& array, Id nextId);

/// Whether the counts keep to content_budget.h's limits and there is a group at all.
[[nodiscard]] Checked<void> checkGroupCounts(const std::vector<HairGroup>& groups);

/// "groups/<group>/<map>/<layer>.png"
[[nodiscard]] QString layerEntryName(const HairGroup& group, const MapStack& stack, const Layer& layer);

} // namespace hairpaint::model
