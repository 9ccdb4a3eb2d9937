// Hair bent by one of its points.
#include "model/tools/shaping/bent_hair.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <cmath>

using namespace hairpaint;
using namespace hairpaint::model;

class TestBentHair : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void guideStrandsKeepTheirLength_data()
    {
        QTest::addColumn<int>("node");
        QTest::addColumn<float>("x");
        QTest::addColumn<float>("y");
        QTest::addColumn<bool>("within");
        QTest::newRow("tip, aside") << 7 << 0.1F << -0.2F << true;
        QTest::newRow("tip, to the root") << 7 << 0.01F << 0.0F << true;
        QTest::newRow("middle, up") << 4 << 0.05F << 0.1F << true;
        QTest::newRow("further than it reaches") << 7 << 1.0F << 1.0F << false;
    }
    void guideStrandsKeepTheirLength()
    {
        QFETCH(int, node);
        QFETCH(float, x);
        QFETCH(float, y);
        QFETCH(bool, within);
        HairCourse course;
        for (int i = 0; i < 8; ++i)
            course.push_back({0.01F * std::sin(static_cast<float>(i)), -0.05F * static_cast<float>(i),
                              0.002F * static_cast<float>(i)});
        const HairCourse before = course;
        const glm::vec3 target(x, y, 0.02F);
        bendHair(course, static_cast<std::size_t>(node), target);
        QCOMPARE(course.front(), before.front());
        for (std::size_t i = 1; i < course.size(); ++i)
            QVERIFY(std::abs(glm::distance(course[i - 1], course[i]) - glm::distance(before[i - 1], before[i])) <
                    1e-5F);
        const float awayM = glm::distance(course[static_cast<std::size_t>(node)], target);
        QVERIFY2(within ? awayM < 1e-3F : awayM > 0.1F, qPrintable(QString::number(static_cast<double>(awayM))));
    }

    void aNodeIsPutWhereThereIsNone()
    {
        HairCourse course{{0.0F, 0.0F, 0.0F}, {0.0F, -0.1F, 0.0F}, {0.0F, -0.2F, 0.0F}};
        QCOMPARE(nodeAlong(course, 0.1F), std::size_t{1});
        QCOMPARE(course.size(), std::size_t{3});
        QCOMPARE(nodeAlong(course, 0.15F), std::size_t{2});
        QCOMPARE(course.size(), std::size_t{4});
        QVERIFY(glm::distance(course[2], glm::vec3(0.0F, -0.15F, 0.0F)) < 1e-6F);
        QCOMPARE(nodeAlong(course, 1.0F), std::size_t{3});
    }
};

HAIRPAINT_TEST(TestBentHair, Gui)
#include "test_bent_hair.moc"
