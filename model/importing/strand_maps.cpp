// StrandSums of strands at each texel of the skin, and maps of those.
#include "model/importing/strand_maps.h"

#include "model/importing/lock_estimate.h"
#include "model/importing/median.h"
#include "model/importing/outward_fill.h"
#include "model/importing/strand_sums.h"
#include "model/values/texel_math.h"
#include "sim/groom/braid_layout.h"
#include "sim/groom/direction_texel.h"
#include "sim/groom/groom.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::model {

namespace {

constexpr int kMostImportedNodes = 16;
constexpr float kWidestStrandM = 1e-3F;
constexpr float kThinnestStrandM = 10e-6F;
constexpr float kBraidEdge = 3.0F;
constexpr float kBraidInside = 6.0F; ///< A texel or two from there, so that no hair stands on the edge.

/// Values over a whole map.
template<typename Value>
struct MapValues
{
    std::vector<Value> values;
    std::vector<std::uint8_t> known;
    explicit MapValues(int size)
        : values(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), Value(0.0F)), known(values.size())
    {}
    void set(std::uint32_t texel, const Value& value)
    {
        values[texel] = value;
        known[texel] = 1;
    }
};

/// Writes `texelOf(number of the texel)` into the map's one layer.
template<typename TexelOf>
void writeLayer(HairGroup& group, MapKind kind, const TexelOf& texelOf)
{
    sim::TiledRaster& raster = group.map(kind).layers.front().raster;
    const auto channels = static_cast<std::size_t>(raster.channels());
    for (int tile = 0; tile < raster.tileCount(); ++tile) {
        const sim::TexelRect rect = raster.tileRect(tile);
        const std::span<std::uint16_t> pixels = raster.writableTile(tile);
        std::size_t at = 0;
        for (int y = rect.y0; y < rect.y1; ++y)
            for (int x = rect.x0; x < rect.x1; ++x) {
                const sim::Texel texel = texelOf(static_cast<std::size_t>(y) * static_cast<std::size_t>(raster.size()) +
                                                 static_cast<std::size_t>(x));
                std::copy_n(texel.begin(), channels, pixels.data() + at);
                at += channels;
            }
        raster.compact(tile);
    }
}

/// The next number of two digits.
float roundUp(float value)
{
    if (!(value > 0.0F))
        return 0.0F;
    const float step = std::pow(10.0F, std::floor(std::log10(value)) - 1.0F);
    return std::ceil(value / step * 0.9999F) * step;
}

/// Makes the maps and settings of one group.
class GroupMaker
{
public:
    GroupMaker(const HeadStrands& onHead, const SkinTexels& texels, const StrandSums& sums, double skinAreaM2)
        : m_onHead(onHead), m_texels(texels), m_sums(sums), m_skinAreaM2(skinAreaM2)
    {}

    [[nodiscard]] HairGroup fill(HairGroup group, bool hasColours) const
    {
        writeDensity(group);
        writeLength(group);
        writeCurl(group);
        writeBraids(group);
        writeGel(group);
        writeLocks(group);
        writeDirection(group);
        if (hasColours)
            writeColours(group);
        setFibre(group.settings);
        return group;
    }

private:
    /// `valueOf(sum)` where there is weight; other texels as those around.
    template<typename Value, typename ValueOf>
    [[nodiscard]] MapValues<Value> filled(const ValueOf& valueOf, float TexelSum::*weight = &TexelSum::weight) const
    {
        MapValues<Value> map(m_texels.size);
        for (std::size_t i = 0; i < m_texels.count(); ++i)
            if (m_sums.strands[i].*weight > 0.0F)
                map.set(m_texels.texel[i], valueOf(m_sums.strands[i]));
        fillOutward(static_cast<std::size_t>(m_texels.size), map.values, map.known);
        return map;
    }
    void writeScalar(HairGroup& group, MapKind kind, const std::vector<float>& values, float greatest) const
    {
        writeLayer(group, kind, [&](std::size_t texel) {
            return sim::Texel{unit16(std::clamp(values[texel] / greatest, 0.0F, 1.0F)), 65535};
        });
    }

