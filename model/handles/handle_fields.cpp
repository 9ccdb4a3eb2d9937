// Regions by landmarks, and lengths multiplied: see the header.
#include "model/handles/handle_fields.h"

#include "model/document/range_change.h"
#include "model/project/group_schema.h"
#include "model/values/texel_math.h"
#include "sim/base/parallel.h"
#include "sim/base/rounded.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace hairpaint::model {

namespace {

using sim::HeadLandmark;

/// Distance between the ears of bust-1, on which the distances below were measured.
constexpr float kEarSpanM = 0.1484F;
constexpr int kTileSide = sim::TiledRaster::kTileSize;
constexpr int kColumns = 73; ///< Angles of 0 .. 180 degrees; both sides count as one.
constexpr float kRowStepM = 0.0025F;
constexpr float kBelowNapeM = 0.06F; ///< So far below the nape columns reach.

/// 1 up to `inner`, 0 from `outer` on.
float within(float inner, float outer, float x)
{
    const float t = std::clamp((outer - x) / (outer - inner), 0.0F, 1.0F);
    return t * t * (3.0F - 2.0F * t);
}

/// Whose result scales with its layers.
bool isProportional(BlendMode mode)
{
    return mode == BlendMode::Normal || mode == BlendMode::Darken || mode == BlendMode::Lighten ||
           mode == BlendMode::Add || mode == BlendMode::Subtract || mode == BlendMode::Difference;
}

bool isPlain(const Layer& layer)
{
    return layer.visible && layer.blend == BlendMode::Normal && unit16(layer.opacity) == 65535;
}

} // namespace

HandleRegions::HandleRegions(const sim::HeadLandmarks& landmarks) : m_landmarks(landmarks)
{
    const glm::vec3 left = landmarks[HeadLandmark::EarLeft];
    const glm::vec3 right = landmarks[HeadLandmark::EarRight];
    m_scale = std::max(glm::distance(left, right), 1e-3F) / kEarSpanM;
    m_axisHd = 0.5F * (left + right) - glm::vec3(0.0F, 0.0F, 0.0036F * m_scale);
}

float HandleRegions::fringe(glm::vec3 rootHd) const
{
    // The hairline goes back to the sides.
    const glm::vec3 from = (rootHd - hairlineHd()) / m_scale;
    const float aside = std::abs(from.x);
    const float behind = -from.z - 0.25F * aside - 4.0F * aside * aside;
    return within(0.046F, 0.060F, aside) * within(0.046F, 0.062F, behind) * within(0.012F, 0.030F, -from.y);
}

float HandleRegions::faded(glm::vec3 rootHd) const
{
    constexpr float kDegree = std::numbers::pi_v<float> / 180.0F;
    return (1.0F - within(40.0F * kDegree, 60.0F * kDegree, angle(rootHd))) *
           within(topM() - 0.045F * m_scale, topM() - 0.020F * m_scale, rootHd.y);
}

float HandleRegions::angle(glm::vec3 rootHd) const
{
    return sim::atan2Rounded(std::abs(rootHd.x - m_axisHd.x), rootHd.z - m_axisHd.z);
}

sim::RayHd HandleRegions::rayAt(float angle, float heightM) const
{
    return {.originHd = {m_axisHd.x, heightM, m_axisHd.z},
            .directionHd = {sim::sinRounded(angle), 0.0F, sim::cosRounded(angle)}};
}

std::vector<sim::SurfacePoint> HandleRegions::partLine(const sim::Skin& skin, float side) const
{
    constexpr int kPoints = 10;
    constexpr float kAsideM = 0.032F;
    const float leftM = hairlineHd().x + side * kAsideM * m_scale;
    const float frontM = hairlineHd().z - 0.014F * m_scale;
    // A part at the side ends before the crown.
    const float backM = m_landmarks[HeadLandmark::Crown].z - (side == 0.0F ? 0.048F : 0.020F) * m_scale;
    std::vector<sim::SurfacePoint> points;
    points.reserve(kPoints);
    for (int i = 0; i < kPoints; ++i) {
        const float forwardM = std::lerp(frontM, backM, static_cast<float>(i) / (kPoints - 1));
        const float highM = topM() + m_scale;
        if (const auto point = skin.pick({.originHd = {leftM, highM, forwardM}, .directionHd = {0.0F, -1.0F, 0.0F}}))
            points.push_back(*point);
    }
    return points;
}

