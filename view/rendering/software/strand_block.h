// Sixteen strands side by side, as the kernels of the software renderer take and give them.
#pragma once

#include "sim/groom/group_settings.h"
#include "sim/groom/strand_look.h"
#include "view/rendering/coat_axis.h"
#include "view/rendering/light/hair_light.h"
#include "view/rendering/software/occlusion_cells.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hairpaint::sim {
struct GroupFrame;
}

namespace hairpaint::rendering {

inline constexpr std::size_t kBlockLanes = 16;
inline constexpr int kMostNodes = 32;
inline constexpr int kMostOfSpan = 256;
using LaneRow = std::array<float, kBlockLanes>;

/// What is known of the strands. A lane without a strand has width 0.
struct alignas(64) StrandBlock
{
    int nodes = 2;
    bool anyBraid = false;
    bool anyCurl = false;
    const sim::CurlSettings* coils = nullptr; ///< See sim::coilsOf.
    bool anyFrizz = false;
    bool anyTaut = false;
    bool anyTipStart = false; ///< Tip colours begin at different fractions; else all have one sim::TipMix.
    bool anyFrame = false;    ///< Curled, braided or frizzy: the frame along the skeleton matters.
    LaneRow turns;
    LaneRow curlRadiusM; ///< 0 where there is no curl.
    LaneRow phase;
    LaneRow lengthM;
    LaneRow width; ///< Factor on the group's width.
    LaneRow variation;
    LaneRow order;                     ///< 0..1: where not all hairs are drawn, those of the lowest order are.
    std::array<LaneRow, 3> rootColour; ///< sRGB as encoded, 0..1.
    std::array<LaneRow, 3> tipColour;
    LaneRow tipScale; ///< sim::TipMix
    LaneRow tipOffset;
    std::array<float, 3 * kBlockLanes> tangentWo; ///< [3][kBlockLanes] tangent at the root.
    LaneRow braid;                                ///< sim::BraidKind
    LaneRow wisp;
    LaneRow taut; ///< 1: see sim::StrandStyle::isTaut(), else 0.
    LaneRow braidRadiusM;
    LaneRow braidStart;
    LaneRow braidTurns;
    LaneRow braidTaper; ///< 0..1
    LaneRow braidTied;  ///< 0..1
    LaneRow wispX;
    LaneRow wispY;
    LaneRow frizzM;
    LaneRow frizzRad;           ///< sim::FrizzOfStyle
    LaneRow shine;              ///< Factor on the group's shine; 1 where the gloss map is not painted.
    LaneRow sharpness;          ///< Sharpness of the highlights over the group's.
    LaneRow perTaper;           ///< The strand's length over its taper's, at least 1.
    std::vector<float> nodesWo; ///< [nodes][3][kBlockLanes]
};

/// Fills a block with strands of a group, one to sixteen positioned slots; lanes beyond them repeat the last one, with
/// no width. `turnWoFromHd`: the head's rotation.
void fillBlock(StrandBlock& block, const sim::GroupFrame& group, std::span<const std::uint32_t> slots,
               const glm::mat3& turnWoFromHd);

/// What is the same for all strands of a group in one picture.
struct StrandView
{
    glm::mat4 projectionFromWo{1.0F};
    glm::mat4 gridFromWo{1.0F}; ///< From the world to the light's grid.
    EyeGrid eyeGrid;
    std::array<CoatAxis, 2> coatAxes;              ///< Axes of the light's grid and of the eye's.
    std::array<const std::uint32_t*, 2> opacity{}; ///< [side][side][side], toward the light and toward the eye.
    int gridSide = 0;
    glm::vec2 sizeSp{0.0F};   ///< The picture, samples.
    float samplesPerM = 0.0F; ///< Samples that a metre covers at a distance of 1 m.
    float groupWidthM = 0.0F; ///< Diameter of a hair whose width is 1.
    float fraction = 1.0F;    ///< Fraction of the hairs that are drawn; they are widened to cover as much.
    float rootAlpha = 1.0F;
    float tipAlpha = 1.0F;
    bool tapers = false; ///< Strands taper over less than all of their length.
    float variationScale = 0.0F;
    float sectionAxes = 1.0F; ///< See StrandMaterial.
    float nearestM = 0.0F;    ///< Distance at which depths, of 16 bits, begin.
    float depthsPerM = 0.0F;
    float toleranceSp = 0.25F; ///< How far a drawn curve may lie beside the true one.
    /// Coverings of hair in front, seen by the eye, from which on nothing is drawn.
    float undrawnCoverings = 10.0F;
    bool inEveryColumn = true; ///< Whether those lie in every column, see DepthOfCoat.
    /// Fraction of the drawn hairs that is left where others hide them by half and more; 1 where all are drawn.
    float deepFraction = 1.0F;
    OcclusionCells head{};
    HairLighting lighting;
};

/// Number of segments in which each span between nodes is drawn. 0: the span is part of the segment that begins in the
/// span before; never for the first span or the last.
struct SpanSegments
{
    std::array<int, kMostNodes> of{};
    int total = 0;
    /// Where the strands taper, 0..1 in the last span, which then is one segment: the point at its begin moves there. 0
    /// where it stays.
    float tipAlong = 0.0F;

    /// Position of a span's point `j`, 0..1 in the span.
    [[nodiscard]] float along(int span, int nodes, int j) const
    {
        if (tipAlong > 0.0F && j == 0 && span + 2 == nodes)
            return tipAlong;
        return static_cast<float>(j) / static_cast<float>(of[static_cast<std::size_t>(span)]);
    }
};

/// Points of sixteen strands, projected, and lit where they end a segment that may be seen. Rows [point][kBlockLanes].
struct StrandPoints
{
    std::vector<float> pointsWo; ///< [point][3][kBlockLanes]
    std::vector<float> fraction; ///< [point] fraction of the strand, 0..1.
    std::vector<float> x;        ///< Samples, right.
    std::vector<float> y;        ///< Samples, up.
    std::vector<float> depth;    ///< 0..65535
    std::vector<float> width;    ///< Samples covered across the segment's main direction; 0 where it is not seen.
    std::vector<std::uint32_t>
        colour; ///< Square roots of the light / kMostLight, 10 bits each from the lowest: r, g, b.
    /// [segment], a bit a lane: not beside the picture, and not surely hidden by the head.
    std::vector<std::uint32_t> mayBeSeen;
    void resize(std::size_t points);
};

} // namespace hairpaint::rendering