    /// Beyond the outermost hairs of a braid none is told to grow: patches on both sides of a parting would become one.
    /// `inside`: weight; among hairs it is twelve.
    [[nodiscard]] static bool isBesideBraids(const TexelSum& sum, float inside)
    {
        return sum.weight < inside && 2.0F * sum.braided[0] < sum.weight;
    }

    void writeDensity(HairGroup& group) const
    {
        MapValues<float> map(m_texels.size);
        std::vector<float> some;
        for (std::size_t i = 0; i < m_texels.count(); ++i) {
            map.set(m_texels.texel[i],
                    isBesideBraids(m_sums.strands[i], kBraidInside) ? 0.0F : m_sums.strands[i].densityPerM2);
            if (m_sums.strands[i].densityPerM2 > 0.0F)
                some.push_back(m_sums.strands[i].densityPerM2);
        }
        // Beside an island's edge its own texels are read along with others.
        fillOutward(static_cast<std::size_t>(m_texels.size), map.values, map.known);
        // A few texels that are denser than all others would make candidates everywhere.
        constexpr std::size_t kOneOf = 200;
        float greatest = 0.0F;
        if (!some.empty()) {
            const auto high = some.begin() + static_cast<std::ptrdiff_t>(some.size() - 1 - some.size() / kOneOf);
            std::ranges::nth_element(some, high);
            greatest = *high;
        }
        greatest = std::clamp(roundUp(greatest), 1e4F, 4e6F);
        group.settings.greatestDensityPerM2 = greatest;
        writeScalar(group, MapKind::Density, map.values, greatest);
    }

    void writeLength(HairGroup& group) const
    {
        const auto map = filled<float>([](const TexelSum& sum) { return sum.lengthM / sum.weight; });
        const float greatest = std::clamp(roundUp(*std::ranges::max_element(map.values)), 0.001F, 2.0F);
        group.settings.greatestLengthM = greatest;
        writeScalar(group, MapKind::Length, map.values, greatest);
    }

    void writeCurl(HairGroup& group) const
    {
        if (std::ranges::none_of(m_sums.strands, [](const TexelSum& sum) { return sum.coiled > 0.0F; }))
            return;
        const auto curl = filled<float>([](const TexelSum& sum) { return sum.curl / sum.weight; });
        writeScalar(group, MapKind::Curl, curl.values, 1.0F);
        const auto radii =
            filled<float>([](const TexelSum& sum) { return sum.radiusM / sum.coiled; }, &TexelSum::coiled);
        const float greatest = std::clamp(roundUp(*std::ranges::max_element(radii.values)), 0.0005F, 0.2F);
        group.settings.greatestCurlRadiusM = greatest;
        writeScalar(group, MapKind::CurlSize, radii.values, greatest);
    }

    void writeBraids(HairGroup& group) const
    {
        if (m_onHead.braidRadiusM <= 0.0F)
            return;
        MapValues<glm::vec4> weights(m_texels.size);
        for (std::size_t i = 0; i < m_texels.count(); ++i) {
            const TexelSum& sum = m_sums.strands[i];
            weights.set(m_texels.texel[i], isBesideBraids(sum, kBraidEdge) || sum.weight <= 0.0F
                                               ? glm::vec4(1.0F, 0.0F, 0.0F, 0.0F)
                                               : sum.braided / sum.weight);
        }
        fillOutward(static_cast<std::size_t>(m_texels.size), weights.values, weights.known);
        writeLayer(group, MapKind::Braid, [&](std::size_t texel) {
            const glm::vec4& all = weights.values[texel];
            glm::length_t heaviest = 0;
            for (glm::length_t kind = 1; kind < all.length(); ++kind)
                heaviest = all[kind] > all[heaviest] ? kind : heaviest;
            return sim::Texel{static_cast<std::uint16_t>(heaviest), 65535};
        });
        group.settings.braidRadiusM = std::clamp(m_onHead.braidRadiusM, 0.0005F, 0.2F);
        group.settings.braidSpacingM = std::clamp(m_onHead.braidSpacingM, 0.005F, 2.0F);
        group.settings.nodesPerHair = kMostImportedNodes; // They hang and lie in bends.
        // So many basis hairs that each braid hangs by its own.
        constexpr float kNarrower = 0.7F;    ///< The map's are a little wider than the hair's.
        constexpr float kGapSpacings = 1.8F; ///< Basis hairs' spacings in a gap between two braids.
        constexpr double kMostForGaps = 65536.0;
        if (m_onHead.braidGapM > 0.0F) {
            const double spacingM = kNarrower * m_onHead.braidGapM / kGapSpacings;
            group.settings.basisHairs =
                std::max(group.settings.basisHairs,
                         static_cast<int>(std::min(m_skinAreaM2 / (spacingM * spacingM), kMostForGaps)));
        }
    }

