// Tiles of directions and gel.
#include "model/tools/combing/hold.h"

#include "model/maps/tile_paint.h"
#include "model/tools/live_edit.h"
#include "model/values/texel_math.h"
#include "sim/base/parallel.h"
#include "sim/groom/direction_texel.h"

#include <algorithm>
#include <functional>

namespace hairpaint::model {

namespace {

/// Lays what `valueAt(uv, texel, values)` writes, through the mask, as far as `nearAt(uv)` and where it returns true.
template<typename NearAt, typename ValueAt>
sim::RasterTilePtr heldTile(const NearAt& nearAt, const MapSpec& spec, int mapSize, int tileIndex,
                            const sim::RasterTilePtr& before, const HoldPaint& paint, const ValueAt& valueAt)
{
    const int tilesAcross = mapSize / kTile;
    const glm::ivec2 first(tileIndex % tilesAcross * kTile, tileIndex / tilesAcross * kTile);
    const auto channels = static_cast<std::size_t>(spec.valueChannels);
    StrokeBuffer::MaskTile mask{};
    std::vector<std::uint16_t> values(sim::kTileTexels * channels);
    bool any = false;
    for (int y = 0; y < kTile; ++y)
        for (int x = 0; x < kTile; ++x) {
            const std::size_t texel = static_cast<std::size_t>(y) * kTile + static_cast<std::size_t>(x);
            const std::uint16_t wanted = paint.mask != nullptr ? (*paint.mask)[texel] : std::uint16_t{65535};
            if (wanted == 0)
                continue;
            const glm::vec2 position = (glm::vec2(first + glm::ivec2(x, y)) + 0.5F) / static_cast<float>(mapSize);
            const glm::vec2 uv(position.x, 1.0F - position.y);
            const float near = nearAt(uv);
            if (near == 0.0F || !valueAt(uv, first + glm::ivec2(x, y), &values[texel * channels]))
                continue;
            mask[texel] = near == 1.0F ? wanted : static_cast<std::uint16_t>(near * static_cast<float>(wanted));
            any = true;
        }
    return any ? paintTile(spec, before, mask, {.values = values.data(), .opacity = paint.opacity}) : before;
}

} // namespace

sim::RasterTilePtr heldDirection(const LyingField& field, int mapSize, int tileIndex, const sim::RasterTilePtr& before,
                                 const HoldPaint& paint)
{
    return heldTile([&](glm::vec2 uv) { return field.nearness(uv); }, mapSpec(MapKind::Direction), mapSize, tileIndex,
                    before, paint,
                    [&](glm::vec2 uv, glm::ivec2, std::uint16_t* values) {
                        const std::optional<glm::vec2> direction = field.at(uv);
                        if (!direction)
                            return false;
                        const sim::Texel texel = sim::texelOfDirection(*direction);
                        std::copy_n(texel.begin(), 2, values);
                        return true;
                    });
}

sim::RasterTilePtr heldGel(const LyingField& field, const sim::TiledRaster& shown, float least, int tileIndex,
                           const sim::RasterTilePtr& before, const HoldPaint& paint)
{
    const std::uint16_t leastStored = unit16(least);
    return heldTile([&](glm::vec2 uv) { return field.nearnessOfRoots(uv); }, mapSpec(MapKind::Gel), shown.size(),
                    tileIndex, before, paint,
                    [&](glm::vec2, glm::ivec2 at, std::uint16_t* values) {
                        values[0] = leastStored;
                        return shown.texel(at.x, at.y)[0] < leastStored;
                    });
}

namespace {

using MakeHeld =
    std::function<sim::RasterTilePtr(int tileIndex, const sim::RasterTilePtr& before, const HoldPaint& paint)>;

std::optional<LayerEdit> heldLayer(const HoldRequest::Target& target, const MakeHeld& make, const Progress& progress)
{
    constexpr std::size_t kTilesBetween = 64; ///< Questions whether it goes on.
    const std::vector<int> tiles = tilesIn(target.layer, target.clips);
    LayerEdit edit{.address = target.address, .after = {}};
    edit.after.resize(tiles.size());
    for (std::size_t done = 0; done < tiles.size(); done += kTilesBetween) {
        if (progress && !progress(static_cast<double>(done) / static_cast<double>(tiles.size())))
            return std::nullopt;
        const std::size_t some = std::min(kTilesBetween, tiles.size() - done);
        sim::parallelFor(some, 4, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = done + begin; i < done + end; ++i) {
                StrokeBuffer::MaskTile mask;
                mask.fill(65535);
                keepInside(target.clips, target.layer.tileRect(tiles[i]), mask);
                edit.after[i] = {tiles[i], make(tiles[i], target.layer.tile(tiles[i]), {.mask = &mask})};
            }
        });
    }
    std::erase_if(edit.after, [&](const auto& entry) { return entry.second == target.layer.tile(entry.first); });
    return edit;
}

} // namespace

std::optional<std::vector<LayerEdit>> holdHair(const LyingField& field, const HoldRequest& request,
                                               const Progress& progress)
{
    constexpr double kHalf = 0.5;
    const auto half = [&progress](double from) {
        return progress ? Progress([&progress, from](double part) { return progress(from + kHalf * part); })
                        : Progress();
    };
    std::optional<LayerEdit> gel = heldLayer(
        request.gel,
        [&](int tile, const sim::RasterTilePtr& before, const HoldPaint& paint) {
            return heldGel(field, *request.shownGel, request.leastGel, tile, before, paint);
        },
        half(0.0));
    if (!gel)
        return std::nullopt;
    std::optional<LayerEdit> direction = heldLayer(
        request.direction,
        [&](int tile, const sim::RasterTilePtr& before, const HoldPaint& paint) {
            return heldDirection(field, request.direction.layer.size(), tile, before, paint);
        },
        half(kHalf));
    if (!direction)
        return std::nullopt;
    return std::vector<LayerEdit>{std::move(*gel), std::move(*direction)};
}

QString holdStepText()
{
    return QCoreApplication::translate("Tool", kHoldStep);
}

} // namespace hairpaint::model
