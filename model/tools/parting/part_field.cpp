// Distances and directions about a curve at samples of the layout, and the texels between.
#include "model/tools/parting/part_field.h"

#include "model/values/texel_math.h"
#include "sim/base/parallel.h"
#include "sim/base/rounded.h"
#include "sim/groom/direction_texel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace hairpaint::model {

namespace {

/// In rows of `across`.
std::size_t indexOf(int column, int row, int across)
{
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(across) + static_cast<std::size_t>(column);
}

constexpr float kFullReach = 0.6F;  ///< Fraction of the reach within which the parting alone says how hair lies.
constexpr float kPastEndM = 0.008F; ///< Distance past its ends within which a parting still lays hair fully.
/// Distance past its ends at which a parting has no effect any more, or its reach if that is less.
constexpr float kEndFadeM = 0.04F;
constexpr float kLaidBack = 0.35F;    ///< Weight of backward against 1 for sideways, on top and at the forehead.
constexpr float kOutward = 1.5F;      ///< Weight of onward past a parting's ends, where both sides meet.
constexpr float kBlurM = 0.003F;      ///< Distance within which a nearer piece of the curve weighs no more.
constexpr float kFacesAway = -0.3F;   ///< Cosine between normals: the other side of something thin.
constexpr float kLeastGapTx = 0.6F;   ///< Half a gap's width.
constexpr float kGapSoftness = 0.35F; ///< Width of a gap's soft edge, as a fraction of half the gap's width.
constexpr float kLeastSoftnessTx = 0.5F;
constexpr float kOneIslandM = 0.02F; ///< Samples further apart are no neighbours.
constexpr float kCloseM = 0.004F;    ///< Further from the curve than this its two sides do not meet.

/// 0 up to `from`, 1 past `to`.
float eased(float from, float to, float x)
{
    const float t = std::clamp((x - from) / std::max(to - from, 1e-9F), 0.0F, 1.0F);
    return t * t * (3.0F - 2.0F * t);
}

} // namespace

PartCurve ledToHairline(const sim::Skin& skin, const std::vector<sim::SurfacePoint>& points,
                        const sim::TiledRaster& density, PartLook& look)
{
    PartCurve curve(skin, points);
    if (curve.empty())
        return curve;
    std::vector<sim::SurfacePoint> all = pointsToHairline(skin, curve, false, density);
    const std::vector<sim::SurfacePoint> after = pointsToHairline(skin, curve, true, density);
    if (all.empty() && after.empty())
        return curve;
    std::ranges::reverse(all);
    const std::size_t first = all.size();
    const std::size_t last = first + points.size() - 1;
    all.insert(all.end(), points.begin(), points.end());
    all.insert(all.end(), after.begin(), after.end());
    PartCurve led(skin, all);
    const std::vector<PartCurve::Sample>& samples = led.samples();
    const auto alongM = [&](std::size_t point) {
        const auto at = std::ranges::lower_bound(samples, point, {}, &PartCurve::Sample::point);
        return at != samples.end() ? at->alongM : led.lengthM();
    };
    look.leadInM = alongM(first);
    look.leadOutM = after.empty() ? 0.0F : led.lengthM() - alongM(last);
    return led;
}

PartField::PartField(SkinFrames& frames, PartCurve curve, const PartLook& look)
    : m_look(look), m_curve(std::move(curve)), m_zigzag(look.zigzagM, partedM())
{
    if (m_curve.empty())
        return;
    m_lowHd = glm::vec3(std::numeric_limits<float>::max());
    m_highHd = -m_lowHd;
    for (const PartCurve::Sample& sample : m_curve.samples()) {
        m_lowHd = glm::min(m_lowHd, sample.positionHd - m_look.reachM);
        m_highHd = glm::max(m_highHd, sample.positionHd + m_look.reachM);
    }
    m_tiles.resize(std::size_t{kTilesAcross} * kTilesAcross);
    const std::vector<int> near = tilesNear(frames.skin().mesh());
    for (const int tile : near) // Fills the table, which one thread alone may.
        (void)frames.point(tile % kTilesAcross * SkinFrames::kTileSide, tile / kTilesAcross * SkinFrames::kTileSide);
    sim::parallelFor(near.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            fill(m_tiles[static_cast<std::size_t>(near[i])], near[i], frames);
    });
}

