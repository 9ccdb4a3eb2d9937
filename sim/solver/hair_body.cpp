// How much hair each basis hair stands for, what is dense at rest, and a grid now and then.
#include "sim/solver/hair_body.h"

#include "sim/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::sim {

namespace {

constexpr std::size_t kBlocksAtOnce = 16;
constexpr std::size_t kBlocksAPart = 8;
constexpr std::size_t kMostParts = 4;
constexpr std::size_t kMostCells = 16384;
constexpr std::size_t kMostNodesSplatted = 24576; ///< With more, every second strand counts twice, and so on.
constexpr float kUnits = 536870912.0F;            ///< 2^29: all hair in one cell stays below 2^31.
constexpr float kLeastCellM = 0.008F;
constexpr float kMostCellM = 0.02F;
constexpr float kCellsASegment = 2.0F;
constexpr float kFurthestM = 4.0F; ///< From the head's origin; no hair is longer.
/// Length of hair in a volume, 1/m2, of hair that hangs loosely: a twentieth of it are fibres of 80 um.
constexpr float kLoosePerM2 = 1e7F;

} // namespace

void HairBody::setGroom(const Groom& groom)
{
    const float body = groom.settings.physics.body;
    m_gains = {.friction = 0.2F * body, .contact = std::min(2.0F * body, 1.0F)};
    m_nodes = groom.nodes;
    m_blocks = groom.basis->blockCount();
    countHairs(groom);
    measureRest(groom);
    m_contact.assign(StrandBlocks(m_nodes).floatsFor(m_blocks), 0.0F);
    m_dense.assign(m_blocks, 0);
    m_stepsLeft = 0;
}

void HairBody::forget()
{
    std::ranges::fill(m_contact, 0.0F);
    std::ranges::fill(m_dense, std::uint8_t{0});
    m_stepsLeft = 0;
}

void HairBody::countHairs(const Groom& groom)
{
    const BasisStyles& basis = *groom.basis;
    m_hair.assign(m_blocks * kLanes, 0.0F);
    if (groom.roots) {
        for (std::size_t chunk = 0; chunk < groom.chunks.size(); ++chunk) {
            if (!groom.chunks[chunk])
                continue;
            const std::size_t first = chunk * kChunkSlots;
            const std::size_t count = std::min<std::size_t>(kChunkSlots, groom.roots->neighbours.size() - first);
            for (std::size_t slot = 0; slot < count; ++slot)
                if (groom.chunks[chunk]->drawn[slot] && !groom.chunks[chunk]->gathered[slot])
                    m_hair[groom.isOfTails ? groom.chunks[chunk]->followed[slot].basis[0]
                                           : groom.roots->neighbours[first + slot][0]] += 1.0F;
        }
    } else {
        std::ranges::fill(m_hair, 1.0F);
    }
    std::size_t samples = 1;
    while (m_hair.size() * static_cast<std::size_t>(m_nodes) / samples > kMostNodesSplatted)
        samples *= 2;
    double length = 0.0;
    double segments = 0.0;
    double hairs = 0.0;
    for (std::size_t strand = 0; strand < m_hair.size(); ++strand) {
        const float segment = basis[BasisQuantity::SegmentLength][strand];
        const bool counts = hasLane(basis.wanted, strand) && segment > 0.0F && strand % samples == 0;
        const float count = counts ? m_hair[strand] * static_cast<float>(samples) : 0.0F;
        hairs += count;
        segments += count * segment;
        m_hair[strand] = count * segment;
        length += static_cast<double>(m_hair[strand]) * (m_nodes - 1);
    }
    m_metresPerUnit = length > 0.0 ? static_cast<float>(length / kUnits) : 1.0F;
    for (float& hair : m_hair)
        hair /= m_metresPerUnit;
    // Nodes further apart than two cells would be lumps.
    const auto segmentM = static_cast<float>(hairs > 0.0 ? segments / hairs : 0.0);
    m_cellM = std::clamp(segmentM / kCellsASegment, kLeastCellM, kMostCellM);
}

void HairBody::measureRest(const Groom& groom)
{
    const float* const rest = groom.basis->restPositions.data();
    const BodyNodes nodes{.nodes = m_nodes, .positions = rest, .previous = rest, .hair = m_hair.data()};
    makeGrid(nodes);
    m_perRest.resize(m_blocks * static_cast<std::size_t>(m_nodes) * kLanes);
    const float perUnit = densityPerUnit();
    const std::size_t floats = static_cast<std::size_t>(m_nodes) * kLanes;
    parallelFor(m_blocks, kBlocksAtOnce, [&](std::size_t begin, std::size_t end) {
        readBody(nodes, m_grid, m_perRest.data(), begin, end);
        for (std::size_t i = begin * floats; i < end * floats; ++i)
            m_perRest[i] = 1.0F / std::max(m_perRest[i] * perUnit, kLoosePerM2);
    });
}

