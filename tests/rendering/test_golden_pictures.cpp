// Small pictures of what the renderer draws, kept beside the tests: a change of the look is seen, and meant or mended.
// HAIRPAINT_WRITE_GOLDEN=1 writes them anew.
#include "tests/rendering/renderer_fixture.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QImage>
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace hairpaint;
using namespace hairpaint::testing;
using rendering::Scene;

namespace {

constexpr int kWidth = 160;
constexpr int kHeight = 160;
// Drivers round differently and spread single samples of thin hair otherwise; a look is more than that.
constexpr double kMeanTolerance = 2.0;    ///< Of 255, over all pixels and channels.
constexpr double kOutlierFraction = 0.02; ///< Of the pixels may differ by more than kOutlier in some channel.
constexpr int kOutlier = 48;

using MakeScene = std::function<Scene()>;

Scene ballWith(const BallHair& hair, const sim::GroupSettings& settings = {})
{
    Scene scene = emptyScene();
    scene.head = makeBall(kBall);
    scene.hair = makeFrame(hairOnBall(kBall, hair), settings);
    return scene;
}

Scene head()
{
    Scene scene = emptyScene();
    scene.head = makeBall(kBall);
    return scene;
}

Scene longDark()
{
    return ballWith({.hairs = 6000, .lengthM = 0.25F});
}

Scene shortBlond()
{
    return ballWith(
        {.hairs = 8000, .lengthM = 0.04F, .stiffness = 0.9F, .rootColour = 0xFF5C9CC0U, .tipColour = 0xFF9AD0EEU});
}

Scene ringlets()
{
    return ballWith({.hairs = 3000,
                     .lengthM = 0.2F,
                     .turns = 8.0F,
                     .curlRadiusM = 0.006F,
                     .rootColour = 0xFF20306AU,
                     .tipColour = 0xFF3050A0U});
}

Scene dyedAndShiny()
{
    sim::GroupSettings settings;
    settings.material.shine = 1.0F;
    settings.material.roughness = 0.15F;
    settings.material.tipAlpha = 1.0F;
    settings.material.colourVariation = 0.4F;
    return ballWith({.hairs = 6000, .lengthM = 0.15F, .rootColour = 0xFF8A2A10U, .tipColour = 0xFFB060F0U}, settings);
}

Scene litFromBehind()
{
    Scene scene = longDark();
    scene.light.directionWo = glm::normalize(glm::vec3(0.3F, 0.4F, -1.0F));
    return scene;
}

Scene plaits()
{
    std::vector<HandMadeStrand> strands;
    for (int i = 0; i < 300; ++i) {
        const float x = (i % 3 == 0 ? -0.04F : i % 3 == 1 ? 0.0F : 0.04F);
        HandMadeStrand strand = straightStrand({x, 0.09F, 0.0F}, {x, -0.1F, 0.0F}, 0xFF284468U, 12);
        const float turn = static_cast<float>(i) * 2.399963F;
        const float radius = std::sqrt(static_cast<float>(i % 100) / 100.0F);
        strand.style.braid = i % 3 == 0   ? sim::BraidKind::Plait
                             : i % 3 == 1 ? sim::BraidKind::Twist
                                          : sim::BraidKind::Loc;
        strand.style.wisp = static_cast<std::uint8_t>(i / 3 % (i % 3 == 1 ? 2 : 3));
        strand.style.braidRadiusM = 0.012F;
        strand.style.braidTurns = 4.0F;
        strand.style.wispOffset = {radius * std::cos(turn), radius * std::sin(turn)};
        strand.style.width = 6.0F;
        strands.push_back(strand);
    }
    Scene scene = emptyScene();
    scene.hair = makeFrame(strands);
    return scene;
}

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
        QTest::addRow("head") << MakeScene{head};
        QTest::addRow("long-dark") << MakeScene{longDark};
        QTest::addRow("short-blond") << MakeScene{shortBlond};
        QTest::addRow("ringlets") << MakeScene{ringlets};
        QTest::addRow("dyed-and-shiny") << MakeScene{dyedAndShiny};
        QTest::addRow("lit-from-behind") << MakeScene{litFromBehind};
        QTest::addRow("plaits") << MakeScene{plaits};
    }

    void thePictureIsTheOneKept()
    {
        QFETCH(MakeScene, make);
        const QString name = QString::fromLatin1(QTest::currentDataTag()) + QStringLiteral(".png");
        const QString path = QStringLiteral(HAIRPAINT_TEST_DATA "/golden/") + name;
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
