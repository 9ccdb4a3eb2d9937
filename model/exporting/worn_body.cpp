// A thing's sheen becomes a surface's roughness.
#include "model/exporting/worn_body.h"

#include "model/values/srgb.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace hairpaint::model {

namespace {

/// Of a thing's colour, sRGB, and that of its surface, linear.
QRgb product(QRgb colour, const glm::vec3& by)
{
    if (by == glm::vec3(1.0F))
        return colour;
    const auto channel = [](int value, float factor) {
        const float linear = factor * linearFromSrgb(static_cast<float>(value) / 255.0F);
        return static_cast<int>(std::lround(255.0F * srgbFromLinear(std::clamp(linear, 0.0F, 1.0F))));
    };
    return qRgb(channel(qRed(colour), by.x), channel(qGreen(colour), by.y), channel(qBlue(colour), by.z));
}

/// `posed`: makes what goes out of a mesh.
template<typename Posed>
void addBodies(const CurveSet& curves, const Worn& worn, std::vector<WornBody>& bodies, const Posed& posed)
{
    constexpr double kLeastRoughness = 0.3; // The roughness at a sheen of 1.
    std::vector<HeadPart> surfaces = wornSurfaces(worn, curves.skin());
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        WornBody& body = bodies.emplace_back();
        body.name = QStringLiteral("Worn %1 %2").arg(QLatin1StringView(wornSpec(worn.kind).id)).arg(worn.id);
        if (surfaces.size() > 1)
            body.name += QStringLiteral(" part %1").arg(i + 1);
        body.mesh = posed(*surfaces[i].mesh);
        body.colour = product(worn.colour, surfaces[i].colour);
        body.alpha = surfaces[i].texture ? surfaces[i].alpha : sim::TextureAlpha::Opaque;
        body.texture = std::move(surfaces[i].texture);
        body.isOpen = surfaces[i].doubleSided;
        body.hanging = hangingParts(worn);
        body.roughness = kLeastRoughness + (1.0 - kLeastRoughness) * (1.0 - static_cast<double>(worn.sheen));
    }
}

} // namespace

QRgb meanColour(const WornBody& body)
{
    constexpr std::size_t kMostSamples = 4096;
    if (body.texture == nullptr || body.texture->rgba.empty())
        return body.colour;
    const std::vector<std::uint8_t>& rgba = body.texture->rgba;
    const std::size_t pixels = rgba.size() / 4;
    const std::size_t stride = pixels / kMostSamples + 1;
    glm::vec3 sum(0.0F);
    float weights = 0.0F;
    for (std::size_t i = 0; i < pixels; i += stride) {
        const float weight = body.alpha == sim::TextureAlpha::Opaque ? 1.0F : static_cast<float>(rgba[4 * i + 3]);
        weights += weight;
        for (std::size_t channel = 0; channel < 3; ++channel)
            sum[static_cast<int>(channel)] +=
                weight * linearFromSrgb(static_cast<float>(rgba[4 * i + channel]) / 255.0F);
    }
    return weights > 0.0F ? product(body.colour, sum / weights) : body.colour;
}

std::vector<WornBody> wornBodies(const CurveSet& curves, std::span<const Worn> worn)
{
    std::vector<WornBody> bodies;
    bodies.reserve(worn.size());
    for (const Worn& one : worn)
        addBodies(curves, one, bodies, [&](const sim::HeadMesh& mesh) { return posedWorn(curves, one, mesh); });
    return bodies;
}

std::vector<WornBody> turnedBodies(const CurveSet& curves, const Worn& worn, const glm::quat& turn)
{
    std::vector<WornBody> bodies;
    addBodies(curves, worn, bodies, [&](const sim::HeadMesh& mesh) { return turnedWorn(worn, mesh, turn); });
    return bodies;
}

} // namespace hairpaint::model
