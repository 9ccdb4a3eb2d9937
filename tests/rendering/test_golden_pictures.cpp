// Small pictures of what the renderer draws, kept beside the tests: a change of the look is seen, and meant or mended.
// HAIRPAINT_WRITE_GOLDEN=1 writes them anew.
#include "tests/rendering/golden_scenes.h"
#include "tests/rendering/renderer_fixture.h"
#include "tests/support/locations.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QImage>
#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace hairpaint;
using namespace hairpaint::testing;

namespace {

constexpr int kWidth = 160;
constexpr int kHeight = 160;
// Drivers round differently and spread single samples of thin hair otherwise; a look is more than that.
constexpr double kMeanTolerance = 2.0; ///< Limit on the mean difference over all pixels and channels, of 255.
/// Limit on the fraction of pixels that differ by more than kOutlier in some channel.
constexpr double kOutlierFraction = 0.02;
constexpr int kOutlier = 48;

QImage imageOf(const Picture& picture)
{
    return QImage(picture.pixels.data(), picture.width, picture.height, picture.width * 4, QImage::Format_RGBX8888)
        .convertToFormat(QImage::Format_RGB32);
}

} // namespace

class TestGoldenPictures : public RendererFixture
{
    Q_OBJECT
private Q_SLOTS:
    void thePictureIsTheOneKept_data()
    {
        QTest::addColumn<MakeScene>("make");
        for (const GoldenScene& scene : goldenScenes())
            QTest::addRow("%s", scene.name) << scene.make;
    }

    void thePictureIsTheOneKept()
    {
        QFETCH(MakeScene, make);
        const QString name = QString::fromLatin1(QTest::currentDataTag()) + QStringLiteral(".png");
        const QString path = test::dataPath(u"golden/") + name;
        const QImage now = imageOf(draw(make(), {.samples = 4}, kWidth, kHeight));
        if (qEnvironmentVariableIsSet("HAIRPAINT_WRITE_GOLDEN"))
            QVERIFY(now.save(path));
        const QImage kept = QImage(path).convertToFormat(QImage::Format_RGB32);
        QCOMPARE(kept.size(), now.size());

        QImage difference(now.size(), QImage::Format_RGB32);
        double sum = 0.0;
        int outliers = 0;
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x) {
                const QColor a = kept.pixelColor(x, y);
                const QColor b = now.pixelColor(x, y);
                const int red = std::abs(a.red() - b.red());
                const int green = std::abs(a.green() - b.green());
                const int blue = std::abs(a.blue() - b.blue());
                sum += red + green + blue;
                outliers += std::max({red, green, blue}) > kOutlier ? 1 : 0;
                difference.setPixelColor(
                    x, y, QColor(std::min(255, red * 4), std::min(255, green * 4), std::min(255, blue * 4)));
            }
        const double mean = sum / (3.0 * kWidth * kHeight);
        const double fraction = outliers / (1.0 * kWidth * kHeight);
        if (mean > kMeanTolerance || fraction > kOutlierFraction) {
            QVERIFY(QDir().mkpath(QStringLiteral("golden-failures")));
            now.save(QStringLiteral("golden-failures/now-") + name);
            difference.save(QStringLiteral("golden-failures/difference-") + name);
            QFAIL(qPrintable(QStringLiteral("mean difference %1, outliers %2; see golden-failures in %3")
                                 .arg(mean)
                                 .arg(fraction)
                                 .arg(QDir::currentPath())));
        }
    }
};

HAIRPAINT_TEST(TestGoldenPictures, None)
#include "test_golden_pictures.moc"
