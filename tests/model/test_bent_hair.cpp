// Hair bent by one of its points.
#include "model/tools/bent_hair.h"
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

    void hairThatSwingsKeepsItsShape_data()
    {
        QTest::addColumn<float>("x");
        QTest::addColumn<float>("y");
        QTest::newRow("aside") << 0.2F << -0.2F;
        QTest::newRow("straight up") << 0.0F << 0.4F;
        QTest::newRow("where it is") << 0.0F << -0.4F;
    }
    void hairThatSwingsKeepsItsShape()
    {
        QFETCH(float, x);
        QFETCH(float, y);
        HairCourse course{{0.0F, 0.0F, 0.0F}, {0.03F, -0.1F, 0.0F}, {0.02F, -0.2F, 0.01F}, {0.0F, -0.4F, 0.0F}};
        const HairCourse before = course;
        const glm::vec3 target(x, y, 0.0F);
        swingHair(course, course.back(), target);
        QCOMPARE(course.front(), before.front());
        QVERIFY(glm::distance(course[3], glm::normalize(target) * 0.4F) < 1e-4F);
        for (std::size_t i = 0; i < course.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                QVERIFY(std::abs(glm::distance(course[i], course[j]) - glm::distance(before[i], before[j])) < 1e-5F);
    }

    void pointsLieAlongTheHair()
    {
        const HairCourse course{{0.0F, 0.0F, 0.0F}, {0.0F, -0.1F, 0.0F}, {0.1F, -0.1F, 0.0F}};
        QVERIFY(glm::distance(pointAlong(course, 0.15F), glm::vec3(0.05F, -0.1F, 0.0F)) < 1e-6F);
        QCOMPARE(pointAlong(course, 0.0F), course.front());
        QCOMPARE(pointAlong(course, 1.0F), course.back());
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
