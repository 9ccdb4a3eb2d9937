// What of the hair is said to hide what lies behind.
#include "tests/rendering/hand_made_hair.h"
#include "tests/support/test_program.h"
#include "view/rendering/eye_grid.h"
#include "view/rendering/light/hair_light.h"
#include "view/rendering/software/opacity_grids.h"

#include <QtTest>

#include <algorithm>
#include <numeric>
#include <vector>

using namespace hairpaint::rendering;
using namespace hairpaint::testing;

class TestOpacityGrids : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    /// A braid's hairs are counted in its middle line and run to and fro about it: were all of them in front of one
    /// that passes before that line, the braid would have slots.
    void oneVoxelHidesNoMoreThanItMay()
    {
        Scene scene = emptyScene();
        scene.hair = makeFrame(comb(0xFF808080U, 20'000, 0.002F, 80e-6F), plainSettings());
        const FrameConstants constants = frameConstants(scene, {.width = 200, .height = 150}, 0.1F);
        std::vector<std::uint32_t> slots(20'000);
        std::iota(slots.begin(), slots.end(), 0U);
        const std::vector<OpacityGrids::Source> sources{
            {.group = &scene.hair->groups[0], .slots = slots, .detail = 1.0F}};
        OpacityGrids grids;
        grids.fill(sources, constants, true);
        constexpr std::size_t kSlice = static_cast<std::size_t>(kGridSide) * kGridSide;
        std::uint32_t most = 0;
        std::uint32_t mostBehind = 0;
        for (std::size_t column = 0; column < kSlice; ++column)
            for (std::size_t z = 1; z < kGridSide; ++z) {
                const std::uint32_t before = grids.grid(1)[(z - 1) * kSlice + column] & 0xFFFFU;
                const std::uint32_t here = grids.grid(1)[z * kSlice + column] & 0xFFFFU;
                most = std::max(most, before == 0 ? here : 0U);
                mostBehind = std::max(mostBehind, here);
            }
        QVERIFY(most > 0);
        QVERIFY(mostBehind >= most);
        QVERIFY2(most <= static_cast<std::uint32_t>(0.5F * kMostWithinVoxel * kGridUnits + 1.0F),
                 qPrintable(QString::number(most)));
    }
};

HAIRPAINT_TEST(TestOpacityGrids, None)
#include "test_opacity_grids.moc"
