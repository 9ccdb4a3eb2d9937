// What is worn on the head, as the bodies that files show of it.
#pragma once

#include "model/exporting/curve_set.h"
#include "model/exporting/posed_mesh.h"
#include "model/project/worn.h"

#include <QString>

#include <memory>
#include <span>
#include <vector>

namespace hairpaint::model {

/// A surface of a thing: all of it but for own meshes of several materials.
struct WornBody
{
    QString name; ///< "Worn ponytail 3": its kind and id; with " part 2" where there are more.
    PosedMesh mesh;
    QRgb colour = 0; ///< sRGB, opaque; times the texture.
    sim::TextureAlpha alpha = sim::TextureAlpha::Opaque;
    std::shared_ptr<const sim::MeshTexture> texture = {}; ///< Null where it has none.
    bool isOpen = false;                                  ///< Whether its inside is seen, too.
    std::span<const HangingPart> hanging = {};            ///< Parts of the mesh that may swing.
    double roughness = 1.0; ///< 0..1, of glTF's metallic-roughness material, and USD's UsdPreviewSurface.
};

/// What stands for colour and texture where there is room for one colour: the texture's mean, times the colour.
[[nodiscard]] QRgb meanColour(const WornBody& body);

/// All that are drawn, Wo, where the head of the curves holds them; in their order. Any thread.
[[nodiscard]] std::vector<WornBody> wornBodies(const CurveSet& curves, std::span<const Worn> worn);
/// Those of one thing on a head at rest that is turned about its origin.
[[nodiscard]] std::vector<WornBody> turnedBodies(const CurveSet& curves, const Worn& worn, const glm::quat& turn);

} // namespace hairpaint::model
