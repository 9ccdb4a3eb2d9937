// The formula by which version 0.1 combed, texel by texel.
#include "model/files/former_combing.h"

#include "model/maps/compositor.h"
#include "model/project/content_budget.h"
#include "sim/base/parallel.h"
#include "sim/groom/direction_texel.h"
#include "sim/skin/skin_frame.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>

namespace hairpaint::model {

namespace {

constexpr int kCombedSize = 512;
constexpr int kBleed = 4;           ///< Texels that are filled past the islands' borders.
constexpr float kFlattest = 0.976F; ///< Greatest flatness, that of long hair: it rose 22 cm in a metre.
constexpr float kStiffM = 0.03F;    ///< Hair shorter than this stood upright.
constexpr float kLimpM = 0.14F;     ///< Hair longer than this lay as flat as it could.
/// Weight of sideways against 1 for down, at full parting, on top and at the forehead.
constexpr float kSideways = 4.0F;
constexpr float kBackward = 3.6F; ///< Weight of backward against 1 for down, at full sweep.

struct CombedTexel
{
    bool onSkin = false;
    glm::vec3 positionHd{0.0F};
    sim::SkinFrame frame;
};

std::size_t combedIndex(int x, int y)
{
    return static_cast<std::size_t>(y) * kCombedSize + static_cast<std::size_t>(x);
}

/// The skin at every texel; texels off the skin get a neighbour's. Empty where `goesOn` stops it.
std::vector<CombedTexel> texelsOf(const sim::Skin& skin, const std::function<bool()>& goesOn)
{
    constexpr int kRowsAtOnce = 32;
    std::vector<CombedTexel> table(combedIndex(0, kCombedSize));
    for (int top = 0; top < kCombedSize; top += kRowsAtOnce) {
        if (goesOn && !goesOn())
            return {};
        sim::parallelFor(kRowsAtOnce, 1, [&](std::size_t begin, std::size_t end) {
            for (int y = top + static_cast<int>(begin); y < top + static_cast<int>(end); ++y)
                for (int x = 0; x < kCombedSize; ++x) {
                    const glm::vec2 uv = glm::vec2(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F) /
                                         static_cast<float>(kCombedSize);
                    if (const std::optional<sim::SurfacePoint> point = skin.atUv({uv.x, 1.0F - uv.y}))
                        table[combedIndex(x, y)] = {true, point->positionHd, sim::SkinFrame::at(*point)};
                }
        });
    }
    constexpr std::array<glm::ivec2, 4> kBeside = {{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};
    for (int round = 0; round < kBleed; ++round) {
        const std::vector<CombedTexel> before = table;
        for (int y = 1; y + 1 < kCombedSize; ++y)
            for (int x = 1; x + 1 < kCombedSize; ++x)
                for (const glm::ivec2& step : kBeside)
                    if (CombedTexel& at = table[combedIndex(x, y)]; !at.onSkin)
                        at = before[combedIndex(x + step.x, y + step.y)];
    }
    return table;
}

/// A scalar map's value at a texel of the painted size.
float scalarAt(const MapStack& stack, int x, int y)
{
    const auto texel = [&stack](int at) { return (2 * at + 1) * stack.size / (2 * kCombedSize); };
    return static_cast<float>(resolveTexel(stack, texel(x), texel(y))[0]) / 65535.0F;
}

float smoothStep(float from, float to, float x)
{
    const float t = std::clamp((x - from) / (to - from), 0.0F, 1.0F);
    return t * t * (3.0F - 2.0F * t);
}

/// Hd, along the skin.
glm::vec3 combedAlong(const CombedTexel& at, const FormerCombing& combing)
{
    const glm::vec3 n = at.frame.normal;
    const float up = std::clamp(n.y, 0.0F, 1.0F);
    const float side = at.positionHd.x < 0.0F ? -1.0F : 1.0F;
    const float front = std::clamp(n.z, 0.0F, 1.0F);
    const float most = std::max(up, front);
    // Over the face nothing fell straight down once it was combed at all.
    const float down = 1.0F - front * std::min(1.0F, combing.parting + combing.sweepBack);
    const glm::vec3 combed(kSideways * combing.parting * most * side, -down, -kBackward * combing.sweepBack * most);
    const glm::vec3 along = combed - n * glm::dot(combed, n);
    const float length = glm::length(along);
    return length > 1e-6F ? along / length : glm::vec3(side, 0.0F, 0.0F);
}

sim::TiledRaster painted(const HairGroup& group, const FormerCombing& combing, const std::vector<CombedTexel>& table)
{
    const sim::GroupSettings& settings = group.settings;
    const float shortestM = settings.shortestLengthM;
    const float rangeM = settings.greatestLengthM - shortestM;
    sim::TiledRaster raster = emptyRaster(mapSpec(MapKind::Direction), kCombedSize);
    for (int y = 0; y < kCombedSize; ++y)
        for (int x = 0; x < kCombedSize; ++x) {
            const CombedTexel& at = table[combedIndex(x, y)];
            if (!at.onSkin)
                continue;
            const float lengthM = shortestM + rangeM * scalarAt(group.map(MapKind::Length), x, y);
            const float loose = 1.0F - scalarAt(group.map(MapKind::Gel), x, y);
            const float flatness =
                kFlattest * smoothStep(kStiffM, kLimpM, lengthM) * loose * loose * (1.0F - combing.body);
            sim::Texel texel = sim::texelOfDirection(at.frame.fromHd(combedAlong(at, combing)) * flatness);
            texel[2] = 65535;
            raster.setTexel(x, y, texel);
        }
    for (int tile = 0; tile < raster.tileCount(); ++tile)
        raster.compact(tile);
    return raster;
}

} // namespace

bool paintFormerCombing(Project& project, std::span<const std::optional<FormerCombing>> groups,
                        const std::function<bool()>& goesOn)
{
    if (project.head == nullptr || project.head->skin == nullptr ||
        std::ranges::none_of(groups, [](const auto& one) { return one.has_value(); }))
        return true;
    const std::vector<CombedTexel> table = texelsOf(*project.head->skin, goesOn);
    if (table.empty())
        return false;
    for (std::size_t i = 0; i < std::min(groups.size(), project.groups.size()); ++i) {
        if (!groups[i])
            continue;
        if (goesOn && !goesOn())
            return false;
        HairGroup& group = project.groups[i];
        MapStack combed = group.map(MapKind::Direction); // One empty layer, since the file lacks the map.
        combed.size = kCombedSize;
        combed.layers.erase(combed.layers.begin() + 1, combed.layers.end());
        combed.layers.front().name = QCoreApplication::translate("Files", "Parting and sweep back");
        combed.layers.front().raster = painted(group, *groups[i], table);
        std::swap(group.map(MapKind::Direction), combed);
        if (excessOf(project.groups) != ContentExcess::None)
            std::swap(group.map(MapKind::Direction), combed);
    }
    return true;
}

} // namespace hairpaint::model