FadeColumns::FadeColumns(const sim::Skin& skin, const HandleRegions& regions, const sim::TiledRaster& length)
    : m_lowestM(regions.napeM() - kBelowNapeM * regions.scale()), m_stepM(kRowStepM * regions.scale()),
      m_rows(std::max(2, static_cast<int>((regions.topM() - m_lowestM) / m_stepM) + 1)),
      m_values(static_cast<std::size_t>(m_rows) * kColumns)
{
    sim::parallelFor(kColumns, 4, [&](std::size_t begin, std::size_t end) {
        for (std::size_t column = begin; column < end; ++column) {
            const float angle = std::numbers::pi_v<float> * static_cast<float>(column) / (kColumns - 1);
            float last = 0.0F;
            for (int row = m_rows - 1; row >= 0; --row) { // What misses the head is as what lies above it.
                const auto point = skin.pick(regions.rayAt(angle, m_lowestM + m_stepM * static_cast<float>(row)));
                if (point)
                    last = length.sampleScalar(point->uv);
                m_values[column * static_cast<std::size_t>(m_rows) + static_cast<std::size_t>(row)] = last;
            }
        }
    });
}

float FadeColumns::at(float angle, float heightM) const
{
    const float x = std::clamp(angle / std::numbers::pi_v<float> * (kColumns - 1), 0.0F, kColumns - 1.001F);
    const float y = std::clamp((heightM - m_lowestM) / m_stepM, 0.0F, static_cast<float>(m_rows) - 1.001F);
    const auto column = static_cast<std::size_t>(x);
    const auto row = static_cast<std::size_t>(y);
    const auto value = [&](std::size_t c, std::size_t r) { return m_values[c * static_cast<std::size_t>(m_rows) + r]; };
    const float dx = x - static_cast<float>(column);
    const float dy = y - static_cast<float>(row);
    return std::lerp(std::lerp(value(column, row), value(column + 1, row), dx),
                     std::lerp(value(column, row + 1), value(column + 1, row + 1), dx), dy);
}

void LengthFactors::spread(SkinFrames& frames)
{
    constexpr int kSide = SkinFrames::kSize;
    std::vector<std::uint8_t> isKnown(m_factors.size());
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x)
            isKnown[indexOf(x, y)] = frames.point(x, y).has_value() ? 1 : 0;
    for (int pass = 0; pass < 2; ++pass) {
        const std::vector<std::uint8_t> before = isKnown;
        for (int y = 0; y < kSide; ++y)
            for (int x = 0; x < kSide; ++x) {
                if (before[indexOf(x, y)] != 0)
                    continue;
                for (const auto& [dx, dy] : {std::pair(-1, 0), std::pair(1, 0), std::pair(0, -1), std::pair(0, 1)}) {
                    const int nx = x + dx;
                    const int ny = y + dy;
                    if (nx < 0 || ny < 0 || nx >= kSide || ny >= kSide || before[indexOf(nx, ny)] == 0)
                        continue;
                    at(x, y) = m_factors[indexOf(nx, ny)];
                    isKnown[indexOf(x, y)] = 1;
                    break;
                }
            }
    }
}

float LengthFactors::texelFactor(int x, int y, int size) const
{
    constexpr int kSide = SkinFrames::kSize;
    if (size == kSide)
        return m_factors[indexOf(x, y)];
    const auto entry = [size](int texel) {
        return std::clamp((static_cast<float>(texel) + 0.5F) * kSide / static_cast<float>(size) - 0.5F, 0.0F,
                          kSide - 1.001F);
    };
    const float fx = entry(x);
    const float fy = entry(y);
    const int left = static_cast<int>(fx);
    const int top = static_cast<int>(fy);
    const float dx = fx - static_cast<float>(left);
    return std::lerp(std::lerp(m_factors[indexOf(left, top)], m_factors[indexOf(left + 1, top)], dx),
                     std::lerp(m_factors[indexOf(left, top + 1)], m_factors[indexOf(left + 1, top + 1)], dx),
                     fy - static_cast<float>(top));
}

