// Rasters and lights the head.
#include "view/rendering/software/head_kernel.h"

#include "sim/base/rounded.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "view/rendering/software/head_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.
#include "view/rendering/light/lanes_inl.h"
#include "view/rendering/light/skin_light_inl.h"
#include "view/rendering/light/tone_inl.h"
#include "view/rendering/software/grid_lookup_inl.h"
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace hairpaint::rendering::HWY_NAMESPACE {

constexpr std::int32_t kVertexFloats = sizeof(HeadVertex) / sizeof(float);
constexpr int kNoTriangle = -1;

/// Sixteen points in a sample at which its cover is taken, each alone in its row and column.
alignas(64) constexpr float kSampleX[kMostLanes] = {0.53125F, 0.78125F, 0.21875F, 0.96875F, 0.34375F, 0.65625F,
                                                    0.09375F, 0.84375F, 0.46875F, 0.03125F, 0.71875F, 0.28125F,
                                                    0.90625F, 0.15625F, 0.59375F, 0.40625F};
alignas(64) constexpr float kSampleY[kMostLanes] = {0.03125F, 0.09375F, 0.15625F, 0.21875F, 0.28125F, 0.34375F,
                                                    0.40625F, 0.46875F, 0.53125F, 0.59375F, 0.65625F, 0.71875F,
                                                    0.78125F, 0.84375F, 0.90625F, 0.96875F};

/// A side of a triangle: a x + b y + c, over 0 inside.
struct Side
{
    float a, b, c;
};
HWY_INLINE Side sideOf(const HeadVertex& from, const HeadVertex& to, float turn, float x, float y)
{
    const float a = (from.y - to.y) * turn;
    const float b = (to.x - from.x) * turn;
    return {a, b, -(a * (from.x - x) + b * (from.y - y))};
}

/// Linear value of an sRGB byte.
float linearOf(std::uint8_t encoded)
{
    const float x = static_cast<float>(encoded) / 255.0F;
    return x <= 0.04045F ? x / 12.92F : sim::powRounded((x + 0.055F) / 1.055F, 2.4F);
}

const std::array<float, 256>& linearTable()
{
    static const std::array<float, 256> table = [] {
        std::array<float, 256> values{};
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = linearOf(static_cast<std::uint8_t>(i));
        return values;
    }();
    return table;
}

/// Bilinear sample of a texture that repeats: linear colour, and alpha.
glm::vec4 texelAt(const sim::MeshTexture& texture, float u, float v)
{
    const auto width = static_cast<float>(texture.width);
    const auto height = static_cast<float>(texture.height);
    const float x = (u - std::floor(u)) * width - 0.5F;
    const float y = (1.0F - (v - std::floor(v))) * height - 0.5F;
    const float left = std::floor(x);
    const float top = std::floor(y);
    const std::array<float, 256>& table = linearTable();
    glm::vec4 sum(0.0F);
    for (int i = 0; i < 4; ++i) {
        const int dx = i & 1;
        const int dy = i >> 1;
        const auto wrapped = [](int at, std::uint32_t side) {
            const auto s = static_cast<int>(side);
            return static_cast<std::size_t>((at % s + s) % s);
        };
        const std::size_t column = wrapped(static_cast<int>(left) + dx, texture.width);
        const std::size_t row = wrapped(static_cast<int>(top) + dy, texture.height);
        const std::uint8_t* texel = texture.rgba.data() + (row * texture.width + column) * 4;
        const float weight = (dx == 1 ? x - left : 1.0F - (x - left)) * (dy == 1 ? y - top : 1.0F - (y - top));
        sum += weight * glm::vec4(table[texel[0]], table[texel[1]], table[texel[2]],
                                  static_cast<float>(texel[3]) * (1.0F / 255.0F));
    }
    return sum;
}

struct BandScratch
{
    std::vector<std::int32_t> triangle; ///< Number of the nearest triangle at each sample.
    std::vector<std::uint16_t> cover;   ///< Points of each sample that are covered, a bit a point.
};

HWY_INLINE void rasterTriangle(const HeadBand& band, std::uint32_t number, BandScratch& scratch)
{
    const glm::uvec3 corners = band.triangles[number];
    const HeadVertex& a = band.vertices[corners.x];
    const HeadVertex& b = band.vertices[corners.y];
    const HeadVertex& c = band.vertices[corners.z];
    const int left = std::max(static_cast<int>(std::floor(std::min({a.x, b.x, c.x}))), 0);
    const int right = std::min(static_cast<int>(std::floor(std::max({a.x, b.x, c.x}))), band.width - 1);
    const int low = std::max(static_cast<int>(std::floor(std::min({a.y, b.y, c.y}))), band.firstRow);
    const int high = std::min(static_cast<int>(std::floor(std::max({a.y, b.y, c.y}))), band.endRow - 1);
    const float area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    if (left > right || low > high || area == 0.0F)
        return;
    const float turn = area > 0.0F ? 1.0F : -1.0F;
    // Relative to the corner of the box, so that large pictures lose nothing.
    const auto x0 = static_cast<float>(left);
    const auto y0 = static_cast<float>(low);
    const Side sides[3] = {sideOf(b, c, turn, x0, y0), sideOf(c, a, turn, x0, y0), sideOf(a, b, turn, x0, y0)};
    const float perArea = 1.0F / (area * turn);
    // 1/distance is linear on the picture.
    const float weights[3] = {a.perDistance * perArea, b.perDistance * perArea, c.perDistance * perArea};
    const float farthest = std::min({a.perDistance, b.perDistance, c.perDistance});
    const float nearestCorner = std::max({a.perDistance, b.perDistance, c.perDistance});
    for (int y = low; y <= high; ++y)
        for (int x = left; x <= right; ++x) {
            const auto dx = static_cast<float>(x - left);
            const auto dy = static_cast<float>(y - low);
            std::uint32_t inside = 0;
            for (std::size_t lane = 0; lane < kMostLanes; lane += hn::Lanes(Tag())) {
                const Lanes px = loaded(kSampleX + lane) + Lanes(dx);
                const Lanes py = loaded(kSampleY + lane) + Lanes(dy);
                const auto on = [&](const Side& side) {
                    return px * Lanes(side.a) + py * Lanes(side.b) + Lanes(side.c);
                };
                const Yes hit = {hn::Ge(least(least(on(sides[0]), on(sides[1])), on(sides[2])).v, hn::Zero(Tag()))};
                HWY_ALIGN std::uint8_t bits[8] = {};
                hn::StoreMaskBits(Tag(), hit.m, bits);
                inside |= (static_cast<std::uint32_t>(bits[0]) | (static_cast<std::uint32_t>(bits[1]) << 8U)) << lane;
            }
            if (inside == 0)
                continue;
            float per = 0.0F;
            for (int i = 0; i < 3; ++i)
                per += (sides[i].a * (dx + 0.5F) + sides[i].b * (dy + 0.5F) + sides[i].c) * weights[i];
            // Where the triangle covers a sample's rim only, its middle lies outside.
            const float distance = 1.0F / std::clamp(per, farthest, nearestCorner);
            if (band.isMasked) {
                glm::vec2 uv(0.0F);
                const HeadVertex* const vertices[3] = {&a, &b, &c};
                for (int i = 0; i < 3; ++i)
                    uv += (sides[i].a * (dx + 0.5F) + sides[i].b * (dy + 0.5F) + sides[i].c) * weights[i] * distance *
                          vertices[i]->uv;
                if (texelAt(*band.texture, uv.x, uv.y).w < 0.5F)
                    continue;
            }
            const std::size_t at = static_cast<std::size_t>(y - band.firstRow) * static_cast<std::size_t>(band.width) +
                                   static_cast<std::size_t>(x);
            float& nearest = band.distancesM[static_cast<std::size_t>(y) * static_cast<std::size_t>(band.width) +
                                             static_cast<std::size_t>(x)];
            scratch.cover[at] = static_cast<std::uint16_t>(scratch.cover[at] | inside);
            if (distance < nearest) {
                nearest = distance;
                scratch.triangle[at] = static_cast<std::int32_t>(number);
            }
        }
}

/// Lights up to a vector's samples of a row.
HWY_INLINE void lightSamples(const HeadBand& band, const std::int32_t* xs, const std::int32_t* numbers, int row,
                             std::size_t count)
{
    const Tag d;
    const IntTag di;
    const Ints number = hn::LoadU(di, numbers);
    const auto corner = [&](int i) {
        const auto* indices = reinterpret_cast<const std::int32_t*>(band.triangles.data());
        return hn::Mul(hn::GatherIndex(di, indices + i, hn::Mul(number, hn::Set(di, 3))), hn::Set(di, kVertexFloats));
    };
    const Ints corners[3] = {corner(0), corner(1), corner(2)};
    const float* vertices = &band.vertices[0].x;
    const auto field = [&](int i, int f) { return Lanes(hn::GatherIndex(d, vertices + f, corners[i])); };
    const Lanes x = Lanes(hn::ConvertTo(d, hn::LoadU(di, xs))) + Lanes(0.5F);
    const Lanes y(static_cast<float>(row) + 0.5F);
    Lanes vx[3];
    Lanes vy[3];
    for (int i = 0; i < 3; ++i) {
        vx[i] = field(i, 0) - x;
        vy[i] = field(i, 1) - y;
    }
    // How much of each corner, by the areas opposite it and the distances.
    const auto opposite = [&](int i, int j) { return vx[i] * vy[j] - vx[j] * vy[i]; };
    Lanes part[3] = {opposite(1, 2), opposite(2, 0), opposite(0, 1)};
    const Lanes area = part[0] + part[1] + part[2];
    const Lanes perArea = Lanes(1.0F) / select(area * area > Lanes(1e-20F), area, Lanes(1.0F));
    Lanes sum(0.0F);
    for (int i = 0; i < 3; ++i) {
        part[i] = most(part[i] * perArea, Lanes(0.0F)) * field(i, 2);
        sum = sum + part[i];
    }
    const Lanes perSum = Lanes(1.0F) / most(sum, Lanes(1e-9F));
    for (Lanes& p : part)
        p = p * perSum;
    const auto blended = [&](int f) { return field(0, f) * part[0] + field(1, f) * part[1] + field(2, f) * part[2]; };
    SkinPoint<Lanes> point;
    point.positionWo = {blended(3), blended(4), blended(5)};
    point.normalWo = {blended(6), blended(7), blended(8)};
    point.positionHd = {blended(9), blended(10), blended(11)};
    point.sky = blended(12);
    point.lips = blended(13);
    point.lids = blended(14);
    point.blush = blended(15);
    point.isTinted = band.isTinted;
    point.tint = {Lanes(0.0F), Lanes(0.0F), Lanes(0.0F)};
    point.untinted = Lanes(1.0F);
    if (point.isTinted) {
        point.tint = {blended(16), blended(17), blended(18)};
        point.untinted = Lanes(1.0F) - blended(19);
    }
    if (band.texture != nullptr) {
        HWY_ALIGN float uv[2][kMostLanes] = {};
        hn::Store(blended(20).v, d, uv[0]);
        hn::Store(blended(21).v, d, uv[1]);
        HWY_ALIGN float tint[3][kMostLanes] = {};
        for (std::size_t i = 0; i < count; ++i) {
            const glm::vec4 texel = texelAt(*band.texture, uv[0][i], uv[1][i]);
            for (int c = 0; c < 3; ++c)
                tint[c][i] = texel[c] * band.textureColour[c];
        }
        point.isTinted = true; // The scalp's tint lies over the texture.
        point.tint = point.tint + Triple<Lanes>{Lanes(hn::Load(d, tint[0])), Lanes(hn::Load(d, tint[1])),
                                                Lanes(hn::Load(d, tint[2]))} *
                                      point.untinted;
        point.untinted = Lanes(0.0F);
    }
    Triple<Lanes> normal = unit(point.normalWo);
    const Triple<Lanes> toEye = unit(tripleOf<Lanes>(band.lighting.eyeWo) - point.positionWo);
    const Lanes facing = dot(normal, toEye);
    point.normalWo = select(facing < Lanes(-0.3F), normal * Lanes(-1.0F), normal);
    const Lanes distance = Lanes(1.0F) / most(sum, Lanes(1e-6F));
    point.pixelM = distance * Lanes(1.4142F / band.samplesPerM) / most(facing, Lanes(0.15F));
    const Triple<Lanes> lit = skinLight(band.lighting, point);
    const auto encoded = [&](Lanes c) {
        return hn::ConvertTo(
            di, (root(clamped(c * Lanes(1.0F / kMostLight), 0.0F, 1.0F)) * Lanes(65535.0F) + Lanes(0.5F)).v);
    };
    HWY_ALIGN std::int32_t rgb[3][kMostLanes] = {};
    hn::Store(encoded(lit.x), di, rgb[0]);
    hn::Store(encoded(lit.y), di, rgb[1]);
    hn::Store(encoded(lit.z), di, rgb[2]);
    for (std::size_t i = 0; i < count; ++i) {
        HeadSample& sample = band.samples[static_cast<std::size_t>(row) * static_cast<std::size_t>(band.width) +
                                          static_cast<std::size_t>(xs[i])];
        sample.red = static_cast<std::uint16_t>(rgb[0][i]);
        sample.green = static_cast<std::uint16_t>(rgb[1][i]);
        sample.blue = static_cast<std::uint16_t>(rgb[2][i]);
    }
}

void drawBand(const HeadBand& band)
{
    const auto rows = static_cast<std::size_t>(band.endRow - band.firstRow);
    const std::size_t count = rows * static_cast<std::size_t>(band.width);
    BandScratch scratch;
    scratch.triangle.assign(count, kNoTriangle);
    scratch.cover.assign(count, 0);
    for (const std::uint32_t number : band.numbers)
        rasterTriangle(band, number, scratch);
    for (int row = band.firstRow; row < band.endRow; ++row) {
        HWY_ALIGN std::int32_t xs[kMostLanes] = {};
        HWY_ALIGN std::int32_t numbers[kMostLanes] = {};
        std::size_t held = 0;
        const std::size_t inBand = static_cast<std::size_t>(row - band.firstRow) * static_cast<std::size_t>(band.width);
        const std::int32_t* triangles = scratch.triangle.data() + inBand;
        const std::uint16_t* cover = scratch.cover.data() + inBand;
        HeadSample* samples = band.samples + static_cast<std::size_t>(row) * static_cast<std::size_t>(band.width);
        for (int x = 0; x < band.width; ++x) {
            if (cover[x] != 0)
                samples[x].cover = static_cast<std::uint16_t>(
                    std::min(samples[x].cover + std::popcount(cover[x]) * 65535 / 16, 65535));
            if (triangles[x] == kNoTriangle)
                continue;
            if (band.worn != nullptr)
                band.worn[static_cast<std::size_t>(row) * static_cast<std::size_t>(band.width) +
                          static_cast<std::size_t>(x)] = 1;
            xs[held] = x;
            numbers[held] = triangles[x];
            if (++held == hn::Lanes(Tag())) {
                lightSamples(band, xs, numbers, row, held);
                held = 0;
            }
        }
        if (held > 0) {
            // Unused lanes repeat the last sample.
            for (std::size_t i = held; i < hn::Lanes(Tag()); ++i) {
                xs[i] = xs[held - 1];
                numbers[i] = numbers[held - 1];
            }
            lightSamples(band, xs, numbers, row, held);
        }
    }
}

/// Whether any of `count` cells of a row shows the head.
HWY_INLINE bool isHeadIn(const ShadeTask& task, int row, int cell, int count)
{
    const int x0 = cell * task.cellSp.x;
    const int x1 = std::min((cell + count) * task.cellSp.x, task.width);
    const int y1 = std::min((row + 1) * task.cellSp.y, task.height);
    for (int y = row * task.cellSp.y; y < y1; ++y) {
        if (task.rowHasHead[y] == 0)
            continue;
        const float* distances = task.distancesM + static_cast<std::size_t>(y) * static_cast<std::size_t>(task.width);
        Lanes nearest(kNoHeadM);
        int x = x0;
        for (; x + static_cast<int>(hn::Lanes(Tag())) <= x1; x += static_cast<int>(hn::Lanes(Tag())))
            nearest = least(nearest, loaded(distances + x));
        bool head = any(nearest < Lanes(kNoHeadM));
        for (; x < x1; ++x)
            head = head || distances[x] < kNoHeadM;
        if (head)
            return true;
    }
    return false;
}

void shadeRows(const ShadeTask& task, int begin, int end)
{
    constexpr float kCellPoints[5][2] = {{0.5F, 0.5F}, {0.1F, 0.1F}, {0.9F, 0.1F}, {0.1F, 0.9F}, {0.9F, 0.9F}};
    const std::size_t step = hn::Lanes(Tag());
    for (int row = begin; row < end; ++row)
        for (int cell = 0; cell < task.across; cell += static_cast<int>(step)) {
            HWY_ALIGN float atX[kMostLanes] = {};
            HWY_ALIGN float atY[kMostLanes] = {};
            HWY_ALIGN float distance[kMostLanes];
            std::fill_n(distance, kMostLanes, kNoHeadM);
            const int count = std::min(static_cast<int>(step), task.across - cell);
            const bool near = isHeadIn(task, row, cell, count);
            bool head = false;
            for (int i = 0; i < count; ++i) {
                atX[i] = (static_cast<float>(cell + i) + 0.5F) * static_cast<float>(task.cellSp.x);
                atY[i] = (static_cast<float>(row) + 0.5F) * static_cast<float>(task.cellSp.y);
                for (const auto& position : kCellPoints) {
                    if (!near)
                        break;
                    const int x = std::min(static_cast<int>((static_cast<float>(cell + i) + position[0]) *
                                                            static_cast<float>(task.cellSp.x)),
                                           task.width - 1);
                    const int y = std::min(
                        static_cast<int>((static_cast<float>(row) + position[1]) * static_cast<float>(task.cellSp.y)),
                        task.height - 1);
                    const float here =
                        task.distancesM[static_cast<std::size_t>(y) * static_cast<std::size_t>(task.width) +
                                        static_cast<std::size_t>(x)];
                    if (here >= kNoHeadM)
                        continue;
                    atX[i] = static_cast<float>(x) + 0.5F;
                    atY[i] = static_cast<float>(y) + 0.5F;
                    distance[i] = here;
                    head = true;
                    break;
                }
            }
            float* out = task.shade + static_cast<std::size_t>(row) * static_cast<std::size_t>(task.across) +
                         static_cast<std::size_t>(cell);
            // The position at that distance on the ray through the sample: through the far plane, scaled.
            const Lanes px = loaded(atX) * Lanes(2.0F / task.sizeSp.x) - Lanes(1.0F);
            const Lanes py = loaded(atY) * Lanes(2.0F / task.sizeSp.y) - Lanes(1.0F);
            // Hair behind so many coverings was not drawn; gaps in front of it must not show what lies behind.
            const float aLittle = 1.5F / static_cast<float>(task.gridSide);
            const OpacityTwice hair = opacityTwice(task.opacity[1], task.gridSide,
                                                   inEyeGrid(task.eyeGrid, px, py, loaded(distance), aLittle));
            const Lanes coverings = task.inEveryColumn ? hair.inEveryColumn : hair.here;
            HWY_ALIGN float result[kMostLanes];
            stored(smoothStep(0.7F * task.undrawnCoverings, task.undrawnCoverings, coverings), result);
            std::copy_n(result, count, task.hidden + (out - task.shade));
            if (!head) {
                std::fill_n(out, count, 1.0F);
                continue;
            }
            const glm::mat4& m = task.woFromProjection;
            const auto far = [&](int r) {
                return px * Lanes(m[0][r]) + py * Lanes(m[1][r]) + Lanes(m[2][r] + m[3][r]);
            };
            const Lanes perW = Lanes(1.0F) / far(3);
            const Triple<Lanes> eye = tripleOf<Lanes>(task.eyeWo);
            const Triple<Lanes> ray = Triple<Lanes>{far(0) * perW, far(1) * perW, far(2) * perW} - eye;
            const Lanes along = loaded(distance) / dot(ray, tripleOf<Lanes>(task.viewAxisWo));
            const Triple<Lanes> wo = eye + ray * along;
            const Lanes fromLight =
                lightThrough(task.opacity[0], task.gridSide, inGrid(task.gridFromWo, wo, 0.0F), 0.6F);
            const Lanes toEye = lightThrough(task.opacity[1], task.gridSide,
                                             inEyeGrid(task.eyeGrid, px, py, loaded(distance), 0.0F), 2.0F);
            // Only the side of the head that is turned toward the light gets shadow.
            const Lanes sideX = wo.x - Lanes(task.headWo.x);
            const Lanes sideZ = wo.z - Lanes(task.headWo.z);
            const Lanes lit = smoothStep(-0.3F, 0.2F,
                                         (sideX * Lanes(task.lightWo.x) + sideZ * Lanes(task.lightWo.z)) /
                                             root(sideX * sideX + sideZ * sideZ + Lanes(1e-4F)));
            const Lanes shade = (Lanes(1.0F) - Lanes(0.65F) * lit * (Lanes(1.0F) - fromLight)) *
                                (Lanes(task.keptUnderHair) + Lanes(1.0F - task.keptUnderHair) * toEye);
            stored(shade, result);
            for (int i = 0; i < count; ++i)
                out[i] = distance[i] < kNoHeadM ? result[i] : 1.0F;
        }
}

} // namespace hairpaint::rendering::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hairpaint::rendering {

HWY_EXPORT(drawBand);
HWY_EXPORT(shadeRows);

void drawHeadBand(const HeadBand& band)
{
    HWY_DYNAMIC_DISPATCH(drawBand)(band);
}

void shadeSkin(const ShadeTask& task, int begin, int end)
{
    HWY_DYNAMIC_DISPATCH(shadeRows)(task, begin, end);
}

} // namespace hairpaint::rendering
#endif
