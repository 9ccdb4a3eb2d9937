// Deposit, blur, and light swept through the grid along its axes.
#include "model/cards/hair_field.h"

#include "sim/base/parallel.h"
#include "sim/base/rounded.h"
#include "sim/skin/solid_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hairpaint::model {

namespace {

constexpr float kFinestCellM = 0.003F;
constexpr float kMostCells = 100.0F; ///< Along the longest side.
constexpr int kMargin = 4;           ///< Empty cells on each side.
constexpr float kSolidPerM = 1e4F;
/// Hair lets light through and scatters it: so much of its area counts.
constexpr float kShading = 0.15F;
constexpr float kFillingM = 0.01F; ///< Depth at which so dense hair hides what is behind.

} // namespace

HairField::HairField(const CurveSet& set, const SampledHair& hair)
{
    glm::vec3 least(std::numeric_limits<float>::max());
    glm::vec3 greatest(std::numeric_limits<float>::lowest());
    for (const glm::vec3& sample : hair.samplesWo) {
        least = glm::min(least, sample);
        greatest = glm::max(greatest, sample);
    }
    if (hair.count() == 0)
        least = greatest = glm::vec3(0.0F);
    const glm::vec3 extent = greatest - least;
    m_cellM = std::max(kFinestCellM, std::max({extent.x, extent.y, extent.z}) / kMostCells);
    m_size = glm::ivec3(glm::ceil(extent / m_cellM)) + 1 + 2 * kMargin;
    m_originWo = least - static_cast<float>(kMargin) * m_cellM;
    const std::size_t cells =
        static_cast<std::size_t>(m_size.x) * static_cast<std::size_t>(m_size.y) * static_cast<std::size_t>(m_size.z);
    m_areaPerM.assign(cells, 0.0F);
    deposit(hair);
    fillHead(set);
    measureOpenness();
    blurFilled();
}

void HairField::deposit(const SampledHair& hair)
{
    const float perVolume = 1.0F / (m_cellM * m_cellM * m_cellM * static_cast<float>(SampledHair::kSamples));
    for (std::size_t i = 0; i < hair.count(); ++i) {
        const float area = hair.lengthM[i] * hair.widthM[i] * perVolume;
        for (const glm::vec3& sample : hair.samples(i))
            m_areaPerM[indexOf(glm::ivec3((sample - m_originWo) / m_cellM + 0.5F))] += area;
    }
    m_filled.resize(m_areaPerM.size());
    std::ranges::transform(m_areaPerM, m_filled.begin(),
                           [](float area) { return 1.0F - sim::expRounded(-area * kFillingM); });
}

void HairField::fillHead(const CurveSet& set)
{
    constexpr int kHeadCells = 64;
    const sim::Skin* skin = set.skin();
    if (skin == nullptr)
        return;
    const std::function<bool()> always;
    sim::GoingOn goingOn(always);
    const sim::SolidGrid solid = sim::solidGridOf(skin->mesh(), kHeadCells, goingOn);
    const sim::HeadPose& pose = set.pose();
    const glm::quat back = glm::conjugate(pose.rotation);
    glm::ivec3 cell(0);
    for (cell.z = 0; cell.z < m_size.z; ++cell.z)
        for (cell.y = 0; cell.y < m_size.y; ++cell.y)
            for (cell.x = 0; cell.x < m_size.x; ++cell.x) {
                const glm::vec3 positionHd = back * (m_originWo + m_cellM * glm::vec3(cell) - pose.positionWo);
                const glm::ivec3 own(glm::floor((positionHd - solid.originHd) / solid.cellM + 0.5F));
                const bool within =
                    glm::all(glm::greaterThanEqual(own, glm::ivec3(0))) && glm::all(glm::lessThan(own, solid.size));
                if (!within || solid.inside[solid.indexOf(own)] == 0)
                    continue;
                m_filled[indexOf(cell)] = 1.0F;
                m_areaPerM[indexOf(cell)] = kSolidPerM;
            }
}

