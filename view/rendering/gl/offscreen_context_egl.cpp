// The off-screen context on Linux: EGL without a display.
#include "view/rendering/gl/offscreen_context.h"

#ifdef __linux__

#include <epoxy/egl.h>

#include <array>
#include <string_view>

namespace hairpaint::rendering {
namespace {

class EglContext final : public OffscreenContext
{
public:
    EglContext(EGLDisplay display, EGLContext context) : m_display(display), m_context(context) {}
    EglContext(const EglContext&) = delete;
    EglContext& operator=(const EglContext&) = delete;
    ~EglContext() override
    {
        if (eglGetCurrentContext() == m_context)
            EglContext::doneCurrent();
        // The display is shared by every context of the process, so it is not terminated.
        eglDestroyContext(m_display, m_context);
    }

    bool makeCurrent() override
    {
        return eglBindAPI(EGL_OPENGL_API) == EGL_TRUE &&
               eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, m_context) == EGL_TRUE;
    }

    void doneCurrent() override { eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT); }

private:
    EGLDisplay m_display;
    EGLContext m_context;
};

EGLDisplay initialised(EGLDisplay display)
{
    EGLint major = 0;
    EGLint minor = 0;
    if (display != EGL_NO_DISPLAY && eglInitialize(display, &major, &minor) == EGL_TRUE)
        return display;
    return EGL_NO_DISPLAY;
}

bool drawsInSoftware(EGLDeviceEXT device)
{
    const char* extensions = eglQueryDeviceStringEXT(device, EGL_EXTENSIONS);
    return extensions != nullptr &&
           std::string_view(extensions).find("EGL_MESA_device_software") != std::string_view::npos;
}

/// The first GPU on which EGL starts.
EGLDisplay gpuDisplay()
{
    if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_device") ||
        !epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration"))
        return EGL_NO_DISPLAY;
    std::array<EGLDeviceEXT, 16> devices{};
    EGLint count = 0;
    if (eglQueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &count) != EGL_TRUE)
        return EGL_NO_DISPLAY;
    for (EGLint i = 0; i < count; ++i) {
        EGLDeviceEXT device = devices.at(static_cast<std::size_t>(i));
        if (drawsInSoftware(device))
            continue;
        EGLDisplay display = initialised(eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr));
        if (display != EGL_NO_DISPLAY)
            return display;
    }
    return EGL_NO_DISPLAY;
}

EGLDisplay surfacelessDisplay()
{
    if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless"))
        return EGL_NO_DISPLAY;
    return initialised(eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr));
}

EGLContext makeContext(EGLDisplay display)
{
    if (display == EGL_NO_DISPLAY || eglBindAPI(EGL_OPENGL_API) != EGL_TRUE)
        return EGL_NO_CONTEXT;
    const std::array<EGLint, 7> attributes{
        EGL_CONTEXT_MAJOR_VERSION,           4,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    if (epoxy_has_egl_extension(display, "EGL_KHR_no_config_context"))
        return eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.data());
    const std::array<EGLint, 3> wanted{EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (eglChooseConfig(display, wanted.data(), &config, 1, &count) != EGL_TRUE || count == 0)
        return EGL_NO_CONTEXT;
    return eglCreateContext(display, config, EGL_NO_CONTEXT, attributes.data());
}

} // namespace

tl::expected<std::unique_ptr<OffscreenContext>, std::string> OffscreenContext::create()
{
    if (!epoxy_has_egl())
        return tl::unexpected(std::string("EGL is not installed."));
    // Where drivers of several makers are installed, a display without surface may be one that draws in software.
    for (const auto candidate : {gpuDisplay, surfacelessDisplay}) {
        EGLDisplay display = candidate();
        EGLContext context = makeContext(display);
        if (context != EGL_NO_CONTEXT)
            return std::make_unique<EglContext>(display, context);
    }
    return tl::unexpected(std::string("EGL offers no OpenGL 4.3 context without a display."));
}

void adoptCurrentContext() {}

} // namespace hairpaint::rendering

#endif
