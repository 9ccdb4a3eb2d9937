// Numbers of rows as the layers of a braid map have them.
#include "model/tools/row_number.h"

#include "model/maps/texel_ops.h"
#include "sim/groom/groom.h"

#include <algorithm>
#include <vector>

namespace hairpaint::model {

namespace {

constexpr auto kFirstRow = static_cast<std::uint16_t>(sim::BraidKind::Cornrow);
constexpr std::size_t kLayerChannels = 2; ///< The number, then the coverage.

/// Marks the rows of a layer in `used`, by number.
void markRows(const sim::TiledRaster& layer, std::vector<bool>& used)
{
    const auto mark = [&used](std::uint16_t number, std::uint16_t coverage) {
        if (coverage > 0 && isRow(number) && number < used.size())
            used[number] = true;
    };
    for (int index = 0; index < layer.tileCount(); ++index) {
        const sim::RasterTile& tile = *layer.tile(index);
        if (tile.isUniform()) {
            mark(tile.uniform[0], tile.uniform[1]);
            continue;
        }
        for (std::size_t at = 0; at < tile.pixels.size(); at += kLayerChannels)
            mark(tile.pixels[at], tile.pixels[at + 1]);
    }
}

/// By number.
std::vector<bool> rowsOf(const MapStack& braids)
{
    std::vector<bool> used(std::size_t{sim::kLastRowNumber} + 1, false);
    for (const Layer& layer : braids.layers)
        markRows(layer.raster, used);
    return used;
}

} // namespace

bool isRow(std::uint16_t number)
{
    return number >= kFirstRow;
}

std::vector<std::uint16_t> newRowNumbers(const MapStack& braids, std::size_t count)
{
    const std::vector<bool> used = rowsOf(braids);
    std::size_t next = used.size();
    while (next > kFirstRow && !used[next - 1])
        --next;
    std::vector<std::uint16_t> numbers;
    for (; next < used.size() && numbers.size() < count; ++next)
        numbers.push_back(static_cast<std::uint16_t>(next));
    for (std::size_t free = kFirstRow; free < used.size() && numbers.size() < count; ++free)
        if (!used[free] && std::ranges::find(numbers, free) == numbers.end())
            numbers.push_back(static_cast<std::uint16_t>(free));
    numbers.resize(count, kFirstRow);
    return numbers;
}

void renumberRows(const MapStack& braids, std::vector<sim::Texel>& texels,
                  const std::function<bool(std::size_t)>& isLaidOver)
{
    const std::vector<bool> used = rowsOf(braids);
    std::vector<std::uint16_t> numbers(used.size(), 0); // By old number; 0: it stays.
    std::vector<std::uint16_t> changing;
    for (std::size_t i = 0; i < texels.size(); ++i) {
        const std::uint16_t number = texels[i][0];
        const bool mayStay = texels[i][1] == 0 || !isRow(number) || number >= used.size() || !used[number];
        if (mayStay || numbers[number] != 0 || isLaidOver(i))
            continue;
        numbers[number] = number;
        changing.push_back(number);
    }
    if (changing.empty())
        return;
    std::ranges::sort(changing);
    const std::vector<std::uint16_t> fresh = newRowNumbers(braids, changing.size());
    for (std::size_t i = 0; i < changing.size(); ++i)
        numbers[changing[i]] = fresh[i];
    for (sim::Texel& texel : texels)
        if (texel[0] < numbers.size() && numbers[texel[0]] != 0)
            texel[0] = numbers[texel[0]];
}

sim::Texel strokeTexel(const ToolContext& context, const ToolEvent& begin)
{
    const MapSpec& spec = mapSpec(context.target.map);
    sim::Texel texel = texelOf(spec, context.settings.value(spec.kind));
    const HairGroup* group = context.document.project().group(context.target.group);
    if (spec.kind != MapKind::Braid || !isRow(texel[0]) || group == nullptr)
        return texel;
    const std::optional<sim::SurfacePoint>& point = begin.hair ? begin.hair->root : begin.point;
    const bool isOnMap = begin.area == Area::Paint || point;
    const sim::MapRaster map = context.document.resolvedNow(context.target.group, spec.kind);
    if (map != nullptr && isOnMap) {
        const std::uint16_t there = map->sampleNearest(point ? point->uv : begin.uv)[0];
        if (isRow(there)) {
            texel[0] = there;
            return texel;
        }
    }
    texel[0] = newRowNumbers(group->map(MapKind::Braid), 1).front();
    return texel;
}

} // namespace hairpaint::model