    void writeGel(HairGroup& group) const
    {
        constexpr float kGelOfHeld = 0.92F;
        constexpr float kMostStand = 0.5F; ///< A texel is held if more than this fraction of its hairs is.
        /// Least fraction of all hairs; single hairs that stand by chance need no gel.
        constexpr double kFewHeld = 0.02;
        double held = 0.0;
        double all = 0.0;
        for (std::size_t i = 0; i < m_texels.count(); ++i) {
            const TexelSum& sum = m_sums.strands[i];
            const double hairs = static_cast<double>(sum.densityPerM2) * static_cast<double>(m_texels.areaM2[i]);
            all += hairs;
            held += sum.held > kMostStand * sum.weight ? hairs : 0.0;
        }
        if (held < kFewHeld * all)
            return;
        const auto map = filled<float>([](const TexelSum& sum) { return kGelOfHeld * sum.held / sum.weight; });
        writeScalar(group, MapKind::Gel, map.values, 1.0F);
    }

    void writeLocks(HairGroup& group) const
    {
        const LockEstimate locks = estimateLocks(m_onHead.strands);
        if (locks.clump <= 0.0F)
            return;
        writeLayer(group, MapKind::Clump, [&](std::size_t) { return sim::Texel{unit16(locks.clump), 65535}; });
        // As dense as the hairs stand, each counted once.
        double hairs = 0.0;
        double densities = 0.0;
        for (std::size_t i = 0; i < m_texels.count(); ++i) {
            const double density = m_sums.strands[i].densityPerM2;
            hairs += density * m_texels.areaM2[i];
            densities += density * density * m_texels.areaM2[i];
        }
        const double locksPerM2 = densities / std::max(hairs, 1.0) / static_cast<double>(locks.hairs);
        group.settings.basisHairs = static_cast<int>(std::clamp(locksPerM2 * m_skinAreaM2, 256.0, 1e7));
    }

    void writeDirection(HairGroup& group) const
    {
        constexpr float kEnough = 0.5F; ///< Weight of roots that need no hair from elsewhere.
        MapValues<glm::vec2> map(m_texels.size);
        for (std::size_t i = 0; i < m_texels.count(); ++i) {
            const DirectionSum& own = m_sums.roots[i];
            const DirectionSum& further = m_sums.further[i];
            const sim::SkinFrame& frame = m_texels.frame[i];
            if (own.weight > 0.0F && (own.weight >= kEnough || further.weight <= 0.0F))
                map.set(m_texels.texel[i], own.in(frame));
            else if (own.weight > 0.0F)
                map.set(m_texels.texel[i], sim::turnedBetween(further.in(frame), own.in(frame), own.weight / kEnough));
            else if (further.weight > 0.0F)
                map.set(m_texels.texel[i], further.in(frame));
        }
        // No softer edge: what is mixed of growing and lying is neither.
        constexpr float kNearBy = 0.25F;
        const MapValues<float> near = nearness(map.known);
        fillOutward(static_cast<std::size_t>(m_texels.size), map.values, map.known);
        writeLayer(group, MapKind::Direction, [&](std::size_t texel) {
            sim::Texel value = sim::texelOfDirection(map.values[texel]);
            value[2] = near.values[texel] > kNearBy ? 65535 : 0;
            return value;
        });
    }

