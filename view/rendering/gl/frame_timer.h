// Measures the time of frames without waiting for them.
#pragma once

#include "view/rendering/gl/gl_objects.h"

#include <array>
#include <chrono>

namespace hairpaint::rendering {

/// Asks the GPU for its own time of each frame and takes the answer when a later frame begins. One begin() and end() a
/// frame, in the same context.
class FrameTimer
{
public:
    void begin();
    void end();
    /// The newest frame that the GPU has told of, or handing over the last one where that took longer.
    [[nodiscard]] double milliseconds() const;
    /// Wall clock since the last begin().
    [[nodiscard]] double sinceBegin() const;

private:
    static constexpr std::size_t kQueries = 4; ///< Frames that may be unfinished.
    struct Query
    {
        GlName<deleteQuery> name;
        bool waits = false;
    };
    std::array<Query, kQueries> m_queries;
    std::size_t m_next = 0;
    bool m_asking = false; ///< Between begin() and end().
    double m_gpuMs = 0.0;
    double m_handingOverMs = 0.0;
    std::chrono::steady_clock::time_point m_begin;
};

} // namespace hairpaint::rendering
