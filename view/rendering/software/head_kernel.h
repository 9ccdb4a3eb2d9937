// Triangles of the head become samples, and these get their light.
#pragma once

#include "sim/skin/mesh_texture.h"
#include "view/rendering/eye_grid.h"
#include "view/rendering/light/skin_light.h"
#include "view/rendering/software/tile_kernel.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>

namespace hairpaint::rendering {

/// A vertex as the picture has it. The kernel gathers its floats by number.
struct HeadVertex
{
    float x = 0.0F, y = 0.0F; ///< Position in the picture, samples.
    float perDistance = 0.0F; ///< 1/m; 0 where it lies behind the eye.
    glm::vec3 positionWo{0.0F};
    glm::vec3 normalWo{0.0F};
    glm::vec3 positionHd{0.0F};
    float sky = 1.0F, lips = 0.0F, lids = 0.0F, blush = 0.0F; ///< 0..1
    glm::vec4 tint{0.0F};                                     ///< See ScalpTint::Texel.
    glm::vec2 uv{0.0F};                                       ///< Read only where there is a texture.
};
static_assert(sizeof(HeadVertex) == 22 * sizeof(float));

inline constexpr float kNoHeadM = 1e9F; ///< Distance of a sample without head.

/// Rows firstRow..endRow of the head's picture, and one mesh that is drawn there.
struct HeadBand
{
    std::span<const HeadVertex> vertices;
    std::span<const glm::uvec3> triangles;
    std::span<const std::uint32_t> numbers; ///< Numbers of the triangles that may touch the band, ascending.
    int width = 0;
    int firstRow = 0;
    int endRow = 0;
    float samplesPerM = 0.0F; ///< Samples that a metre covers at a distance of 1 m.
    SkinLighting lighting;
    bool isTinted = false;                     ///< Whether any vertex has a tint.
    const sim::MeshTexture* texture = nullptr; ///< Null: none.
    glm::vec3 textureColour{1.0F};             ///< Linear, times the texture.
    bool isMasked = false;                     ///< Whether nothing is drawn where the texture's alpha is under a half.
    HeadSample* samples = nullptr;             ///< The picture's; rows are `width` long.
    float* distancesM = nullptr;
    std::uint8_t* worn = nullptr; ///< Becomes 1 where the mesh is seen; null: it is no solid.
};
/// Draws the band's triangles and lights them, over what was drawn there of other meshes. It adds up how much of a
/// sample meshes cover: where their outlines meet, nothing shines through.
void drawHeadBand(const HeadBand& band);

/// The hair's shadow on the skin and what it hides, in cells.
struct ShadeTask
{
    glm::mat4 woFromProjection{1.0F};
    glm::mat4 gridFromWo{1.0F}; ///< From the world to the light's grid.
    EyeGrid eyeGrid;
    std::array<const std::uint32_t*, 2> opacity{};
    int gridSide = 0;
    glm::vec3 eyeWo{0.0F};
    glm::vec3 lightWo{0.0F};
    glm::vec3 headWo{0.0F};
    glm::vec2 sizeSp{0.0F};
    glm::ivec2 cellSp{1}; ///< Samples across and up a cell.
    int across = 0;
    int width = 0; ///< Width of the head's picture, samples.
    int height = 0;
    const float* distancesM = nullptr;
    const std::uint8_t* rowHasHead = nullptr; ///< [rows of samples] 0: no head in it.
    glm::vec3 viewAxisWo{0.0F};               ///< Away from the eye, unit: distances are measured along it.
    float keptUnderHair = 1.0F;    ///< Fraction of its light that skin keeps under dense hair, see FrameConstants.
    float undrawnCoverings = 0.0F; ///< As StrandView::undrawnCoverings; so is inEveryColumn.
    bool inEveryColumn = true;
    float* shade = nullptr;
    float* hidden = nullptr; ///< 0..1: how surely what lies behind the hair is hidden by it.
};
/// Shades the rows of cells begin..end.
void shadeSkin(const ShadeTask& task, int begin, int end);

} // namespace hairpaint::rendering
