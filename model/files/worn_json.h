// What is worn, as JSON. Keys, ranges and defaults: hairpaint_format.md. Errors: clauses for a sentence of sentences.h.
#pragma once

#include "model/project/project.h"
#include "model/values/sentences.h"

#include <QJsonObject>

#include <memory>
#include <vector>

namespace hairpaint::model {

/// Into the arrays of the root that the table of kinds names; others into `worn`.
void wornToJson(const std::vector<Worn>& all, const std::vector<HairGroup>& groups, QJsonObject& root);
/// The same of a style: all into `worn`, which is not there where there is none.
void wornToPreset(const std::vector<Worn>& all, const std::vector<HairGroup>& groups, QJsonObject& root);
[[nodiscard]] Checked<std::vector<Worn>> wornOfPreset(const QJsonObject& root, const std::vector<HairGroup>& groups,
                                                      Id nextId);
/// Whether some of it stands in `worn`, which readers of the first two versions do not know.
[[nodiscard]] bool needsWornArray(const std::vector<Worn>& all);

/// The meshes that users brought, each once; a file holds them under their index here and 1.
[[nodiscard]] std::vector<std::shared_ptr<const OwnMesh>> ownMeshesOf(const std::vector<Worn>& all);

/// As insertWorn() keeps them, own meshes named alone (OwnMesh::entry). Ids are checked to be below `nextId` and none
/// of the groups' or layers'; a thing without one has the id 0, for the caller to set.
[[nodiscard]] Checked<std::vector<Worn>> wornFromJson(const QJsonObject& root, const std::vector<HairGroup>& groups,
                                                      Id nextId);

} // namespace hairpaint::model
