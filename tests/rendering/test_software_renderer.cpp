// Our own renderer: exact pictures, the same on every instruction set and for any number of threads, and near to
// OpenGL's.
#include "sim/base/parallel.h"
#include "tests/rendering/golden_scenes.h"
#include "tests/rendering/renderer_fixture.h"
#include "tests/support/locations.h"
#include "tests/support/test_program.h"
#include "view/rendering/frame_constants.h"
#include "view/rendering/software/software_renderer.h"

#include <QDir>
#include <QImage>
#include <QtTest>

#include <hwy/highway.h>

#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

using namespace hairpaint;
using namespace hairpaint::testing;
using rendering::Quality;
using rendering::Scene;

namespace {

constexpr int kSoftSide = 160;

void forceInstructions(std::int64_t target)
{
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

Picture softly(const Scene& scene, const Quality& quality = {}, int width = kSoftSide, int height = kSoftSide)
{
    rendering::SoftwareRenderer renderer;
    Picture picture{.width = width, .height = height, .pixels = {}};
    renderer.draw(scene, quality, width, height);
    renderer.read(picture.pixels);
    return picture;
}

Picture lastOf(rendering::Backend& renderer, int width = kSoftSide, int height = kSoftSide)
{
    Picture picture{.width = width, .height = height, .pixels = {}};
    renderer.read(picture.pixels);
    return picture;
}

/// The sum of its linear light, in pixels of full green.
double lightOf(const Picture& picture)
{
    double sum = 0.0;
    for (std::size_t i = 1; i < picture.pixels.size(); i += 4)
        sum += std::pow((picture.pixels[i] / 255.0 + 0.055) / 1.055, 2.4);
    return sum;
}

Scene ringedHair()
{
    Scene scene = goldenScenes()[1].make();
    scene.ring = rendering::Ring{.centreHd = {0.0F, 0.0F, 0.1F}, .normalHd = {0.0F, 0.0F, 1.0F}, .radiusM = 0.02F};
    return scene;
}

void addGoldenRows()
{
    QTest::addColumn<MakeScene>("make");
    for (const GoldenScene& scene : goldenScenes())
        QTest::addRow("%s", scene.name) << scene.make;
}

} // namespace

class TestSoftwareRenderer : public RendererFixture
{
    Q_OBJECT
private Q_SLOTS:
    void thePictureIsExactlyTheOneKept_data() { addGoldenRows(); }

    /// HAIRPAINT_WRITE_GOLDEN=1 writes them anew.
    void thePictureIsExactlyTheOneKept()
    {
        QFETCH(MakeScene, make);
        const QString name = QString::fromLatin1(QTest::currentDataTag()) + QStringLiteral(".png");
        const QString path = test::dataPath(u"golden/software/") + name;
        const Picture drawn = softly(make());
        const QImage now = QImage(drawn.pixels.data(), drawn.width, drawn.height, QImage::Format_RGBX8888)
                               .convertToFormat(QImage::Format_RGB32);
        if (qEnvironmentVariableIsSet("HAIRPAINT_WRITE_GOLDEN"))
            QVERIFY(now.save(path));
        const QImage kept = QImage(path).convertToFormat(QImage::Format_RGB32);
        if (kept == now)
            return;
        QVERIFY(QDir().mkpath(QStringLiteral("golden-failures")));
        now.save(QStringLiteral("golden-failures/software-") + name);
        QFAIL(qPrintable(QStringLiteral("see golden-failures in %1").arg(QDir::currentPath())));
    }

    void openGlDrawsNearlyTheSame_data() { addGoldenRows(); }

    void openGlDrawsNearlyTheSame()
    {
        QFETCH(MakeScene, make);
        constexpr int kSide = 200;
        const Scene scene = make();
        for (const int samples : {1, 4}) {
            const Picture software = softly(scene, {.samples = samples}, kSide, kSide);
            const Picture gl = draw(scene, {.samples = samples}, kSide, kSide);
            const double difference = software.difference(gl) / (3.0 * 255.0);
            QVERIFY2(difference < 0.02, qPrintable(QString::number(difference)));
        }
    }