void PartField::fill(Tile& tile, int index, SkinFrames& frames) const
{
    const int left = index % kTilesAcross * SkinFrames::kTileSide;
    const int top = index / kTilesAcross * SkinFrames::kTileSide;
    tile.samples.resize(std::size_t{kTileSide} * kTileSide);
    tile.nearestM = std::numeric_limits<float>::max();
    auto sample = tile.samples.begin();
    for (int y = 0; y < kTileSide; ++y)
        for (int x = 0; x < kTileSide; ++x, ++sample)
            if (const std::optional<FramedPoint>& skin = frames.point(left + x * kStride, top + y * kStride)) {
                *sample = sampleOf(*skin);
                if (*sample)
                    tile.nearestM = std::min(tile.nearestM, sim::hypotRounded((*sample)->lateralM, (*sample)->beyondM));
            }
}

/// Tiles of SkinFrames into which a face of the mesh that comes into reach is unfolded.
std::vector<int> PartField::tilesNear(const sim::HeadMesh& mesh) const
{
    constexpr int kAcross = kTilesAcross;
    std::array<bool, std::size_t{kAcross} * kAcross> marked{};
    for (const glm::uvec3& face : mesh.triangles) {
        const std::array corners{mesh.positionsHd[face.x], mesh.positionsHd[face.y], mesh.positionsHd[face.z]};
        const glm::vec3 low = glm::min(corners[0], glm::min(corners[1], corners[2]));
        const glm::vec3 high = glm::max(corners[0], glm::max(corners[1], corners[2]));
        if (glm::any(glm::lessThan(high, m_lowHd)) || glm::any(glm::greaterThan(low, m_highHd)))
            continue;
        const glm::vec3 middle = 0.5F * (low + high);
        const float limit = m_look.reachM + 0.5F * glm::distance(low, high);
        const bool near = std::ranges::any_of(m_curve.samples(), [&](const PartCurve::Sample& sample) {
            const glm::vec3 away = sample.positionHd - middle;
            return glm::dot(away, away) < limit * limit;
        });
        if (!near)
            continue;
        const std::array uvs{mesh.uvs[face.x], mesh.uvs[face.y], mesh.uvs[face.z]};
        const auto tileOf = [](glm::vec2 uv) {
            return glm::clamp(glm::ivec2(glm::floor(glm::vec2(uv.x, 1.0F - uv.y) * static_cast<float>(kAcross))),
                              glm::ivec2(0), glm::ivec2(kAcross - 1));
        };
        const glm::vec2 lowUv = glm::min(uvs[0], glm::min(uvs[1], uvs[2]));
        const glm::vec2 highUv = glm::max(uvs[0], glm::max(uvs[1], uvs[2]));
        const glm::ivec2 first = tileOf({lowUv.x, highUv.y});
        const glm::ivec2 last = tileOf({highUv.x, lowUv.y});
        for (int row = first.y; row <= last.y; ++row)
            for (int column = first.x; column <= last.x; ++column)
                marked.at(indexOf(column, row, kAcross)) = true;
    }
    std::vector<int> tiles;
    for (std::size_t i = 0; i < marked.size(); ++i)
        if (marked.at(i))
            tiles.push_back(static_cast<int>(i));
    return tiles;
}

float PartField::endFadeM() const
{
    return std::min(kEndFadeM, m_look.reachM);
}

