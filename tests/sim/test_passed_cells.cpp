// Which strands passed which cells.
#include "sim/groom/lay.h"
#include "sim/groom/passed_cells.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <random>
#include <vector>

using namespace hairpaint::sim;

class TestPassedCells : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void strandsThatPassedAreFoundHoweverOftenTheyWereLaid();
};

void TestPassedCells::strandsThatPassedAreFoundHoweverOftenTheyWereLaid()
{
    constexpr int kNodes = 8;
    constexpr std::size_t kStrands = 2 * kChunkSlots + 100;
    constexpr std::size_t kCells = 5000;
    constexpr int kRounds = 6;
    std::mt19937 random(7);
    PassedCells passed;
    passed.startOver(kStrands, kNodes);
    std::vector<std::vector<std::int32_t>> lists(kStrands);
    for (int round = 0; round < kRounds; ++round) {
        // Now and then all of a chunk is laid anew.
        const bool startsChunk = round % 2 == 1;
        if (startsChunk)
            passed.startChunk(1);
        // Strands of the first chunk pass near its number, those of the others far from it, some none any more.
        for (std::size_t strand = 0; strand < kStrands; ++strand) {
            const bool isStarted = startsChunk && chunkOf(strand) == 1;
            if (random() % 3 == 0 && !isStarted)
                continue;
            std::vector<std::int32_t>& list = lists[strand];
            list.clear();
            const std::size_t first = chunkOf(strand) * 2000 + random() % 500;
            for (std::size_t i = 0; i < random() % (Lay::mostPassed(kNodes) + 1); ++i)
                list.push_back(static_cast<std::int32_t>(std::min(first + i, kCells - 1)));
            std::vector<std::int32_t> ended = list;
            ended.resize(Lay::mostPassed(kNodes), SkinBand::kNone);
            passed.put(strand, random() % 2 == 0 ? ended : list);
        }
        for (const std::size_t number : {1U, 40U}) {
            std::vector<std::uint32_t> cells;
            for (std::size_t i = 0; i < number; ++i)
                cells.push_back(static_cast<std::uint32_t>(random() % kCells));
            SlotSet found(kStrands);
            passed.findPassing(cells, kCells, found);
            for (std::uint32_t strand = 0; strand < kStrands; ++strand) {
                const bool crosses = std::ranges::any_of(lists[strand], [&](std::int32_t cell) {
                    return std::ranges::find(cells, static_cast<std::uint32_t>(cell)) != cells.end();
                });
                QCOMPARE(found.contains(strand), crosses);
            }
        }
    }
}

HAIRPAINT_TEST(TestPassedCells, None)
#include "test_passed_cells.moc"
