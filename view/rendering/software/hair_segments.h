// All hair of a picture as segments in its tiles.
#pragma once

#include "view/rendering/drawn_fraction.h"
#include "view/rendering/frame_constants.h"
#include "view/rendering/software/head_occlusion.h"
#include "view/rendering/software/opacity_grids.h"
#include "view/rendering/software/screen_segments.h"
#include "view/rendering/software/strand_list.h"
#include "view/rendering/software/tile_kernel.h"

#include <atomic>
#include <cstddef>
#include <map>
#include <memory>
#include <vector>

namespace hairpaint::rendering {

class HairSegments
{
public:
    /// `mostBytes`: about as many are held of what a picture needs while it is drawn, its samples included; a fraction
    /// of that in any case.
    explicit HairSegments(std::size_t mostBytes) : m_mostBytes(mostBytes) {}
    /// Chooses the strands, fills the opacity grids and cuts the strands into batches. Unless `fine`, hair that is half
    /// hidden is drawn by fewer strands.
    /// What the head hides of it is not drawn.
    void begin(const std::shared_ptr<const sim::StrandFrame>& frame, const FrameConstants& constants, float detail,
               bool fine, const HeadOcclusion& head);
    /// Number of batches; each can be drawn on its own, on any thread.
    [[nodiscard]] std::size_t batchCount() const { return m_batchCount; }
    void drawBatch(std::size_t batch);
    /// Whether the batches would take too many bytes at once, so that some were left empty: fewer rows must be drawn at
    /// once.
    [[nodiscard]] bool isTooMuch() const { return m_usedBytes > m_mostBatchBytes && m_tiles.rows() > 1; }
    /// From now on these rows of tiles are drawn; the batches are to be drawn anew.
    void setRows(int firstUp, int endUp);
    /// Fills entries and segments of a tile of the rows that are drawn, after all batches.
    void collect(std::size_t tile, TileSamples& samples) const;
    [[nodiscard]] const OpacityGrids& grids() const { return m_grids; }
    [[nodiscard]] const TileGrid& tiles() const { return m_tiles; }
    [[nodiscard]] std::size_t hairs() const { return m_hairs; }
    /// Hairs whose StrandStyle::detail is below it are drawn, where the frame has their positions.
    [[nodiscard]] float detail() const { return m_detail; }
    /// Number of segments in the batches drawn.
    [[nodiscard]] std::size_t segmentCount() const;
    /// How hair that lies behind other hair is drawn.
    [[nodiscard]] const DepthOfCoat& depth() const { return m_depth; }
    [[nodiscard]] float nearestM() const { return m_nearestM; }
    [[nodiscard]] float depthsPerM() const { return m_depthsPerM; }

private:
    struct Group
    {
        const sim::GroupFrame* frame;
        const StrandList* list;
        StrandView view;
        float fraction; ///< Fraction of its hairs that are drawn.
        float widthSp;  ///< Width of one of its hairs, samples.
    };
    struct Piece
    {
        std::size_t group;
        std::size_t first; ///< First strand in the group's list.
        std::size_t end;
    };

    std::shared_ptr<const sim::StrandFrame> m_frame; ///< Kept while it is drawn.
    glm::mat3 m_turnWoFromHd{1.0F};
    std::map<int, StrandList> m_lists; ///< By the group's id.
    std::vector<Group> m_groups;
    std::vector<Piece> m_pieces;
    std::vector<SegmentBatch> m_batches;
    std::vector<std::size_t> m_batchSegments;
    std::size_t m_batchCount = 0;
    std::size_t m_hairs = 0;
    float m_detail = 0.0F;
    OpacityGrids m_grids;
    TileGrid m_tiles;
    std::size_t m_mostBytes;
    std::size_t m_mostBatchBytes = 0;
    std::atomic<std::size_t> m_usedBytes = 0; ///< Bytes of the batches drawn.
    DepthOfCoat m_depth{};
    float m_nearestM = 0.0F;
    float m_depthsPerM = 0.0F;
};

} // namespace hairpaint::rendering
