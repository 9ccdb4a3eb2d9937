// Planes of texels, and their PNG files.
#include "model/cards/card_images.h"

#include <QBuffer>
#include <QImage>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hairpaint::model {

namespace {

constexpr std::array<CardImageKind, 7> kImageKinds = {{
    {.name = "baseColor", .embedded = true},
    {.name = "normal", .embedded = true},
    {.name = "rootToTip", .embedded = false},
    {.name = "strandId", .embedded = false},
    {.name = "occlusion", .embedded = false},
    {.name = "depth", .embedded = false},
    {.name = "flow", .embedded = false},
}};

constexpr std::uint8_t kSeen = 128; ///< Alpha from which a texel has hair of its own.

/// For every texel about the nearest seed: two passes over the rows, each looking at the neighbours that
/// it has been to (Danielsson 1980).
class NearestSeeds
{
public:
    NearestSeeds(const std::vector<std::uint8_t>& alpha, int size) : m_size(size), m_nearest(alpha.size())
    {
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                m_nearest[at(x, y)] = alpha[at(x, y)] >= kSeen
                                          ? static_cast<std::uint32_t>(y) << kRowShift | static_cast<std::uint32_t>(x)
                                          : kNone;
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x)
                take(x, y, {{{-1, 0}, {-1, -1}, {0, -1}, {1, -1}}});
            for (int x = size - 1; x >= 0; --x)
                take(x, y, {{{1, 0}, {1, 0}, {1, 0}, {1, 0}}});
        }
        for (int y = size - 1; y >= 0; --y) {
            for (int x = size - 1; x >= 0; --x)
                take(x, y, {{{1, 0}, {-1, 1}, {0, 1}, {1, 1}}});
            for (int x = 0; x < size; ++x)
                take(x, y, {{{-1, 0}, {-1, 0}, {-1, 0}, {-1, 0}}});
        }
    }
    /// Its index; the texel's own where there is no seed.
    [[nodiscard]] std::size_t of(std::size_t texel) const
    {
        const std::uint32_t seed = m_nearest[texel];
        return seed == kNone ? texel : at(columnOf(seed), rowOf(seed));
    }

private:
    // A seed is kept as its row and column: an index would have to be divided for every neighbour that is looked at.
    static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
    static constexpr int kRowShift = 16;
    static int columnOf(std::uint32_t seed) { return static_cast<int>(seed & 0xFFFFU); }
    static int rowOf(std::uint32_t seed) { return static_cast<int>(seed >> kRowShift); }
    static int squared(std::uint32_t seed, int x, int y)
    {
        if (seed == kNone)
            return std::numeric_limits<int>::max();
        const int dx = columnOf(seed) - x;
        const int dy = rowOf(seed) - y;
        return dx * dx + dy * dy;
    }
    void take(int x, int y, const std::array<glm::ivec2, 4>& neighbours)
    {
        std::uint32_t& own = m_nearest[at(x, y)];
        int least = squared(own, x, y);
        if (least == 0)
            return;
        for (const glm::ivec2& step : neighbours) {
            const glm::ivec2 other(x + step.x, y + step.y);
            if (other.x < 0 || other.y < 0 || other.x >= m_size || other.y >= m_size)
                continue;
            const std::uint32_t seed = m_nearest[at(other.x, other.y)];
            const int away = squared(seed, x, y);
            if (away < least) {
                least = away;
                own = seed;
            }
        }
    }
    [[nodiscard]] std::size_t at(int x, int y) const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_size) + static_cast<std::size_t>(x);
    }

    int m_size;
    std::vector<std::uint32_t> m_nearest;
};

glm::u8vec3 shownIn(const CardTexel& texel, std::size_t kind)
{
    switch (kind) {
    case 0:
        return texel.colour;
    case 1:
        return texel.normal;
    case 2:
        return glm::u8vec3(texel.rootToTip);
    case 3:
        return glm::u8vec3(texel.strandId);
    case 4:
        return glm::u8vec3(texel.occlusion);
    case 5:
        return glm::u8vec3(texel.depth);
    default:
        return texel.flow;
    }
}

} // namespace

CardImages::CardImages(int sizePx)
    : m_size(sizePx), m_texels(static_cast<std::size_t>(sizePx) * static_cast<std::size_t>(sizePx)),
      m_alpha(m_texels.size())
{}

void CardImages::dilate()
{
    const NearestSeeds nearest(m_alpha, m_size);
    for (std::size_t i = 0; i < m_texels.size(); ++i)
        if (const std::size_t seed = nearest.of(i); seed != i)
            m_texels[i] = m_texels[seed];
}

std::span<const CardImageKind> cardImageKinds()
{
    return kImageKinds;
}

QByteArray cardImagePng(CardImages& images, const CardImageKind& kind)
{
    const auto number = static_cast<std::size_t>(&kind - kImageKinds.data());
    const bool hasAlpha = number == 0;
    const bool isGrey = number >= 2 && number <= 5;
    QImage image(images.size(), images.size(),
                 hasAlpha ? QImage::Format_RGBA8888
                 : isGrey ? QImage::Format_Grayscale8
                          : QImage::Format_RGB888);
    if (image.isNull())
        throw std::bad_alloc();
    for (int y = 0; y < images.size(); ++y) {
        uchar* out = image.scanLine(y);
        for (int x = 0; x < images.size(); ++x) {
            const std::size_t i = images.indexOf(x, y);
            const glm::u8vec3 shown = shownIn(images.texels()[i], number);
            *out++ = shown.r;
            if (isGrey)
                continue;
            *out++ = shown.g;
            *out++ = shown.b;
            if (hasAlpha)
                *out++ = images.alpha()[i];
        }
    }
    QByteArray png;
    QBuffer buffer(&png);
    buffer.open(QIODevice::WriteOnly);
    if (!image.save(&buffer, "PNG"))
        throw std::bad_alloc();
    return png;
}

} // namespace hairpaint::model
