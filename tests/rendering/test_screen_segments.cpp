// Batches of segments keep the room that pictures need, and no more.
#include "tests/support/test_program.h"
#include "view/rendering/software/screen_segments.h"

#include <QtTest>

using namespace hairpaint::rendering;

namespace {

const TileGrid kTiles(320, 320, 1e6F);

/// Sixteen strands upright beside each other.
StrandPoints uprightStrands(int segments)
{
    StrandPoints points;
    points.resize(static_cast<std::size_t>(segments) + 1);
    for (std::size_t i = 0; i < points.x.size(); ++i) {
        points.x[i] = 10.0F + 18.0F * static_cast<float>(i % kBlockLanes);
        const std::size_t point = i / kBlockLanes;
        points.y[i] = 5.0F + 300.0F * static_cast<float>(point) / static_cast<float>(segments);
        points.depth[i] = 1000.0F;
        points.width[i] = 1.0F;
        points.colour[i] = 0;
    }
    return points;
}

void drawPicture(SegmentBatch& batch, const StrandPoints& points, int segments, int blocks)
{
    SegmentScratch scratch;
    batch.clear();
    for (int i = 0; i < blocks; ++i)
        batch.add(kTiles, points, segments, scratch);
    batch.sort(kTiles, scratch);
}

std::ptrdiff_t entriesOf(const SegmentBatch& batch)
{
    std::ptrdiff_t count = 0;
    for (std::size_t tile = 0; tile < kTiles.count(); ++tile)
        count += batch.end(tile) - batch.begin(tile);
    return count;
}

} // namespace

class TestScreenSegments : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void roomThatIsNotNeededAnyMoreIsFreed()
    {
        constexpr int kSegments = 20;
        constexpr int kMany = 200;
        const StrandPoints points = uprightStrands(kSegments);
        SegmentBatch batch;
        drawPicture(batch, points, kSegments, 1);
        const std::size_t little = batch.heldBytes();
        const std::ptrdiff_t entries = entriesOf(batch);
        QVERIFY(entries >= kSegments * static_cast<std::ptrdiff_t>(kBlockLanes));

        // Much once in a while is room that is needed.
        drawPicture(batch, points, kSegments, kMany);
        const std::size_t much = batch.heldBytes();
        QVERIFY(much > 20 * little);
        for (int i = 0; i < 4 * SegmentBatch::kPicturesKept; ++i)
            drawPicture(batch, points, kSegments, i % 8 == 0 ? kMany : 1);
        QVERIFY(batch.heldBytes() >= much / 2);

        for (int i = 0; i < 2 * SegmentBatch::kPicturesKept; ++i)
            drawPicture(batch, points, kSegments, 1);
        QVERIFY(batch.heldBytes() <= 4 * little);
        QCOMPARE(entriesOf(batch), entries);
    }
};

HAIRPAINT_TEST(TestScreenSegments, None)
#include "test_screen_segments.moc"
