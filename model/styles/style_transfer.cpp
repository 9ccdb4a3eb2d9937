// Every layer sampled through a correspondence, tile by tile.
#include "model/styles/style_transfer.h"

#include "model/project/group_schema.h"
#include "model/styles/uv_correspondence.h"
#include "model/styles/worn_transfer.h"
#include "sim/base/parallel.h"
#include "sim/groom/direction_texel.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hairpaint::model {

namespace {

/// Beyond the islands' borders, so that nothing of the default bleeds in where hair is sampled between texels.
constexpr int kGutter = 2;
constexpr int kFieldSide = sim::TiledRaster::kTileSize + 2 * kGutter;
/// Corresponding uv on both layouts.
struct UvPair
{
    glm::vec2 from, to;
};
using UvField = std::vector<std::optional<UvPair>>; ///< [kFieldSide][kFieldSide]

std::size_t fieldIndex(int x, int y)
{
    return static_cast<std::size_t>(y) * kFieldSide + static_cast<std::size_t>(x);
}

/// Where the texels of a tile, and some around it, come from.
UvField fieldOf(const UvCorrespondence& correspondence, const sim::TexelRect& tile, int size)
{
    UvField field(std::size_t{kFieldSide} * kFieldSide);
    for (int y = 0; y < kFieldSide; ++y)
        for (int x = 0; x < kFieldSide; ++x) {
            const glm::vec2 centre(static_cast<float>(tile.x0 - kGutter + x) + 0.5F,
                                   static_cast<float>(tile.y0 - kGutter + y) + 0.5F);
            const glm::vec2 uv = centre / static_cast<float>(size);
            if (uv.x > 0.0F && uv.x < 1.0F && uv.y > 0.0F && uv.y < 1.0F)
                if (const std::optional<glm::vec2> from = correspondence.at({uv.x, 1.0F - uv.y}))
                    field[fieldIndex(x, y)] = UvPair{*from, {uv.x, 1.0F - uv.y}};
        }
    return field;
}

/// Texels off the skin get the uv of a neighbour on it.
void widen(UvField& field)
{
    constexpr std::array<glm::ivec2, 8> kAround = {
        {{-1, 0}, {1, 0}, {0, -1}, {0, 1}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}}};
    for (int round = 0; round < kGutter; ++round) {
        const UvField before = field;
        for (int y = 1; y + 1 < kFieldSide; ++y)
            for (int x = 1; x + 1 < kFieldSide; ++x)
                for (const glm::ivec2& step : kAround)
                    if (!field[fieldIndex(x, y)])
                        field[fieldIndex(x, y)] = before[fieldIndex(x + step.x, y + step.y)];
    }
}

/// Bilinear, each texel's values weighed by its coverage: nothing of what is not painted shows.
sim::Texel blendedTexel(const sim::TiledRaster& raster, glm::vec2 uv, std::size_t values)
{
    const int last = raster.size() - 1;
    const glm::vec2 inTexels = glm::vec2(uv.x, 1.0F - uv.y) * static_cast<float>(raster.size()) - 0.5F;
    const glm::vec2 corner = glm::floor(inTexels);
    const glm::vec2 fraction = inTexels - corner;
    std::array<float, 4> sums{};
    float coverage = 0.0F;
    for (int k = 0; k < 4; ++k) {
        const glm::ivec2 at = glm::clamp(glm::ivec2(corner) + glm::ivec2(k % 2, k / 2), 0, last);
        const sim::Texel texel = raster.texel(at.x, at.y);
        const float weight =
            (k % 2 == 0 ? 1.0F - fraction.x : fraction.x) * (k / 2 == 0 ? 1.0F - fraction.y : fraction.y);
        const float covered = weight * static_cast<float>(texel[values]);
        coverage += covered;
        for (std::size_t channel = 0; channel < values; ++channel)
            sums[channel] += covered * static_cast<float>(texel[channel]);
    }
    sim::Texel texel{};
    if (coverage > 0.0F)
        for (std::size_t channel = 0; channel < values; ++channel)
            texel[channel] = static_cast<std::uint16_t>(std::lround(sums[channel] / coverage));
    texel[values] = static_cast<std::uint16_t>(std::lround(coverage));
    return texel;
}

/// From the old head's frame to the new one's.
void turn(sim::Texel& texel, const UvCorrespondence& correspondence, const UvPair& uv)
{
    const sim::Texel turned = sim::texelOfDirection(correspondence.direction(sim::directionOf(texel), uv.from, uv.to));
    std::copy_n(turned.begin(), 2, texel.begin());
}

sim::RasterTilePtr carriedTile(const sim::TiledRaster& raster, const MapSpec& spec,
                               const UvCorrespondence& correspondence, int index)
{
    const auto values = static_cast<std::size_t>(spec.valueChannels);
    const auto channels = static_cast<std::size_t>(spec.layerChannels());
    UvField field = fieldOf(correspondence, raster.tileRect(index), raster.size());
    widen(field);
    sim::RasterTile tile;
    tile.pixels.assign(sim::kTileTexels * channels, 0);
    auto out = tile.pixels.begin();
    for (int y = kGutter; y < kFieldSide - kGutter; ++y)
        for (int x = kGutter; x < kFieldSide - kGutter; ++x, out += static_cast<std::ptrdiff_t>(channels)) {
            const std::optional<UvPair>& uv = field[fieldIndex(x, y)];
            if (!uv)
                continue;
            sim::Texel texel =
                spec.bilinear() ? blendedTexel(raster, uv->from, values) : raster.sampleNearest(uv->from);
            if (spec.texel == TexelKind::Vector && texel[values] != 0)
                turn(texel, correspondence, *uv);
            std::copy_n(texel.begin(), channels, out);
        }
    return std::make_shared<const sim::RasterTile>(sim::folded(std::move(tile)));
}

