// Groups added, removed, renamed, moved, shown, set and replaced by a preset's.
#pragma once

#include "model/document/command_ptr.h"
#include "model/document/document.h"
#include "model/styles/style_use.h"

#include <vector>

namespace hairpaint::model {

/// Every map empty.
[[nodiscard]] CommandPtr addGroupCommand(Document& document, const QString& name,
                                         const sim::GroupSettings& settings = {});
/// A copy with new ids.
[[nodiscard]] CommandPtr addGroupCommand(Document& document, HairGroup group);
/// Groups read from a file of that name (model/importing), with new ids. Null where there is none.
[[nodiscard]] CommandPtr importHairCommand(Document& document, std::vector<HairGroup> groups, const QString& fileName);
/// Eyebrows and eyelashes (model/growth/face_hair.h), with new ids; or those that are there are shown, or hidden. Null
/// where there is nothing to add.
[[nodiscard]] CommandPtr addFaceHairCommand(Document& document, std::vector<HairGroup> groups);
[[nodiscard]] CommandPtr showFaceHairCommand(Document& document, bool visible);
/// Null for the last group: a project has at least one.
[[nodiscard]] CommandPtr removeGroupCommand(Document& document, Id group);
[[nodiscard]] CommandPtr renameGroupCommand(Document& document, Id group, const QString& name);
/// Null if its index stays the same. `newPosition`: index, 0 first.
[[nodiscard]] CommandPtr moveGroupCommand(Document& document, Id group, int newPosition);
[[nodiscard]] CommandPtr showGroupCommand(Document& document, Id group, bool visible);
/// The group with another range (model/document/range_change.h), made of its committed content.
[[nodiscard]] CommandPtr setRangeCommand(Document& document, struct RangeChange change, const QString& text);
/// Ranges change as numbers do: the texels stay, so that all hair is scaled. Null where nothing differs.
[[nodiscard]] CommandPtr setSettingsCommand(Document& document, Id group, const sim::GroupSettings& settings,
                                            const QString& text);
/// See applyPreset().
[[nodiscard]] CommandPtr applyPresetCommand(Document& document, const Preset& preset, const StyleUse& use = {});

} // namespace hairpaint::model
