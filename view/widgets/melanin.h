// The colours that hair grows in: what two pigments make of white hair.
#pragma once

#include <QColor>

namespace hairpaint::view {

struct Melanin
{
    double amount = 0.0;  ///< 0..1: from white to black; the pigment grows with its square, so that steps look even.
    double redness = 0.0; ///< 0..1: the part of it that is pheomelanin, the red pigment; the rest is the brown one.
};

/// The colour of a coat of such hair. Absorption of the pigments: d'Eon and others 2011; a coat's colour by it: Chiang
/// and others 2016, equation 9, as the light on hair has it.
[[nodiscard]] QColor melaninColour(const Melanin& melanin);
/// The melanin whose colour is nearest to a given one, by least squares of the absorption.
[[nodiscard]] Melanin nearestMelanin(const QColor& colour);

} // namespace hairpaint::view
