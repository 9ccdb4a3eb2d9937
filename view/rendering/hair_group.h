// One hair group's data on the GPU: styles, skeletons and the list of drawn strands.
#pragma once

#include "sim/motion/strand_frame.h"
#include "view/rendering/gl_objects.h"
#include "view/rendering/hair_list.h"

#include <memory>
#include <vector>

namespace hairpaint::rendering {

/// The frame is the canonical side; only what differs from the upload before is sent.
class HairGroup
{
public:
    /// Brings the GPU's copy up to date; returns the bytes sent. `group` lives inside `frame`.
    std::size_t upload(const std::shared_ptr<const sim::StrandFrame>& frame, const sim::GroupFrame& group, float detail,
                       int smoothSegments);
    /// Binds strands, styles and skeletons to storage 0, 1 and 2.
    void bind() const;
    [[nodiscard]] const HairList& list() const { return m_list; }
    [[nodiscard]] const sim::Groom& groom() const { return *m_groom; }

private:
    std::size_t uploadStyles();
    [[nodiscard]] std::size_t uploadPositions(const sim::GroupFrame& group);

    std::shared_ptr<const sim::Groom> m_groom;
    std::shared_ptr<const sim::StrandFrame> m_frame;                 ///< Of the positions uploaded.
    std::vector<std::shared_ptr<const sim::StrandChunk>> m_uploaded; ///< By place.
    std::shared_ptr<const sim::RootSet> m_roots;
    HairList m_list;
    Buffer m_strands;
    Buffer m_styles;
    Buffer m_positions;
};

} // namespace hairpaint::rendering
