// Takes the strands of all groups through curve and light onto the picture's plane, with compute shaders.
#pragma once

#include "view/rendering/drawn_fraction.h"
#include "view/rendering/frame_constants.h"
#include "view/rendering/gl/gl_objects.h"
#include "view/rendering/gl/hair_buffers.h"

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace hairpaint::rendering {

class HairPass
{
public:
    [[nodiscard]] static tl::expected<std::unique_ptr<HairPass>, std::string> create();

    struct Report
    {
        std::size_t hairs = 0;
        std::size_t segments = 0;
        std::size_t uploadedBytes = 0;
        float detail = 1.0F; ///< As FrameStatistics::detail.
    };
    /// Sends what differs from the frame before; null shows no hair. `fine`: a picture to be kept.
    Report upload(const std::shared_ptr<const sim::StrandFrame>& frame, const FrameConstants& constants, float detail,
                  bool fine);
    /// A piece that software draws in a fraction of a second, and a slow GPU in a few milliseconds.
    static constexpr std::uint32_t kSmallPiecePoints = 1U << 14U;
    /// After upload(), with the frame's constants bound to uniform buffer 0: fills the opacity grid and cuts what is to
    /// be drawn into pieces of at most `piecePoints`, but of one strand at least.
    void begin(const FrameConstants& constants, std::uint32_t piecePoints);
    /// With the same constants bound: expands, lights and projects the next piece. False where there was none left.
    bool projectPiece();
    /// 0..1: how much of what begin() found is done.
    [[nodiscard]] double progress() const;
    /// All points of what begin() found, as projected_point.glsl has them.
    [[nodiscard]] const Buffer& projected() const { return m_projected; }
    [[nodiscard]] std::size_t projectedPoints() const { return m_pointCount; }

    /// Binds the opacity grids of the last begin() to two texture units.
    void bindOpacity(unsigned lightUnit, unsigned eyeUnit) const;

    /// The points of the last batch drawn, Wo, xyz and the strand's number. For tests.
    [[nodiscard]] const Buffer& points() const { return m_points; }
    [[nodiscard]] const HairBuffers& group(int id) const { return m_groups.at(id); }

private:
    HairPass() = default;
    struct Piece
    {
        int group; ///< Its id.
        StrandBatch strands;
        std::uint32_t firstProjected;
    };
    /// How a group is drawn in this picture.
    struct Fractions
    {
        float fraction; ///< Fraction of its hairs that are drawn; they are widened to cover as much.
        float deep;     ///< Fraction of those that is left where others hide them, see deepFraction().
    };
    Report uploadGroups(const std::shared_ptr<const sim::StrandFrame>& frame, const FrameConstants& constants,
                        float detail, bool fine);
    void fillGrid(const FrameConstants& constants);
    void addPieces(int groupId, std::uint32_t piecePoints);

    Program m_splat;
    Program m_sum;
    Program m_expand;
    Program m_shade;
    Buffer m_points;
    Buffer m_projected;
    Buffer m_voxels;
    std::array<Texture, 2> m_opacity;     ///< Grids along the light and along the eye's rays.
    std::map<int, HairBuffers> m_groups;  ///< By the group's id.
    std::vector<int> m_visible;           ///< Ids, in the frame's order.
    std::map<int, Fractions> m_fractions; ///< By the group's id.
    bool m_fine = false;
    DepthOfCoat m_depth{};
    std::size_t m_pointCount = 0;
    std::vector<Piece> m_pieces;
    std::size_t m_nextPiece = 0;
};

} // namespace hairpaint::rendering
