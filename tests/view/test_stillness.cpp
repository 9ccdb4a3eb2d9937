// Motion that shows is told from motion that does not.
#include "tests/support/test_program.h"
#include "view/head_area/stillness.h"

#include <QTest>

#include <algorithm>
#include <numeric>

using namespace hairpaint;

namespace {

constexpr std::size_t kChunks = 8;

/// A groom of eight full chunks, with eight nodes a hair.
std::shared_ptr<sim::Groom> fullGroom()
{
    auto groom = std::make_shared<sim::Groom>();
    groom->chunks.assign(kChunks, std::make_shared<sim::StrandChunk>());
    groom->packedChunk.resize(kChunks);
    std::iota(groom->packedChunk.begin(), groom->packedChunk.end(), 0);
    groom->packedChunks = kChunks;
    return groom;
}

std::shared_ptr<sim::StrandFrame> frameOf(std::shared_ptr<const sim::Groom> groom, float shiftM)
{
    auto frame = std::make_shared<sim::StrandFrame>();
    frame->groups.push_back({.groom = std::move(groom), .positions = {}});
    frame->groups.front().positions.assign(
        frame->groups.front().groom->blocks().floatsFor(kChunks * sim::kBlocksPerChunk), shiftM);
    return frame;
}

} // namespace

class TestStillness : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aPixelIsTheLimit_data()
    {
        QTest::addColumn<double>("px");
        QTest::addColumn<bool>("moves");
        QTest::newRow("nothing") << 0.0 << false;
        QTest::newRow("half a pixel") << 0.5 << false;
        QTest::newRow("two pixels") << 2.0 << true;
    }
    void aPixelIsTheLimit()
    {
        QFETCH(double, px);
        QFETCH(bool, moves);
        const rendering::Camera camera;
        const QSize area(600, 500);
        const double metresPerPx =
            2.0 * static_cast<double>(camera.distanceM * std::tan(camera.fieldOfViewRad / 2.0F)) / area.height();
        const auto groom = fullGroom();
        view::Stillness stillness;
        QVERIFY(stillness.moved(frameOf(groom, 0.0F), camera, area)); // The first.
        const auto shift = static_cast<float>(px * metresPerPx / std::sqrt(3.0));
        QCOMPARE(stillness.moved(frameOf(groom, shift), camera, area), moves);
    }

    void aSlowDriftIsNoticed()
    {
        const rendering::Camera camera;
        const auto groom = fullGroom();
        view::Stillness stillness;
        QVERIFY(stillness.moved(frameOf(groom, 0.0F), camera, {600, 500}));
        int noticed = 0;
        for (int i = 1; i <= 100; ++i)
            noticed += stillness.moved(frameOf(groom, 5e-5F * static_cast<float>(i)), camera, {600, 500}) ? 1 : 0;
        QVERIFY(noticed >= 3 && noticed < 50);
    }

    void oneTipThatMovesIsEnough()
    {
        const auto groom = fullGroom();
        const auto before = frameOf(groom, 0.0F);
        const auto after = frameOf(groom, 0.0F);
        // The last of eight nodes of one block in nine.
        for (std::size_t block = 0; block < 512; block += 9)
            after->groups.front().positions[(block * 8 + 7) * 3 * sim::kLanes] = 0.05F;
        view::Stillness stillness;
        QVERIFY(stillness.moved(before, {}, {600, 500}));
        QVERIFY(stillness.moved(after, {}, {600, 500}));
    }

    void whatNoFramePositionsDoesNotMove()
    {
        const auto groom = fullGroom();
        const auto chunk = std::make_shared<sim::StrandChunk>();
        chunk->leastDetail.fill(0.5F);
        chunk->leastDetail.front() = 0.0F;
        groom->chunks.assign(kChunks, chunk);
        const auto before = frameOf(groom, 0.0F);
        const auto after = frameOf(groom, 0.05F);
        for (const auto& frame : {before, after})
            frame->groups.front().detail = 0.25F;
        const std::size_t blockFloats = groom->blocks().blockFloats();
        for (std::size_t c = 0; c < kChunks; ++c)
            std::fill_n(after->groups.front().positions.begin() +
                            static_cast<std::ptrdiff_t>(c * sim::kBlocksPerChunk * blockFloats),
                        blockFloats, 0.0F);
        view::Stillness stillness;
        QVERIFY(stillness.moved(before, {}, {600, 500}));
        QVERIFY(!stillness.moved(after, {}, {600, 500}));
    }

    void anotherGroomOrPoseIsAnotherPicture()
    {
        const auto groom = fullGroom();
        view::Stillness stillness;
        const auto first = frameOf(groom, 0.0F);
        QVERIFY(stillness.moved(first, {}, {600, 500}));
        QVERIFY(!stillness.moved(first, {}, {600, 500}));
        QVERIFY(stillness.moved(frameOf(fullGroom(), 0.0F), {}, {600, 500}));
        const auto turned = frameOf(groom, 0.0F);
        turned->pose.positionWo.x = 0.01F;
        QVERIFY(stillness.moved(turned, {}, {600, 500}));
    }
};

HAIRPAINT_TEST(TestStillness, None)
#include "test_stillness.moc"
