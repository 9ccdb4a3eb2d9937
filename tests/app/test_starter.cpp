// The project that the program starts with.
#include "app/headless/settled_hair.h"
#include "app/styles/library.h"
#include "tests/support/test_program.h"
#include "view/look/resources.h"

#include <QtTest>

#include <cmath>

namespace hairpaint::app {

namespace {

/// The starter's skeletons after two seconds, of few hairs.
std::vector<float> settled(bool wind)
{
    model::Project project = starterProject();
    project.maxHairs = 20'000;
    project.wind.enabled = wind;
    return SettledHair(std::move(project), 2.0).frame()->groups.front().positions;
}

} // namespace

class TestStarter : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { view::initResources(); }

    void theWindIsABreathThatSkewsNoHaircut()
    {
        const std::vector<float> still = settled(false);
        const std::vector<float> blown = settled(true);
        QCOMPARE(blown.size(), still.size());
        double sum = 0.0;
        double shift = 0.0;
        std::size_t nodes = 0;
        for (std::size_t row = 0; row < still.size(); row += 3 * sim::kLanes)
            for (std::size_t lane = row; lane < row + sim::kLanes; ++lane) {
                if (still[lane] == 0.0F)
                    continue;
                const auto x = static_cast<double>(blown[lane] - still[lane]);
                const auto y = static_cast<double>(blown[lane + sim::kLanes] - still[lane + sim::kLanes]);
                const auto z = static_cast<double>(blown[lane + 2 * sim::kLanes] - still[lane + 2 * sim::kLanes]);
                sum += std::sqrt(x * x + y * y + z * z);
                shift += x;
                ++nodes;
            }
        QVERIFY(nodes > 1000);
        const double meanM = sum / static_cast<double>(nodes);
        const double shiftM = std::abs(shift) / static_cast<double>(nodes);
        QVERIFY2(meanM > 1e-5, qPrintable(QString::number(meanM)));
        QVERIFY2(meanM < 0.006, qPrintable(QString::number(meanM)));
        QVERIFY2(shiftM < 0.003, qPrintable(QString::number(shiftM)));
    }

    void aBaldHeadIsTheFirstStyleAndHasNoHair()
    {
        const std::vector<model::PresetEntry> styles = listStyles();
        QCOMPARE(styles.front().path, baldStylePath());
        QCOMPARE(styleName(styles.front().path), QStringLiteral("Bald"));
        const model::Result<model::Preset> bald = loadStyle(styles.front().path);
        QVERIFY(bald && bald->groups.size() == 1);
        QVERIFY(loadStyle(styles[1].path));
    }
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestStarter, Core)
#include "test_starter.moc"
