// Draws the strands of all groups into the sample buffer with compute shaders.
#pragma once

#include "view/rendering/frame_constants.h"
#include "view/rendering/gl_objects.h"
#include "view/rendering/hair_buffers.h"

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <string>

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
    /// With the frame's constants bound to uniform buffer 0: fills the opacity grid, then draws into `samples`, which
    /// already hold the head's depth. With `progress` (0..1; false stops) it waits for each of many small pieces;
    /// false where it was stopped.
    bool draw(const FrameConstants& constants, float detail, const Buffer& samples,
              const std::function<bool(double)>& progress = {});

    /// Binds the opacity grids of the last draw to two texture units.
    void bindOpacity(unsigned lightUnit, unsigned eyeUnit) const;

    /// The points of the last batch drawn, Wo, xyz and the strand's number. For tests.
    [[nodiscard]] const Buffer& points() const { return m_points; }
    [[nodiscard]] const HairBuffers& group(int id) const { return m_groups.at(id); }

private:
    HairPass() = default;
    void fillGrid(const FrameConstants& constants, float detail);
    /// `piecePoints`: batches are cut into pieces of no more; `pieceDone` (of so many points) says whether to go on.
    bool drawGroup(const HairBuffers& group, const FrameConstants& constants, float detail, const Buffer& samples,
                   std::uint32_t piecePoints, const std::function<bool(std::uint32_t)>& pieceDone);
    void drawPiece(const StrandBatch& piece, const HairBuffers& group, float detail, const Buffer& samples,
                   unsigned rows);

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
};

} // namespace hairpaint::rendering