void HairField::measureOpenness()
{
    constexpr float kDirections = 6.0F;
    // Half of a cell's own hair lies before its middle.
    std::vector<float> half(m_areaPerM.size());
    sim::parallelFor(half.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            half[i] = sim::expRounded(-0.5F * kShading * m_areaPerM[i] * m_cellM);
    });
    m_openness.assign(m_areaPerM.size(), 0.0F);
    for (int axis = 0; axis < 3; ++axis) {
        const int other = (axis + 1) % 3;
        const int third = (axis + 2) % 3;
        glm::ivec3 next(0);
        next[axis] = 1;
        const std::size_t stride = indexOf(next);
        const auto length = static_cast<std::size_t>(m_size[axis]);
        const auto sweep = [&](std::size_t first, bool forward) {
            float light = 1.0F;
            for (std::size_t i = 0; i < length; ++i) {
                const std::size_t index = first + stride * (forward ? i : length - 1 - i);
                m_openness[index] += light * half[index] / kDirections;
                light *= half[index] * half[index];
            }
        };
        sim::parallelFor(static_cast<std::size_t>(m_size[other]), 8, [&](std::size_t begin, std::size_t end) {
            for (std::size_t a = begin; a < end; ++a)
                for (int b = 0; b < m_size[third]; ++b) {
                    glm::ivec3 cell(0);
                    cell[other] = static_cast<int>(a);
                    cell[third] = b;
                    sweep(indexOf(cell), true);
                    sweep(indexOf(cell), false);
                }
        });
    }
}

void HairField::blurFilled()
{
    constexpr int kPasses = 3;
    const std::array<std::size_t, 3> strides{1, static_cast<std::size_t>(m_size.x),
                                             static_cast<std::size_t>(m_size.x) * static_cast<std::size_t>(m_size.y)};
    std::vector<float> before;
    for (int pass = 0; pass < kPasses; ++pass)
        for (int axis = 0; axis < 3; ++axis) {
            before = m_filled;
            const std::size_t stride = strides.at(static_cast<std::size_t>(axis));
            const auto length = static_cast<std::size_t>(m_size[axis]);
            for (std::size_t i = 0, at = 0; i < before.size(); i += stride, at = at + 1 < length ? at + 1 : 0)
                for (std::size_t j = i; j < i + stride; ++j) {
                    const float low = at > 0 ? before[j - stride] : 0.0F;
                    const float high = at + 1 < length ? before[j + stride] : 0.0F;
                    m_filled[j] = 0.25F * (low + high) + 0.5F * before[j];
                }
        }
}

float HairField::at(const std::vector<float>& values, const glm::vec3& positionWo) const
{
    const glm::vec3 last(m_size - 2);
    const glm::vec3 inCells = glm::clamp((positionWo - m_originWo) / m_cellM, glm::vec3(0.0F), last);
    const glm::ivec3 cell(inCells);
    const glm::vec3 part = inCells - glm::vec3(cell);
    const std::size_t first = indexOf(cell);
    const auto row = static_cast<std::size_t>(m_size.x);
    const std::size_t layer = row * static_cast<std::size_t>(m_size.y);
    const auto along = [&](std::size_t i) { return glm::mix(values[i], values[i + 1], part.x); };
    return glm::mix(glm::mix(along(first), along(first + row), part.y),
                    glm::mix(along(first + layer), along(first + layer + row), part.y), part.z);
}

glm::vec3 HairField::outward(const glm::vec3& positionWo) const
{
    glm::vec3 rise(0.0F);
    for (int axis = 0; axis < 3; ++axis) {
        glm::vec3 step(0.0F);
        step[axis] = m_cellM;
        rise[axis] = at(m_filled, positionWo + step) - at(m_filled, positionWo - step);
    }
    // About 1 where a full half space ends.
    constexpr float kSteepest = 2.0F;
    const glm::vec3 out = -kSteepest * rise;
    const float length = glm::length(out);
    return length > 1.0F ? out / length : out;
}

float HairField::openness(const glm::vec3& positionWo) const
{
    return at(m_openness, positionWo);
}

} // namespace hairpaint::model
