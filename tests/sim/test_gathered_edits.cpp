// Ties that change: what is tied, painted and dragged is built anew where it differs, and nowhere else.
#include "groom_bytes.h"
#include "sim/base/deterministic.h"
#include "sim/base/parallel.h"
#include "tests/support/test_program.h"
#include "tied_ball.h"

#include <QtTest>

#include <map>

using namespace hairpaint::sim;
using namespace hairpaint::test;
using namespace hairpaint::test::tied;

class TestGatheredEdits : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void cleanup() { setThreadCount(0); }

    void eachTailFollowsItsOwnTieAlone()
    {
        GroomInput input = tiedBall();
        input.groups.front().ties = {tieAt(1, {-0.8F, 0.2F, -0.5F}), tieAt(2, {0.8F, 0.2F, -0.5F})};
        paintSquare(input.groups.front().gathered, {0.5F, 0.45F}, {1.0F, 1.0F}, 2);
        const auto groom = groomed(input);
        QVERIFY(groom->tails != nullptr);
        const MapRaster& map = input.groups.front().gathered;
        const auto numberAt = [&](std::uint32_t slot) { return map->sampleNearest(groom->roots->uv[slot])[0]; };
        std::map<int, int> counts;
        forEachGathered(*groom, [&](std::uint32_t slot, const StrandStyle&, bool isTailed) {
            QVERIFY(isTailed);
            ++counts[numberAt(slot)];
            const Followed& followed = groom->chunks[chunkOf(slot)]->followed[inChunk(slot)];
            float sum = 0.0F;
            for (std::size_t k = 0; k < followed.basis.size(); ++k) {
                sum += followed.weights[k];
                if (followed.weights[k] > 0.0F)
                    QCOMPARE(numberAt(groom->roots->basisSlot[followed.basis[k]]), numberAt(slot));
            }
            QVERIFY(std::abs(sum - 1.0F) < 1e-5F);
        });
        QVERIFY(counts[1] > 500 && counts[2] > 500);
    }

    void aPatchWithoutBasisHairBorrowsOne()
    {
        GroomInput input = tiedBall(40000);
        input.groups.front().settings.basisHairs = 32;
        input.groups.front().gathered = mapOfTexel(1, {0});
        paintSquare(input.groups.front().gathered, {0.48F, 0.78F}, {0.52F, 0.80F}, 1);
        std::size_t tailed = 0;
        forEachGathered(*groomed(input),
                        [&](std::uint32_t, const StrandStyle&, bool isTailed) { tailed += isTailed ? 1 : 0; });
        QVERIFY2(tailed > 5, qPrintable(QString::number(tailed)));
    }

    void paintingBesideChangesNoTiedHair()
    {
        GroomInput input = tiedBall();
        GroomBuilder builder;
        const auto before = builder.update(input).grooms.front();
        paintSquare(input.groups.front().maps[MapSlot::Length], {0.2F, 0.1F}, {0.8F, 0.42F}, 30000);
        paintSquare(input.groups.front().maps[MapSlot::Braid], {0.2F, 0.1F}, {0.8F, 0.42F}, 1);
        const auto after = builder.update(input).grooms.front();
        QVERIFY(differenceOf(*before, *after) != nullptr);
        forEachGathered(*before, [&](std::uint32_t slot, const StrandStyle& style, bool) {
            QVERIFY(sameBytes(std::vector{style}, std::vector{after->style(slot)}));
            for (int node = 0; node < before->nodes; ++node)
                QVERIFY(restNode(*before, slot, node) == restNode(*after, slot, node));
        });
        QVERIFY(after->tails == before->tails || differenceOf(*after->tails, *before->tails) == nullptr);
    }

    void tyingChangesNoLooseHair()
    {
        GroomInput input = tiedBall();
        const auto tied = groomed(input);
        input.groups.front().ties.clear();
        const auto loose = groomed(input);
        forEachHair(*tied, [&](std::uint32_t slot, const StrandStyle& style) {
            if (tied->chunks[chunkOf(slot)]->gathered[inChunk(slot)])
                return;
            QVERIFY(sameBytes(std::vector{style}, std::vector{loose->style(slot)}));
            for (int node = 0; node < tied->nodes; ++node)
                QVERIFY(restNode(*tied, slot, node) == restNode(*loose, slot, node));
        });
    }

    void hairOfTiesInTurnsLiesAsIfItsNeighboursWereLoose()
    {
        GroomInput input = tiedBall(2000);
        GroomInput::Group& group = input.groups.front();
        group.ties.push_back(tieAt(2, {0.7F, 0.5F, -0.5F}));
        for (int stripe = 0; stripe < 25; ++stripe) {
            const float fromU = 0.04F * static_cast<float>(stripe);
            paintSquare(group.gathered, {fromU, 0.5F}, {fromU + 0.02F, 0.95F}, 2);
        }
        const auto both = groomed(input);
        group.ties.pop_back();
        const auto one = groomed(input);
        int count = 0;
        forEachGathered(*one, [&](std::uint32_t slot, const StrandStyle&, bool) {
            for (int node = 0; node <= ringNode(one->nodes); ++node)
                QVERIFY(restNode(*both, slot, node) == restNode(*one, slot, node));
            ++count;
        });
        QVERIFY2(count > 300, qPrintable(QString::number(count)));
    }

    void randomEditsEqualAFreshBuild_data()
    {
        QTest::addColumn<int>("seed");
        for (int seed = 0; seed < 6; ++seed)
            QTest::addRow("seed %d", seed) << seed;
    }

    void randomEditsEqualAFreshBuild()
    {
        QFETCH(int, seed);
        GroomInput input = tiedBall(4000);
        GroomInput::Group& group = input.groups.front();
        group.settings.locks.sizeM = seed % 2 == 0 ? 0.0F : 0.03F;
        group.maps[MapSlot::Clump] = mapOfTexel(1, {30000});
        std::uint64_t chance = hash64(77, static_cast<std::uint64_t>(seed));
        const auto next = [&](std::uint64_t below) {
            chance = hash64(chance, 1);
            return chance % below;
        };
        const auto square = [&](MapRaster& map, std::uint16_t value) {
            const glm::vec2 low(static_cast<float>(next(80)) / 100.0F, 0.3F + static_cast<float>(next(50)) / 100.0F);
            paintSquare(map, low, low + 0.15F, value);
        };
        GroomBuilder builder;
        for (int edit = 0; edit < 14; ++edit) {
            switch (next(8)) {
            case 0:
            case 1:
                if (group.gathered)
                    square(group.gathered, static_cast<std::uint16_t>(next(4)));
                break;
            case 2:
                square(group.maps[MapSlot::Length], static_cast<std::uint16_t>(next(65536)));
                break;
            case 3:
                square(group.maps[MapSlot::Braid], static_cast<std::uint16_t>(next(2)));
                break;
            case 4:
                square(group.maps[MapSlot::Density], static_cast<std::uint16_t>(next(2) * 65535));
                break;
            case 5:
                for (Tie& tie : group.ties) {
                    tie.pointHd.x += 0.004F;
                    tie.form = next(4) == 0 ? TieForm::Bun : TieForm::Tail;
                }
                break;
            case 6:
                group.ties = {tieAt(1, {0.0F, 0.6F, -0.8F})};
                if (next(2) == 0)
                    group.ties.push_back(tieAt(2, {0.8F, 0.2F, -0.5F}));
                if (next(2) == 0)
                    group.ties.push_back(tieAt(3, {0.0F, 1.0F, 0.1F}, {0.0F, 1.0F, 0.0F}));
                break;
            default:
                square(group.maps[MapSlot::Clump], static_cast<std::uint16_t>(next(65536)));
                break;
            }
            setThreadCount(edit % 2 == 0 ? 0 : 1);
            const auto updated = builder.update(input).grooms.front();
            const auto fresh = groomed(input);
            const char* const difference = differenceOf(*updated, *fresh);
            QVERIFY2(difference == nullptr,
                     qPrintable(QStringLiteral("edit %1: %2").arg(edit).arg(QLatin1StringView(difference))));
        }
    }

    void anyNumberOfThreadsGivesTheSameFrame()
    {
        std::vector<float> first;
        for (const int threads : {1, 2, 5}) {
            setThreadCount(threads);
            Simulation simulation;
            simulation.setInput(tiedBall());
            simulation.settle(0.3);
            const GroupFrame frame = frameOf(simulation);
            if (first.empty())
                first = frame.positions;
            QVERIFY(sameBytes(first, frame.positions));
        }
    }

    void aTieThatNoRootReadsIsNone()
    {
        GroomInput input = tiedBall();
        const std::vector<Tie> ties = input.groups.front().ties;
        input.groups.front().ties.clear();
        GroomBuilder builder;
        (void)builder.update(input);
        input.groups.front().ties = {tieAt(9, {0.0F, 1.0F, 0.0F})};
        QVERIFY(builder.update(input).grooms.front()->tails == nullptr);
        input.groups.front().ties = ties;
        QVERIFY(builder.update(input).grooms.front()->tails != nullptr);
    }

    void aDraggedTieTakesItsTailAlong()
    {
        GroomInput input = tiedBall();
        Simulation simulation;
        simulation.setInput(input);
        simulation.settle(3.0);
        const GroupFrame before = frameOf(simulation);
        input.groups.front().ties.front().pointHd.x += 0.003F;
        simulation.setInput(input);
        QVERIFY(!simulation.isNew());
        const GroupFrame after = frameOf(simulation);
        forEachGathered(*after.groom, [&](std::uint32_t slot, const StrandStyle&, bool isTailed) {
            if (isTailed)
                QVERIFY(glm::length(frameNodes(after, slot).back() - frameNodes(before, slot).back()) < 0.02F);
        });
        simulation.settle(10.0);
        QVERIFY(simulation.asleep());
    }
};

HAIRPAINT_TEST(TestGatheredEdits, None)
#include "test_gathered_edits.moc"
