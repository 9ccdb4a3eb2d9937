// Draws rings on the pixels around them.
#include "view/rendering/software/ring_overlay.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::rendering {
namespace {

float srgbOfRoot(std::uint16_t rootOfLinear)
{
    // The root in fastSrgb is what is stored.
    const float s = static_cast<float>(rootOfLinear) * (1.0F / 65535.0F);
    const float bent = (((-0.309565892F * s + 0.842780549F) * s - 0.944855478F) * s + 1.447898657F) * s;
    return std::max(bent - 0.037004691F, 12.92F * std::min(s * s, 0.0031F));
}

/// Draws one ring over one picture.
class RingOverlay
{
public:
    RingOverlay(const FrameConstants& constants, const HeadPicture& head, const glm::vec4& ring)
        : m_constants(constants), m_head(head), m_ring(ring)
    {
        const glm::vec4 far = constants.woFromProjection * glm::vec4(0.0F, 0.0F, 1.0F, 1.0F);
        m_axisWo = glm::normalize(glm::vec3(far) / far.w - glm::vec3(constants.eyeWo));
    }

    void draw(std::uint8_t* pixels) const
    {
        const glm::vec4 clip = m_constants.projectionFromWo * glm::vec4(glm::vec3(m_ring), 1.0F);
        if (m_ring.w <= 0.0F || clip.w <= 0.01F)
            return;
        const glm::ivec2 samples(m_constants.target.z, m_constants.target.w);
        const glm::ivec2 size(m_head.width() / samples.x, m_head.height() / samples.y);
        const glm::vec2 centrePx = (glm::vec2(clip) / clip.w * 0.5F + 0.5F) * glm::vec2(size);
        // The skin bends toward the eye here and there; and the line has a width.
        const float reachPx = m_ring.w * m_constants.gridSize.z / clip.w / static_cast<float>(samples.y) * 1.3F + 8.0F;
        const auto bounded = [](float p, int most) {
            return static_cast<int>(std::clamp(p, 0.0F, static_cast<float>(most)));
        };
        const float metrePerPixel = clip.w * static_cast<float>(samples.y) / m_constants.gridSize.z;
        for (int y = bounded(centrePx.y - reachPx, size.y); y < bounded(centrePx.y + reachPx + 1.0F, size.y); ++y)
            for (int x = bounded(centrePx.x - reachPx, size.x); x < bounded(centrePx.x + reachPx + 1.0F, size.x); ++x)
                lay(glm::ivec2(x, y) * samples, samples, metrePerPixel,
                    pixels + (static_cast<std::size_t>(size.y - 1 - y) * static_cast<std::size_t>(size.x) +
                              static_cast<std::size_t>(x)) *
                                 4);
    }

private:
    [[nodiscard]] std::size_t indexOf(glm::ivec2 at) const
    {
        const int x = std::clamp(at.x, 0, m_head.width() - 1);
        const int y = std::clamp(at.y, 0, m_head.height() - 1);
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_head.width()) + static_cast<std::size_t>(x);
    }
    [[nodiscard]] float fromCentreM(glm::ivec2 at) const
    {
        const glm::vec2 ndc = (glm::vec2(at) + 0.5F) / glm::vec2(m_constants.target) * 2.0F - 1.0F;
        const glm::vec4 far = m_constants.woFromProjection * glm::vec4(ndc, 1.0F, 1.0F);
        const glm::vec3 eye(m_constants.eyeWo);
        const glm::vec3 ray = glm::vec3(far) / far.w - eye;
        const float distanceM = std::min(m_head.distancesM()[indexOf(at)], 100.0F);
        return glm::distance(eye + ray * (distanceM / glm::dot(ray, m_axisWo)), glm::vec3(m_ring));
    }
    void lay(glm::ivec2 at, glm::ivec2 samples, float metrePerPixel, std::uint8_t* pixel) const
    {
        const HeadSample& skin = m_head.samples()[indexOf(at)];
        if (skin.cover == 0)
            return;
        const float d = fromCentreM(at);
        const glm::vec2 slope =
            glm::vec2(fromCentreM(at + glm::ivec2(samples.x, 0)), fromCentreM(at + glm::ivec2(0, samples.y))) - d;
        const float pixels =
            (d - m_ring.w) / std::clamp(glm::length(slope), 0.15F * metrePerPixel, 3.0F * metrePerPixel);
        glm::vec3 colour(static_cast<float>(pixel[0]), static_cast<float>(pixel[1]), static_cast<float>(pixel[2]));
        const auto over = [&colour](glm::vec3 above, float alpha) { colour += (above * 255.0F - colour) * alpha; };
        if (pixels < 0.0F)
            over({srgbOfRoot(skin.red), srgbOfRoot(skin.green), srgbOfRoot(skin.blue)}, 0.55F);
        over(glm::vec3(0.06F), 0.75F * std::clamp(1.7F - std::abs(pixels - 1.4F), 0.0F, 1.0F));
        over(glm::vec3(0.97F), std::clamp(1.5F - std::abs(pixels), 0.0F, 1.0F));
        for (int c = 0; c < 3; ++c)
            pixel[c] = static_cast<std::uint8_t>(std::clamp(colour[c] + 0.5F, 0.0F, 255.0F));
    }

    const FrameConstants& m_constants;
    const HeadPicture& m_head;
    const glm::vec4& m_ring;
    glm::vec3 m_axisWo;
};

} // namespace

void drawRings(const FrameConstants& constants, const HeadPicture& head, std::uint8_t* pixels)
{
    for (const glm::vec4& ring : constants.ringWo)
        RingOverlay(constants, head, ring).draw(pixels);
}

} // namespace hairpaint::rendering
