// Where long hair falls that nobody has combed, a stroke begins with how it lies.
#include "model/files/head_file.h"
#include "model/tools/lying/fallen_hair.h"
#include "sim/groom/direction_texel.h"
#include "tests/model/tool_studio.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <cmath>

using namespace hairpaint;
using namespace hairpaint::test;

namespace {

/// The built-in head with nothing combed, all hair of one length.
Project uncombed(float lengthM)
{
    Project project = filledPatch(MapKind::Length, 65535);
    project.head = defaultHead();
    project.groups.front().settings.greatestLengthM = lengthM;
    return project;
}

/// On top of the head, beside the middle.
const glm::vec3 kTop(0.03F, 0.15F, 0.02F);

} // namespace

class TestFallenHair : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void longHairFallsToItsSideAndShortHairLiesAsItGrows()
    {
        for (const float lengthM : {0.40F, 0.03F}) {
            Studio studio(uncombed(lengthM));
            studio.map = MapKind::Direction;
            SkinFrames frames(studio.document.project().head->skin);
            FallenHair hair(studio.context(), frames, studio.layer().size());
            const sim::SurfacePoint point = frames.skin().nearest(kTop);
            const glm::vec3 liesHd = sim::SkinFrame::at(point).toHd(hair.at(point.uv));
            const bool fallen = liesHd.x > 0.5F;
            QCOMPARE(fallen, lengthM > 0.2F);
            QCOMPARE(liesHd.z > 0.2F, lengthM < 0.2F); // Forward, as the stream goes there.
        }
    }

    void onlyWhatIsPaintedOnIsFilledIn()
    {
        Studio studio(uncombed(0.40F));
        studio.map = MapKind::Direction;
        SkinFrames frames(studio.document.project().head->skin);
        FallenHair hair(studio.context(), frames, studio.layer().size());
        const glm::vec2 uv = frames.skin().nearest(kTop).uv;
        const int size = studio.layer().size();
        const glm::ivec2 texel(static_cast<int>(uv.x * static_cast<float>(size)),
                               static_cast<int>((1.0F - uv.y) * static_cast<float>(size)));
        constexpr int kSide = sim::TiledRaster::kTileSize;
        const int tile = texel.y / kSide * studio.layer().tilesAcross() + texel.x / kSide;
        const std::size_t inTile =
            static_cast<std::size_t>(texel.y % kSide) * kSide + static_cast<std::size_t>(texel.x % kSide);
        StrokeBuffer::MaskTile mask{};
        mask[inTile] = 1;
        const sim::RasterTilePtr before = studio.layer().tile(tile);
        QCOMPARE(hair.under(tile, before, mask), before); // Not looked at.
        hair.look(tile);
        QCOMPARE(hair.under(tile, before, {}), before);
        const sim::RasterTilePtr filled = hair.under(tile, before, mask);
        int painted = 0;
        for (std::size_t i = 0; i < sim::kTileTexels; ++i)
            painted += filled->pixels[3 * i + 2] != 0 ? 1 : 0;
        QCOMPARE(painted, 1);
        const glm::vec2 there = sim::directionOf({filled->pixels[3 * inTile], filled->pixels[3 * inTile + 1], 0, 0});
        QVERIFY(
            glm::distance(there, hair.at((glm::vec2(texel) + 0.5F) / static_cast<float>(size) * glm::vec2(1.0F, -1.0F) +
                                         glm::vec2(0.0F, 1.0F))) < 1e-3F);
    }

    void combedHairLiesAsItIsCombed()
    {
        Studio studio(uncombed(0.40F));
        studio.map = MapKind::Direction;
        const glm::vec2 uv = studio.document.project().head->skin->nearest(kTop).uv;
        studio.settings.brushSizeM = 0.04F;
        studio.settings.hardness = 1.0F;
        studio.press(QStringLiteral("comb"), uv.x, uv.y - 0.03F);
        studio.move(QStringLiteral("comb"), uv.x, uv.y + 0.03F);
        studio.release(QStringLiteral("comb"), uv.x, uv.y + 0.03F);
        SkinFrames frames(studio.document.project().head->skin);
        FallenHair hair(studio.context(), frames, studio.layer().size());
        const glm::vec2 lies = hair.at(uv);
        QVERIFY2(lies.y > 0.8F && std::abs(lies.x) < 0.3F, qPrintable(QStringLiteral("%1 %2").arg(lies.x).arg(lies.y)));
    }
};

HAIRPAINT_TEST(TestFallenHair, None)
#include "test_fallen_hair.moc"
