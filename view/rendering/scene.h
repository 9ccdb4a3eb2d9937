// What the renderer is asked to show, besides the hair itself.
#pragma once

#include "sim/motion/strand_frame.h"
#include "sim/skin/ellipsoid.h"
#include "sim/skin/head_mesh.h"
#include "sim/skin/mesh_texture.h"
#include "view/rendering/light/environment.h"
#include "view/rendering/light/far_light.h"

#include <glm/glm.hpp>

#include <memory>
#include <optional>
#include <vector>

namespace hairpaint::rendering {

struct CardSet;

/// Orbits a target. Wo, m, rad.
struct Camera
{
    glm::vec3 targetWo{0.0F, -0.01F, 0.0F};
    float distanceM = 0.75F;
    float azimuthRad = 0.0F;      ///< 0 looks at the face (from +z); positive moves the eye toward +x.
    float elevationRad = 0.05F;   ///< -pi/2..pi/2
    float fieldOfViewRad = 0.52F; ///< Vertical.
    [[nodiscard]] glm::vec3 eyeWo() const;
    [[nodiscard]] glm::mat4 view() const;
    [[nodiscard]] glm::mat4 projection(float aspect) const;
    friend bool operator==(const Camera&, const Camera&) = default;
};

/// A key light, a fill beside the eye, a rim light behind the head as the eye sees it, and surroundings.
struct Light
{
    glm::vec3 directionWo{0.4F, 0.6F, 0.7F}; ///< Toward the key light, unit.
    glm::vec3 colour{0.9F};                  ///< Colour of the key light; linear, intensity included.
    float fill = 0.4F;
    float rim = 0.6F;
    float ambient = 0.35F; ///< How bright the surroundings are.
    EnvironmentKind surroundings = EnvironmentKind::Studio;
    ScatteringModel scattering = ScatteringModel::Marschner;
    friend bool operator==(const Light&, const Light&) = default;
};

/// What the head's skin looks like. Colours are linear.
struct SkinShading
{
    glm::vec3 colour{0.51F, 0.455F, 0.412F};
    glm::vec3 lips{0.46F, 0.38F, 0.33F};
    glm::vec3 lids{0.47F, 0.41F, 0.37F};
    float scatter = 0.25F; ///< 0..1: how far light spreads within it, red furthest.
    float grain = 0.25F;   ///< 0..1: how deep pores and fine lines are.
    float sheen = 0.6F;    ///< 0..1: how much of the light it reflects without taking its colour.
    friend bool operator==(const SkinShading&, const SkinShading&) = default;
};

/// A lit body that goes with the head; hair lies before and behind it.
struct Solid
{
    std::shared_ptr<const sim::HeadMesh> mesh; ///< Closed, in a space of its own in which it fits the unit ball,
    sim::Ellipsoid shape;                      ///< which is scaled, turned (unit) and moved to this.
    glm::vec3 colour{0.5F};                    ///< Linear.
    float sheen = 0.6F;                        ///< As SkinShading::sheen.
    bool open = false;                         ///< The mesh is not closed: its inside is seen.
    bool masked = false;                       ///< Where the texture's alpha is under a half nothing is drawn.
    std::shared_ptr<const sim::MeshTexture> texture = {}; ///< Multiplied by the colour; null: none.
    friend bool operator==(const Solid&, const Solid&) = default;
};
/// What a solid is shaded as.
[[nodiscard]] inline SkinShading skinOf(const Solid& solid)
{
    return {.colour = solid.colour,
            .lips = solid.colour,
            .lids = solid.colour,
            .scatter = 0.0F,
            .grain = 0.0F,
            .sheen = solid.sheen};
}

/// The brush ring on the skin: drawn as a line around `radiusM`, and hair inside fades.
struct Ring
{
    glm::vec3 centreHd{0.0F};
    glm::vec3 normalHd{0.0F, 1.0F, 0.0F};
    float radiusM = 0.015F;
    friend bool operator==(const Ring&, const Ring&) = default;
};

struct Scene
{
    std::shared_ptr<const sim::HeadMesh> head;
    std::shared_ptr<const sim::HeadMesh> headInMotion; ///< Coarser, for frames whose view changes; null: as `head`.
    std::shared_ptr<const sim::StrandFrame> hair;
    std::shared_ptr<const CardSet> cards; ///< Instead of the hair, which still tells how the head is held; null: none.
    std::vector<Solid> solids = {};
    Camera camera;
    Light light;
    SkinShading skin;
    std::shared_ptr<const sim::MeshTexture> skinTexture = {}; ///< On the head, instead of skin's colours; null: none.
    glm::vec3 background{0.03F};                              ///< Linear.
    bool transparent = false; ///< No background: pixels tell how much of them is covered; see Capabilities.
    std::optional<Ring> ring;
    std::optional<Ring> mirroredRing;
    friend bool operator==(const Scene&, const Scene&) = default; ///< Compares meshes and frame by pointer.
};

} // namespace hairpaint::rendering
