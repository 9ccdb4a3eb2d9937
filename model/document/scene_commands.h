// Wind, light, background, skin, what is worn and the head.
#pragma once

#include "model/document/command_ptr.h"
#include "model/document/document.h"

#include <memory>
#include <optional>
#include <vector>

namespace hairpaint::model {

/// Null where nothing differs; likewise the next ones. Whether the wind blows does not change; see
/// Document::setWindOn.
[[nodiscard]] CommandPtr setWindCommand(Document& document, const sim::Wind& wind);
[[nodiscard]] CommandPtr setLightCommand(Document& document, const LightSettings& light);
[[nodiscard]] CommandPtr setBackgroundCommand(Document& document, QRgb background);
[[nodiscard]] CommandPtr setSkinCommand(Document& document, SkinTone skin);
/// With a new id, behind those of its kind. Null where the project holds as many as it may.
[[nodiscard]] CommandPtr addWornCommand(Document& document, Worn worn);
/// With the patch that it is painted as. Null where there is none.
[[nodiscard]] CommandPtr removeWornCommand(Document& document, Id id);
/// Undo names of wind, light and background, for edits that are previewed before they are committed.
[[nodiscard]] QString windStepText();
[[nodiscard]] QString lightStepText();
[[nodiscard]] QString backgroundStepText();
/// Where it brings a picture of its skin, that is shown; where it brings none, none is any more.
void putHead(Project& project, const std::shared_ptr<const Head>& head);
/// As putHead(), with the ellipsoids that it brings, and the groups as they were carried to it (style_transfer.h), or
/// the maps taken as they lie.
[[nodiscard]] CommandPtr setHeadCommand(Document& document, std::shared_ptr<const Head> head,
                                        std::vector<sim::Ellipsoid> ellipsoids,
                                        std::optional<std::vector<HairGroup>> groups = {});

} // namespace hairpaint::model
