// One group's strands from groom to groom and step to step.
#include "sim/motion/group_dynamics.h"

#include "sim/base/parallel.h"
#include "sim/groom/groom_lineage.h"
#include "sim/solver/solver_kernel.h"
#include "sim/solver/start_shape.h"
#include "sim/solver/strand_constants.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hairpaint::sim {

namespace {

constexpr std::size_t kBlocksAtOnce = 16;
constexpr int kSettleSteps = 84; ///< 0.7 s
constexpr float kSettleDamping = 5.0F;

/// By how much the edges of one shape point elsewhere than those of the other: 0 within 30 degrees, 1 from 70.
float turnBetween(std::span<const glm::vec3> before, std::span<const glm::vec3> after)
{
    constexpr float kNone = 0.87F;
    constexpr float kWhole = 0.34F;
    float along = 0.0F;
    float lengths = 0.0F;
    for (std::size_t node = 1; node < before.size(); ++node) {
        const glm::vec3 a = before[node] - before[node - 1];
        const glm::vec3 b = after[node] - after[node - 1];
        along += glm::dot(a, b);
        lengths += std::sqrt(glm::dot(a, a) * glm::dot(b, b));
    }
    return lengths > 0.0F ? std::clamp((kNone - along / lengths) / (kNone - kWhole), 0.0F, 1.0F) : 0.0F;
}

glm::vec3 downOf(const StepForces& calm)
{
    const glm::vec3 gravity(calm.gravity[0], calm.gravity[1], calm.gravity[2]);
    const float pull = std::sqrt(glm::dot(gravity, gravity));
    return pull > 0.0F ? gravity / pull : glm::vec3(0.0F, -1.0F, 0.0F);
}

/// The direction in which hair hangs that leans: it starts on its own side of the shoulder.
glm::vec3 leaningDown(const StepForces& calm, const GroupGains& gains, float lean)
{
    if (!gains.leans || lean == 0.0F)
        return downOf(calm);
    constexpr float kOfStrand = 0.75F; // The lean grows along the strand, and most of it hangs from there on.
    StepForces leaning = calm;
    for (std::size_t axis = 0; axis < leaning.gravity.size(); ++axis)
        leaning.gravity[axis] += kOfStrand * lean * gains.lean[axis];
    return downOf(leaning);
}

/// Number of times that the distance within which hair counts as still has doubled.
unsigned doublingsAfter(std::size_t calmSteps)
{
    constexpr std::size_t kExact = 480; // 4 s
    constexpr std::size_t kDoubles = 240;
    constexpr std::size_t kMost = 5;
    return calmSteps < kExact ? 0U : static_cast<unsigned>(std::min(1 + (calmSteps - kExact) / kDoubles, kMost));
}

std::size_t calmAfter(std::size_t calmSteps, const StepForces& step)
{
    return step.windy ? 0 : calmSteps + 1;
}

bool sameColliders(const ColliderSet& a, const ColliderSet& b)
{
    if (a.count != b.count || a.grid != b.grid)
        return false;
    return std::equal(a.items.begin(), a.items.begin() + a.count, b.items.begin());
}

/// A groom before the first one: no strands.
const Groom& nothing()
{
    static const Groom groom = [] {
        Groom empty;
        empty.nodes = 0;
        empty.basis = std::make_shared<BasisStyles>();
        return empty;
    }();
    return groom;
}

} // namespace

void GroupDynamics::setGroom(std::shared_ptr<const Groom> groom, const ColliderSet& colliders, const StepForces& calm,
                             const Neck& neck)
{
    m_neck = neck;
    if (groom == m_groom && sameColliders(m_colliders, colliders)) {
        m_isNew = m_groom->basisCount == 0;
        m_gathered.setGroom(*m_groom, colliders, calm, neck);
        return; // Something else of the input differs: hair at rest stays at rest.
    }
    const std::shared_ptr<const Groom> kept = std::exchange(m_groom, std::move(groom));
    const Groom& before = kept ? *kept : nothing();
    const bool otherColliders = !sameColliders(m_colliders, colliders);
    const bool otherGains = !kept || !sameFor(Affects::Motion, before.settings, m_groom->settings);
    m_colliders = colliders;
    if (otherGains) {
        m_gains = gainsOf(m_groom->settings.physics, m_groom->nodes);
        m_gains.beginsInAir = m_groom->isOfTails;
        m_drag = m_gains.drag;
    }

    std::vector<std::size_t> arrived;
    if (sameStrands(before, *m_groom)) {
        m_state.setColliders(m_colliders.count);
        if (before.basis != m_groom->basis)
            arrived = takeStrands(before, {}, m_state, downOf(calm));
    } else {
        StrandState old = std::exchange(m_state, {});
        m_state.resize(m_groom->nodes, m_groom->basis->blockCount(), m_colliders.count);
        arrived = takeStrands(before, originsOf(before, *m_groom), old, downOf(calm));
    }
    if (otherGains || otherColliders) {
        parallelFor(m_state.blocks, kBlocksAtOnce, [this](std::size_t begin, std::size_t end) {
            for (std::size_t strand = begin * kLanes; strand < end * kLanes; ++strand) {
                if (m_state.field(strand, kStill) < kUnwanted)
                    setStrandConstants(m_state, *m_groom, strand, m_colliders);
            }
        });
        wake();
    }
    m_isNew = arrived.size() == m_groom->basisCount;
    settle(arrived, calm);
    if (!(m_groom->settings.physics.body > 0.0F))
        m_body.reset();
    else if (!m_body)
        m_body = std::make_unique<HairBody>();
    if (m_body)
        m_body->setGroom(*m_groom);
    setBraids();
    const bool otherCoat = otherColliders || otherGains || before.roots != m_groom->roots;
    m_dependents.prepare(*m_groom, m_colliders, otherCoat);
    m_gathered.setGroom(*m_groom, m_colliders, calm, neck);
    rouse();
}

