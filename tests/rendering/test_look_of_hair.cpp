// What frizz, width, gloss, taper and tip colours are in pictures, by either renderer.
#include "tests/rendering/renderer_fixture.h"
#include "tests/support/test_program.h"
#include "view/rendering/software/software_renderer.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>
#include <vector>

using namespace hairpaint::rendering;

namespace hairpaint::testing {

namespace {

constexpr int kLookWidth = 200;
constexpr int kLookHeight = 150;
constexpr std::uint32_t kLookGrey = 0xFFC0C0C0U;

/// The sum of all channels in columns x0 .. x1 - 1 and rows y0 .. y1 - 1.
double lightOver(const Picture& picture, int x0, int y0, int x1, int y1)
{
    double sum = 0.0;
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) {
            const glm::ivec3 pixel = picture.at(x, y);
            sum += pixel.x + pixel.y + pixel.z;
        }
    return sum;
}

/// The pixels' greatest channels, of the hundredth that is lightest, in the middle half of the columns.
double lightestOf(const Picture& picture)
{
    std::vector<int> light;
    light.reserve(picture.pixels.size() / 8);
    for (int y = 0; y < picture.height; ++y)
        for (int x = picture.width / 4; x < picture.width * 3 / 4; ++x) {
            const glm::ivec3 pixel = picture.at(x, y);
            light.push_back(std::max({pixel.x, pixel.y, pixel.z}));
        }
    std::ranges::sort(light);
    double sum = 0.0;
    const std::size_t first = light.size() * 99 / 100;
    for (std::size_t i = first; i < light.size(); ++i)
        sum += light[i];
    return sum / static_cast<double>(light.size() - first);
}

/// Hair combed over a ball from its top down, in a coat of some layers.
std::vector<HandMadeStrand> combedDown()
{
    constexpr int kHairs = 16000;
    constexpr int kNodes = 12;
    constexpr float kCoatM = 0.0015F;
    constexpr float kLowestRad = 2.4F;
    std::vector<HandMadeStrand> strands(kHairs);
    for (int i = 0; i < kHairs; ++i) {
        HandMadeStrand& strand = strands[static_cast<std::size_t>(i)];
        const auto golden = static_cast<float>(i) * 0.618034F;
        const float around = 6.2831853F * (golden - std::floor(golden));
        const float above = 1.005F + kCoatM / kBall.x * static_cast<float>(i % 7);
        strand.style.rootColour = strand.style.tipColour = 0xFF101A28U;
        strand.nodesWo.resize(kNodes);
        for (int node = 0; node < kNodes; ++node) {
            const float down = 0.1F + kLowestRad * static_cast<float>(node) / static_cast<float>(kNodes - 1);
            strand.nodesWo[static_cast<std::size_t>(node)] =
                kBall * above *
                glm::vec3(std::sin(down) * std::cos(around), std::cos(down), std::sin(down) * std::sin(around));
        }
    }
    return strands;
}

/// The greatest part by which light along a row lies off the line between what is left and right of it.
double offTheLine(std::span<const double> light)
{
    constexpr std::size_t kAside = 4;
    double most = 0.0;
    for (std::size_t i = kAside; i + kAside < light.size(); ++i) {
        const double line = 0.5 * (light[i - kAside] + light[i + kAside]);
        most = std::max(most, std::abs(light[i] - line) / std::max(line, 1.0));
    }
    return most;
}

} // namespace

class TestLookOfHair : public RendererFixture
{
    Q_OBJECT
private:
    SoftwareRenderer m_software;

    Picture drawnBy(bool software, const Scene& scene)
    {
        if (!software)
            return draw(scene, {}, kLookWidth, kLookHeight);
        m_software.draw(scene, {}, kLookWidth, kLookHeight);
        Picture picture{.width = kLookWidth, .height = kLookHeight, .pixels = {}};
        m_software.read(picture.pixels);
        return picture;
    }
    /// Upright hair that stands apart, before black.
    Picture drawnComb(bool software, const std::function<void(sim::StrandStyle&)>& style,
                      const std::function<void(sim::StrandMaterial&)>& material = {}, int hairs = 40)
    {
        Scene scene = emptyScene();
        scene.background = glm::vec3(0.0F);
        std::vector<HandMadeStrand> strands = comb(kLookGrey, hairs, 0.1F, 400e-6F);
        float chance = -1.0F;
        for (HandMadeStrand& strand : strands) {
            style(strand.style);
            strand.style.variation = chance += 1.9F / static_cast<float>(hairs);
        }
        sim::GroupSettings settings = plainSettings();
        if (material)
            material(settings.material);
        scene.hair = makeFrame(strands, settings);
        return drawnBy(software, scene);
    }
    Picture drawnCoat(bool software, std::uint16_t gloss)
    {
        Scene scene = emptyScene();
        scene.background = glm::vec3(0.0F);
        std::vector<HandMadeStrand> strands = hairOnBall(kBall, {.hairs = 4000, .lengthM = 0.2F});
        for (HandMadeStrand& strand : strands)
            strand.style.gloss = gloss;
        sim::GroupSettings settings = plainSettings();
        settings.material.shine = 0.5F;
        scene.hair = makeFrame(strands, settings);
        return drawnBy(software, scene);
    }
    static void byRenderer()
    {
        QTest::addColumn<bool>("software");
        QTest::newRow("software") << true;
        QTest::newRow("OpenGL") << false;
    }

private Q_SLOTS:
    void widthsAreSeen_data() { byRenderer(); }
    void widthsAreSeen()
    {
        QFETCH(bool, software);
        const auto light = [&](float width) {
            return lightOver(drawnComb(software, [&](sim::StrandStyle& style) { style.width *= width; }), 0, 0,
                             kLookWidth, kLookHeight);
        };
        const double one = light(1.0F);
        QVERIFY(one > 1000.0);
        const double thick = light(1.7F) / one;
        const double thin = light(0.3F) / one;
        QVERIFY2(thick > 1.2 && thin < 0.6, qPrintable(QStringLiteral("%1 %2").arg(thick).arg(thin)));
    }

