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
    std::optional<sim::HeadLandmarks> landmarks = {}; ///< Landmarks of an imported head; none for a built-in one.
};

struct ProjectManifest
{
    Project project; ///< Without a head; layers without texels (see groupsFromJson), ids of all set.
    HeadReference head;
    /// By group, in files of version 1: the combing of a group that has no direction map. Empty for later versions.
    std::vector<std::optional<FormerCombing>> formerCombing = {};
};

struct PresetManifest
{
    Preset preset; ///< Without a head; layers without texels, likewise.
    HeadReference head;
};

/// The oldest format version that can hold all of the project.
[[nodiscard]] int formatVersionOf(const Project& project);
[[nodiscard]] Checked<QByteArray> projectToJson(const Project& project);
[[nodiscard]] Checked<ProjectManifest> projectFromJson(const QByteArray& json);
[[nodiscard]] Checked<QByteArray> presetToJson(const Preset& preset);
[[nodiscard]] Checked<PresetManifest> presetFromJson(const QByteArray& json);

} // namespace hairpaint::model
