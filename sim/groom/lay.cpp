// The hairs' constants into lanes.
#include "sim/groom/lay.h"

#include "sim/base/deterministic.h"
#include "sim/groom/curve_constants.h"
#include "sim/groom/rest_shape.h"
#include "sim/groom/variation.h"
#include "sim/skin/natural_stream.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::sim {

namespace {

/// Distance from a root to the points on each side between which a parting is looked for, m.
constexpr float kProbeM = 0.005F;
/// Distance of the samples that find a parting's line, m, and their number to each side of the root.
constexpr float kStepM = 0.0015F;
constexpr int kSteps = 3;

/// Length along which a hair's height in the coat rises, m: as is set, but no sooner than a head falls off by `topM`,
/// which its coils reach, so that a parting is no groove. 0, at once, where that is set.
float coatRise(float setM, float topM, float lengthM)
{
    constexpr float kHeadRadiusM = 0.09F;
    constexpr float kRisesWithin = 0.4F; // Greatest fraction of the length.
    if (setM <= 0.0F)
        return 0.0F;
    return std::min(std::max(setM, std::sqrt(2.0F * kHeadRadiusM * topM)), kRisesWithin * lengthM);
}

/// The part of curled hairs at a root that fall over the middle of a whorl, by how steep hair grows there: none from
/// some 2 cm off it on, nor where somebody combed, nor past the chin, where hair grows steeply, too.
float partOverWhorl(const LayRoot& root, DirectionVector painted, DirectionVector natural)
{
    constexpr float kMost = 0.6F;
    constexpr float kSteep = 0.35F;   ///< Flatness at which so many do,
    constexpr float kFlat = 0.65F;    ///< and at which none do.
    constexpr float kUpwards = 0.25F; ///< Least height of the skin's normal.
    const float steep = (kFlat - glm::length(natural)) / (kFlat - kSteep);
    if (root.liftM <= 0.0F || steep <= 0.0F || root.frame.normal.y < kUpwards)
        return 0.0F;
    return kMost * std::min(steep, 1.0F) * uncombed(painted, natural);
}

/// `growth`, for `part` of the hairs turned to the middle of the whorl: all would leave it, and bare it.
glm::vec3 overWhorl(float part, const LayRoot& root, glm::vec3 growth)
{
    constexpr float kSpreadRad = 0.6F;
    constexpr float kOwn = 71.3F;
    const float chance = root.chance * kOwn - std::floor(root.chance * kOwn);
    if (chance >= part)
        return growth;
    // The stream does not come straight from there.
    const float angle = kSwirlRad + kSpreadRad * (2.0F * chance / part - 1.0F);
    return growth * -cosDet(angle) - glm::cross(root.frame.normal, growth) * sinDet(angle);
}

} // namespace

bool isUpright(const MapSampler& direction)
{
    return direction.isUniform() && direction.vector(glm::vec2(0.5F)) == DirectionVector(0.0F);
}

std::size_t Lay::mostPassed(int nodes)
{
    // One cell a segment where a segment takes one step; else steps are longer than half the longest.
    constexpr auto kOfShortSteps = static_cast<std::size_t>(kFurthestLayM / (0.5F * kLongestLayStepM)) + 2;
    static_assert(kOfShortSteps < kMostPassed && kMostNodes <= static_cast<int>(kMostPassed));
    return std::max(static_cast<std::size_t>(nodes - 1), kOfShortSteps) + 1; // And the cell of m_strayedTo.
}