    void glossIsSeen_data() { byRenderer(); }
    void glossIsSeen()
    {
        QFETCH(bool, software);
        const double matte = lightestOf(drawnCoat(software, 0));
        const double natural = lightestOf(drawnCoat(software, sim::StrandStyle{}.gloss));
        const double mirror = lightestOf(drawnCoat(software, 65535));
        QVERIFY2(mirror > natural + 4.0 && natural > matte + 2.0,
                 qPrintable(QStringLiteral("%1 %2 %3").arg(matte).arg(natural).arg(mirror)));
    }

    void smoothHairHasNoBandsWhereItTurnsFromTheEye_data() { byRenderer(); }
    void smoothHairHasNoBandsWhereItTurnsFromTheEye()
    {
        QFETCH(bool, software);
        Scene scene = emptyScene();
        scene.background = glm::vec3(0.0F);
        scene.head = makeBall(kBall);
        scene.camera.distanceM *= 0.5F;
        sim::GroupSettings settings = plainSettings();
        settings.material.widthM = 300e-6F;
        scene.hair = makeFrame(combedDown(), settings);
        const Picture picture = drawnBy(software, scene);
        const int middle = kLookHeight / 2;
        int last = kLookWidth - 1;
        while (last > 0 && lightOver(picture, last, middle, last + 1, middle + 1) < 30.0)
            --last;
        // From where the coat leans by 40 degrees to where the silhouette begins.
        const int radius = last - kLookWidth / 2;
        QVERIFY2(radius > 30, qPrintable(QString::number(radius)));
        std::vector<double> right;
        std::vector<double> left;
        for (int x = radius * 64 / 100; x < radius * 96 / 100; ++x) {
            right.push_back(lightOver(picture, kLookWidth / 2 + x, middle - 8, kLookWidth / 2 + x + 1, middle + 8));
            left.push_back(lightOver(picture, kLookWidth / 2 - x, middle - 8, kLookWidth / 2 - x + 1, middle + 8));
        }
        QVERIFY2(offTheLine(right) < 0.012 && offTheLine(left) < 0.012,
                 qPrintable(QStringLiteral("%1 %2").arg(offTheLine(right)).arg(offTheLine(left))));
    }

    void frizzIsSeenAndBothRenderersDrawTheSame()
    {
        const auto frizz = [](float frizzM) { return [frizzM](sim::StrandStyle& style) { style.frizzM = frizzM; }; };
        const Picture straight = drawnComb(true, frizz(0.0F), {}, 8);
        const Picture frizzy = drawnComb(true, frizz(0.01F), {}, 8);
        const Picture other = drawnComb(false, frizz(0.01F), {}, 8);
        const double strayed = frizzy.difference(straight);
        const double apart = frizzy.difference(other);
        QVERIFY2(strayed > 6.0 * apart && strayed > 1.0, qPrintable(QStringLiteral("%1 %2").arg(strayed).arg(apart)));
        // Roots stay.
        QVERIFY(frizzy.difference(straight, 0, 0, kLookWidth, 46) < 0.4 * strayed);
    }

    void flatFibresGlintAlongTheHairAndBothRenderersDrawTheSame()
    {
        const auto drawn = [&](bool software, float axes) {
            return drawnComb(
                software,
                [](sim::StrandStyle& style) {
                    style.turns = 2.0F;
                    style.curlRadiusM = 0.002F;
                    style.phase = 1.0F;
                },
                [axes](sim::StrandMaterial& material) { material.sectionAxes = axes; }, 8);
        };
        const Picture round = drawn(true, 1.0F);
        const Picture flat = drawn(true, 2.0F);
        const double turned = flat.difference(round);
        const double apart = flat.difference(drawn(false, 2.0F));
        const double roundApart = round.difference(drawn(false, 1.0F));
        QVERIFY2(apart < 1.5 * roundApart + 0.2 * turned && turned > 0.3,
                 qPrintable(QStringLiteral("%1 %2 %3").arg(turned).arg(apart).arg(roundApart)));
        double least = 10.0;
        double most = 0.0;
        for (int y = 40; y + 8 <= kLookHeight - 40; y += 8) {
            const double part = lightOver(flat, 0, y, kLookWidth, y + 8) / lightOver(round, 0, y, kLookWidth, y + 8);
            least = std::min(least, part);
            most = std::max(most, part);
        }
        QVERIFY2(most > 1.1 * least, qPrintable(QStringLiteral("%1 %2").arg(least).arg(most)));
    }

