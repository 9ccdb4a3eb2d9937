// Tests that an even subset of the hairs has the exact number, is equally dense everywhere, and that smaller subsets
// lie within larger ones.
#include "sim/groom/even_subset.h"
#include "tests/support/test_grooms.h"
#include "tests/support/test_heads.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <set>

using namespace hairpaint::sim;
using namespace hairpaint::test;

namespace {

using Grooms = std::vector<std::shared_ptr<const Groom>>;

/// Twice as dense on the left as on the right, and a hidden group.
Grooms twoGroups()
{
    GroomInput input;
    input.skin = std::make_shared<const Skin>(makePatchHead(16, 0.2F));
    for (int id = 1; id <= 3; ++id) {
        GroomInput::Group group = uniformGroup();
        group.id = id;
        group.settings.greatestDensityPerM2 = 5e5F;
        group.settings.basisHairs = 256;
        group.maps[MapSlot::Density] = halves(1.0F, 0.5F);
        group.visible = id != 2;
        input.groups.push_back(group);
    }
    return GroomBuilder().update(input).grooms;
}

/// Group and slot of every drawn hair of the visible groups.
std::set<std::pair<int, std::size_t>> drawn(const Grooms& grooms)
{
    std::set<std::pair<int, std::size_t>> hairs;
    for (const auto& groom : grooms) {
        std::size_t count = 0;
        for (std::size_t slot = 0; slot < groom->roots->count(); ++slot)
            if (const auto& chunk = groom->chunks[slot / kChunkSlots]; chunk && chunk->drawn[slot % kChunkSlots]) {
                ++count;
                if (groom->visible)
                    hairs.emplace(groom->groupId, slot);
            }
        if (count != groom->drawnCount)
            return {};
    }
    return hairs;
}

} // namespace

class TestEvenSubset : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void theNumberIsExactAndSmallerSubsetsArePartsOfLarger()
    {
        const Grooms all = twoGroups();
        auto larger = drawn(all);
        QVERIFY(larger.size() > 20'000);
        for (const std::size_t count : {std::size_t{20'000}, std::size_t{9'999}, std::size_t{1'000}, std::size_t{1}}) {
            const auto kept = drawn(evenSubset(all, count));
            QCOMPARE(kept.size(), count);
            QVERIFY(std::ranges::includes(larger, kept));
            larger = kept;
        }
    }

    void everywhereTheSameFractionIsKept()
    {
        const Grooms all = twoGroups();
        const Grooms kept = evenSubset(all, drawn(all).size() / 4);
        const auto inHalf = [](const Groom& groom, bool left) {
            std::size_t count = 0;
            for (std::size_t slot = 0; slot < groom.roots->count(); ++slot)
                if (const auto& chunk = groom.chunks[slot / kChunkSlots];
                    chunk && chunk->drawn[slot % kChunkSlots] && (groom.roots->uv[slot].x < 0.5F) == left)
                    ++count;
            return static_cast<double>(count);
        };
        for (const std::size_t group : {std::size_t{0}, std::size_t{2}})
            for (const bool left : {true, false}) {
                const double fraction = inHalf(*kept[group], left) / inHalf(*all[group], left);
                QVERIFY2(std::abs(fraction - 0.25) < 0.01, qPrintable(QString::number(fraction)));
            }
        QCOMPARE(inHalf(*kept[1], true), inHalf(*all[1], true)); // Hidden hair is in no subset.
    }

    void allAreKeptWhereThereAreNoMore()
    {
        const Grooms all = twoGroups();
        QVERIFY(evenSubset(all, drawn(all).size()) == all);
        QVERIFY(evenSubset({}, 5).empty());
    }
};

HAIRPAINT_TEST(TestEvenSubset, None)
#include "test_even_subset.moc"
