// What is worn on the head, as the bodies that files show of it.
#pragma once

#include "model/exporting/curve_set.h"
#include "model/exporting/posed_mesh.h"
#include "model/project/worn.h"

#include <QString>

#include <span>
#include <vector>

namespace hairpaint::model {

struct WornBody
{
    QString name; ///< "Worn ponytail 3": its kind and id.
    PosedMesh mesh;
    QRgb colour = 0;                           ///< sRGB, opaque.
    bool isOpen = false;                       ///< Whether its inside is seen, too.
    std::span<const HangingPart> hanging = {}; ///< Parts of the mesh that may swing.
    double roughness = 1.0; ///< 0..1, of glTF's metallic-roughness material, and USD's UsdPreviewSurface.
};

/// One that is drawn, of a mesh that was posed for it.
[[nodiscard]] WornBody wornBody(const Worn& worn, PosedMesh mesh);
/// All that are drawn, Wo, where the head of the curves holds them; in their order. Any thread.
[[nodiscard]] std::vector<WornBody> wornBodies(const CurveSet& curves, std::span<const Worn> worn);

} // namespace hairpaint::model
