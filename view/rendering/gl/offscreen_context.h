// An OpenGL context without a window: pictures, films, tests, and drawing where OpenGL is software.
#pragma once

#include <tl/expected.hpp>

#include <memory>
#include <string>

namespace hairpaint::rendering {

/// EGL without a display on Linux (Mesa surfaceless, else a device); on Windows a hidden window's WGL context. Use from
/// one thread.
class OffscreenContext
{
public:
    [[nodiscard]] static tl::expected<std::unique_ptr<OffscreenContext>, std::string> create();
    virtual ~OffscreenContext() = default;
    OffscreenContext(const OffscreenContext&) = delete;
    OffscreenContext& operator=(const OffscreenContext&) = delete;

    /// False, with nothing current, where the driver refuses.
    [[nodiscard]] virtual bool makeCurrent() = 0;
    virtual void doneCurrent() = 0;

protected:
    OffscreenContext() = default;
};

/// To be called on the thread of a context that somebody else made current, before the first call of OpenGL there. On
/// Windows the functions of OpenGL are kept by thread; elsewhere nothing is done.
void adoptCurrentContext();

} // namespace hairpaint::rendering
