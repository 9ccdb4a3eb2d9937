// Separable resampling, a row of the source at a time.
#include "model/maps/image_resample.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <vector>

namespace hairpaint::model {

namespace {

/// The source samples of one target sample along one axis: weights of first, first + 1, ..., summing to 1.
struct Taps
{
    int first = 0;
    std::vector<float> weights;
};

std::vector<Taps> makeTaps(int source, int target)
{
    std::vector<Taps> all(static_cast<std::size_t>(target));
    const double step = static_cast<double>(source) / target;
    const double radius = std::max(step, 1.0);
    for (int i = 0; i < target; ++i) {
        const double centre = (i + 0.5) * step - 0.5;
        const int first = static_cast<int>(std::ceil(centre - radius));
        const int last = static_cast<int>(std::floor(centre + radius));
        Taps& taps = all[static_cast<std::size_t>(i)];
        taps.first = std::clamp(first, 0, source - 1);
        taps.weights.assign(static_cast<std::size_t>(std::clamp(last, 0, source - 1) - taps.first) + 1, 0.0F);
        double sum = 0.0;
        for (int at = first; at <= last; ++at)
            sum += radius - std::abs(at - centre);
        for (int at = first; at <= last; ++at) {
            const auto index = static_cast<std::size_t>(std::clamp(at, 0, source - 1) - taps.first);
            taps.weights[index] += static_cast<float>((radius - std::abs(at - centre)) / sum);
        }
    }
    return all;
}

using Row = std::vector<float>; ///< [size][channels]: values times coverage, then coverage; 0..65535 and its square.

Row shrinkRow(std::span<const sim::Texel> source, const std::vector<Taps>& taps, std::size_t channels)
{
    Row row(taps.size() * channels, 0.0F);
    for (std::size_t x = 0; x < taps.size(); ++x) {
        float* out = row.data() + x * channels;
        for (std::size_t tap = 0; tap < taps[x].weights.size(); ++tap) {
            const sim::Texel& texel = source[static_cast<std::size_t>(taps[x].first) + tap];
            const float covered = taps[x].weights[tap] * static_cast<float>(texel[channels - 1]);
            for (std::size_t c = 0; c + 1 < channels; ++c)
                out[c] += covered * static_cast<float>(texel[c]);
            out[channels - 1] += covered;
        }
    }
    return row;
}

std::uint16_t rounded(float value)
{
    return static_cast<std::uint16_t>(std::clamp(std::lround(value), 0L, 65535L));
}

/// Hands texels to a raster a band of tiles at a time.
class RasterFiller
{
public:
    RasterFiller(int size, int channels)
        : m_raster(size, channels), m_channels(static_cast<std::size_t>(channels)),
          m_band(static_cast<std::size_t>(size) * kTile * static_cast<std::size_t>(channels))
    {}

    void addTexel(const sim::Texel& texel)
    {
        std::copy_n(texel.begin(), m_channels, m_band.begin() + static_cast<std::ptrdiff_t>(m_filled));
        m_filled += m_channels;
        if (m_filled == m_band.size())
            flush();
    }
    sim::TiledRaster take() { return std::move(m_raster); }

private:
    static constexpr std::size_t kTile = sim::TiledRaster::kTileSize;

    void flush()
    {
        const auto across = static_cast<std::size_t>(m_raster.tilesAcross());
        for (std::size_t tile = 0; tile < across; ++tile) {
            const int index = m_nextTile++;
            const std::span<std::uint16_t> target = m_raster.writableTile(index);
            for (std::size_t y = 0; y < kTile; ++y)
                std::copy_n(m_band.data() + (y * across + tile) * kTile * m_channels, kTile * m_channels,
                            target.data() + y * kTile * m_channels);
            m_raster.compact(index);
        }
        m_filled = 0;
    }

    sim::TiledRaster m_raster;
    std::size_t m_channels;
    std::vector<std::uint16_t> m_band;
    std::size_t m_filled = 0;
    int m_nextTile = 0;
};

} // namespace

sim::TiledRaster resampleBilinear(int width, int height, const TexelRowReader& readRow, int size, int channels,
                                  sim::Texel empty)
{
    const auto count = static_cast<std::size_t>(channels);
    const std::vector<Taps> across = makeTaps(width, size);
    const std::vector<Taps> down = makeTaps(height, size);
    std::vector<sim::Texel> source(static_cast<std::size_t>(width));
    std::deque<Row> rows; // of the source, from firstRow on
    int firstRow = 0;
    RasterFiller filler(size, channels);
    Row sum;
    for (const Taps& taps : down) {
        for (; firstRow < taps.first && !rows.empty(); ++firstRow)
            rows.pop_front();
        if (rows.empty())
            firstRow = taps.first;
        while (rows.size() < taps.weights.size()) {
            readRow(firstRow + static_cast<int>(rows.size()), source);
            rows.push_back(shrinkRow(source, across, count));
        }
        sum.assign(static_cast<std::size_t>(size) * count, 0.0F);
        for (std::size_t tap = 0; tap < taps.weights.size(); ++tap)
            for (std::size_t i = 0; i < sum.size(); ++i)
                sum[i] += taps.weights[tap] * rows[tap][i];
        for (std::size_t x = 0; x < static_cast<std::size_t>(size); ++x) {
            const float* covered = sum.data() + x * count;
            const float coverage = covered[count - 1];
            sim::Texel texel = empty;
            if (coverage > 0.0F)
                for (std::size_t c = 0; c + 1 < count; ++c)
                    texel[c] = rounded(covered[c] / coverage);
            texel[count - 1] = rounded(coverage);
            filler.addTexel(texel);
        }
    }
    return filler.take();
}

sim::TiledRaster resampleNearest(int width, int height, const TexelRowReader& readRow, int size, int channels)
{
    std::vector<sim::Texel> source(static_cast<std::size_t>(width));
    const auto sourceAt = [size](int i, int length) {
        return static_cast<int>((2 * static_cast<std::int64_t>(i) + 1) * length /
                                (2 * static_cast<std::int64_t>(size)));
    };
    RasterFiller filler(size, channels);
    int readY = -1;
    for (int y = 0; y < size; ++y) {
        if (const int wanted = sourceAt(y, height); wanted != readY) {
            readY = wanted;
            readRow(readY, source);
        }
        for (int x = 0; x < size; ++x)
            filler.addTexel(source[static_cast<std::size_t>(sourceAt(x, width))]);
    }
    return filler.take();
}

} // namespace hairpaint::model
