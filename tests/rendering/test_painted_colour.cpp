// The colour that is painted is the colour that is seen: the mean of a head's coat in the light of a new
// project, from all around.
#include "tests/rendering/hand_made_hair.h"
#include "tests/support/test_program.h"
#include "view/rendering/software/software_renderer.h"

#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>
#include <vector>

using namespace hairpaint;
using namespace hairpaint::testing;

namespace {

constexpr int kCoatSide = 160;
constexpr std::array kEyesRad{0.0F, 0.6F, 1.6F, 3.14159F, -1.6F};

/// CIE 1976.
struct Lab
{
    double lightness = 0.0;
    double a = 0.0;
    double b = 0.0;
    [[nodiscard]] double chroma() const { return std::hypot(a, b); }
    [[nodiscard]] double hueDeg() const { return std::atan2(b, a) * 180.0 / std::numbers::pi; }
};

Lab labOf(double red, double green, double blue)
{
    const auto linear = [](double byte) {
        const double c = byte / 255.0;
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    const double r = linear(red);
    const double g = linear(green);
    const double b = linear(blue);
    const auto f = [](double t) { return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0; };
    const double x = f((0.4124564 * r + 0.3575761 * g + 0.1804375 * b) / 0.95047);
    const double y = f(0.2126729 * r + 0.7151522 * g + 0.0721750 * b);
    const double z = f((0.0193339 * r + 0.1191920 * g + 0.9503041 * b) / 1.08883);
    return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

Lab labOf(QRgb colour)
{
    return labOf(qRed(colour), qGreen(colour), qBlue(colour));
}

/// From each of kEyesRad.
std::vector<std::vector<std::uint8_t>> coatPictures(QRgb painted, float shine)
{
    static const std::shared_ptr<const sim::HeadMesh> head = makeBall(kBall);
    static const std::vector<HandMadeStrand> grey = hairOnBall(kBall, {.hairs = 16'000, .lengthM = 0.25F});
    const std::uint32_t colour = 0xFF000000U | static_cast<std::uint32_t>(qBlue(painted)) << 16U |
                                 static_cast<std::uint32_t>(qGreen(painted)) << 8U |
                                 static_cast<std::uint32_t>(qRed(painted));
    sim::GroupSettings settings;
    settings.material.shine = shine;
    settings.material.tipAlpha = 1.0F;
    rendering::Scene scene = emptyScene();
    scene.head = head;
    std::vector<HandMadeStrand> strands = grey;
    for (HandMadeStrand& strand : strands)
        strand.style.rootColour = strand.style.tipColour = colour;
    scene.hair = makeFrame(strands, settings);
    rendering::SoftwareRenderer renderer;
    std::vector<std::vector<std::uint8_t>> pictures(kEyesRad.size());
    for (std::size_t eye = 0; eye < kEyesRad.size(); ++eye) {
        scene.camera.azimuthRad = kEyesRad.at(eye);
        renderer.draw(scene, {.samples = 4}, kCoatSide, kCoatSide);
        renderer.read(pictures[eye]);
    }
    return pictures;
}

/// Pixels that nothing but hair covers, by eye: where blue hair is all blue and red hair all red.
const std::vector<std::vector<bool>>& coats()
{
    static const std::vector<std::vector<bool>> all = [] {
        std::vector<std::vector<bool>> masks;
        masks.reserve(kEyesRad.size());
        const auto reds = coatPictures(qRgb(200, 0, 0), 0.0F);
        const auto blues = coatPictures(qRgb(0, 0, 200), 0.0F);
        for (std::size_t eye = 0; eye < kEyesRad.size(); ++eye) {
            const std::vector<std::uint8_t>& red = reds[eye];
            const std::vector<std::uint8_t>& blue = blues[eye];
            std::vector<bool> mask(red.size() / 4);
            for (std::size_t i = 0; i < mask.size(); ++i)
                mask[i] = red[4 * i] > 6 * red[4 * i + 2] && blue[4 * i + 2] > 6 * blue[4 * i];
            masks.push_back(mask);
        }
        return masks;
    }();
    return all;
}

struct Seen
{
    Lab mean;
    double darkest = 0.0;       ///< Lightness that a tenth of the coat stays below,
    double lightest = 0.0;      ///< and above.
    std::vector<double> ofEyes; ///< Mean lightness by eye.
};

Seen seenOf(QRgb painted, float shine)
{
    Seen seen;
    std::vector<double> lightness;
    seen.ofEyes.reserve(kEyesRad.size());
    const auto pictures = coatPictures(painted, shine);
    for (std::size_t eye = 0; eye < kEyesRad.size(); ++eye) {
        const std::vector<std::uint8_t>& pixels = pictures[eye];
        const std::vector<bool>& mask = coats().at(eye);
        lightness.reserve(lightness.size() + mask.size());
        const std::size_t first = lightness.size();
        for (std::size_t i = 0; i < mask.size(); ++i) {
            if (!mask[i])
                continue;
            const Lab lab = labOf(pixels[4 * i], pixels[4 * i + 1], pixels[4 * i + 2]);
            lightness.push_back(lab.lightness);
            seen.mean.a += lab.a;
            seen.mean.b += lab.b;
        }
        seen.ofEyes.push_back(std::reduce(lightness.begin() + static_cast<std::ptrdiff_t>(first), lightness.end()) /
                              static_cast<double>(lightness.size() - first));
    }
    const auto count = static_cast<double>(lightness.size());
    seen.mean.lightness = std::reduce(lightness.begin(), lightness.end()) / count;
    seen.mean.a /= count;
    seen.mean.b /= count;
    std::ranges::sort(lightness);
    seen.darkest = lightness[lightness.size() / 10];
    seen.lightest = lightness[lightness.size() * 9 / 10];
    return seen;
}

} // namespace

class TestPaintedColour : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void theCoatShowsThePaintedColour_data()
    {
        QTest::addColumn<QRgb>("painted");
        QTest::addColumn<float>("shine");
        const std::array colours{
            std::pair{"black", qRgb(0x0A, 0x08, 0x06)}, std::pair{"dark brown", qRgb(0x5B, 0x3A, 0x22)},
            std::pair{"brown", qRgb(0x7A, 0x52, 0x30)}, std::pair{"auburn", qRgb(0x8A, 0x3A, 0x1C)},
            std::pair{"blond", qRgb(0xD9, 0xB3, 0x6C)}, std::pair{"grey", qRgb(0x8C, 0x8C, 0x8C)},
            std::pair{"white", qRgb(0xE8, 0xE6, 0xE2)}, std::pair{"pink", qRgb(0xE8, 0x6C, 0xA8)},
            std::pair{"blue", qRgb(0x2A, 0x4F, 0xB0)},  std::pair{"red", qRgb(0xB0, 0x20, 0x20)},
            std::pair{"green", qRgb(0x2E, 0x8B, 0x57)}};
#if defined(HAIRPAINT_ASAN)
        constexpr std::size_t kStep = 4; // A picture takes long; the code is the same for each.
#else
        constexpr std::size_t kStep = 1;
#endif
        for (std::size_t i = 0; i < colours.size(); i += kStep)
            for (const float shine : {0.0F, 0.5F})
                QTest::addRow("%s, shine %g", colours[i].first, double{shine}) << colours[i].second << shine;
    }

    void theCoatShowsThePaintedColour()
    {
        QFETCH(QRgb, painted);
        QFETCH(float, shine);
        const Lab wanted = labOf(painted);
        const Seen seen = seenOf(painted, shine);
        QString said = QStringLiteral("L* %1 C* %2 h %3, seen %4 %5 %6, tenths %7 %8, by eye")
                           .arg(wanted.lightness, 0, 'f', 1)
                           .arg(wanted.chroma(), 0, 'f', 1)
                           .arg(wanted.hueDeg(), 0, 'f', 1)
                           .arg(seen.mean.lightness, 0, 'f', 1)
                           .arg(seen.mean.chroma(), 0, 'f', 1)
                           .arg(seen.mean.hueDeg(), 0, 'f', 1)
                           .arg(seen.darkest, 0, 'f', 1)
                           .arg(seen.lightest, 0, 'f', 1);
        for (const double lightness : seen.ofEyes)
            said += QStringLiteral(" %1").arg(lightness, 0, 'f', 1);
        QVERIFY2(std::abs(seen.mean.lightness - wanted.lightness) < 7.0, qPrintable(said));
        QVERIFY2(seen.darkest < wanted.lightness && seen.lightest > wanted.lightness, qPrintable(said));
        constexpr double kGrey = 5.0; // Chroma below which no hue is seen.
        if (wanted.chroma() < kGrey) {
            QVERIFY2(seen.mean.chroma() < kGrey, qPrintable(said));
            return;
        }
        const double hue = std::remainder(seen.mean.hueDeg() - wanted.hueDeg(), 360.0);
        QVERIFY2(std::abs(hue) < 10.0, qPrintable(said));
        QVERIFY2(std::abs(seen.mean.chroma() / wanted.chroma() - 1.0) < 0.25, qPrintable(said));
    }
};

HAIRPAINT_TEST(TestPaintedColour, None)
#include "test_painted_colour.moc"
