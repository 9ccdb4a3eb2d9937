// Timer queries in a ring.
#include "view/rendering/gl/frame_timer.h"

#include <epoxy/gl.h>

#include <algorithm>

namespace hairpaint::rendering {

void FrameTimer::begin()
{
    if (m_asking)
        end(); // The frame before never came to its end: memory ran out.
    m_begin = std::chrono::steady_clock::now();
    for (std::size_t i = 0; i < kQueries; ++i) {
        Query& query = m_queries.at((m_next + i) % kQueries); // The oldest first, so that the newest answer stays.
        GLuint there = GL_FALSE;
        if (query.waits)
            glGetQueryObjectuiv(query.name.id(), GL_QUERY_RESULT_AVAILABLE, &there);
        if (there == GL_FALSE)
            continue;
        GLuint64 nanoseconds = 0;
        glGetQueryObjectui64v(query.name.id(), GL_QUERY_RESULT, &nanoseconds);
        m_gpuMs = static_cast<double>(nanoseconds) * 1e-6;
        query.waits = false;
    }
    Query& next = m_queries.at(m_next);
    m_asking = !next.waits;
    if (!m_asking)
        return; // So far behind that the oldest frame is not done: its answer will do.
    if (next.name.id() == 0) {
        GLuint id = 0;
        glGenQueries(1, &id);
        next.name = GlName<deleteQuery>(id);
    }
    glBeginQuery(GL_TIME_ELAPSED, next.name.id());
}

void FrameTimer::end()
{
    if (m_asking) {
        glEndQuery(GL_TIME_ELAPSED);
        m_queries.at(m_next).waits = true;
        m_next = (m_next + 1) % kQueries;
    }
    m_asking = false;
    m_handingOverMs = sinceBegin();
}

double FrameTimer::milliseconds() const
{
    return std::max(m_gpuMs, m_handingOverMs);
}

double FrameTimer::sinceBegin() const
{
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - m_begin).count();
}

} // namespace hairpaint::rendering
