// project.json: everything of a project or preset that is not a mesh or an image. Keys: hairpaint_format.md.
// Errors: clauses for a sentence of sentences.h.
#pragma once

#include "model/files/former_combing.h"
#include "model/project/project.h"
#include "model/styles/preset.h"
#include "model/values/sentences.h"

namespace hairpaint::model {

inline constexpr qint64 kMostJsonBytes = 4 << 20;

/// What a project file says of its head; the mesh comes from elsewhere.
struct HeadReference
{
    QString name;
    bool builtIn = true;
    float unitScale = 1.0F;
    UpAxis upAxis = UpAxis::Y;
    std::optional<sim::HeadLandmarks> landmarks = {}; ///< Of an imported head.
};

struct ProjectManifest
{
    Project project; ///< Without a head; layers without texels (see groupsFromJson), ids of all set.
    HeadReference head;
    /// Of each group of a file of version 1 that has no direction map; empty for later versions.
    std::vector<std::optional<FormerCombing>> formerCombing = {};
};

struct PresetManifest
{
    Preset preset; ///< Without a head; layers without texels, likewise.
    HeadReference head;
};

/// The first one that says all of it.
[[nodiscard]] int formatVersionOf(const Project& project);
[[nodiscard]] Checked<QByteArray> projectToJson(const Project& project);
[[nodiscard]] Checked<ProjectManifest> projectFromJson(const QByteArray& json);
[[nodiscard]] Checked<QByteArray> presetToJson(const Preset& preset);
[[nodiscard]] Checked<PresetManifest> presetFromJson(const QByteArray& json);

} // namespace hairpaint::model
