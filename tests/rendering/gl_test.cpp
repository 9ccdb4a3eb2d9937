// The context of drawing tests.
#include "tests/rendering/gl_test.h"

#include <epoxy/gl.h>

#include <utility>

namespace hairpaint::testing {

double Picture::difference(const Picture& other, int x0, int y0, int x1, int y1) const
{
    double sum = 0.0;
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) {
            const glm::ivec3 d = glm::abs(at(x, y) - other.at(x, y));
            sum += d.x + d.y + d.z;
        }
    return sum / ((x1 - x0) * (y1 - y0));
}

GlTest::GlTest()
{
    auto context = rendering::OffscreenContext::create();
    if (!context) {
        m_failure = context.error();
        return;
    }
    m_context = std::move(*context);
    if (!m_context->makeCurrent()) {
        m_failure = "The context cannot be made current.";
        return;
    }
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(
        [](GLenum, GLenum type, GLuint, GLenum severity, GLsizei length, const GLchar* text, const void* errors) {
            if (type == GL_DEBUG_TYPE_ERROR || severity == GL_DEBUG_SEVERITY_HIGH) {
                auto* lines = static_cast<std::string*>(const_cast<void*>(errors));
                lines->append(text, static_cast<std::size_t>(length)).append("\n");
            }
        },
        &m_errors);
}

GlTest::~GlTest()
{
    if (m_context)
        m_context->doneCurrent();
}

std::string GlTest::takeErrors()
{
    for (GLenum error = glGetError(); error != GL_NO_ERROR; error = glGetError())
        m_errors += "glGetError " + std::to_string(error) + "\n";
    return std::exchange(m_errors, {});
}

ForeignFramebuffer::ForeignFramebuffer(int width, int height) : m_width(width), m_height(height)
{
    glGenTextures(1, &m_texture);
    glBindTexture(GL_TEXTURE_2D, m_texture);
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, width, height);
    glGenFramebuffers(1, &m_framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, m_texture, 0);
    glViewport(1, 2, 3, 4);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
}

ForeignFramebuffer::~ForeignFramebuffer()
{
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glBindTexture(GL_TEXTURE_2D, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &m_framebuffer);
    glDeleteTextures(1, &m_texture);
}

bool ForeignFramebuffer::isBound() const
{
    GLint framebuffer = 0;
    GLint texture = 0;
    GLint viewport[4] = {};
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &texture);
    glGetIntegerv(GL_VIEWPORT, viewport);
    return framebuffer == static_cast<GLint>(m_framebuffer) && texture == static_cast<GLint>(m_texture) &&
           viewport[0] == 1 && viewport[3] == 4 && glIsEnabled(GL_DEPTH_TEST) != 0 && glIsEnabled(GL_BLEND) != 0;
}

glm::ivec3 ForeignFramebuffer::centre() const
{
    std::uint8_t pixel[4] = {};
    glReadPixels(m_width / 2, m_height - 1 - m_height / 2, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    return {pixel[0], pixel[1], pixel[2]};
}

Picture drawn(rendering::Backend& renderer, const rendering::Scene& scene, const rendering::Quality& quality, int width,
              int height)
{
    Picture picture{.width = width, .height = height, .pixels = {}};
    renderer.draw(scene, quality, width, height);
    renderer.read(picture.pixels);
    return picture;
}

} // namespace hairpaint::testing
