// The dab kernel: row by row, a fill where the dab is full and one polynomial where it fades.
#include "model/tools/strokes/stroke_buffer.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hairpaint::model {

namespace {

int clampedInt(float value, int low, int high)
{
    return static_cast<int>(std::clamp(value, static_cast<float>(low), static_cast<float>(high)));
}

constexpr int kLanes = 8;      ///< Texels that are worked on at a time; a tile's row is a multiple of it.
constexpr int kNarrowest = 48; ///< A row's full part is filled apart where it is this wide; else finding it costs more.

/// One row of a dab: q = (a x + cross) x + rowTerm, the mask smooth from 0 where q = 1 to `full` where (1 - q) slope
/// = 1.
struct RowTerms
{
    float a, cross, rowTerm, slope, full;

    [[nodiscard]] std::uint16_t mask(float x) const
    {
        const float q = (a * x + cross) * x + rowTerm;
        const float t = std::min(std::max((1.0F - q) * slope, 0.0F), 1.0F);
        // lround would not become vector code; t is never negative.
        // NOLINTNEXTLINE(bugprone-incorrect-roundings)
        return static_cast<std::uint16_t>(static_cast<int>(t * t * (3.0F - 2.0F * t) * full + 0.5F));
    }
};

/// The masks of `count` texels, the first `dx` from the centre, maximised into `row`.
void fadeRow(std::uint16_t* row, int count, float dx, RowTerms terms)
{
    for (int i = 0; i < count; ++i)
        row[i] = std::max(row[i], terms.mask(dx + static_cast<float>(i)));
}

void fillRow(std::uint16_t* row, int count, std::uint16_t full)
{
    if (full == 65535) {
        std::fill_n(row, count, full);
        return;
    }
    for (int i = 0; i < count; ++i)
        row[i] = std::max(row[i], full);
}

} // namespace

/// A dab made ready: the mask falls from `full` where q <= 1 - 1/slope smoothly to 0 where q = 1.
struct StrokeBuffer::Kernel
{
    Dab dab;
    float slope;
    float full;
    float halfWidth, halfHeight; ///< Half the size of the bounding box, texels.

    explicit Kernel(const Dab& source) : dab(source)
    {
        const float determinant = std::max(dab.a * dab.c - dab.b * dab.b, 1e-12F);
        halfWidth = std::sqrt(dab.c / determinant);
        halfHeight = std::sqrt(dab.a / determinant);
        // q rises by 2/r a texel at the rim: even the hardest dab fades over about a texel.
        const float shortest = 1.0F / std::sqrt(std::max(dab.a, dab.c));
        const float fade = std::max(1.0F - dab.hardness * dab.hardness, std::min(1.0F, 2.0F / shortest));
        slope = 1.0F / std::max(fade, 1e-4F);
        full = std::round(std::clamp(dab.strength, 0.0F, 1.0F) * 65535.0F);
    }
};

StrokeBuffer::StrokeBuffer(int size, int valueChannels)
    : m_size(size), m_tilesAcross(size / kTile), m_valueChannels(static_cast<std::size_t>(valueChannels))
{
    const auto count = static_cast<std::size_t>(m_tilesAcross) * static_cast<std::size_t>(m_tilesAcross);
    m_tiles.resize(count);
    m_values.resize(count);
    m_isDirty.resize(count);
}

StrokeBuffer::MaskTile& StrokeBuffer::writableMask(int tileIndex)
{
    const auto index = static_cast<std::size_t>(tileIndex);
    if (m_tiles[index] == nullptr)
        m_tiles[index] = std::make_unique<MaskTile>();
    if (!m_isDirty[index]) {
        m_isDirty[index] = true;
        m_dirty.push_back(tileIndex);
    }
    return *m_tiles[index];
}

std::vector<int> StrokeBuffer::takeDirty()
{
    for (const int index : m_dirty)
        m_isDirty[static_cast<std::size_t>(index)] = false;
    std::ranges::sort(m_dirty);
    return std::exchange(m_dirty, {});
}

/// Roots of q(x) = limit in every row. Rounding is on the safe side; the texels themselves decide by the polynomial.
void StrokeBuffer::findSpans(const Kernel& kernel, const sim::TexelRect& rect)
{
    const Dab& dab = kernel.dab;
    const float fullLimit = 1.0F - 1.0F / kernel.slope;
    m_spans.clear();
    for (int y = rect.y0; y < rect.y1; ++y) {
        const float dy = static_cast<float>(y) + 0.5F - dab.yTx;
        const float middle = dab.xTx - 0.5F - dab.b * dy / dab.a;
        // a (x - middle)2 = limit - dy2 (c - b2/a)
        const float rest = dy * dy * (dab.c - dab.b * dab.b / dab.a);
        const float half = std::sqrt(std::max(1.0F - rest, 0.0F) / dab.a);
        Span span{clampedInt(std::floor(middle - half), rect.x0, rect.x1),
                  clampedInt(std::ceil(middle + half) + 1.0F, rect.x0, rect.x1), 0, 0};
        span.full0 = span.full1 = span.x1;
        if (rest < fullLimit && span.x1 - span.x0 >= kNarrowest) {
            const float fullHalf = std::sqrt((fullLimit - rest) / dab.a);
            const int full0 = clampedInt(std::ceil(middle - fullHalf) + 1.0F, span.x0, span.x1);
            const int full1 = clampedInt(std::floor(middle + fullHalf), span.x0, span.x1);
            if (full0 < full1) {
                span.full0 = full0;
                span.full1 = full1;
            }
        }
        m_spans.push_back(span);
    }
}