sim::TiledRaster carriedRaster(const sim::TiledRaster& raster, const MapSpec& spec,
                               const UvCorrespondence& correspondence)
{
    const std::optional<sim::Texel> one = raster.uniformValue();
    const bool turns = spec.texel == TexelKind::Vector && one && (*one)[2] != 0;
    if (one && !turns)
        return raster;
    sim::TiledRaster carried = emptyRaster(spec, raster.size());
    std::vector<sim::RasterTilePtr> tiles(static_cast<std::size_t>(raster.tileCount()));
    sim::parallelFor(tiles.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t index = begin; index < end; ++index)
            tiles[index] = carriedTile(raster, spec, correspondence, static_cast<int>(index));
    });
    for (std::size_t index = 0; index < tiles.size(); ++index)
        carried.setTile(static_cast<int>(index), std::move(tiles[index]));
    return carried;
}

/// Root mean square of the landmarks' distances from their middle, m.
float sizeOf(const sim::HeadLandmarks& landmarks)
{
    glm::vec3 middle(0.0F);
    for (const glm::vec3& p : landmarks.positionsHd)
        middle += p / static_cast<float>(sim::kHeadLandmarkCount);
    float squares = 0.0F;
    for (const glm::vec3& p : landmarks.positionsHd)
        squares += glm::dot(p - middle, p - middle);
    return std::sqrt(squares / static_cast<float>(sim::kHeadLandmarkCount));
}

/// How many times as large a head is; 1 where landmarks coincide or lie nowhere.
float sizeRatio(const Head& from, const Head& to)
{
    constexpr float kSameSize = 0.03F; // Between grown-up heads lengths stay the round numbers that they are.
    constexpr float kMostRatio = 2.0F; // What differs by more is no head, or in another unit.
    const float ratio = sizeOf(*to.landmarks) / sizeOf(*from.landmarks);
    if (!std::isfinite(ratio) || ratio <= 0.0F || std::abs(ratio - 1.0F) < kSameSize)
        return 1.0F;
    return std::clamp(ratio, 1.0F / kMostRatio, kMostRatio);
}

/// As many of what counts on the scalp, and hair that ends at the same landmarks.
void carrySettings(sim::GroupSettings& settings, const Head& from, const Head& to)
{
    for (const GroupSetting& row : groupSchema())
        if (row.countsOnScalp)
            row.writeShown(settings, row.shown(settings, from.scalpFraction), to.scalpFraction);
    const float ratio = sizeRatio(from, to);
    for (const char* key : {"greatest_length_m", "shortest_length_m", "braid_spacing_m", "braid_radius_m"}) {
        const GroupSetting& row = groupSetting(QLatin1StringView(key));
        row.write(settings, std::clamp(row.read(settings) * static_cast<double>(ratio), row.least, row.greatest));
    }
}

/// A head may come from two files. With its landmarks elsewhere it is another one.
bool areSame(const Head& a, const Head& b)
{
    return &a == &b || (!a.builtIn && !b.builtIn && a.unitScale == b.unitScale && a.upAxis == b.upAxis &&
                        a.sourceGlb == b.sourceGlb && a.landmarks == b.landmarks);
}

int largestMap(const std::vector<HairGroup>& groups)
{
    int largest = sim::TiledRaster::kSmallestSize;
    for (const HairGroup& group : groups)
        for (const MapStack& stack : group.maps)
            for (const Layer& layer : stack.layers)
                if (!layer.raster.uniformValue())
                    largest = std::max(largest, stack.size);
    return largest;
}

} // namespace

bool canCarry(const std::shared_ptr<const Head>& from, const std::shared_ptr<const Head>& to)
{
    return from && to && !areSame(*from, *to) && from->skin && to->skin && from->landmarks && to->landmarks;
}

std::optional<std::vector<HairGroup>> carriedGroups(std::vector<HairGroup> groups,
                                                    const std::shared_ptr<const Head>& from,
                                                    const std::shared_ptr<const Head>& to, const Progress& progress)
{
    constexpr int kLargestTable = 1024; // Two seconds; between its entries lies next to nothing of a head.
    constexpr double kTableFraction = 0.5;
    if (!canCarry(from, to))
        return groups;
    const std::shared_ptr<const UvCorrespondence> correspondence =
        UvCorrespondence::between(from, to, std::min(largestMap(groups), kLargestTable),
                                  [&](double made) { return !progress || progress(kTableFraction * made); });
    if (!correspondence)
        return std::nullopt;
    const auto total = static_cast<double>(groups.size() * mapSpecs().size());
    double done = 0.0;
    for (HairGroup& group : groups) {
        carrySettings(group.settings, *from, *to);
        for (SharedStack& stack : group.maps) {
            const MapSpec& spec = mapSpec(stack->kind);
            for (Layer& layer : stack.write().layers) {
                if (progress && !progress(kTableFraction + (1.0 - kTableFraction) * done / total))
                    return std::nullopt;
                layer.raster = carriedRaster(layer.raster, spec, *correspondence);
            }
            done += 1.0;
        }
    }
    return groups;
}

std::optional<Preset> carriedPreset(Preset preset, const std::shared_ptr<const Head>& to, const Progress& progress)
{
    if (preset.head && to && areSame(*preset.head, *to))
        preset.head = to; // One of them is enough.
    if (!canCarry(preset.head, to))
        return preset;
    std::optional<std::vector<HairGroup>> groups = carriedGroups(std::move(preset.groups), preset.head, to, progress);
    if (!groups)
        return std::nullopt;
    preset.groups = std::move(*groups);
    preset.worn = carriedWorn(std::move(preset.worn), preset.head, to);
    preset.head = to;
    return preset;
}

} // namespace hairpaint::model