void GroupDynamics::setBraids()
{
    const std::vector<float>& girths = (*m_groom->basis)[BasisQuantity::Girth];
    // One has nothing to keep off.
    if (std::ranges::count_if(girths, [](float girthM) { return girthM > 0.0F; }) < 2) {
        m_braids.reset();
        return;
    }
    if (!m_braids)
        m_braids = std::make_unique<BraidContact>();
    m_braids->setGroom(*m_groom);
}

std::vector<std::size_t> GroupDynamics::takeStrands(const Groom& before, std::span<const std::int32_t> origin,
                                                    const StrandState& old, glm::vec3 downHd)
{
    const Groom& now = *m_groom;
    std::vector<std::uint16_t> arrivedLanes(m_state.blocks, 0);
    parallelFor(m_state.blocks, kBlocksAtOnce, [&](std::size_t begin, std::size_t end) {
        for (std::size_t block = begin; block < end; ++block) {
            if (origin.empty() && sameBlock(*before.basis, *now.basis, now.nodes, block))
                continue;
            for (std::size_t lane = 0; lane < kLanes; ++lane) {
                const std::size_t strand = block * kLanes + lane;
                const std::int32_t was = origin.empty() ? static_cast<std::int32_t>(strand) : origin[strand];
                const StrandChange change = changeOf(before, was, now, strand);
                if (change == StrandChange::Gone) {
                    m_state.field(strand, kStill) = kUnwanted;
                    continue;
                }
                if (change == StrandChange::Arrived) {
                    arrivedLanes[block] = static_cast<std::uint16_t>(arrivedLanes[block] | (1U << lane));
                    setStrandConstants(m_state, now, strand, m_colliders);
                    continue;
                }
                if (!origin.empty())
                    m_state.copyStrand(old, static_cast<std::size_t>(was), strand);
                if (change == StrandChange::Shape)
                    reshape(before, static_cast<std::size_t>(was), strand, downHd);
            }
        }
    });
    std::vector<std::size_t> arrived;
    for (std::size_t block = 0; block < m_state.blocks; ++block) {
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            if (((arrivedLanes[block] >> lane) & 1U) != 0)
                arrived.push_back(block * kLanes + lane);
        }
    }
    return arrived;
}

/// Moves a strand to its new rest shape. One whose rest shape turns to another direction cannot keep its displacement:
/// hair that hung would stand off as far from the new shape as it hung from the old.
void GroupDynamics::reshape(const Groom& before, std::size_t was, std::size_t strand, glm::vec3 downHd)
{
    const Groom& now = *m_groom;
    const auto nodes = static_cast<std::size_t>(now.nodes);
    std::array<glm::vec3, kMostNodes> restBefore;
    std::array<glm::vec3, kMostNodes> restNow;
    std::array<glm::vec3, kMostNodes> hanging;
    before.blocks().read(before.basis->restPositions, was, std::span(restBefore).first(nodes));
    now.blocks().read(now.basis->restPositions, strand, std::span(restNow).first(nodes));
    const float lengthBefore = m_state.field(strand, kSegmentLength);
    setStrandConstants(m_state, now, strand, m_colliders);
    const float length = m_state.field(strand, kSegmentLength);
    const float turned = turnBetween(std::span(restBefore).first(nodes), std::span(restNow).first(nodes));
    if (turned > 0.0F)
        hang(m_state, strand, std::span(restNow).first(nodes), downHd, std::span(hanging).first(nodes));
    m_state.reshapeStrand(strand, {.beforeHd = restBefore,
                                   .afterHd = restNow,
                                   .hangingHd = hanging,
                                   .turned = turned,
                                   .factor = length / lengthBefore,
                                   .segmentM = length,
                                   .isRootMoved = now.isOfTails});
}