void HairBody::makeGrid(const BodyNodes& nodes)
{
    const std::size_t parts = std::clamp<std::size_t>(m_blocks / kBlocksAPart, 1,
                                                      std::min(kMostParts, static_cast<std::size_t>(threadCount())));
    const auto ofPart = [&](std::size_t part) { return m_blocks * part / parts; };
    std::array<BodyBounds, kMostParts> bounds;
    parallelFor(parts, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t part = begin; part < end; ++part)
            bounds[part] = boundsOfBody(nodes, ofPart(part), ofPart(part + 1));
    });
    std::array<float, 3> size{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        float least = kFurthestM;
        float greatest = -kFurthestM;
        for (std::size_t part = 0; part < parts; ++part) {
            least = std::min(least, bounds[part].least[axis]);
            greatest = std::max(greatest, bounds[part].greatest[axis]);
        }
        m_grid.origin[axis] = std::max(least, -kFurthestM);
        size[axis] = std::max(std::min(greatest, kFurthestM) - m_grid.origin[axis], 0.0F);
    }
    // Hair that is blown about fills more room: coarser cells, rather than more.
    std::array<std::int32_t, 3> count{};
    float cellM = m_cellM;
    for (;; cellM *= 1.25F) {
        std::size_t cells = 1;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            count[axis] = static_cast<std::int32_t>(size[axis] / cellM) + 2;
            cells *= static_cast<std::size_t>(count[axis]);
        }
        if (cells <= kMostCells)
            break;
    }
    m_grid.inverseCell = 1.0F / cellM;
    m_grid.row = count[0];
    m_grid.slice = count[0] * count[1];
    for (std::size_t axis = 0; axis < 3; ++axis)
        m_grid.last[axis] = static_cast<float>(count[axis] - 2) + 0.999F;
    const std::size_t numbers = static_cast<std::size_t>(m_grid.slice) * static_cast<std::size_t>(count[2]) * 4;
    m_parts.resize(std::max(m_parts.size(), parts));
    parallelFor(parts, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t part = begin; part < end; ++part) {
            m_parts[part].assign(numbers, 0);
            BodyGrid own = m_grid;
            own.cells = m_parts[part].data();
            splatBody(nodes, own, ofPart(part), ofPart(part + 1));
        }
    });
    if (parts > 1)
        parallelFor(numbers, 4096, [&](std::size_t begin, std::size_t end) {
            for (std::size_t part = 1; part < parts; ++part)
                for (std::size_t i = begin; i < end; ++i)
                    m_parts[0][i] += m_parts[part][i];
        });
    m_grid.cells = m_parts[0].data();
    ++m_gridsMade;
}

BodyNodes HairBody::nodesOf(const StrandState& state) const
{
    return {
        .nodes = m_nodes, .positions = state.now().data(), .previous = state.previous.data(), .hair = m_hair.data()};
}

float HairBody::densityPerUnit() const
{
    return m_metresPerUnit * m_grid.inverseCell * m_grid.inverseCell * m_grid.inverseCell;
}

std::size_t HairBody::meet(const StrandState& state, std::size_t wanted)
{
    m_isNew = m_stepsLeft == 0;
    if (m_isNew) {
        makeGrid(nodesOf(state));
        m_stepsLeft = kStepsAGrid;
    }
    const std::size_t count = std::min(wanted, m_stepsLeft);
    m_stepsLeft -= count;
    return count;
}

void HairBody::push(const SolverBlocks& blocks, int present, std::size_t begin, std::size_t end)
{
    if (!m_isNew)
        return;
    const BodyNodes nodes{.nodes = m_nodes,
                          .positions = blocks.positions[static_cast<std::size_t>(present)],
                          .previous = blocks.previous,
                          .hair = m_hair.data()};
    const BodyPush push{.gains = m_gains,
                        .perRest = m_perRest.data(),
                        .densityPerUnit = densityPerUnit(),
                        .still = blocks.lanes + std::size_t{kStill} * kLanes,
                        .stillStride = blocks.laneRows * kLanes,
                        .previous = blocks.previous,
                        .contact = m_contact.data(),
                        .dense = m_dense.data()};
    pushBody(nodes, m_grid, push, begin, end);
}

} // namespace hairpaint::sim
