// A part that begins behind the hairline.
#include "tests/model/parter.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <cmath>

using namespace hairpaint;
using namespace hairpaint::test;

class TestPartHairline : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    /// Over the top, from 0.6 before it: hair grows as far as 1.0, or everywhere.
    void hairBeforeThePartFallsToBothSides()
    {
        const auto parted = [](float bareFromZ) {
            auto part = std::make_unique<Parter>(makeBallHead(), 512, true, bareFromZ);
            part->settings.partReachM = 0.06F;
            for (const float angle : {0.6F, 0.2F, -0.3F})
                part->click(overTop(angle));
            return part;
        };
        const auto led = parted(kPartedBallM * std::sin(1.0F));
        for (const float angle : {0.7F, 0.85F, 0.97F})
            for (const float side : {-1.0F, 1.0F}) {
                const glm::vec3 beside =
                    glm::normalize(overTop(angle) + glm::vec3(side * 0.01F, 0.0F, 0.0F)) * kPartedBallM;
                QVERIFY2(led->coverageAt(beside) > 0.95F, qPrintable(QString::number(angle)));
                QVERIFY2(led->directionAt(beside).x * side > 0.7F, qPrintable(QString::number(angle)));
                QVERIFY(led->densityAt(overTop(angle)) > 0.95F); // Without a gap.
            }
        QVERIFY(led->densityAt(overTop(0.3F)) < 0.5F);
        led->cancel();
        const auto endless = parted(1.0F);
        QVERIFY(endless->coverageAt(overTop(0.97F)) < 0.5F);
        endless->cancel();
    }

    /// Its front end lies where no hair grows any more.
    void aPartFromTheHairlineIsLedNowhere()
    {
        Parter part(makeBallHead(), 512, true, kPartedBallM * std::sin(0.5F));
        for (const float angle : {0.6F, 0.2F, -0.3F})
            part.click(overTop(angle));
        QVERIFY(part.coverageAt(overTop(1.05F)) < 0.2F);
        part.cancel();
    }
};

HAIRPAINT_TEST(TestPartHairline, Gui)
#include "test_part_hairline.moc"