/// None out of reach.
std::optional<PartField::Sample> PartField::sampleOf(const FramedPoint& skin) const
{
    if (glm::any(glm::lessThan(skin.positionHd, m_lowHd)) || glm::any(glm::greaterThan(skin.positionHd, m_highHd)))
        return std::nullopt;
    const std::vector<PartCurve::Sample>& samples = m_curve.samples();
    glm::vec3 tangents(0.0F);
    glm::vec3 awayHd(0.0F);
    float nearest = std::numeric_limits<float>::max();
    std::size_t piece = 0;
    float within = 0.0F;
    for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
        const glm::vec3 from = samples[i].positionHd;
        const glm::vec3 edge = samples[i + 1].positionHd - from;
        const float t =
            std::clamp(glm::dot(skin.positionHd - from, edge) / std::max(glm::dot(edge, edge), 1e-12F), 0.0F, 1.0F);
        const glm::vec3 away = skin.positionHd - (from + edge * t);
        const float square = glm::dot(away, away);
        // Every piece says where its right lies, the nearest loudest: far out, the field of a bent curve is smooth.
        const float blurred = square + kBlurM * kBlurM;
        tangents += edge * (1.0F / (blurred * blurred));
        if (square < nearest) {
            nearest = square;
            awayHd = away;
            piece = i;
            within = t;
        }
    }
    if (nearest > m_look.reachM * m_look.reachM)
        return std::nullopt;
    const PartCurve::Sample& a = samples[piece];
    const PartCurve::Sample& b = samples[piece + 1];
    if (glm::dot(a.normalHd, skin.frame.normal) < kFacesAway)
        return std::nullopt;
    const glm::vec2 right = skin.frame.fromHd(glm::cross(tangents, skin.frame.normal));
    const float length = glm::length(right);
    if (length <= 0.0F)
        return std::nullopt;
    Sample sample{.positionHd = skin.positionHd, .right = right / length, .frame = skin.frame};
    glm::vec3 outHd(0.0F);
    if (piece == 0 && within <= 0.0F)
        outHd = -a.tangentHd;
    else if (piece + 2 == samples.size() && within >= 1.0F)
        outHd = b.tangentHd;
    sample.beyondM = std::max(glm::dot(awayHd, outHd), 0.0F);
    const float turned = kOutward * eased(0.0F, endFadeM(), sample.beyondM);
    const float combed = std::clamp(std::max(skin.frame.normal.y, skin.frame.normal.z), 0.0F, 1.0F);
    const glm::vec2 back = skin.frame.fromHd({0.0F, 0.0F, -kLaidBack * combed});
    sample.shared = back - sample.right * glm::dot(back, sample.right) + skin.frame.fromHd(outHd) * turned;
    const glm::vec3 rightHd = glm::mix(a.rightHd(), b.rightHd(), within);
    const float sideM = std::sqrt(std::max(nearest - sample.beyondM * sample.beyondM, 0.0F));
    sample.lateralM = std::copysign(sideM, glm::dot(awayHd, rightHd));
    sample.alongM = glm::mix(a.alongM, b.alongM, within);
    return sample;
}

const PartField::Sample* PartField::entry(int x, int y) const
{
    const Tile& tile = m_tiles[indexOf(x / kTileSide, y / kTileSide, kTilesAcross)];
    if (tile.samples.empty())
        return nullptr;
    const std::optional<Sample>& sample = tile.samples[indexOf(x % kTileSide, y % kTileSide, kTileSide)];
    return sample ? &*sample : nullptr;
}

/// Between the samples around it that lie on its island; none out of reach.
std::optional<PartField::Sample> PartField::at(glm::vec2 uv) const
{
    constexpr float kPerUv = SkinFrames::kSize;
    const glm::vec2 onTable =
        glm::clamp((glm::vec2(uv.x, 1.0F - uv.y) * kPerUv - 0.5F) / static_cast<float>(kStride), 0.0F, kSize - 1.0F);
    const glm::ivec2 corner(glm::floor(onTable));
    const glm::vec2 fraction = onTable - glm::vec2(corner);
    std::array<std::pair<const Sample*, float>, 4> around{};
    const Sample* nearest = nullptr;
    float nearestWeight = 0.0F;
    for (int k = 0; k < 4; ++k) {
        const glm::ivec2 there = glm::min(corner + glm::ivec2(k % 2, k / 2), kSize - 1);
        const float weight =
            (k % 2 == 0 ? 1.0F - fraction.x : fraction.x) * (k / 2 == 0 ? 1.0F - fraction.y : fraction.y);
        const Sample* sample = entry(there.x, there.y);
        around[static_cast<std::size_t>(k)] = {sample, weight};
        if (sample != nullptr && weight >= nearestWeight) {
            nearest = sample;
            nearestWeight = weight;
        }
    }
    if (nearest == nullptr)
        return std::nullopt;
    Sample sum{.frame = nearest->frame};
    float weights = 0.0F;
    for (const auto& [sample, weight] : around) {
        // Between two windings of a curve the left of one meets the right of the other: no parting lies there.
        if (sample == nullptr || glm::dot(sample->frame.x, nearest->frame.x) < SkinFrames::kAlike ||
            glm::dot(sample->frame.normal, nearest->frame.normal) < SkinFrames::kAlike ||
            glm::distance(sample->positionHd, nearest->positionHd) > kOneIslandM ||
            (sample->lateralM * nearest->lateralM < 0.0F && std::abs(nearest->lateralM) > kCloseM))
            continue;
        sum.right += sample->right * weight;
        sum.shared += sample->shared * weight;
        sum.lateralM += sample->lateralM * weight;
        sum.alongM += sample->alongM * weight;
        sum.beyondM += sample->beyondM * weight;
        weights += weight;
    }
    const float length = glm::length(sum.right);
    if (weights <= 0.0F || length <= 0.0F)
        return *nearest;
    sum.right /= length;
    sum.shared /= weights;
    sum.lateralM /= weights;
    sum.alongM /= weights;
    sum.beyondM /= weights;
    return sum;
}