    /// Close by a voxel of the shade is smaller than what lies between hairs that are known to it.
    void shadeIsEvenAlongHairCloseBy()
    {
        Scene scene = emptyScene();
        scene.head = makeBall(kBall);
        scene.camera.distanceM = 0.25F;
        std::vector<HandMadeStrand> strands = comb(0xFF202020U, 40'000, 4.0F, 60e-6F);
        for (HandMadeStrand& strand : strands) // A thin curtain that hangs before the ball.
            for (glm::vec3& node : strand.nodesWo)
                node.z = 0.125F;
        scene.hair = makeFrame(strands, plainSettings());
        constexpr int kSide = 240;
        const Picture picture = softly(scene, {.samples = 4}, kSide, kSide);
        double uneven = 0.0;
        for (int y = 80; y < 160; ++y)
            for (int x = 80; x < 160; ++x)
                uneven += std::abs(2 * picture.at(x, y).y - picture.at(x, y - 8).y - picture.at(x, y + 8).y);
        uneven /= 80.0 * 80.0;
        QVERIFY2(uneven < 12.0, qPrintable(QString::number(uneven)));
    }

    void aPictureOfMuchHairIsDrawnInPartsThatFitTogether()
    {
        constexpr std::size_t kLittle = 1'500'000; ///< Bytes.
        for (const GoldenScene& golden : goldenScenes()) {
            if (golden.name != std::string_view("plaits") && golden.name != std::string_view("long-dark"))
                continue;
            const Scene scene = golden.make();
            const Picture whole = softly(scene);
            rendering::SoftwareRenderer inParts(kLittle);
            int told = 0;
            double last = 0.0;
            QVERIFY(inParts.drawPatiently(scene, {}, kSoftSide, kSoftSide, [&](double done) {
                ++told;
                last = done;
                return done >= 0.0 && done <= 1.0;
            }));
            QVERIFY(told > 0 && last > 0.5);
            QVERIFY2(lastOf(inParts).pixels == whole.pixels, golden.name);
        }
    }

    /// However many hairs lie in a column of the grid, they may lie in a small part of it.
    void whatLooksOutBesideADenseLockIsDrawn()
    {
        constexpr int kSide = 240;
        constexpr int kLockPixels = 3;
        Scene scene = emptyScene();
        const std::vector<HandMadeStrand> curtain = comb(0xFFC0C0C0U, 1600, 0.2F);
        std::vector<HandMadeStrand> both = curtain;
        for (HandMadeStrand strand : comb(0xFF202020U, 20'000, 0.001F, 60e-6F)) {
            for (glm::vec3& node : strand.nodesWo)
                node.z += 0.08F;
            both.push_back(std::move(strand));
        }
        scene.hair = makeFrame(curtain, plainSettings());
        const Picture alone = softly(scene, rendering::pictureQuality(), kSide, kSide);
        scene.hair = makeFrame(both, plainSettings());
        const Picture beside = softly(scene, rendering::pictureQuality(), kSide, kSide);
        const auto differ = [&](int x) { return std::abs(alone.at(x, kSide / 2).y - beside.at(x, kSide / 2).y) > 40; };
        QVERIFY(differ(kSide / 2)); // The lock itself.
        for (int x = kSide / 2 - 30; x < kSide / 2 + 30; ++x)
            if (std::abs(x - kSide / 2) > kLockPixels)
                QVERIFY2(!differ(x), qPrintable(QString::number(x)));
    }

    void theHeadsPictureHoldsWhileHairMoves()
    {
        Scene scene;
        scene.head = makeBall({0.08F, 0.11F, 0.1F});
        const rendering::Target target{.width = 200, .height = 150};
        const auto constants = [&](float lengthM) {
            scene.hair = makeFrame(hairOnBall({0.08F, 0.11F, 0.1F}, {.hairs = 100, .lengthM = lengthM}));
            return rendering::frameConstants(scene, target, 0.1F);
        };
        const rendering::FrameConstants some = constants(0.1F);
        const rendering::FrameConstants others = constants(0.4F);
        QVERIFY(some != others);
        QVERIFY(rendering::withoutHair(some) == rendering::withoutHair(others));
    }

    void everyInstructionSetGivesTheSameBytes_data()
    {
        QTest::addColumn<qint64>("target");
        forceInstructions(0);
        for (const std::int64_t target : hwy::SupportedAndGeneratedTargets())
            QTest::newRow(hwy::TargetName(target)) << qint64{target};
    }

    void everyInstructionSetGivesTheSameBytes()
    {
        QFETCH(qint64, target);
        struct Best
        {
            const char* name;
            Scene scene;
            int samples;
            Picture picture;
        };
        static const std::vector<Best> all = [] {
            std::vector<Best> made;
            for (const GoldenScene& golden : goldenScenes()) {
                const Scene scene = golden.make();
                for (const int samples : {1, 4})
                    made.push_back({golden.name, scene, samples, softly(scene, {.samples = samples})});
            }
            return made;
        }();
        for (const Best& best : all) {
            forceInstructions(target);
            const Picture forced = softly(best.scene, {.samples = best.samples});
            forceInstructions(0);
            QVERIFY2(best.picture.pixels == forced.pixels, best.name);
        }
    }

    void anyNumberOfThreadsGivesTheSameBytes()
    {
        for (const int samples : {1, 4}) {
            sim::setThreadCount(1);
            const Picture one = softly(ringedHair(), {.samples = samples}, 300, 220);
            for (const int threads : {2, 8}) {
                sim::setThreadCount(threads);
                const Picture many = softly(ringedHair(), {.samples = samples}, 300, 220);
                sim::setThreadCount(0);
                QVERIFY(one.pixels == many.pixels);
            }
        }
    }

    void stepsGiveThePictureDrawnAtOnce()
    {
        const Picture whole = softly(ringedHair());
        rendering::SoftwareRenderer renderer;
        renderer.draw(goldenScenes()[0].make(), {}, 60, 40);
        const Picture last = lastOf(renderer, 60, 40);
        renderer.begin(ringedHair(), {}, kSoftSide, kSoftSide);
        int steps = 0;
        while (!renderer.step(0.0)) {
            QVERIFY(lastOf(renderer, 60, 40).pixels == last.pixels);
            ++steps;
        }
        QVERIFY2(steps >= 5, qPrintable(QString::number(steps)));
        QVERIFY(lastOf(renderer).pixels == whole.pixels);
        QVERIFY(renderer.statistics().inSteps);
        QVERIFY(renderer.step(0.0)); // Nothing is left.
    }

    void whatWasDrawnBeforeLeavesNoTrace()
    {
        rendering::SoftwareRenderer renderer;
        for (const GoldenScene& golden : goldenScenes()) {
            const Scene scene = golden.make();
            renderer.draw(scene, {}, kSoftSide, kSoftSide);
            QVERIFY2(lastOf(renderer).pixels == softly(scene).pixels, golden.name);
        }
    }

    void fewerHairsCoverAsMuch_data()
    {
        QTest::addColumn<float>("detail");
        QTest::addColumn<int>("samples");
        QTest::newRow("all, moving") << 1.0F << 1;
        QTest::newRow("half, still") << 0.5F << 4;
        QTest::newRow("quarter, still") << 0.25F << 4;
        QTest::newRow("quarter, moving") << 0.25F << 1;
    }

    /// By the light that black hair takes from a white picture.
    void fewerHairsCoverAsMuch()
    {
        QFETCH(float, detail);
        QFETCH(int, samples);
        // So large that hair rarely lies over hair, which then covers less.
        constexpr int kAcross = 1600;
        constexpr int kUp = 1200;
        Scene scene = emptyScene();
        scene.background = glm::vec3(0.9F);
        const double bare = lightOf(softly(scene, {}, kAcross, kUp));
        std::vector<HandMadeStrand> strands = comb(0xFF000000U, 640, 0.12F, 50e-6F);
        for (std::size_t i = 0; i < strands.size(); ++i)
            strands[i].style.detail = std::fmod(static_cast<float>(i) * 0.618034F, 1.0F); // Evenly, as a groom's.
        scene.hair = makeFrame(strands, plainSettings());
        const double all = bare - lightOf(softly(scene, {}, kAcross, kUp));
        const double fewer = bare - lightOf(softly(scene, {.detail = detail, .samples = samples}, kAcross, kUp));
        QVERIFY2(all > 2000.0, qPrintable(QString::number(all)));
        QVERIFY2(std::abs(fewer / all - 1.0) < 0.03, qPrintable(QString::number(fewer / all)));
    }

    void theSilhouetteKeepsItsCoverage_data()
    {
        QTest::addColumn<float>("distanceM");
        QTest::addColumn<int>("samples");
        for (const float distance : {0.3F, 0.5F, 0.75F, 1.2F, 2.5F})
            for (const int samples : {1, 4})
                QTest::addRow("%g m, %d samples", double{distance}, samples) << distance << samples;
    }

    /// Nothing pops: a quarter of the hairs covers the silhouette as all of them do, at every zoom.
    void theSilhouetteKeepsItsCoverage()
    {
        QFETCH(float, distanceM);
        QFETCH(int, samples);
        static const auto hair = [] {
            std::vector<HandMadeStrand> strands =
                hairOnBall(kBall, {.hairs = 20'000, .lengthM = 0.2F, .stiffness = 0.5F});
            for (std::size_t i = 0; i < strands.size(); ++i)
                strands[i].style.detail = std::fmod(static_cast<float>(i) * 0.7548777F, 1.0F); // Evenly, as a groom's.
            return makeFrame(strands, plainSettings());
        }();
        Scene scene = emptyScene();
        scene.transparent = true;
        scene.camera.distanceM = distanceM;
        scene.hair = hair;
        const auto cover = [](const Picture& picture) {
            double sum = 0.0;
            for (std::size_t i = 3; i < picture.pixels.size(); i += 4)
                sum += picture.pixels[i];
            return sum;
        };
        const double all = cover(softly(scene, {.samples = 4}, 400, 400));
        const double quarter = cover(softly(scene, {.detail = 0.25F, .samples = samples}, 400, 400));
        QVERIFY(all > 0.0);
        QVERIFY2(std::abs(quarter / all - 1.0) < 0.03, qPrintable(QString::number(quarter / all)));
    }

    void manySamplesShowTheSamePicture()
    {
        for (const GoldenScene& golden : goldenScenes()) {
            const Picture four = softly(golden.make(), {.samples = 4});
            const Picture sixteen = softly(golden.make(), {.samples = 16});
            QVERIFY2(four.difference(sixteen) < 3.0 * 3.0, golden.name);
        }
    }

    /// The bytes of a picture are its linear light, toned as far as it is the scene's, encoded.
    void linearLightIsWhatTheBytesShow()
    {
        const auto toned = [](float light, float brightest) {
            const float over = std::max(brightest - 0.5F, 0.0F) * 2.0F;
            const float shown = std::min(brightest, 0.5F) + 0.5F * over / (1.0F + over);
            const float white = 0.5F * std::pow(over / (1.0F + over), 4.0F);
            return std::lerp(light * shown / std::max(brightest, 1e-6F), shown, white);
        };
        const auto byteOf = [](float value) {
            return 255.0F *
                   std::min(value <= 0.0031308F ? 12.92F * value : 1.055F * std::pow(value, 1.0F / 2.4F) - 0.055F,
                            1.0F);
        };
        Scene scene = ringedHair();
        scene.ring.reset();
        rendering::SoftwareRenderer renderer;
        const auto drawn = [&](bool transparent, std::vector<float>& linear) {
            scene.transparent = transparent;
            renderer.draw(scene, {.linear = true}, kSoftSide, kSoftSide);
            renderer.readLinear(linear);
            return lastOf(renderer);
        };
        std::vector<float> own;
        std::vector<float> whole;
        const Picture bare = drawn(true, own);
        const Picture shown = drawn(false, whole);
        QCOMPARE(own.size(), bare.pixels.size());
        QCOMPARE(whole.size(), shown.pixels.size());
        int bright = 0;
        for (std::size_t i = 0; i < own.size(); ++i) {
            const float alpha = own[i / 4 * 4 + 3];
            if (i % 4 == 3) {
                QVERIFY(std::abs(alpha * 255.0F - static_cast<float>(bare.pixels[i])) < 1.0F);
                QCOMPARE(whole[i], 1.0F);
                continue;
            }
            const float light = own[i] / std::max(alpha, 1e-6F);
            const std::size_t pixel = i / 4 * 4;
            const float brightest = std::max({own[pixel], own[pixel + 1], own[pixel + 2]}) / std::max(alpha, 1e-6F);
            bright += light > 0.6F ? 1 : 0;
            if (alpha > 0.01F)
                QVERIFY2(std::abs(byteOf(toned(light, brightest)) - static_cast<float>(bare.pixels[i])) < 2.0F,
                         qPrintable(QString::number(i)));
            const float background = whole[i] - own[i];
            QVERIFY2(std::abs(byteOf(toned(light, brightest) * alpha + background) -
                              static_cast<float>(shown.pixels[i])) < 2.0F,
                     qPrintable(QString::number(i)));
        }
        QVERIFY(bright > 20); // Else the curve was not asked for.
        renderer.draw(scene, {}, kSoftSide, kSoftSide);
        renderer.readLinear(own);
        QVERIFY(own.empty());
    }

    void plainBackgroundHasTheColourAskedFor()
    {
        for (const int samples : {1, 4}) {
            Scene scene = emptyScene();
            scene.background = glm::vec3(0.791298F);
            const Picture picture = softly(scene, {.samples = samples}, 200, 150);
            for (const int x : {0, 99, 199})
                for (int channel = 0; channel < 3; ++channel)
                    QVERIFY(std::abs(picture.at(x, 75)[channel] - 230) <= 1);
            QVERIFY(picture.at(0, 0).x >= picture.at(0, 149).x);
        }
    }

    void hairBehindTheHeadIsHidden()
    {
        Scene scene = emptyScene();
        scene.head = makeBall(kBall);
        const Picture bald = softly(scene);
        const auto hairAt = [](float z) {
            sim::GroupSettings thick = plainSettings();
            thick.material.widthM = 2e-3F;
            return makeFrame({straightStrand({-0.02F, 0.05F, z}, {0.02F, -0.05F, z}, 0xFF0000FFU)}, thick);
        };
        scene.hair = hairAt(-0.2F);
        QVERIFY(softly(scene).difference(bald, 60, 60, 100, 100) < 1.0);
        scene.hair = hairAt(0.2F);
        QVERIFY(softly(scene).difference(bald, 60, 60, 100, 100) > 1.0);
    }

    void crossingLayersMeetWhereTheyCross_data()
    {
        QTest::addColumn<int>("height");
        for (const int height : {448, 456, 464, 472, 480})
            QTest::addRow("%d samples high", height) << height;
    }

    /// Wherever the borders of tiles lie: green hair comes out of red hair at half the picture's height.
    void crossingLayersMeetWhereTheyCross()
    {
        QFETCH(int, height);
        constexpr int kAcross = 96;
        constexpr float kLean = 0.8F;
        Scene scene = emptyScene();
        std::vector<HandMadeStrand> strands = comb(0xFF0000FFU, 120, 0.04F, 1e-3F);
        for (HandMadeStrand& strand : comb(0xFF00FF00U, 120, 0.04F, 1e-3F)) {
            for (glm::vec3& node : strand.nodesWo)
                node.z = kLean * node.y;
            strands.push_back(strand);
        }
        scene.hair = makeFrame(strands, plainSettings());
        const Picture picture = softly(scene, {}, kAcross, height);
        for (int x = kAcross / 2 - 16; x < kAcross / 2 + 16; x += 4)
            for (int y = height / 4; y < height * 3 / 4; ++y) {
                constexpr int kMargin = 5;
                if (std::abs(y - height / 2) < kMargin)
                    continue;
                const auto colour = picture.at(x, y);
                QVERIFY2((colour[1] > colour[0]) == (y < height / 2),
                         qPrintable(QStringLiteral("%1, %2").arg(x).arg(y - height / 2)));
            }
    }

    void hairOutOfThePictureDoesNoHarm()
    {
        Scene scene = ringedHair();
        const float nan = std::numeric_limits<float>::quiet_NaN();
        const auto frame = makeFrame({straightStrand({-9.0F, 5.0F, 0.1F}, {9.0F, -5.0F, 0.1F}, 0xFF0000FFU),
                                      straightStrand({0.0F, 0.0F, 50.0F}, {0.0F, 0.0F, -50.0F}, 0xFF0000FFU),
                                      straightStrand({nan, 0.0F, 0.0F}, {0.0F, nan, 0.0F}, 0xFF0000FFU)},
                                     plainSettings());
        scene.hair = frame;
        for (const int samples : {1, 4})
            QCOMPARE(softly(scene, {.samples = samples}, 33, 517).pixels.size(), std::size_t{33 * 517 * 4});
    }
};

HAIRPAINT_TEST(TestSoftwareRenderer, None)
#include "test_software_renderer.moc"
