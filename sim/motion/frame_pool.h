// Frames that go round between worker and reader, so that their memory is allocated once.
#pragma once

#include "sim/base/mailbox.h"
#include "sim/motion/strand_frame.h"

#include <memory>
#include <vector>

namespace hairpaint::sim {

/// Any thread may let go of a frame; it then waits here with its memory for positions, and without the grooms that it
/// showed. Frames may outlive the pool.
class FramePool
{
public:
    FramePool() : m_idle(std::make_shared<IdleFrames>()) {}

    /// A frame to be written, with memory of an earlier one where there is any. Back in the pool when let go.
    [[nodiscard]] std::shared_ptr<StrandFrame> frame()
    {
        std::unique_ptr<StrandFrame> frame;
        m_idle->update([&frame](auto& idle) {
            if (!idle.empty()) {
                frame = std::move(idle.back());
                idle.pop_back();
            }
        });
        if (!frame)
            frame = std::make_unique<StrandFrame>();
        return {frame.release(), Return{m_idle}};
    }

private:
    static constexpr std::size_t kMostIdle = 3;
    using IdleFrames = Mailbox<std::vector<std::unique_ptr<StrandFrame>>>;

    struct Return
    {
        std::shared_ptr<IdleFrames> idle;
        void operator()(StrandFrame* done) const
        {
            std::unique_ptr<StrandFrame> frame(done);
            for (GroupFrame& group : frame->groups)
                group.groom.reset();
            idle->update([&frame](auto& frames) {
                if (frames.size() < kMostIdle)
                    frames.push_back(std::move(frame));
            });
        }
    };

    std::shared_ptr<IdleFrames> m_idle;
};

} // namespace hairpaint::sim
