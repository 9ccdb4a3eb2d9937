// A thing's sheen becomes a surface's roughness.
#include "model/exporting/worn_body.h"

#include <utility>

namespace hairpaint::model {

WornBody wornBody(const Worn& worn, PosedMesh mesh)
{
    constexpr double kLeastRoughness = 0.3; // The roughness at a sheen of 1.
    return {.name = QStringLiteral("Worn %1 %2").arg(QLatin1StringView(wornSpec(worn.kind).id)).arg(worn.id),
            .mesh = std::move(mesh),
            .colour = worn.colour,
            .isOpen = worn.ownMesh.isRead(),
            .hanging = hangingParts(worn),
            .roughness = kLeastRoughness + (1.0 - kLeastRoughness) * (1.0 - static_cast<double>(worn.sheen))};
}

std::vector<WornBody> wornBodies(const CurveSet& curves, std::span<const Worn> worn)
{
    std::vector<WornBody> bodies;
    bodies.reserve(worn.size());
    for (const Worn& one : worn)
        if (wornSpec(one.kind).drawn())
            bodies.push_back(wornBody(one, posedWorn(curves, one)));
    return bodies;
}

} // namespace hairpaint::model
