// A set of texels of a map: one bit each, 8 MB at 8192.
#pragma once

#include "sim/base/tiled_raster.h"

#include <cstdint>
#include <span>
#include <vector>

namespace hairpaint::model {

/// Row 0 at v = 1, as in a raster.
class TexelMask
{
public:
    /// `size`: texels a side, a multiple of 64. `filled`: begins with all of them.
    explicit TexelMask(int size, bool filled = false);

    [[nodiscard]] int size() const { return m_size; }
    [[nodiscard]] bool at(int x, int y) const { return ((word(x, y) >> bitOf(x)) & 1U) != 0; }
    void set(int x, int y) { wordAt(x, y) |= std::uint64_t{1} << bitOf(x); }
    void set(int y, int x0, int x1); ///< Sets the texels x0 .. x1 - 1 of a row.
    [[nodiscard]] bool any(const sim::TexelRect& rect) const;

    void keepInside(std::span<const sim::TexelRect> rects);
    void add(const TexelMask& other);
    void remove(const TexelMask& other);
    /// The mask with all texels added that are at most `rings` steps away, diagonal steps included.
    [[nodiscard]] TexelMask grown(int rings) const;

private:
    [[nodiscard]] static unsigned bitOf(int x) { return static_cast<unsigned>(x) % 64U; }
    [[nodiscard]] std::size_t indexOf(int x, int y) const
    {
        return static_cast<std::size_t>(y) * m_wordsAcross + static_cast<std::size_t>(x) / 64U;
    }
    [[nodiscard]] std::uint64_t word(int x, int y) const { return m_words[indexOf(x, y)]; }
    [[nodiscard]] std::uint64_t& wordAt(int x, int y) { return m_words[indexOf(x, y)]; }
    [[nodiscard]] std::span<const std::uint64_t> row(int y) const
    {
        return std::span(m_words).subspan(static_cast<std::size_t>(y) * m_wordsAcross, m_wordsAcross);
    }

    int m_size;
    std::size_t m_wordsAcross;
    std::vector<std::uint64_t> m_words;
};

} // namespace hairpaint::model