bool Lay::add(const LayRoot& root, float lengthM)
{
    const float falls = fallFraction(lengthM);
    const DirectionVector painted = m_inputs.direction.vector(root.uv);
    const DirectionVector natural =
        m_inputs.natural != nullptr ? m_inputs.natural->vector(root.uv) : DirectionVector(0.0F);
    m_strayedTo[m_count] = SkinBand::kNone;
    const glm::vec3 own =
        growthDirections(painted, m_inputs.natural != nullptr ? &natural : nullptr, root.positionHd, root.frame)
            .of(falls);
    const bool strays = m_inputs.field != nullptr && root.strayHd != glm::vec3(0.0F);
    const float over =
        strays && m_inputs.natural != nullptr ? partOverWhorl(root, painted, natural) * (1.0F - falls) : 0.0F;
    const glm::vec3 turned = overWhorl(over, root, own);
    const glm::vec3 growth = strays && turned == own ? strayed(root, falls, own) : turned;
    const float square = std::min(glm::dot(growth, growth), 1.0F);
    const glm::vec3 direction = growth + root.frame.normal * std::sqrt(1.0F - square);
    constexpr float kShortestPartedM = 0.02F; ///< Shorter hair shows its skin anyway,
    constexpr float kLongPartedM = 0.06F;     ///< and from here on a parting is as wide as it gets.
    const float parted = std::min((lengthM - kShortestPartedM) / (kLongPartedM - kShortestPartedM), 1.0F);
    const bool isDrawn =
        !(m_inputs.partGapM > 0.0F && m_inputs.field != nullptr && parted > 0.0F &&
          square > kStandsBelow * kStandsBelow && isBare(root, falls, own, m_inputs.partGapM * parted));
    const float segmentM = isDrawn ? lengthM / static_cast<float>(m_nodes - 1) : 0.0F;
    const std::size_t lane = m_count++;
    for (int axis = 0; axis < 3; ++axis) {
        m_lanes.rootHd[static_cast<std::size_t>(axis)][lane] = root.positionHd[axis];
        m_lanes.directionHd[static_cast<std::size_t>(axis)][lane] = direction[axis];
    }
    m_lanes.segmentM[lane] = segmentM;
    m_lanes.steps[lane] = std::max(std::ceil(segmentM / kLongestLayStepM), 1.0F);
    m_lanes.falls[lane] = falls;
    const float coatM = std::min(m_inputs.coatM, 0.001F + 0.12F * lengthM) * (0.3F + 0.7F * root.chance) + root.liftM;
    m_lanes.coatM[lane] = coatM;
    const float riseM = coatRise(m_inputs.coatRiseM, coatM + root.liftM, lengthM);
    m_lanes.perRise[lane] = riseM > 0.0F ? 1.0F / riseM : 0.0F;
    constexpr float kAcrossM = 0.009F; // The width of a parting: two cells.
    m_lanes.keepsM[lane] = strays && growth != own ? kAcrossM : 0.0F;
    m_lanes.lies[lane] = square > kStandsBelow * kStandsBelow ? 1.0F : 0.0F;
    m_isUpright[lane] = square == 0.0F;
    return isDrawn;
}

bool Lay::isBare(const LayRoot& root, float falls, glm::vec3 growth, float gapM) const
{
    constexpr float kDiverges = 1.0F; ///< Least difference of the directions on both sides of a parting, at most 2,
    constexpr float kParallel = 0.5F; ///< and the greatest along it; in a whorl directions differ all around.
    constexpr float kCrosses = 0.7F;  ///< A hair whose chance is greater crosses the line all the same.
    if (root.chance > kCrosses || glm::dot(growth, growth) < kStandsBelow * kStandsBelow)
        return false;
    const SkinBand& band = *m_inputs.field->band();
    const LayCell* cells = m_inputs.field->cells();
    const auto at = [&](glm::vec3 offset) {
        const std::int32_t cell = band.cellAt(root.positionHd + offset);
        return cell == SkinBand::kNone ? growth : cells[cell].directions.of(falls);
    };
    // How the field spreads: a symmetric matrix, whose first axis goes across the parting.
    const glm::vec3 overX = at(root.frame.x * kProbeM) - at(root.frame.x * -kProbeM);
    const glm::vec3 overY = at(root.frame.y * kProbeM) - at(root.frame.y * -kProbeM);
    const float xx = glm::dot(overX, root.frame.x);
    const float yy = glm::dot(overY, root.frame.y);
    const float xy = 0.5F * (glm::dot(overX, root.frame.y) + glm::dot(overY, root.frame.x));
    const float mean = 0.5F * (xx + yy);
    const float half = 0.5F * (xx - yy);
    const float apart = std::sqrt(half * half + xy * xy);
    if (mean + apart < kDiverges || mean - apart > kParallel)
        return false;
    const glm::vec2 axis = half > 0.0F ? glm::vec2(apart + half, xy) : glm::vec2(xy, apart - half);
    const glm::vec3 across = (root.frame.x * axis.x + root.frame.y * axis.y) / std::sqrt(glm::dot(axis, axis));

    constexpr float kWaverPhase = 2.6F;
    constexpr float kFiner = 1.7F;
    constexpr float kUneven = 0.35F; ///< Fraction by which the line's width wavers;
    constexpr float kFrayed = 0.4F;  ///< fraction of it by which single hairs differ.
    const glm::vec3 offset = root.frame.x * (m_inputs.partWaversM * wavering(root.positionHd, 0.0F)) +
                             root.frame.y * (m_inputs.partWaversM * wavering(root.positionHd, kPartAlongPhase));
    const float bareM = 0.5F * gapM * (1.0F + kUneven * wavering(root.positionHd * kFiner, kWaverPhase)) *
                        (1.0F + kFrayed * (root.chance - 0.5F));
    // The line lies between two samples whose cells are on different sides.
    float beforeM = 0.0F;
    float beforeTo = 1.0F;
    for (int step = -kSteps; step <= kSteps; ++step) {
        const std::int32_t cell = band.cellAt(root.positionHd + offset + across * (kStepM * static_cast<float>(step)));
        if (cell == SkinBand::kNone)
            continue;
        const float atM =
            glm::dot(band.cells()[static_cast<std::size_t>(cell)].positionHd - root.positionHd - offset, across);
        const float to = glm::dot(cells[cell].directions.of(falls), across);
        if (beforeTo < 0.0F && to >= 0.0F && std::abs(beforeM + (atM - beforeM) * (beforeTo / (beforeTo - to))) < bareM)
            return true;
        beforeM = atM;
        beforeTo = to;
    }
    return false;
}

