// Draws the strands of all groups into the sample buffer with compute shaders.
#pragma once

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
    };
    /// Sends what differs from the frame before; null shows no hair.
    Report upload(const std::shared_ptr<const sim::StrandFrame>& frame, float detail, int smoothSegments);
    /// A piece that software draws in a fraction of a second, and a slow GPU in a few milliseconds.
    static constexpr std::uint32_t kSmallPiecePoints = 1U << 14U;
    /// After upload(), with the frame's constants bound to uniform buffer 0: fills the opacity grid and cuts what is to
    /// be drawn into pieces of at most `piecePoints`, but of one strand at least.
    void begin(const FrameConstants& constants, float detail, std::uint32_t piecePoints);
    /// With the same constants bound: draws the next piece into `samples`, which hold the head's depth and the pieces
    /// before. False where there was none left.
    bool drawPiece(const Buffer& samples);
    /// 0..1: how much of what begin() found is drawn.
    [[nodiscard]] double progress() const;

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
        unsigned rows; ///< Of samples that the thickest strand covers.
    };
    void fillGrid(const FrameConstants& constants);
    void addPieces(int groupId, unsigned rows, std::uint32_t piecePoints);

    Program m_splat;
    Program m_sum;
    Program m_expand;
    Program m_shade;
    Program m_raster;
    Buffer m_points;
    Buffer m_projected;
    Buffer m_voxels;
    std::array<Texture, 2> m_opacity;    ///< Toward the light, the eye.
    std::map<int, HairBuffers> m_groups; ///< By the group's id.
    std::vector<int> m_visible;          ///< Ids, in the frame's order.
    float m_detail = 1.0F;
    std::vector<Piece> m_pieces;
    std::size_t m_nextPiece = 0;
};

} // namespace hairpaint::rendering
