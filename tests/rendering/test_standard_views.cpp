// Pictures' cameras see what they are asked to frame, as large as it fits.
#include "tests/support/test_program.h"
#include "view/rendering/standard_views.h"

#include <QtTest>

#include <cmath>
#include <random>

using namespace hairpaint::rendering;

class TestStandardViews : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void allPointsAreSeenAndFillThePicture_data()
    {
        QTest::addColumn<StandardView>("view");
        QTest::addColumn<glm::vec3>("size");
        QTest::addColumn<float>("aspect");
        for (const StandardView view : {StandardView::Front, StandardView::Left, StandardView::Top,
                                        StandardView::Bottom, StandardView::ThreeQuarter}) {
            const auto name = [&](const char* what) {
                return QStringLiteral("%1, %2").arg(int(view)).arg(QLatin1String(what));
            };
            QTest::newRow(qPrintable(name("head"))) << view << glm::vec3(0.16F, 0.25F, 0.2F) << 1.0F;
            QTest::newRow(qPrintable(name("long hair"))) << view << glm::vec3(0.4F, 1.8F, 0.4F) << 1.0F;
            QTest::newRow(qPrintable(name("wide picture"))) << view << glm::vec3(0.5F, 0.2F, 0.5F) << 2.0F;
            QTest::newRow(qPrintable(name("tall picture"))) << view << glm::vec3(0.5F, 0.2F, 0.5F) << 0.4F;
        }
    }
    void allPointsAreSeenAndFillThePicture()
    {
        QFETCH(StandardView, view);
        QFETCH(glm::vec3, size);
        QFETCH(float, aspect);
        std::mt19937 random(5);
        std::uniform_real_distribution<float> unit(-0.5F, 0.5F);
        std::vector<glm::vec3> points;
        points.reserve(500);
        while (points.size() < 500)
            points.push_back(glm::vec3(0.1F, -0.3F, 0.05F) +
                             size * glm::vec3(unit(random), unit(random), unit(random)));
        const Camera camera = fittedCamera(view, points, aspect);
        const glm::mat4 seen = camera.projection(aspect) * camera.view();
        float farthest = 0.0F;
        for (const glm::vec3& point : points) {
            const glm::vec4 clip = seen * glm::vec4(point, 1.0F);
            QVERIFY(clip.w > 0.0F);
            farthest = std::max({farthest, std::abs(clip.x / clip.w), std::abs(clip.y / clip.w)});
        }
        QVERIFY2(farthest <= 0.95F && farthest > 0.9F, qPrintable(QString::number(farthest)));
    }

    void fitsHaveNames()
    {
        QVERIFY(fitNamed("hair") == Fit::Hair);
        QVERIFY(fitNamed("head") == Fit::Head);
        QVERIFY(fitNamed("bust") == Fit::Bust);
        QVERIFY(!fitNamed("pedestal"));
    }
};

HAIRPAINT_TEST(TestStandardViews, None)
#include "test_standard_views.moc"
