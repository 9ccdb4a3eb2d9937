// One hair group's data on the GPU: styles, skeletons and the list of drawn strands.
#pragma once

#include "sim/motion/strand_frame.h"
#include "view/rendering/gl/gl_objects.h"
#include "view/rendering/gl/hair_list.h"

#include <memory>
#include <vector>

namespace hairpaint::rendering {

/// The frame is the canonical side; only what differs from the upload before is sent: styles by chunk, skeletons and
/// the list of strands by blocks. A list shifts where hairs appear or go, and is sent anew from there on.
class HairBuffers
{
public:
    /// Brings the GPU's copy up to date; returns the bytes sent. `group` lives inside `frame`. What could not be sent,
    /// for want of memory here (which throws) or there, is sent by the next call.
    std::size_t upload(const std::shared_ptr<const sim::StrandFrame>& frame, const sim::GroupFrame& group, float detail,
                       SegmentsWanted segments);
    /// Lets go of the frame and the groom, which a group that is not shown has no use for; the next upload sends all.
    void release();
    /// Whether the GPU has all of the last upload.
    [[nodiscard]] bool ready() const { return m_ready; }
    /// Binds strands, styles and skeletons to storage 0, 1 and 2.
    void bind() const;
    [[nodiscard]] const HairList& list() const { return m_list; }
    [[nodiscard]] const sim::Groom& groom() const { return *m_groom; }

private:
    std::size_t uploadStrands();
    std::size_t uploadStyles();
    std::size_t uploadPositions(const std::shared_ptr<const sim::StrandFrame>& frame, const sim::GroupFrame& group);

    std::shared_ptr<const sim::Groom> m_groom;
    std::shared_ptr<const sim::Groom> m_stylesOf;                    ///< Whose styles are uploaded, all of them.
    std::shared_ptr<const std::vector<float>> m_shown;               ///< The positions uploaded; keeps their frame.
    std::vector<DrawnStrand> m_sent;                                 ///< The list uploaded; empty where there is none.
    std::vector<std::shared_ptr<const sim::StrandChunk>> m_uploaded; ///< By the chunk's packed index.
    std::shared_ptr<const sim::RootSet> m_roots;
    HairList m_list;
    Buffer m_strands;
    Buffer m_styles;
    Buffer m_positions;
    bool m_ready = false;
};

} // namespace hairpaint::rendering