void GroupDynamics::hang(const StrandState& state, std::size_t strand, std::span<const glm::vec3> restHd,
                         glm::vec3 downHd, std::span<glm::vec3> nodesHd) const
{
    std::array<float, kMaxColliders> scales{};
    for (int c = 0; c < m_colliders.count; ++c)
        scales[static_cast<std::size_t>(c)] = std::sqrt(state.field(strand, kScale + c));
    const HangingStrand wanted{.segmentM = state.field(strand, kSegmentLength),
                               .stiffnessM = m_groom->settings.physics.stiffnessM,
                               .girthM = state.field(strand, kGirth),
                               .firstGirthM = state.field(strand, kGirthFirst),
                               .styled = styledFraction(state.field(strand, kHold)),
                               .downHd = downHd};
    hangStrand(nodesHd, restHd, wanted, m_colliders, scales);
}

void GroupDynamics::setLean(StrandState& state, std::size_t at, std::size_t strand,
                            std::span<const glm::vec3> restHd) const
{
    const float segmentM = state.field(at, kSegmentLength);
    float& lean = state.field(at, kLean);
    lean = 0.0F;
    // A braid lies where its weight takes it: it is too stiff and too thick to be laid.
    if ((*m_groom->basis)[BasisQuantity::Girth][strand] > 0.0F || !reachesShoulders(restHd, segmentM, m_neck))
        return;
    std::array<glm::vec3, kMostNodes> hanging;
    const std::span<glm::vec3> nodesHd = std::span(hanging).first(restHd.size());
    hang(state, at, restHd, glm::vec3(0.0F, -1.0F, 0.0F), nodesHd);
    lean = leanOf(nodesHd, segmentM, m_neck);
}

void GroupDynamics::settle(std::span<const std::size_t> strands, const StepForces& calm)
{
    if (strands.empty())
        return;
    // Only the strands that are new are stepped, packed into blocks of their own.
    const auto nodes = static_cast<std::size_t>(m_groom->nodes);
    StrandState alone;
    alone.present = 0;
    alone.resize(m_groom->nodes, blocksFor(strands.size()), m_colliders.count);
    std::vector<float> rest(alone.positions[0].size(), 0.0F);
    const GroupGains gains = [this] {
        PhysicsSettings physics = m_groom->settings.physics;
        physics.damping = std::max(physics.damping, kSettleDamping);
        GroupGains damped = gainsOf(physics, m_groom->nodes);
        damped.beginsInAir = m_groom->isOfTails;
        return damped;
    }();
    GroupGains leaning = gains; // As they would be were the hair in its first fall.
    FirstFall::begun().apply(m_neck, leaning);
    const std::vector<StepForces> steps(kSettleSteps, calm);
    parallelFor(alone.blocks, 4, [&](std::size_t begin, std::size_t end) {
        std::array<glm::vec3, kMostNodes> shape;
        std::array<glm::vec3, kMostNodes> hanging;
        for (std::size_t i = begin * kLanes; i < std::min(end * kLanes, strands.size()); ++i) {
            const std::size_t strand = strands[i];
            m_groom->blocks().read(m_groom->basis->restPositions, strand, std::span(shape).first(nodes));
            alone.shape().write(rest, i, std::span(shape).first(nodes));
            for (int row = 0; row < m_state.laneRows; ++row)
                alone.field(i, row) = m_state.field(strand, row);
            setLean(alone, i, strand, std::span(shape).first(nodes));
            hang(alone, i, std::span(shape).first(nodes), leaningDown(calm, leaning, alone.field(i, kLean)),
                 std::span(hanging).first(nodes));
            alone.setStrand(i, std::span(hanging).first(nodes));
        }
        stepBlocks(alone.view(rest.data()), gains, m_colliders, steps, 0, begin, end);
    });
    alone.present = kSettleSteps % 2;
    for (std::size_t i = 0; i < strands.size(); ++i) {
        alone.stopStrand(i);
        m_state.copyStrand(alone, i, strands[i]);
        m_state.wakeStrand(strands[i]);
    }
}

void GroupDynamics::reset()
{
    if (!m_groom)
        return;
    const auto nodes = static_cast<std::size_t>(m_groom->nodes);
    parallelFor(m_state.blocks, kBlocksAtOnce, [&](std::size_t begin, std::size_t end) {
        std::array<glm::vec3, kMostNodes> rest;
        for (std::size_t strand = begin * kLanes; strand < end * kLanes; ++strand) {
            if (m_state.field(strand, kStill) >= kUnwanted)
                continue;
            m_groom->blocks().read(m_groom->basis->restPositions, strand, std::span(rest).first(nodes));
            m_state.setStrand(strand, std::span(rest).first(nodes));
            setLean(m_state, strand, strand, std::span(rest).first(nodes));
        }
    });
    m_fall.begin();
    if (m_body)
        m_body->forget();
    if (m_braids)
        m_braids->forget();
    if (m_gathered.tails() != nullptr)
        m_gathered.tails()->reset();
    rouse();
}

