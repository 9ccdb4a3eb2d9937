// A rasteriser of textured triangles; light at their corners.
#include "view/rendering/software/card_picture.h"

#include "sim/base/parallel.h"
#include "view/rendering/light/encoded_colour.h"
#include "view/rendering/light/light_range.h"
#include "view/rendering/software/card_light.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hairpaint::rendering {
namespace {

constexpr float kNearestCardM = 0.01F;

/// Bilinear; 0..1.
glm::vec4 texelAt(const CardTexture& texture, const glm::vec2& uv)
{
    const auto most = static_cast<float>(texture.side - 1);
    const glm::vec2 at = glm::clamp(uv * static_cast<float>(texture.side) - 0.5F, 0.0F, most);
    const glm::ivec2 low(at);
    const glm::ivec2 high = glm::min(low + 1, texture.side - 1);
    const glm::vec2 part = at - glm::vec2(low);
    const auto texel = [&texture](int x, int y) {
        return glm::vec4(texture.texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(texture.side) +
                                        static_cast<std::size_t>(x)]);
    };
    const glm::vec4 below = glm::mix(texel(low.x, low.y), texel(high.x, low.y), part.x);
    const glm::vec4 above = glm::mix(texel(low.x, high.y), texel(high.x, high.y), part.x);
    return glm::mix(below, above, part.y) * (1.0F / 255.0F);
}

/// The level that has about a texel a sample; `texels` of the first lie on a sample.
std::size_t levelFor(const CardSet& cards, float texels)
{
    std::size_t level = 0;
    for (; texels > 2.0F && level + 1 < cards.levels.size(); texels *= 0.25F)
        ++level;
    return level;
}

} // namespace

void CardPicture::transform(const CardSet& cards, const FrameConstants& constants)
{
    m_cards = &cards;
    m_corners.resize(cards.corners.size());
    const CardLight light(constants);
    sim::parallelFor(m_corners.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const CardCorner& given = cards.corners[i];
            const glm::vec4 clip =
                constants.projectionFromWo * (constants.woFromHd * glm::vec4(given.positionHd, 1.0F));
            ProjectedVertex& corner = m_corners[i];
            corner.perDistance = clip.w > kNearestCardM ? 1.0F / clip.w : 0.0F;
            corner.x = (clip.x * corner.perDistance * 0.5F + 0.5F) * constants.target.x;
            corner.y = (clip.y * corner.perDistance * 0.5F + 0.5F) * constants.target.y;
            corner.uv = given.uv;
            corner.light = light.on(given);
        }
    });
}

bool CardPicture::drawBand(const CardBand& band) const
{
    bool any = false;
    const auto lowest = static_cast<float>(band.firstRow);
    const auto highest = static_cast<float>(band.endRow);
    for (const glm::uvec3& corners : m_cards->triangles) {
        const ProjectedVertex& a = m_corners[corners.x];
        const ProjectedVertex& b = m_corners[corners.y];
        const ProjectedVertex& c = m_corners[corners.z];
        if (!(std::max({a.y, b.y, c.y}) >= lowest && std::min({a.y, b.y, c.y}) <= highest) ||
            std::min({a.perDistance, b.perDistance, c.perDistance}) <= 0.0F)
            continue;
        const float area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
        if (area == 0.0F)
            continue;
        any = true;
        if (area > 0.0F)
            drawTriangle(band, a, b, c, area);
        else
            drawTriangle(band, a, c, b, -area);
    }
    return any;
}

/// Counter-clockwise on the picture; `area`: twice the triangle's.
void CardPicture::drawTriangle(const CardBand& band, const ProjectedVertex& a, const ProjectedVertex& b,
                               const ProjectedVertex& c, float area) const
{
    const auto whole = [](float at, int least, int most) {
        return static_cast<int>(std::clamp(std::floor(at), static_cast<float>(least), static_cast<float>(most)));
    };
    const int left = whole(std::min({a.x, b.x, c.x}), 0, band.width);
    const int right = whole(std::max({a.x, b.x, c.x}) + 1.0F, 0, band.width);
    const int low = whole(std::min({a.y, b.y, c.y}), band.firstRow, band.endRow);
    const int high = whole(std::max({a.y, b.y, c.y}) + 1.0F, band.firstRow, band.endRow);
    const glm::vec2 u = b.uv - a.uv;
    const glm::vec2 v = c.uv - a.uv;
    const auto side = static_cast<float>(m_cards->levels.front().side);
    const CardTexture& texture =
        m_cards->levels[levelFor(*m_cards, std::abs(u.x * v.y - u.y * v.x) * side * side / area)];
    for (int y = low; y < high; ++y)
        for (int x = left; x < right; ++x) {
            const glm::vec2 at(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
            float ofA = (b.x - at.x) * (c.y - at.y) - (c.x - at.x) * (b.y - at.y);
            float ofB = (c.x - at.x) * (a.y - at.y) - (a.x - at.x) * (c.y - at.y);
            float ofC = (a.x - at.x) * (b.y - at.y) - (b.x - at.x) * (a.y - at.y);
            if (ofA < 0.0F || ofB < 0.0F || ofC < 0.0F)
                continue;
            ofA *= a.perDistance;
            ofB *= b.perDistance;
            ofC *= c.perDistance;
            const float sum = ofA + ofB + ofC; // Times the area it is 1/distance, which is linear on the picture.
            const float distance = area / sum;
            const std::size_t i =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(band.width) + static_cast<std::size_t>(x);
            if (!(distance < band.distancesM[i]))
                continue;
            const glm::vec4 texel = texelAt(texture, (ofA * a.uv + ofB * b.uv + ofC * c.uv) / sum);
            if (texel.a < m_cards->cutoff)
                continue;
            band.distancesM[i] = distance;
            const glm::vec3 light = (ofA * a.light + ofB * b.light + ofC * c.light) / sum;
            const auto held = [&](int channel) {
                const float linear = std::min(linearOfEncoded(texel[channel]) * light[channel] / kMostLight, 1.0F);
                return static_cast<std::uint16_t>(std::lround(std::sqrt(linear) * 65535.0F));
            };
            band.samples[i] = {.red = held(0), .green = held(1), .blue = held(2), .cover = 65535};
        }
}

} // namespace hairpaint::rendering
