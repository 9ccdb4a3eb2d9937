// Asks OpenGL who draws.
#include "view/head_area/gpu_probe.h"

#include "view/rendering/gl/gl_renderer.h"
#include "view/rendering/gl/offscreen_context.h"

#include <thread>

namespace hairpaint::view {

bool hasGpu()
{
    bool found = false;
    // A thread of its own, whose current context is nobody else's.
    std::thread([&found] {
        const auto context = rendering::OffscreenContext::create();
        if (!context || !(*context)->makeCurrent())
            return;
        {
            const auto renderer = rendering::GlRenderer::create();
            found = renderer && (*renderer)->capabilities().graphicsCard;
        }
        (*context)->doneCurrent();
    }).join();
    return found;
}

} // namespace hairpaint::view