    /// 1 in cells of some texels where something is known, and softly less beside them: further off hair grows as it
    /// does on its own.
    [[nodiscard]] MapValues<float> nearness(const std::vector<std::uint8_t>& known) const
    {
        constexpr std::size_t kCell = 16;
        const auto side = static_cast<std::size_t>(m_texels.size);
        const std::size_t cells = side / kCell;
        std::vector<float> any(cells * cells);
        for (std::size_t y = 0; y < side; ++y)
            for (std::size_t x = 0; x < side; ++x)
                if (known[y * side + x] != 0)
                    any[y / kCell * cells + x / kCell] = 1.0F;
        MapValues<float> near(m_texels.size);
        const auto at = [cells](float coordinate) {
            const float moved = std::clamp(coordinate / kCell - 0.5F, 0.0F, static_cast<float>(cells - 1));
            const auto low = std::min(static_cast<std::size_t>(moved), cells - 2);
            return std::pair(low, moved - static_cast<float>(low));
        };
        for (std::size_t y = 0; y < side; ++y)
            for (std::size_t x = 0; x < side; ++x) {
                const auto [cx, fx] = at(static_cast<float>(x) + 0.5F);
                const auto [cy, fy] = at(static_cast<float>(y) + 0.5F);
                const float mean =
                    glm::mix(glm::mix(any[cy * cells + cx], any[cy * cells + cx + 1], fx),
                             glm::mix(any[(cy + 1) * cells + cx], any[(cy + 1) * cells + cx + 1], fx), fy);
                near.values[y * side + x] = known[y * side + x] != 0 ? 1.0F : mean;
            }
        return near;
    }

    void writeColours(HairGroup& group) const
    {
        const auto write = [&](MapKind kind, glm::vec3 TexelSum::*colour) {
            const auto map = filled<glm::vec3>([colour](const TexelSum& sum) { return sum.*colour / sum.weight; });
            writeLayer(group, kind, [&](std::size_t texel) {
                const glm::vec3& value = map.values[texel];
                return sim::Texel{unit16(value.r), unit16(value.g), unit16(value.b), 65535};
            });
        };
        write(MapKind::Colour, &TexelSum::rootColour);
        constexpr float kAlike = 1.5F / 255.0F;
        const auto differs = [](const HeadStrand& strand) {
            const glm::vec3 by = glm::abs(strand.look.tipColour - strand.look.rootColour);
            return std::max({by.r, by.g, by.b}) > kAlike;
        };
        if (std::ranges::any_of(m_onHead.strands, differs))
            write(MapKind::TipColour, &TexelSum::tipColour);
    }

    /// What is the same for all hairs of the group.
    void setFibre(sim::GroupSettings& settings) const
    {
        std::vector<float> widths;
        std::vector<float> taper;
        for (const HeadStrand& strand : m_onHead.strands)
            if (strand.look.rootWidth >= kThinnestStrandM && strand.look.rootWidth <= kWidestStrandM) {
                widths.push_back(strand.look.rootWidth);
                taper.push_back(std::clamp(strand.look.tipWidth / strand.look.rootWidth, 0.0F, 1.0F));
            }
        if (2 * widths.size() > m_onHead.strands.size()) {
            settings.material.widthM = medianOf(widths);
            settings.material.tipAlpha = medianOf(taper);
        }
        // Numbers of points of strands without a coil; exported hair has two for each segment.
        std::vector<float> points;
        for (const HeadStrand& strand : m_onHead.strands)
            if (strand.shape.turns == 0.0F && strand.braid == sim::BraidKind::None)
                points.push_back(static_cast<float>(strand.points));
        if (2 * points.size() > m_onHead.strands.size())
            settings.nodesPerHair =
                std::clamp(static_cast<int>(medianOf(points) + 2.0F) / 2, sim::kLeastNodes, kMostImportedNodes);
        // Hair rises a little above its height in the coat before it lies, so that half of it lies at all of the
        // coat's.
        settings.physics.volumeM = std::clamp(m_onHead.heightM, 0.0F, 0.05F);
    }

    const HeadStrands& m_onHead;
    const SkinTexels& m_texels;
    const StrandSums& m_sums;
    double m_skinAreaM2;
};

} // namespace

std::optional<HairGroup> groupFromStrands(const HeadStrands& onHead, bool hasColours, const SkinTexels& texels,
                                          const QString& name, const std::shared_ptr<const Head>& head,
                                          const Progress& progress)
{
    const std::optional<StrandSums> sums = summed(onHead, texels, progress);
    if (!sums)
        return std::nullopt;
    Project nobody;
    nobody.head = head;
    return GroupMaker(onHead, texels, *sums, head->skin->areaM2())
        .fill(makeGroup(nobody, name, texels.size), hasColours);
}

} // namespace hairpaint::model