float Lay::partingReachM(float partWaversM)
{
    constexpr float kDiagonal = 1.42F;
    return std::max(kProbeM, kDiagonal * partWaversM + kStepM * static_cast<float>(kSteps));
}

void Lay::lay()
{
    if (m_count == 0)
        return;
    // Unused lanes repeat the first.
    for (std::size_t lane = m_count; lane < kLanes; ++lane) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            m_lanes.rootHd[axis][lane] = m_lanes.rootHd[axis][0];
            m_lanes.directionHd[axis][lane] = m_lanes.directionHd[axis][0];
        }
        m_lanes.segmentM[lane] = m_lanes.segmentM[0];
        m_lanes.steps[lane] = m_lanes.steps[0];
        m_lanes.falls[lane] = m_lanes.falls[0];
        m_lanes.coatM[lane] = m_lanes.coatM[0];
        m_lanes.perRise[lane] = m_lanes.perRise[0];
        m_lanes.keepsM[lane] = m_lanes.keepsM[0];
        m_lanes.lies[lane] = m_lanes.lies[0];
    }
    std::ranges::fill(m_passed, SkinBand::kNone);
    LayTask task{.lanes = &m_lanes,
                 .nodes = m_nodes,
                 .nodesHd = m_nodesHd.data(),
                 .passed = m_passed.data(),
                 .mostPassed = kMostPassed};
    if (m_inputs.field != nullptr) {
        task.grid = m_inputs.field->band()->grid();
        task.cells = m_inputs.field->cells();
    }
    layLanes(task);
    for (std::size_t hair = 0; hair < m_count; ++hair) {
        if (m_isUpright[hair])
            straighten(hair);
        if (m_strayedTo[hair] != SkinBand::kNone)
            *std::ranges::find(std::span(m_passed).subspan(hair * kMostPassed, kMostPassed), SkinBand::kNone) =
                m_strayedTo[hair];
    }
}

glm::vec3 Lay::strayed(const LayRoot& root, float falls, glm::vec3 growth)
{
    constexpr float kOpposed = -0.2F; ///< Cosine: along one side of a parting hairs agree.
    const std::int32_t cell = m_inputs.field->band()->cellAt(root.positionHd + root.strayHd);
    m_strayedTo[m_count] = cell;
    if (cell == SkinBand::kNone)
        return growth;
    const glm::vec3 there = m_inputs.field->cells()[cell].directions.of(falls);
    const glm::vec3 along = there - root.frame.normal * glm::dot(there, root.frame.normal);
    const float together2 = glm::dot(along, along) * glm::dot(growth, growth);
    return glm::dot(along, growth) < kOpposed * std::sqrt(together2) ? along : growth;
}

void Lay::straighten(std::size_t hair)
{
    const auto of = [hair](const std::array<LayLanes::Row, 3>& rows) {
        return glm::vec3(rows[0][hair], rows[1][hair], rows[2][hair]);
    };
    std::array<glm::vec3, kMostNodes> buffer{};
    const std::span<glm::vec3> nodes = std::span(buffer).first(static_cast<std::size_t>(m_nodes));
    straightRest({of(m_lanes.rootHd), of(m_lanes.directionHd)},
                 m_lanes.segmentM[hair] * static_cast<float>(m_nodes - 1), nodes);
    StrandBlocks(m_nodes).write(m_nodesHd, hair, nodes);
}

std::span<const std::int32_t> Lay::passed(std::size_t hair) const
{
    return std::span(m_passed).subspan(hair * kMostPassed, mostPassed(m_nodes));
}

} // namespace hairpaint::sim
