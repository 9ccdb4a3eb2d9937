// Frames that go round between worker and reader, so that their memory is allocated once.
#pragma once

#include "sim/base/mailbox.h"
#include "sim/motion/strand_frame.h"

#include <cstddef>
#include <limits>
#include <memory>
#include <numeric>
#include <vector>

namespace hairpaint::sim {

/// Any thread may let go of a frame; it then waits here with its memory for positions, and without the grooms that it
/// showed. One that has room for more than twice as much hair as there is now does not wait. Frames may outlive the
/// pool.
class FramePool
{
public:
    FramePool() : m_idle(std::make_shared<Mailbox<Idle>>()) {}

    /// A frame to be written, with memory of an earlier one where there is any. Back in the pool when let go.
    [[nodiscard]] std::shared_ptr<StrandFrame> frame()
    {
        std::unique_ptr<StrandFrame> frame;
        m_idle->update([&frame](Idle& idle) {
            if (!idle.frames.empty()) {
                frame = std::move(idle.frames.back());
                idle.frames.pop_back();
            }
        });
        if (!frame)
            frame = std::make_unique<StrandFrame>();
        return {frame.release(), Return{m_idle}};
    }

    /// `frame` was written: later ones will be about as large. Memory of an earlier one that it hardly uses is freed.
    void written(StrandFrame& frame)
    {
        for (GroupFrame& group : frame.groups)
            if (group.positions.capacity() / 2 > group.positions.size())
                group.positions.shrink_to_fit();
        m_idle->update([&frame](Idle& idle) {
            idle.usualFloats = floatsOf(frame, &std::vector<float>::size);
            std::erase_if(idle.frames, [&idle](const auto& waiting) { return !idle.fits(*waiting); });
        });
    }

private:
    static std::size_t floatsOf(const StrandFrame& frame, std::size_t (std::vector<float>::*count)() const)
    {
        return std::accumulate(
            frame.groups.begin(), frame.groups.end(), std::size_t{0},
            [count](std::size_t sum, const GroupFrame& group) { return sum + (group.positions.*count)(); });
    }

    struct Idle
    {
        static constexpr std::size_t kMost = 3;
        std::vector<std::unique_ptr<StrandFrame>> frames;
        /// Floats of positions in the frame written last.
        std::size_t usualFloats = std::numeric_limits<std::size_t>::max();

        [[nodiscard]] bool fits(const StrandFrame& frame) const
        {
            return floatsOf(frame, &std::vector<float>::capacity) / 2 <= usualFloats;
        }
    };

    struct Return
    {
        std::shared_ptr<Mailbox<Idle>> idle;
        void operator()(StrandFrame* done) const
        {
            std::unique_ptr<StrandFrame> frame(done);
            for (GroupFrame& group : frame->groups)
                group.groom.reset();
            idle->update([&frame](Idle& waiting) {
                if (waiting.frames.size() < Idle::kMost && waiting.fits(*frame))
                    waiting.frames.push_back(std::move(frame));
            });
        }
    };

    std::shared_ptr<Mailbox<Idle>> m_idle;
};

} // namespace hairpaint::sim
