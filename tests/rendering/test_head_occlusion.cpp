// What the head is said to hide, it hides: against every sample of a picture.
#include "tests/support/test_program.h"
#include "view/rendering/software/head_occlusion.h"

#include <QtTest>

#include <algorithm>
#include <limits>
#include <vector>

using namespace hairpaint::rendering;

namespace {

constexpr int kWidth = 301; // No whole number of cells.
constexpr int kHeight = 229;
constexpr float kNowhere = std::numeric_limits<float>::max();

std::size_t sampleAt(int x, int y)
{
    return static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x);
}

/// A disc whose rim is covered by halves, with some that is worn; nearest in the middle.
struct Disc
{
    std::vector<HeadSample> samples;
    std::vector<float> distancesM;
    std::vector<std::uint8_t> worn;

    Disc() : samples(kWidth * kHeight), distancesM(kWidth * kHeight, 1e9F), worn(kWidth * kHeight, 0)
    {
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x) {
                const int dx = x - 140;
                const int dy = y - 110;
                const auto at = sampleAt(x, y);
                if (dx * dx + dy * dy > 100 * 100)
                    continue;
                samples[at].cover = dx * dx + dy * dy > 97 * 97 ? 0x8000 : 0xFFFF;
                distancesM[at] = 0.5F + 1e-5F * static_cast<float>(dx * dx + dy * dy);
                worn[at] = dy > 40 ? 1 : 0;
            }
    }
    [[nodiscard]] HeadOcclusion::Picture picture() const
    {
        return {.width = kWidth,
                .height = kHeight,
                .samples = samples.data(),
                .distancesM = distancesM.data(),
                .worn = worn.data()};
    }
    [[nodiscard]] float beyondM(int x, int y) const
    {
        const auto at = sampleAt(x, y);
        return samples[at].cover == 0xFFFF ? distancesM[at] + hairShownBehindM(worn[at] != 0) : kNowhere;
    }
};

HeadOcclusion occlusionOf(const Disc& disc)
{
    HeadOcclusion occlusion;
    occlusion.resize(kWidth, kHeight);
    occlusion.fillRows(disc.picture(), 0, 64, true);
    occlusion.fillRows(disc.picture(), 64, kHeight, true);
    occlusion.combine();
    return occlusion;
}

float foundM(const OcclusionCells& cells, int level, int x, int y)
{
    return cells.beyondM[(cells.firstRow.at(static_cast<std::size_t>(level)) + y) * cells.across + x];
}

} // namespace

class TestHeadOcclusion : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aCellTellsTheFarthestOfItselfAndItsNeighbours()
    {
        const Disc disc;
        const HeadOcclusion occlusion = occlusionOf(disc);
        const OcclusionCells cells = occlusion.cells();
        int hidden = 0;
        for (int level = 0; level < kOcclusionLevels; ++level) {
            const int side = kOcclusionCellSp << level;
            for (int y = 0; y * side < kHeight; ++y)
                for (int x = 0; x * side < kWidth; ++x) {
                    float farthestM = 0.0F;
                    for (int sy = y * side; sy < std::min((y + 2) * side, kHeight); ++sy)
                        for (int sx = x * side; sx < std::min((x + 2) * side, kWidth); ++sx)
                            farthestM = std::max(farthestM, disc.beyondM(sx, sy));
                    QCOMPARE(foundM(cells, level, x, y), farthestM);
                    hidden += farthestM < kNowhere ? 1 : 0;
                }
        }
        QVERIFY2(hidden > 300, qPrintable(QString::number(hidden)));
    }

    void withoutAHeadNothingIsHidden()
    {
        const Disc disc;
        HeadOcclusion occlusion = occlusionOf(disc);
        occlusion.fillRows(disc.picture(), 0, kHeight, false);
        occlusion.combine();
        for (int y = 0; y * kOcclusionCellSp < kHeight; ++y)
            for (int x = 0; x * kOcclusionCellSp < kWidth; ++x)
                QCOMPARE(foundM(occlusion.cells(), 0, x, y), kNowhere);
    }
};

HAIRPAINT_TEST(TestHeadOcclusion, None)
#include "test_head_occlusion.moc"
