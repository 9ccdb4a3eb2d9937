// The built-in styles, each recorded as a user makes it.
#pragma once

#include "recording.h"

#include <QStringList>

#include <vector>

namespace hairpaint::presets {

struct Style
{
    const char* id; ///< File name.
    const char* name;
    QStringList tags;
    sim::GroupSettings settings;
    void (*record)(Recording& user);
};

[[nodiscard]] Style longStraight();
[[nodiscard]] Style bob();
[[nodiscard]] Style ringlets();
[[nodiscard]] Style afro();
[[nodiscard]] Style twoPlaits();
[[nodiscard]] Style mohawk();
[[nodiscard]] Style splitDye();
[[nodiscard]] Style buzzCut();
[[nodiscard]] Style slickedUndercut();
[[nodiscard]] Style quiff();
[[nodiscard]] Style sidePart();
[[nodiscard]] Style frenchCrop();

[[nodiscard]] std::vector<Style> builtInStyles(); ///< In the strip's order.

/// What the style's recording makes of hairOfHead(), without its picture.
[[nodiscard]] model::Preset played(const Style& style, const model::HairGroup& grown);

/// What most of them have in common.
[[nodiscard]] sim::GroupSettings settingsOf(float greatestLengthM, float stiffnessM, float volumeM);

/// Cuts hair so that it ends at a height when it falls down the sides of the head, but for what is longer than it may
/// or shorter than it can be.
void cutToLine(Recording& user, float lineHeightM, float shortestM);

} // namespace hairpaint::presets
