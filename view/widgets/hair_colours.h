// The colours that hair is sold in.
#pragma once

#include <QColor>

#include <span>

namespace hairpaint::view {

struct HairColour
{
    const char* name; ///< To be translated in context "HairColours".
    QRgb colour;
};

/// Levels 1 (black) to 10 (lightest blonde), as hairdressers count them.
[[nodiscard]] std::span<const HairColour> naturalHairColours();
[[nodiscard]] std::span<const HairColour> redAndGreyHairColours();
[[nodiscard]] std::span<const HairColour> fashionHairColours();
[[nodiscard]] QString hairColourName(const HairColour& colour);

} // namespace hairpaint::view
