// The off-screen context on Windows: WGL on a window that is never shown.
#include "view/rendering/gl/offscreen_context.h"

#ifdef _WIN32

#include <epoxy/wgl.h>

#include <array>

namespace hairpaint::rendering {
namespace {

class WglContext final : public OffscreenContext
{
public:
    WglContext() = default;
    WglContext(const WglContext&) = delete;
    WglContext& operator=(const WglContext&) = delete;
    ~WglContext() override
    {
        if (m_context != nullptr) {
            if (wglGetCurrentContext() == m_context)
                wglMakeCurrent(nullptr, nullptr);
            wglDeleteContext(m_context);
        }
        if (m_deviceContext != nullptr)
            ReleaseDC(m_window, m_deviceContext);
        if (m_window != nullptr)
            DestroyWindow(m_window);
    }

    /// A plain context first, since only a current one can make a core profile.
    [[nodiscard]] bool start()
    {
        m_window = CreateWindowExW(0, L"STATIC", L"", WS_POPUP, 0, 0, 16, 16, nullptr, nullptr,
                                   GetModuleHandleW(nullptr), nullptr);
        if (m_window == nullptr)
            return false;
        m_deviceContext = GetDC(m_window);
        PIXELFORMATDESCRIPTOR format{};
        format.nSize = sizeof(format);
        format.nVersion = 1;
        format.dwFlags = PFD_DRAW_TO_WINDOW | PFD_SUPPORT_OPENGL;
        format.iPixelType = PFD_TYPE_RGBA;
        format.cColorBits = 32;
        const int index = ChoosePixelFormat(m_deviceContext, &format);
        if (index == 0 || SetPixelFormat(m_deviceContext, index, &format) == FALSE)
            return false;
        m_context = wglCreateContext(m_deviceContext);
        if (m_context == nullptr || wglMakeCurrent(m_deviceContext, m_context) == FALSE)
            return false;
        if (!epoxy_has_wgl_extension(m_deviceContext, "WGL_ARB_create_context_profile"))
            return false;
        const std::array<int, 7> attributes{
            WGL_CONTEXT_MAJOR_VERSION_ARB,    4, WGL_CONTEXT_MINOR_VERSION_ARB, 3, WGL_CONTEXT_PROFILE_MASK_ARB,
            WGL_CONTEXT_CORE_PROFILE_BIT_ARB, 0};
        HGLRC core = wglCreateContextAttribsARB(m_deviceContext, nullptr, attributes.data());
        wglMakeCurrent(nullptr, nullptr);
        wglDeleteContext(m_context);
        m_context = core;
        return m_context != nullptr;
    }

    bool makeCurrent() override
    {
        const bool done = wglMakeCurrent(m_deviceContext, m_context) != FALSE;
        if (done)
            epoxy_handle_external_wglMakeCurrent();
        return done;
    }

    void doneCurrent() override { wglMakeCurrent(nullptr, nullptr); }

private:
    HWND m_window = nullptr;
    HDC m_deviceContext = nullptr;
    HGLRC m_context = nullptr;
};

} // namespace

tl::expected<std::unique_ptr<OffscreenContext>, std::string> OffscreenContext::create()
{
    auto context = std::make_unique<WglContext>();
    if (!context->start())
        return tl::unexpected(std::string("Windows offers no OpenGL 4.3 context."));
    return context;
}

void adoptCurrentContext()
{
    // epoxy only counts the first of a process; from the second on it makes the calling thread's table of functions.
    epoxy_handle_external_wglMakeCurrent();
    epoxy_handle_external_wglMakeCurrent();
}

} // namespace hairpaint::rendering

#endif
