// A context for tests of drawing, which notices every complaint of OpenGL.
#pragma once

#include "view/rendering/gl/gl_renderer.h"
#include "view/rendering/gl/offscreen_context.h"

#include <glm/glm.hpp>

#include <memory>
#include <string>
#include <vector>

namespace hairpaint::testing {

/// RGB as encoded, row 0 on top.
struct Picture
{
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> pixels;
    [[nodiscard]] glm::ivec3 at(int x, int y) const
    {
        const auto i =
            (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) * 4;
        return {pixels[i], pixels[i + 1], pixels[i + 2]};
    }
    /// Mean over columns x0..x1 and rows y0..y1 of the distance in all channels from another picture, 0..255.
    [[nodiscard]] double difference(const Picture& other, int x0, int y0, int x1, int y1) const;
    [[nodiscard]] double difference(const Picture& other) const { return difference(other, 0, 0, width, height); }
};

/// Current as long as it lives.
class GlTest
{
public:
    GlTest();
    ~GlTest();
    GlTest(const GlTest&) = delete;
    GlTest& operator=(const GlTest&) = delete;

    /// Why there is no context; empty where there is.
    [[nodiscard]] const std::string& failure() const { return m_failure; }
    /// Errors reported since the last call, each in a line.
    [[nodiscard]] std::string takeErrors();

private:
    std::unique_ptr<rendering::OffscreenContext> m_context;
    std::string m_failure;
    std::string m_errors;
};

/// A framebuffer of somebody else's, bound and with a viewport, a depth test and blending of its own.
class ForeignFramebuffer
{
public:
    ForeignFramebuffer(int width, int height);
    ~ForeignFramebuffer();
    ForeignFramebuffer(const ForeignFramebuffer&) = delete;
    ForeignFramebuffer& operator=(const ForeignFramebuffer&) = delete;
    [[nodiscard]] unsigned id() const { return m_framebuffer; }
    /// Whether all of that is as it was set.
    [[nodiscard]] bool isBound() const;
    [[nodiscard]] glm::ivec3 centre() const;

private:
    int m_width;
    int m_height;
    unsigned m_framebuffer = 0;
    unsigned m_texture = 0;
};

[[nodiscard]] Picture drawn(rendering::Backend& renderer, const rendering::Scene& scene,
                            const rendering::Quality& quality = {}, int width = 200, int height = 150);

} // namespace hairpaint::testing