SharedStack LengthFactors::applied(const HairGroup& group, sim::GroupSettings& settings) const
{
    constexpr int kChannels = 2;
    const MapSpec& spec = mapSpec(MapKind::Length);
    HairGroup longer = group;
    longer.settings = settings;
    SharedStack* result = &longer.maps[static_cast<std::size_t>(MapKind::Length)];
    if ((*result)->layers.empty())
        return *result;
    const int size = (*result)->size;
    const sim::TiledRaster& any = (*result)->layers.front().raster;
    std::vector<int> tiles;
    for (int index = 0; index < any.tileCount(); ++index) {
        const sim::TexelRect rect = any.tileRect(index);
        bool isTouched = false;
        for (int y = rect.y0; y < rect.y1 && !isTouched; ++y)
            for (int x = rect.x0; x < rect.x1 && !isTouched; ++x)
                isTouched = texelFactor(x, y, size) != 1.0F;
        if (isTouched)
            tiles.push_back(index);
    }
    if (tiles.empty())
        return *result;
    // The greatest value that comes out says how much further the range must reach.
    float greatest = 0.0F;
    for (const Layer& layer : (*result)->layers) {
        if (!layer.visible || !isProportional(layer.blend))
            continue;
        for (const int index : tiles) {
            const sim::TexelRect rect = any.tileRect(index);
            const std::vector<std::uint16_t> texels = sim::expanded(*layer.raster.tile(index), kChannels);
            auto texel = texels.begin();
            for (int y = rect.y0; y < rect.y1; ++y)
                for (int x = rect.x0; x < rect.x1; ++x, texel += kChannels)
                    if (*(texel + 1) != 0)
                        greatest = std::max(greatest, static_cast<float>(*texel) * texelFactor(x, y, size));
        }
    }
    if (greatest > kFull16) {
        const GroupSetting& range = groupSetting(QLatin1StringView("greatest_length_m"));
        const double most = range.greatest / std::max(range.read(settings), 1e-9);
        range.write(settings, range.read(settings) * std::min(static_cast<double>(greatest / kFull16), most));
        longer.maps = withRange(longer, settings).maps;
        result = &longer.maps[static_cast<std::size_t>(MapKind::Length)];
    }
    MapStack& stack = result->write();
    for (std::size_t number = 0; number < stack.layers.size(); ++number) {
        Layer& layer = stack.layers[number];
        if (!isProportional(layer.blend))
            continue;
        const bool coversAll = number == 0 && isPlain(layer);
        std::vector<sim::RasterTilePtr> made(tiles.size());
        sim::parallelFor(tiles.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const sim::RasterTile& tile = *layer.raster.tile(tiles[i]);
                if (!coversAll && tile.isUniform() && tile.uniform[1] == 0) {
                    made[i] = layer.raster.tile(tiles[i]);
                    continue;
                }
                sim::RasterTile changed{.uniform = {}, .pixels = sim::expanded(tile, kChannels)};
                const sim::TexelRect rect = layer.raster.tileRect(tiles[i]);
                auto texel = changed.pixels.begin();
                for (int y = rect.y0; y < rect.y1; ++y)
                    for (int x = rect.x0; x < rect.x1; ++x, texel += kChannels) {
                        const float factor = texelFactor(x, y, size);
                        if (factor == 1.0F)
                            continue;
                        if (coversAll && *(texel + 1) != 65535) {
                            *texel = lerp16(spec.defaultValue[0], *texel, *(texel + 1));
                            *(texel + 1) = 65535;
                        }
                        *texel = unit16(static_cast<float>(*texel) / kFull16 * factor);
                    }
                made[i] = std::make_shared<const sim::RasterTile>(sim::folded(std::move(changed)));
            }
        });
        for (std::size_t i = 0; i < tiles.size(); ++i)
            if (made[i] != layer.raster.tile(tiles[i]))
                layer.raster.setTile(tiles[i], std::move(made[i]));
    }
    return *result;
}

} // namespace hairpaint::model
