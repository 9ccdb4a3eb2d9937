// Cells of a square, told apart by what is covered.
#include "model/heads/layout_packing.h"

#include "model/values/srgb.h"
#include "sim/skin/uv_raster.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <tuple>
#include <utility>

namespace hairpaint::model {

namespace {

constexpr int kCoverSide = 256;
using Cover = std::bitset<std::size_t{kCoverSide} * kCoverSide>;

/// Parts that lie on one square of uvs.
struct Layout
{
    glm::ivec2 tile{0};
    std::int32_t texture = -1;
    glm::vec3 colour{1.0F};
    std::vector<std::size_t> parts;
};

Cover coverOf(const RiggedMesh& mesh, const PartRange& range)
{
    Cover covered;
    for (std::size_t t = range.firstTriangle; t < range.firstTriangle + range.triangles; ++t)
        sim::eachTexelOf(mesh, mesh.triangles[t], kCoverSide, [&covered](std::size_t texel) { covered.set(texel); });
    return covered;
}

/// Beside all of its parts: none of them, nor this one, lies notably under the other, however small it is.
bool fits(const Layout& layout, const MeshPart& part, const Cover& covered, std::span<const Cover> covers)
{
    if (layout.tile != part.tile || (layout.texture != part.texture && layout.texture >= 0 && part.texture >= 0))
        return false;
    const std::size_t own = covered.count();
    return std::ranges::all_of(layout.parts, [&](std::size_t other) {
        const std::size_t smaller = std::min(own, covers[other].count());
        const std::size_t both = (covered & covers[other]).count();
        return static_cast<double>(both) <= kNotableOverlap * static_cast<double>(smaller);
    });
}

std::vector<Layout> layoutsOf(const RiggedMesh& mesh, std::span<const MeshPart> grown,
                              std::span<const PartRange> ranges)
{
    std::vector<Layout> layouts;
    std::vector<Cover> covers;
    covers.reserve(grown.size());
    for (std::size_t i = 0; i < grown.size(); ++i) {
        covers.push_back(coverOf(mesh, ranges[i]));
        auto layout =
            std::ranges::find_if(layouts, [&](const Layout& one) { return fits(one, grown[i], covers[i], covers); });
        if (layout == layouts.end()) {
            layouts.push_back({.tile = grown[i].tile, .texture = -1, .colour = grown[i].colour, .parts = {}});
            layout = layouts.end() - 1;
        }
        if (grown[i].texture >= 0) {
            layout->texture = grown[i].texture;
            layout->colour = grown[i].colour;
        }
        layout->parts.push_back(i);
    }
    std::ranges::stable_sort(layouts, {}, [](const Layout& one) { return std::pair(one.tile.y, one.tile.x); });
    return layouts;
}

/// Their textures side by side, each times its colour.
MeshTexture pictureOf(const RiggedMesh& mesh, std::span<const Layout> layouts, std::uint32_t cells)
{
    std::uint32_t cellSide = 16;
    for (const Layout& layout : layouts)
        if (layout.texture >= 0) {
            const MeshTexture& own = mesh.textures[static_cast<std::size_t>(layout.texture)];
            cellSide = std::max({cellSide, own.width, own.height});
        }
    cellSide = std::min(cellSide, MeshTexture::kLargestSide / cells);
    const std::uint32_t side = cellSide * cells;
    MeshTexture picture{.width = side, .height = side, .rgba = {}};
    picture.rgba.assign(std::size_t{side} * side * 4, 255);
    for (std::size_t i = 0; i < layouts.size(); ++i) {
        const Layout& layout = layouts[i];
        const MeshTexture* const own =
            layout.texture >= 0 ? &mesh.textures[static_cast<std::size_t>(layout.texture)] : nullptr;
        const std::size_t column = i % cells;
        const std::size_t rowFromTop = cells - 1 - i / cells;
        for (std::size_t y = 0; y < cellSide; ++y)
            for (std::size_t x = 0; x < cellSide; ++x) {
                const std::uint8_t* const from =
                    own != nullptr
                        ? own->rgba.data() + (y * own->height / cellSide * own->width + x * own->width / cellSide) * 4
                        : nullptr;
                std::uint8_t* const to =
                    picture.rgba.data() + ((rowFromTop * cellSide + y) * side + column * cellSide + x) * 4;
                for (std::size_t c = 0; c < 3; ++c) {
                    const float shown = from != nullptr ? linearFromSrgb(static_cast<float>(from[c]) / 255.0F) : 1.0F;
                    const float light = shown * layout.colour[static_cast<int>(c)];
                    to[c] =
                        static_cast<std::uint8_t>(std::lround(255.0F * std::clamp(srgbFromLinear(light), 0.0F, 1.0F)));
                }
                to[3] = from != nullptr ? from[3] : 255;
            }
    }
    return picture;
}

} // namespace

std::vector<PartRange> rangesOf(const RiggedMesh& mesh)
{
    std::vector<PartRange> ranges;
    PartRange range;
    for (const MeshPart& part : mesh.parts) {
        range = {.firstVertex = range.firstVertex + range.vertices,
                 .vertices = part.vertices,
                 .firstTriangle = range.firstTriangle + range.triangles,
                 .triangles = part.triangles};
        ranges.push_back(range);
    }
    return ranges;
}

MeshPart withPackedLayouts(RiggedMesh& mesh, std::span<const MeshPart> grown)
{
    RiggedMesh counts;
    counts.parts.assign(grown.begin(), grown.end());
    const std::vector<PartRange> ranges = rangesOf(counts);
    MeshPart one = grown.front();
    for (const MeshPart& part : grown.subspan(1)) {
        one.vertices += part.vertices;
        one.triangles += part.triangles;
    }
    mesh.tiles = UvTiles({udimOf(one.tile)});
    if (grown.size() == 1)
        return one;
    const std::vector<Layout> layouts = layoutsOf(mesh, grown, ranges);
    std::vector<int> numbers(layouts.size());
    std::ranges::transform(layouts, numbers.begin(), [](const Layout& layout) { return udimOf(layout.tile); });
    mesh.tiles = UvTiles(std::move(numbers));
    if (layouts.size() == 1) {
        one.texture = layouts.front().texture;
        one.colour = layouts.front().colour;
        return one;
    }
    const auto cells = static_cast<std::uint32_t>(mesh.tiles.across());
    for (std::size_t i = 0; i < layouts.size(); ++i) {
        const std::size_t row = i / cells;
        const glm::vec2 cell(static_cast<float>(i - row * cells), static_cast<float>(row));
        for (const std::size_t part : layouts[i].parts)
            for (std::size_t v = 0; v < ranges[part].vertices; ++v) {
                glm::vec2& uv = mesh.uvs[ranges[part].firstVertex + v];
                uv = (uv + cell) / static_cast<float>(cells);
            }
    }
    one.tile = glm::ivec2(0);
    one.texture = -1;
    if (std::ranges::any_of(layouts, [](const Layout& layout) { return layout.texture >= 0; })) {
        one.texture = static_cast<std::int32_t>(mesh.textures.size());
        one.colour = glm::vec3(1.0F);
        mesh.textures.push_back(pictureOf(mesh, layouts, cells));
    }
    return one;
}

LayoutOverlap overlapOf(const sim::HeadMesh& mesh)
{
    constexpr int kSide = 512;
    // Margin as a fraction of a triangle's height, so that triangles that meet at an edge share no texel.
    constexpr float kInside = 1e-3F;
    float least = 1e30F;
    float greatest = -1e30F;
    for (const glm::vec3& position : mesh.positionsHd) {
        least = std::min(least, position.x);
        greatest = std::max(greatest, position.x);
    }
    const float middle = 0.5F * (least + greatest);
    const float close = 0.03F * (greatest - least);
    std::vector<std::uint32_t> owner(std::size_t{kSide} * kSide, 0);
    std::size_t covered = 0;
    std::size_t over = 0;
    std::size_t mirrored = 0;
    const auto middleOf = [&mesh](const glm::uvec3& t) {
        return (mesh.positionsHd[t.x] + mesh.positionsHd[t.y] + mesh.positionsHd[t.z]) / 3.0F;
    };
    std::vector<bool> isOver(owner.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        sim::eachTexelOf(
            mesh, mesh.triangles[t], kSide,
            [&](std::size_t texel) {
                if (owner[texel] == 0) {
                    owner[texel] = static_cast<std::uint32_t>(t) + 1;
                    ++covered;
                    return;
                }
                if (isOver[texel])
                    return;
                isOver[texel] = true;
                ++over;
                const glm::vec3 a = middleOf(mesh.triangles[owner[texel] - 1]);
                const glm::vec3 b = middleOf(mesh.triangles[t]);
                const bool isOpposite =
                    std::abs(a.x - b.x) > close && std::abs(a.x + b.x - 2.0F * middle) < 2.0F * close;
                mirrored += isOpposite && std::abs(a.y - b.y) < 2.0F * close ? 1 : 0;
            },
            kInside);
    return {.fraction = covered > 0 ? static_cast<double>(over) / static_cast<double>(covered) : 0.0,
            .isMirrored = over > 0 && 2 * mirrored > over};
}

} // namespace hairpaint::model