    void aTaperThinsTheLastCentimetresAlone_data() { byRenderer(); }
    void aTaperThinsTheLastCentimetresAlone()
    {
        QFETCH(bool, software);
        const auto drawn = [&](float taperM, float tipAlpha) {
            return drawnComb(
                software, [](sim::StrandStyle&) {},
                [&](sim::StrandMaterial& material) {
                    material.taperM = taperM;
                    material.tipAlpha = tipAlpha;
                });
        };
        const Picture whole = drawn(0.0F, 1.0F);
        const Picture faded = drawn(0.0F, 0.1F);
        const Picture tapered = drawn(0.02F, 0.1F);
        int first = 0;
        int last = kLookHeight;
        while (lightOver(whole, 0, first, kLookWidth, first + 1) == 0.0)
            ++first;
        while (lightOver(whole, 0, last - 1, kLookWidth, last) == 0.0)
            --last;
        const int tenth = (last - first) / 10;
        const auto part = [&](const Picture& picture, int from, int to) {
            return lightOver(picture, 0, first + from * tenth, kLookWidth, first + to * tenth) /
                   lightOver(whole, 0, first + from * tenth, kLookWidth, first + to * tenth);
        };
        QVERIFY2(part(tapered, 1, 8) > 0.99, qPrintable(QString::number(part(tapered, 1, 8))));
        QVERIFY(part(faded, 5, 8) < 0.9);
        // Over the last of the ten.
        const double atTip =
            lightOver(tapered, 0, last - tenth, kLookWidth, last) / lightOver(whole, 0, last - tenth, kLookWidth, last);
        QVERIFY2(atTip > 0.4 && atTip < 0.9, qPrintable(QString::number(atTip)));
    }

    void theTipColourBeginsInALineOrSoftly_data() { byRenderer(); }
    void theTipColourBeginsInALineOrSoftly()
    {
        QFETCH(bool, software);
        const auto drawn = [&](float from, float over) {
            return drawnComb(
                software,
                [](sim::StrandStyle& style) {
                    style.rootColour = 0xFF0000C0U;
                    style.tipColour = 0xFFC00000U;
                },
                [&](sim::StrandMaterial& material) {
                    material.tipFrom = from;
                    material.tipOver = over;
                },
                160);
        };
        const auto blueAt = [&](const Picture& picture, int row) {
            double blue = 0.0;
            double all = 0.0;
            for (int x = 40; x < 160; ++x) {
                blue += picture.at(x, row).z;
                all += picture.at(x, row).x + picture.at(x, row).z;
            }
            return blue / all;
        };
        const Picture soft = drawn(0.0F, 1.0F);
        const Picture line = drawn(0.5F, 0.0F);
        constexpr int kRow = 75; // Half of the length.
        QVERIFY(blueAt(soft, kRow) > 0.2 && blueAt(soft, kRow) < 0.8);
        const double above = blueAt(line, kRow - 15);
        const double below = blueAt(line, kRow + 15);
        QVERIFY2(std::min(above, below) < 0.1 && std::max(above, below) > 0.9,
                 qPrintable(QStringLiteral("%1 %2").arg(above).arg(below)));
    }

    void theTipColourOfEachHairBeginsWhereItsOwnDoes_data() { byRenderer(); }
    void theTipColourOfEachHairBeginsWhereItsOwnDoes()
    {
        QFETCH(bool, software);
        int hair = 0;
        const Picture picture = drawnComb(
            software,
            [&hair](sim::StrandStyle& style) {
                style.rootColour = 0xFF0000C0U;
                style.tipColour = 0xFFC00000U;
                style.tipStart = hair++ < 80 ? 0.0F : 0.5F;
            },
            [](sim::StrandMaterial& material) {
                material.tipFrom = 0.25F;
                material.tipOver = 0.0F;
            },
            160);
        // Where most of a column's pixels turn from one colour to the other, of the hair's length.
        const auto blueOf = [&](int from, int to) {
            double blue = 0.0;
            double all = 0.0;
            for (int x = from; x < to; ++x)
                for (int y = 0; y < kLookHeight; ++y) {
                    blue += picture.at(x, y).z;
                    all += picture.at(x, y).x + picture.at(x, y).z;
                }
            return blue / all;
        };
        const double left = blueOf(30, 95);
        const double right = blueOf(105, 170);
        const double more = std::max(left, right);
        const double less = std::min(left, right);
        QVERIFY2(std::abs(more - 0.75) < 0.08 && std::abs(less - 0.375) < 0.08,
                 qPrintable(QStringLiteral("%1 %2").arg(left).arg(right)));
    }
};

} // namespace hairpaint::testing

HAIRPAINT_TEST(hairpaint::testing::TestLookOfHair, None)
#include "test_look_of_hair.moc"
