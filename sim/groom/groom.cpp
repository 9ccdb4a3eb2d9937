// Gives every group its roots and keeps its builder.
#include "sim/groom/groom.h"

#include "sim/base/deterministic.h"
#include "sim/base/parallel.h"
#include "sim/groom/group_builder.h"
#include "sim/skin/skin_band.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::sim {

namespace {

/// What all hairs together may weigh, in nodes: a hair weighs its own and about four more for its root and style. At 8
/// nodes a hair no cap below 1,167,000 hairs is felt; drawing them takes about 2 GB.
constexpr std::size_t kMostWeight = 14'000'000;

std::size_t weightOf(const GroupSettings& settings)
{
    constexpr int kRootAndStyle = 4;
    return static_cast<std::size_t>(std::max(settings.nodesPerHair, 2) + kRootAndStyle);
}

/// Candidates that the density asks for, before any limit.
std::size_t wantedCandidates(const GroomInput::Group& group, const Skin& skin)
{
    constexpr double kMost = 4e9;
    const double count = static_cast<double>(group.settings.greatestDensityPerM2) * skin.areaM2() + 0.5;
    return count > 0.0 ? static_cast<std::size_t>(std::min(count, kMost)) : 0;
}

} // namespace

struct GroomBuilder::State
{
    struct Group
    {
        int id = 0;
        std::shared_ptr<const RootSet> roots;
        std::size_t rootsAsked = 0;
        GroupBuilder builder;
    };

    /// The group's roots, built anew only where skin, seed or one of the counts differs.
    static void findRoots(Group& group, const GroomInput& input, std::size_t count, std::size_t basisCount, bool lies)
    {
        // Groups that overlap must not stand on the same roots.
        const std::uint64_t seed = hash64(input.seed, static_cast<std::uint64_t>(group.id));
        if (group.roots && group.roots->skin == input.skin && group.roots->seed == seed && group.rootsAsked == count &&
            group.roots->basisSlot.size() == std::min(basisCount, group.roots->count()))
            return;
        // The first hair is waited for: what hair that lies asks of the skin is made beside its roots, and kept.
        parallelFor(lies ? 2 : 1, 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t task = begin; task < end; ++task)
                if (task == 0)
                    group.roots = buildRoots(input.skin, count, basisCount, seed);
                else
                    (void)bandOf(input.skin);
        });
        group.rootsAsked = count;
    }

    std::vector<std::unique_ptr<Group>> groups;
    bool collectSlots = false;
};

GroomBuilder::GroomBuilder() : m_state(std::make_unique<State>()) {}
GroomBuilder::~GroomBuilder() = default;

void GroomBuilder::setCollectSlots(bool collect)
{
    m_state->collectSlots = collect;
}

GroomBuilder::Report GroomBuilder::update(const GroomInput& input)
{
    Report report;
    std::vector<std::unique_ptr<State::Group>> kept;
    auto candidatesLeft = static_cast<std::size_t>(std::max(input.maxHairs, 0));
    std::size_t weightLeft = kMostWeight;
    for (const GroomInput::Group& groupInput : input.groups) {
        auto& known = m_state->groups;
        const auto found = std::find_if(known.begin(), known.end(), [&](const std::unique_ptr<State::Group>& group) {
            return group && group->id == groupInput.id;
        });
        kept.push_back(found != known.end() ? std::move(*found) : std::make_unique<State::Group>());
        State::Group& group = *kept.back();
        group.id = groupInput.id;

        const std::size_t wanted = wantedCandidates(groupInput, *input.skin);
        const std::size_t weight = weightOf(groupInput.settings);
        const std::size_t held = weightLeft / weight;
        const std::size_t count = std::min({wanted, candidatesLeft, held});
        const HairLimit limit = count == wanted          ? HairLimit::None
                                : candidatesLeft <= held ? HairLimit::MaxHairs
                                                         : HairLimit::Memory;
        candidatesLeft -= count;
        weightLeft -= count * weight;
        const bool lies = !isUpright(MapSampler(groupInput.maps[MapSlot::Direction]));
        State::findRoots(group, input, count, static_cast<std::size_t>(std::max(groupInput.settings.basisHairs, 1)),
                         lies);
        const GroupBuilder::HeadLay head{.natural = input.naturalDirection,
                                         .band = lies ? bandOf(input.skin) : nullptr,
                                         .distances = input.distances};
        const GroupBuilder::Result result = group.builder.update(groupInput, group.roots, head, limit);
        report.grooms.push_back(result.groom);
        std::vector<std::uint32_t> rebuilt;
        result.rebuilt.forEach([&](std::uint32_t slot) {
            ++report.rebuiltStrands;
            if (m_state->collectSlots)
                rebuilt.push_back(slot);
        });
        if (!rebuilt.empty())
            report.rebuiltSlots = std::move(rebuilt);
    }
    m_state->groups = std::move(kept);
    return report;
}

} // namespace hairpaint::sim
