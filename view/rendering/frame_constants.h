// The constants of a frame for every shader, laid out as in common.glsl, and how they follow from the scene.
#pragma once

#include "view/rendering/scene.h"

#include <array>

namespace hairpaint::rendering {

/// std140. See common.glsl for the meaning of each.
struct FrameConstants
{
    glm::mat4 projectionFromWo;
    glm::mat4 woFromProjection;
    glm::mat4 woFromHd;
    std::array<glm::mat4, 2> gridFromWo;
    glm::vec4 eyeWo;
    glm::vec4 keyWo;
    glm::vec4 keyColour;
    glm::vec4 fillWo;
    glm::vec4 fillColour;
    glm::vec4 rimWo;
    glm::vec4 rimColour;
    std::array<glm::vec4, 9> around;
    glm::vec4 headWo;
    glm::vec4 depthRange;
    glm::vec4 target;
    glm::vec4 gridSize;
    std::array<glm::vec4, 2> background;
    std::array<glm::vec4, 2> ringWo;
    glm::vec4 neckTurn;
    glm::vec4 neckPivotHd;
    glm::vec4 neckReach;
    std::array<glm::vec4, 3> skin;
    std::array<glm::vec4, 2> eyeGrid;
    friend bool operator==(const FrameConstants&, const FrameConstants&) = default;
};

/// A picture's grid of samples.
struct Target
{
    int width = 0; ///< Pixels.
    int height = 0;
    glm::ivec2 samples{1}; ///< Per pixel, across and up.
};

/// For shaders that exist for 1, 2 and 4 samples a pixel.
inline constexpr std::array kSampleDefines{"#define SAMPLES_X 1\n#define SAMPLES_Y 1\n",
                                           "#define SAMPLES_X 2\n#define SAMPLES_Y 1\n",
                                           "#define SAMPLES_X 2\n#define SAMPLES_Y 2\n"};

inline constexpr int kGridSide = 48; ///< Voxels of the opacity grid in each direction.

/// The part of them that the head's picture depends on; nothing in the rest, which follows the hair and what lies over
/// the picture.
[[nodiscard]] FrameConstants withoutHair(FrameConstants constants);

/// `skullRadiusM`: SkullSize of the scene's head.
[[nodiscard]] FrameConstants frameConstants(const Scene& scene, const Target& target, float skullRadiusM);

} // namespace hairpaint::rendering