std::vector<int> PartField::tilesWithin(float distanceM, int size) const
{
    constexpr float kBetweenM = 0.005F; // Something may lie so much nearer than the samples around it.
    const int across = size / kTile;
    std::vector<int> tiles;
    for (int row = 0; row < across && !m_tiles.empty(); ++row)
        for (int column = 0; column < across; ++column) {
            // Tiles of the map and of the table differ in size; each smaller one lies within one larger one.
            bool any = false;
            for (int y = row * kTilesAcross / across; !any && y * across < (row + 1) * kTilesAcross; ++y)
                for (int x = column * kTilesAcross / across; !any && x * across < (column + 1) * kTilesAcross; ++x) {
                    const Tile& tile = m_tiles[indexOf(x, y, kTilesAcross)];
                    any = !tile.samples.empty() && tile.nearestM < distanceM + kBetweenM;
                }
            if (any)
                tiles.push_back(row * across + column);
        }
    return tiles;
}

std::vector<int> PartField::gapTiles(int size) const
{
    return m_look.gapM > 0.0F ? tilesWithin(2.0F * halfGapM(size) + m_look.zigzagM, size) : std::vector<int>();
}

Zigzag::Offset PartField::zigzagAt(float alongM) const
{
    const float partedAtM = alongM - m_look.leadInM;
    return partedAtM > 0.0F && partedAtM < partedM() ? m_zigzag.at(partedAtM) : Zigzag::Offset{};
}

float PartField::halfGapM(int size) const
{
    return std::max(0.5F * m_look.gapM, kLeastGapTx * m_curve.mPerUv() / static_cast<float>(size));
}

template<typename Visit>
void PartField::forTexels(int tileIndex, int size, const Visit& visit) const
{
    const int across = size / kTile;
    const float step = 1.0F / static_cast<float>(size);
    const int leftTx = tileIndex % across * kTile;
    const int topTx = tileIndex / across * kTile;
    const auto left = static_cast<float>(leftTx);
    const auto top = static_cast<float>(topTx);
    std::size_t texel = 0;
    for (int y = 0; y < kTile; ++y)
        for (int x = 0; x < kTile; ++x, ++texel) {
            const glm::vec2 uv((left + static_cast<float>(x) + 0.5F) * step,
                               1.0F - (top + static_cast<float>(y) + 0.5F) * step);
            if (const std::optional<Sample> sample = at(uv))
                visit(texel, *sample);
        }
}

PartField::LaidTile PartField::laid(int tileIndex, int size) const
{
    LaidTile tile;
    tile.values.assign(sim::kTileTexels * 2, static_cast<std::uint16_t>(sim::kDirectionZero));
    forTexels(tileIndex, size, [&](std::size_t texel, const Sample& sample) {
        const float outM = std::abs(sample.lateralM);
        tile.mask.at(texel) =
            unit16((1.0F - eased(kFullReach * m_look.reachM, m_look.reachM, outM)) *
                   (1.0F - eased(std::min(kPastEndM, 0.5F * endFadeM()), endFadeM(), sample.beyondM)));
        const float side = sample.lateralM < zigzagAt(sample.alongM).lateralM ? -1.0F : 1.0F;
        const glm::vec2 direction = sample.right * side + sample.shared;
        const float length = std::max(glm::length(direction), 1e-3F);
        const sim::Texel stored = sim::texelOfDirection(direction * (m_look.flatness / length));
        std::copy_n(stored.begin(), 2, tile.values.begin() + static_cast<std::ptrdiff_t>(2 * texel));
    });
    return tile;
}

StrokeBuffer::MaskTile PartField::gap(int tileIndex, int size) const
{
    StrokeBuffer::MaskTile mask{};
    const float texelM = m_curve.mPerUv() / static_cast<float>(size);
    const float halfM = halfGapM(size);
    const float softM = std::max(kGapSoftness * halfM, kLeastSoftnessTx * texelM);
    forTexels(tileIndex, size, [&](std::size_t texel, const Sample& sample) {
        const Zigzag::Offset zigzag = zigzagAt(sample.alongM);
        const float alongM = sample.alongM - m_look.leadInM;
        const float beyondM = std::max(sample.beyondM, std::max(-alongM, alongM - partedM()));
        const float sideM = (sample.lateralM - zigzag.lateralM) / std::sqrt(1.0F + zigzag.slope * zigzag.slope);
        mask.at(texel) =
            unit16(1.0F - eased(halfM - softM, halfM + softM, sim::hypotRounded(sideM, std::max(beyondM, 0.0F))));
    });
    return mask;
}

} // namespace hairpaint::model