void GroupDynamics::hangAnew(const StepForces& calm)
{
    if (!m_groom)
        return;
    std::vector<std::size_t> wanted;
    wanted.reserve(m_state.blocks * kLanes);
    for (std::size_t strand = 0; strand < m_state.blocks * kLanes; ++strand)
        if (m_state.field(strand, kStill) < kUnwanted)
            wanted.push_back(strand);
    settle(wanted, calm);
    if (m_body)
        m_body->forget();
    if (m_braids)
        m_braids->forget();
    if (m_gathered.tails() != nullptr)
        m_gathered.tails()->hangAnew(calm);
    rouse();
}

void GroupDynamics::wake()
{
    for (std::size_t strand = 0; strand < m_state.blocks * kLanes; ++strand) {
        if (m_state.field(strand, kStill) < kUnwanted)
            m_state.wakeStrand(strand);
    }
    if (m_gathered.tails() != nullptr)
        m_gathered.tails()->wake();
    rouse();
}

void GroupDynamics::rouse()
{
    m_awake = true;
    m_calmSteps = 0;
}

/// Single strands of a coat that is at rest tremble about where others hold them: the longer nothing moves the hair the
/// more they are damped, and the further they may go and fall asleep all the same.
std::size_t GroupDynamics::calmDown(std::span<const StepForces> steps)
{
    const unsigned doublings = doublingsAfter(m_calmSteps);
    constexpr float kDamps = 0.1F; // Fraction of the speed taken in a step, per doubling.
    m_gains.stillM = kStillM * static_cast<float>(1U << doublings);
    m_gains.drag = m_drag * (1.0F - kDamps * static_cast<float>(doublings));
    std::size_t count = 0;
    std::size_t calm = m_calmSteps;
    while (count < steps.size() && doublingsAfter(calm) == doublings)
        calm = calmAfter(calm, steps[count++]);
    return count;
}

bool GroupDynamics::asleep() const
{
    return !m_groom || !m_groom->visible || (!m_awake && (tails() == nullptr || tails()->asleep()));
}

void GroupDynamics::step(std::span<const StepForces> steps)
{
    if (m_gathered.tails() != nullptr)
        m_gathered.tails()->step(steps);
    const bool windy = std::any_of(steps.begin(), steps.end(), [](const StepForces& step) { return step.windy; });
    const bool moves =
        std::any_of(steps.begin(), steps.end(), [](const StepForces& step) { return !step.toNewHead.identity; });
    if (!m_groom || !m_groom->visible || steps.empty())
        return;
    if (moves && !windy)
        wake();
    if (!m_awake && !windy)
        return;
    SolverBlocks blocks = m_state.view(m_groom->basis->restPositions.data());
    for (std::span<const StepForces> left = steps; !left.empty();) {
        std::size_t count = left.size();
        if (m_body || m_braids)
            count = calmDown(left);
        count = std::min(count, m_fall.apply(m_neck, m_gains));
        if (m_braids)
            count = m_braids->meet(m_state, left.first(count));
        if (m_body) {
            count = m_body->meet(m_state, count);
            blocks.contact = m_body->contact();
            blocks.dense = m_body->dense();
        }
        if (m_braids) {
            blocks.braids = m_braids->planes();
            m_braids->pass(count);
        }
        parallelFor(m_state.blocks, kBlocksAtOnce, [&](std::size_t begin, std::size_t end) {
            if (m_body)
                m_body->push(blocks, m_state.present, begin, end);
            stepBlocks(blocks, m_gains, m_colliders, left.first(count), m_state.present, begin, end);
        });
        m_state.present = (m_state.present + static_cast<int>(count)) % 2;
        m_fall.pass(count);
        for (const StepForces& step : left.first(count))
            m_calmSteps = calmAfter(m_calmSteps, step);
        left = left.subspan(count);
    }
    m_awake = windy || std::any_of(m_state.awake.begin(), m_state.awake.end(), [](std::uint8_t a) { return a != 0; });
}

void GroupDynamics::write(GroupFrame& frame, float fraction, const HeadPose& pose, const Neck& neck) const
{
    frame.groom = m_groom;
    if (!m_groom->visible) {
        frame.positions.clear();
        return;
    }
    m_dependents.write(*m_groom, m_state, m_colliders, fraction, pose, neck, frame);
    m_gathered.write(frame, fraction, pose, neck);
}

} // namespace hairpaint::sim
