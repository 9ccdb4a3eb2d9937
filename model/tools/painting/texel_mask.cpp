// Sets of texels, 64 at a time.
#include "model/tools/painting/texel_mask.h"

#include <algorithm>

namespace hairpaint::model {

namespace {

constexpr std::uint64_t kAll = ~std::uint64_t{0};

/// The bits of one word that lie in x0..x1, both within the row.
std::uint64_t bitsBetween(int firstX, int x0, int x1)
{
    const int low = std::clamp(x0 - firstX, 0, 64);
    const int high = std::clamp(x1 - firstX, 0, 64);
    if (low >= high)
        return 0;
    const std::uint64_t below = high == 64 ? kAll : (std::uint64_t{1} << static_cast<unsigned>(high)) - 1U;
    return below & (kAll << static_cast<unsigned>(low));
}

} // namespace

TexelMask::TexelMask(int size, bool filled)
    : m_size(size), m_wordsAcross(static_cast<std::size_t>(size) / 64U),
      m_words(m_wordsAcross * static_cast<std::size_t>(size), filled ? kAll : 0)
{}

void TexelMask::set(int y, int x0, int x1)
{
    for (int first = x0 / 64 * 64; first < x1; first += 64)
        wordAt(first, y) |= bitsBetween(first, x0, x1);
}

bool TexelMask::any(const sim::TexelRect& rect) const
{
    for (int y = rect.y0; y < rect.y1; ++y)
        for (int first = rect.x0 / 64 * 64; first < rect.x1; first += 64)
            if ((word(first, y) & bitsBetween(first, rect.x0, rect.x1)) != 0)
                return true;
    return false;
}

void TexelMask::keepInside(std::span<const sim::TexelRect> rects)
{
    for (int y = 0; y < m_size; ++y)
        for (int first = 0; first < m_size; first += 64) {
            std::uint64_t kept = 0;
            for (const sim::TexelRect& rect : rects)
                if (rect.y0 <= y && y < rect.y1)
                    kept |= bitsBetween(first, rect.x0, rect.x1);
            wordAt(first, y) &= kept;
        }
}

void TexelMask::add(const TexelMask& other)
{
    for (std::size_t i = 0; i < m_words.size(); ++i)
        m_words[i] |= other.m_words[i];
}

void TexelMask::remove(const TexelMask& other)
{
    for (std::size_t i = 0; i < m_words.size(); ++i)
        m_words[i] &= ~other.m_words[i];
}

TexelMask TexelMask::grown(int rings) const
{
    // Along the rows first, then across them.
    TexelMask wide = *this;
    for (int ring = 0; ring < rings; ++ring)
        for (int y = 0; y < m_size; ++y) {
            const std::span<std::uint64_t> words =
                std::span(wide.m_words).subspan(static_cast<std::size_t>(y) * m_wordsAcross, m_wordsAcross);
            std::uint64_t before = 0;
            for (std::size_t i = 0; i < words.size(); ++i) {
                const std::uint64_t here = words[i];
                const std::uint64_t after = i + 1 < words.size() ? words[i + 1] : 0;
                words[i] = here | (here << 1U) | (here >> 1U) | (before >> 63U) | (after << 63U);
                before = here;
            }
        }
    TexelMask result(m_size);
    for (int y = 0; y < m_size; ++y)
        for (int near = std::max(y - rings, 0); near <= std::min(y + rings, m_size - 1); ++near) {
            const std::span<const std::uint64_t> from = wide.row(near);
            const std::size_t first = result.indexOf(0, y);
            for (std::size_t i = 0; i < from.size(); ++i)
                result.m_words[first + i] |= from[i];
        }
    return result;
}

} // namespace hairpaint::model
