// Cells and the sides that go with them.
#include "model/heads/uv_tiles.h"

#include "sim/base/tiled_raster.h"

#include <algorithm>
#include <utility>

namespace hairpaint::model {

namespace {

/// How many times a tile's image a map is: a power of two, as the sides of maps are.
int timesOf(int across)
{
    int times = 1;
    while (2 * times <= across)
        times *= 2;
    return times;
}

} // namespace

UvTiles::UvTiles(std::vector<int> numbers) : m_numbers(std::move(numbers))
{
    if (m_numbers.empty())
        m_numbers = {kFirstUdim};
}

int UvTiles::across() const
{
    int across = 1;
    while (static_cast<std::size_t>(across) * static_cast<std::size_t>(across) < m_numbers.size())
        ++across;
    return across;
}

std::optional<std::size_t> UvTiles::cellOf(int number) const
{
    const auto found = std::ranges::find(m_numbers, number);
    return found == m_numbers.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - m_numbers.begin()));
}

std::optional<int> UvTiles::shared() const
{
    std::vector<int> sorted = m_numbers;
    std::ranges::sort(sorted);
    const auto twice = std::ranges::adjacent_find(sorted);
    return twice == sorted.end() ? std::nullopt : std::optional(*twice);
}

int UvTiles::imageSideFor(int mapSide) const
{
    return std::max(mapSide / timesOf(across()), std::min(mapSide, sim::TiledRaster::kSmallestSize));
}

int UvTiles::mapSideFor(int imageSide) const
{
    return std::clamp(imageSide * timesOf(across()), sim::TiledRaster::kSmallestSize, sim::TiledRaster::kLargestSize);
}

} // namespace hairpaint::model