void StrokeBuffer::add(const Dab& dab, const sim::TexelRect& clip)
{
    add(dab, clip, nullptr);
}

void StrokeBuffer::add(const Dab& dab, const sim::TexelRect& clip, const sim::Texel& value)
{
    add(dab, clip, &value);
}

void StrokeBuffer::layValue(int tileIndex, std::size_t firstTexel, std::span<const std::uint16_t> masks,
                            std::uint16_t* row, const sim::Texel& value)
{
    std::vector<std::uint16_t>& values = m_values[static_cast<std::size_t>(tileIndex)];
    if (values.empty())
        values.resize(sim::kTileTexels * m_valueChannels);
    for (std::size_t i = 0; i < masks.size(); ++i) {
        if (masks[i] == 0 || masks[i] < row[i])
            continue;
        row[i] = masks[i];
        std::copy_n(value.begin(), m_valueChannels,
                    values.begin() + static_cast<std::ptrdiff_t>((firstTexel + i) * m_valueChannels));
    }
}

void StrokeBuffer::add(const Dab& dab, const sim::TexelRect& clip, const sim::Texel* value)
{
    const Kernel kernel(dab);
    const sim::TexelRect rect{std::max({clip.x0, 0, clampedInt(std::floor(dab.xTx - kernel.halfWidth), 0, m_size)}),
                              std::max({clip.y0, 0, clampedInt(std::floor(dab.yTx - kernel.halfHeight), 0, m_size)}),
                              std::min({clip.x1, clampedInt(std::ceil(dab.xTx + kernel.halfWidth), 0, m_size)}),
                              std::min({clip.y1, clampedInt(std::ceil(dab.yTx + kernel.halfHeight), 0, m_size)})};
    if (rect.empty() || kernel.full <= 0.0F)
        return;
    findSpans(kernel, rect);
    for (int tileY = rect.y0 / kTile; tileY <= (rect.y1 - 1) / kTile; ++tileY) {
        for (int tileX = rect.x0 / kTile; tileX <= (rect.x1 - 1) / kTile; ++tileX) {
            const int left = tileX * kTile;
            const int top = std::max(rect.y0, tileY * kTile);
            const int bottom = std::min(rect.y1, (tileY + 1) * kTile);
            const std::span<const Span> spans(m_spans.data() + (top - rect.y0), static_cast<std::size_t>(bottom - top));
            const bool meets = std::ranges::any_of(spans, [left](const Span& span) {
                return span.x0 < left + kTile && span.x1 > left && span.x0 < span.x1;
            });
            if (!meets)
                continue;
            const int index = tileY * m_tilesAcross + tileX;
            MaskTile& tile = writableMask(index);
            for (int y = top; y < bottom; ++y) {
                const Span& span = spans[static_cast<std::size_t>(y - top)];
                const std::size_t first = static_cast<std::size_t>(y % kTile) * kTile;
                if (value == nullptr) {
                    addRow(kernel, span, clip, y, left, tile.data() + first);
                    continue;
                }
                std::array<std::uint16_t, kTile> own{};
                addRow(kernel, span, clip, y, left, own.data());
                layValue(index, first, own, tile.data() + first, *value);
            }
        }
    }
}

/// One row of one tile; `left` is the texel that `row` starts with.
void StrokeBuffer::addRow(const Kernel& kernel, const Span& span, const sim::TexelRect& clip, int y, int left,
                          std::uint16_t* row)
{
    const Dab& dab = kernel.dab;
    const float dy = static_cast<float>(y) + 0.5F - dab.yTx;
    const RowTerms terms{dab.a, 2.0F * dab.b * dy, dab.c * dy * dy, kernel.slope, kernel.full};
    const auto fade = [&](int from, int to) {
        from = std::max(from, left);
        to = std::min(to, left + kTile);
        if (from >= to)
            return;
        // Whole blocks, for the vector loop: the polynomial is 0 past the rim. Not across the clip's sides.
        const int blockFrom = from / kLanes * kLanes;
        const int blockTo = (to + kLanes - 1) / kLanes * kLanes;
        if (blockFrom >= clip.x0 && blockTo <= clip.x1) {
            from = blockFrom;
            to = blockTo;
        }
        fadeRow(row + (from - left), to - from, static_cast<float>(from) + 0.5F - dab.xTx, terms);
    };
    fade(span.x0, span.full0);
    const int full0 = std::max(span.full0, left);
    const int full1 = std::min(span.full1, left + kTile);
    if (full0 < full1)
        fillRow(row + (full0 - left), full1 - full0, static_cast<std::uint16_t>(kernel.full));
    fade(span.full1, span.x1);
}

} // namespace hairpaint::model
