// Each formula of the light on hair beside what it stands for, worked out plainly and in double precision.
#include "tests/support/test_program.h"
#include "view/rendering/frame_lights.h"
#include "view/rendering/light/hair_light_inl.h"
#include "view/rendering/light/tone_inl.h"

#include <QtTest>

#include <cmath>
#include <numbers>
#include <random>

using namespace hairpaint::rendering;
namespace simd = hairpaint::rendering::HWY_NAMESPACE;

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kIndex = 1.55; ///< Index of refraction.

struct Directions
{
    double thetaI, thetaO, phi;
};

simd::FibreAngles<float> anglesOf(const Directions& d)
{
    const double lightDotEye =
        std::sin(d.thetaI) * std::sin(d.thetaO) + std::cos(d.thetaI) * std::cos(d.thetaO) * std::cos(d.phi);
    return simd::fibreAngles(static_cast<float>(std::sin(d.thetaI)), static_cast<float>(std::sin(d.thetaO)),
                             static_cast<float>(std::cos(d.thetaO)), static_cast<float>(lightDotEye));
}

double schlick(double cosine)
{
    const double normal = std::pow((kIndex - 1.0) / (kIndex + 1.0), 2.0);
    return normal + (1.0 - normal) * std::pow(1.0 - cosine, 5.0);
}

/// Over offsets h = sin g across the fibre.
double meanOverWidth(double cosD)
{
    double sum = 0.0;
    constexpr int kSteps = 2000;
    for (int i = 0; i < kSteps; ++i) {
        const double h = (i + 0.5) / kSteps;
        sum += schlick(cosD * std::sqrt(1.0 - h * h));
    }
    return sum / kSteps;
}

double gaussian(double x, double deviation)
{
    return std::exp(-0.5 * x * x / (deviation * deviation)) / (deviation * std::sqrt(2.0 * kPi));
}

struct ReferenceLobes
{
    double r, tt, trt;
};

ReferenceLobes reference(const Directions& d, double roughness, double depth)
{
    const double halfDifference = 0.5 * (d.thetaI - d.thetaO);
    const double half = 0.5 * (d.thetaI + d.thetaO);
    const double cosD = std::cos(halfDifference);
    const double tilt = 0.045;
    const double deviation = 0.02 + 0.18 * roughness;
    const auto m = [&](double shift, double width) {
        return gaussian(2.0 * std::sin(half) - shift, deviation * width) / cosD;
    };
    const double cosHalf = std::cos(0.5 * d.phi);
    const double reflected = meanOverWidth(cosD);
    const double cosRefracted = std::sqrt(1.0 - std::pow(std::sin(halfDifference) / kIndex, 2.0));
    const double through = std::exp(-depth / cosRefracted);
    double turn = 0.0; // The power's integral over a turn.
    for (int i = 0; i < 3600; ++i)
        turn += std::pow(std::cos(i * kPi / 3600.0), 16.0) * 2.0 * kPi / 3600.0;
    const double entered = (1.0 - reflected) * (1.0 - reflected) / turn;
    return {m(-2.0 * tilt, 1.0) * schlick(cosD * cosHalf) * cosHalf / 4.0,
            m(tilt, 0.8) * entered * through * std::pow(std::sin(0.5 * d.phi), 16.0),
            m(4.0 * tilt, 1.8) * entered * reflected * through * through * std::pow(cosHalf, 16.0)};
}

simd::Triple<float> grey(float v)
{
    return {v, v, v};
}

/// All that leaves the fibre toward one inclination when light of 1 comes from everywhere.
double furnace(double thetaO, float roughness)
{
    const FibreShape shape = fibreShape(roughness);
    double sum = 0.0;
    constexpr int kSines = 800;
    constexpr int kAzimuths = 90;
    for (int i = 0; i < kSines; ++i)
        for (int j = 0; j < kAzimuths; ++j) {
            const Directions d{.thetaI = std::asin(-1.0 + (i + 0.5) * 2.0 / kSines),
                               .thetaO = thetaO,
                               .phi = -kPi + (j + 0.5) * 2.0 * kPi / kAzimuths};
            const auto lobes = simd::marschner<simd::LobeSet::All>(shape, anglesOf(d), grey(0.0F), 0.0F);
            sum += static_cast<double>(lobes.r + lobes.tt.x + lobes.trt.x);
        }
    return sum * (2.0 / kSines) * (2.0 * kPi / kAzimuths);
}

class RandomNumbers
{
public:
    double between(double low, double high)
    {
        return low + (high - low) * (static_cast<double>(m_engine()) / 4294967295.0);
    }
    glm::vec3 direction()
    {
        for (;;) {
            const glm::dvec3 v(between(-1.0, 1.0), between(-1.0, 1.0), between(-1.0, 1.0));
            if (glm::length(v) > 0.1 && glm::length(v) < 1.0)
                return glm::normalize(v);
        }
    }
    Directions directions()
    {
        return {.thetaI = between(-1.4, 1.4), .thetaO = between(-1.4, 1.4), .phi = between(-kPi, kPi)};
    }

private:
    std::mt19937 m_engine{7};
};

bool isNear(double a, double b, double relative, double absolute)
{
    return std::abs(a - b) <= absolute + relative * std::abs(b);
}

} // namespace

class TestHairLight : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void marschnersLobesAreThoseOfTheReference()
    {
        RandomNumbers random;
        for (int i = 0; i < 3000; ++i) {
            const Directions d = random.directions();
            const double roughness = random.between(0.0, 1.0);
            const double depth = random.between(0.0, 2.0);
            const auto lobes = simd::marschner<simd::LobeSet::All>(fibreShape(static_cast<float>(roughness)),
                                                                   anglesOf(d), grey(static_cast<float>(depth)), 0.0F);
            const ReferenceLobes expected = reference(d, roughness, depth);
            QVERIFY2(isNear(static_cast<double>(lobes.r), expected.r, 2e-3, 2e-4), qPrintable(QString::number(i)));
            QVERIFY2(isNear(static_cast<double>(lobes.tt.y), expected.tt, 0.02, 2e-3), qPrintable(QString::number(i)));
            QVERIFY2(isNear(static_cast<double>(lobes.trt.z), expected.trt, 0.04, 5e-4),
                     qPrintable(QString::number(i)));
        }
    }

    void noLobeCaresWhichIsTheLightAndWhichTheEye()
    {
        RandomNumbers random;
        for (int i = 0; i < 2000; ++i) {
            const Directions d = random.directions();
            const Directions swapped{.thetaI = d.thetaO, .thetaO = d.thetaI, .phi = -d.phi};
            const FibreShape shape = fibreShape(static_cast<float>(random.between(0.0, 1.0)));
            const auto lobes = simd::marschner<simd::LobeSet::All>(shape, anglesOf(d), grey(0.3F), 0.0F);
            const auto back = simd::marschner<simd::LobeSet::All>(shape, anglesOf(swapped), grey(0.3F), 0.0F);
            QVERIFY(isNear(static_cast<double>(lobes.r), static_cast<double>(back.r), 1e-3, 1e-6));
            QVERIFY(isNear(static_cast<double>(lobes.tt.x), static_cast<double>(back.tt.x), 1e-3, 1e-6));
            QVERIFY(isNear(static_cast<double>(lobes.trt.x), static_cast<double>(back.trt.x), 1e-3, 1e-6));
        }
    }

    void aFibreWithoutPigmentVanishesInAWhiteFurnace_data()
    {
        QTest::addColumn<float>("roughness");
        for (const float roughness : {0.0F, 0.3F, 0.6F, 1.0F})
            QTest::addRow("roughness %g", static_cast<double>(roughness)) << roughness;
    }
    void aFibreWithoutPigmentVanishesInAWhiteFurnace()
    {
        QFETCH(float, roughness);
        double sum = 0.0;
        double weights = 0.0;
        for (int degrees = -85; degrees <= 85; degrees += 10) {
            const double theta = degrees * kPi / 180.0;
            // Weight: how much of the fibre is seen, times how much of the sphere is at theta.
            const double seen = std::cos(theta) * std::cos(theta);
            const double light = furnace(theta, roughness);
            // Where the fibre is seen slantingly, the tilt of wide lobes leaves some beyond its ends.
            if (std::abs(degrees) <= 45)
                QVERIFY2(std::abs(light - 1.0) < 0.05 + 0.05 * static_cast<double>(roughness),
                         qPrintable(QStringLiteral("%1: %2").arg(degrees).arg(light)));
            sum += seen * light;
            weights += seen;
        }
        QVERIFY2(std::abs(sum / weights - 1.0) < 0.03, qPrintable(QString::number(sum / weights)));
    }

    void pigmentOnlyTakesLight()
    {
        for (const float colour : {0.9F, 0.5F, 0.1F, 0.01F}) {
            const float depth = simd::fibreDepth(colour);
            const double log = std::log(static_cast<double>(colour)) / 5.8877;
            QVERIFY(isNear(static_cast<double>(depth), 1.8526 * log * log, 1e-3, 1e-5));
            const auto lobes = simd::marschner<simd::LobeSet::All>(
                fibreShape(0.3F), anglesOf({.thetaI = 0.1, .thetaO = -0.1, .phi = 2.5}), grey(depth), 0.0F);
            const auto clear = simd::marschner<simd::LobeSet::All>(
                fibreShape(0.3F), anglesOf({.thetaI = 0.1, .thetaO = -0.1, .phi = 2.5}), grey(0.0F), 0.0F);
            QVERIFY(lobes.tt.x < clear.tt.x && lobes.r == clear.r);
        }
    }

    void absorptionIsExponential()
    {
        for (int step = 0; step < 3000; ++step) {
            const double x = 0.01 * step;
            QVERIFY(std::abs(static_cast<double>(simd::absorbed(static_cast<float>(x))) - std::exp(-x)) < 3e-3);
        }
    }

    void lightBehindHairIsWhatMetNoneAndWhatWentOn()
    {
        for (const double crossed : {0.0, 0.5, 2.0, 10.0, 40.0})
            for (const double depth : {0.0, 0.05, 0.5, 1.5}) {
                const auto passed = simd::passedThrough(static_cast<float>(crossed), grey(static_cast<float>(depth)));
                const double direct = std::exp(-0.75 * crossed);
                const double all = direct + 0.7 * (1.0 - direct) * std::exp(-crossed * (depth + 0.07));
                QVERIFY(std::abs(static_cast<double>(passed.direct) - direct) < 3e-3);
                QVERIFY(std::abs(static_cast<double>(passed.all.x) - all) < 6e-3);
            }
        // Deep in the coat fair hair is lit and black hair is not.
        const auto fair = simd::passedThrough(6.0F, grey(simd::fibreDepth(0.6F)));
        const auto black = simd::passedThrough(6.0F, grey(simd::fibreDepth(0.01F)));
        QVERIFY(fair.all.x > 0.3F && black.all.x < 0.05F);
    }

    void kajiyaAndKaysHighlightsLieOnMirroredCones()
    {
        RandomNumbers random;
        for (int i = 0; i < 2000; ++i) {
            const Directions d = random.directions();
            const double exponent = random.between(20.0, 400.0);
            const auto shown = simd::kajiyaKay(anglesOf(d), static_cast<float>(exponent));
            const auto cone = [&](double shift, double power) {
                return std::pow(std::max(std::cos(d.thetaI + d.thetaO + shift), 0.0), power);
            };
            QVERIFY(isNear(static_cast<double>(shown.first), cone(0.09, exponent), 0.01, 1e-3));
            QVERIFY(isNear(static_cast<double>(shown.second), cone(-0.18, exponent / 4.0), 0.01, 1e-3));
        }
    }

    /// The best of all normals across the line is found by trying.
    void anIlluminatedLineShowsItsBestNormals()
    {
        RandomNumbers random;
        for (int i = 0; i < 300; ++i) {
            const glm::dvec3 l = random.direction();
            const glm::dvec3 v = random.direction();
            double diffuse = 0.0;
            double specular = 0.0;
            for (int step = 0; step < 7200; ++step) {
                const double angle = step * kPi / 3600.0;
                const glm::dvec3 n(std::cos(angle), std::sin(angle), 0.0);
                diffuse = std::max(diffuse, glm::dot(l, n));
                specular = std::max(specular, glm::dot(v, 2.0 * glm::dot(l, n) * n - l));
            }
            const auto at =
                simd::fibreAngles(static_cast<float>(l.z), static_cast<float>(v.z),
                                  static_cast<float>(std::sqrt(1.0 - v.z * v.z)), static_cast<float>(glm::dot(l, v)));
            const auto shown = simd::illuminatedLine(at, 30.0F);
            QVERIFY(isNear(static_cast<double>(shown.diffuse), std::pow(diffuse, 4.8), 1e-2, 1e-3));
            QVERIFY(isNear(static_cast<double>(shown.specular), std::pow(specular, 30.0), 2e-2, 1e-3));
        }
    }

    void theHeadThrowsASoftShadowBehindItself()
    {
        const simd::Triple<float> up{0.0F, 1.0F, 0.0F};
        const auto left = [&](float x, float y) { return simd::besideHead(simd::Triple<float>{x, y, 0.0F}, 0.1F, up); };
        QCOMPARE(left(0.0F, 0.1F), 1.0F);
        QCOMPARE(left(0.0F, -0.1F), 0.0F);
        QCOMPARE(left(0.2F, -0.1F), 1.0F);
        float last = 0.0F;
        for (int step = 0; step < 100; ++step) {
            const float x = 0.05F + 0.001F * static_cast<float>(step);
            const float here = left(x, -0.2F);
            QVERIFY(here >= last && here - last < 0.05F);
            last = here;
        }
        QCOMPARE(simd::besideHead(simd::Triple<float>{0.01F, -0.1F, 0.0F}, 0.0F, up), 1.0F); // No head.
    }

    void lightShinesThroughHairBehindWhichNoHeadStands()
    {
        // Nothing but what goes through: black hair that absorbs nothing, seen along z.
        const auto glow = [](glm::vec3 fromHead, float headRadiusM) {
            HairLighting lighting;
            lighting.eyeWo = {0.0F, 0.0F, 100.0F};
            lighting.rim = {.towardWo = glm::normalize(glm::vec3(0.95F, 0.0F, -0.31F)), .colour = glm::vec3(1.0F)};
            lighting.headRadiusM = headRadiusM;
            lighting.shine = 0.0F;
            const simd::HairPoint<float> point{.position = {fromHead.x, fromHead.y, fromHead.z},
                                               .tangent = {0.0F, 1.0F, 0.0F},
                                               .colour = grey(0.0F),
                                               .depth = grey(0.0F),
                                               .turned = 0.0F,
                                               .towardKey = 0.0F,
                                               .towardEye = 0.0F,
                                               .towardRim = 0.0F};
            return simd::hairLight(lighting, point).x;
        };
        const glm::vec3 onHead(0.06F, 0.0F, 0.09F); // The light reaches it past the head's side.
        const glm::vec3 besideHead(0.2F, 0.0F, 0.09F);
        QVERIFY(glow(onHead, 0.0F) > 0.01F);
        QVERIFY(glow(onHead, 0.1F) < 0.1F * glow(onHead, 0.0F));
        QCOMPARE(glow(besideHead, 0.1F), glow(besideHead, 0.0F));
    }

    void surroundingsAreAsBrightAsEachOtherAndNowhereNegative_data()
    {
        QTest::addColumn<int>("which");
        for (std::size_t i = 0; i < kEnvironmentCount; ++i)
            QTest::addRow("surroundings %zu", i) << static_cast<int>(i);
    }
    void surroundingsAreAsBrightAsEachOtherAndNowhereNegative()
    {
        QFETCH(int, which);
        const Irradiance& e = irradianceOf(static_cast<EnvironmentKind>(which));
        double mean = 0.0;
        constexpr int kCount = 4000;
        for (int i = 0; i < kCount; ++i) {
            const double y = -1.0 + (i + 0.5) * 2.0 / kCount;
            const double turn = i * 2.399963;
            const double across = std::sqrt(1.0 - y * y);
            const simd::Triple<float> n{static_cast<float>(across * std::cos(turn)), static_cast<float>(y),
                                        static_cast<float>(across * std::sin(turn))};
            const auto light = simd::irradianceAt(e, n);
            QVERIFY(light.x >= 0.0F && light.y >= 0.0F && light.z >= 0.0F);
            mean += 0.2126 * static_cast<double>(light.x) + 0.7152 * static_cast<double>(light.y) +
                    0.0722 * static_cast<double>(light.z);
        }
        QVERIFY2(std::abs(mean / kCount - 1.0) < 0.03, qPrintable(QString::number(mean / kCount)));
    }

    void theToneCurveKeepsWhatIsDimAndNeverClips()
    {
        QCOMPARE(simd::toneOf(0.2F), 0.2F);
        QCOMPARE(simd::toneOf(0.5F), 0.5F);
        float last = 0.0F;
        for (int step = 1; step < 400; ++step) {
            const float light = 0.01F * static_cast<float>(step);
            const float shown = simd::toneOf(light);
            QVERIFY(shown > last && shown <= light && shown < 1.0F);
            last = shown;
        }
        QVERIFY(last > 0.9F);
    }

    void theToneCurveKeepsTheHueAndPalesWhatGlares()
    {
        const simd::Triple<float> dim{0.5F, 0.2F, 0.1F};
        QCOMPARE(simd::toneOf(dim).y, 0.2F);
        const auto hueOf = [](const simd::Triple<float>& c) { return (c.y - c.z) / (c.x - c.z); };
        const auto chromaOf = [](const simd::Triple<float>& c) { return (c.x - c.z) / c.x; };
        float last = 1.0F;
        for (const float gain : {1.0F, 2.0F, 4.0F, 8.0F}) {
            const auto shown = simd::toneOf(dim * gain);
            QVERIFY(isNear(static_cast<double>(hueOf(shown)), static_cast<double>(hueOf(dim)), 1e-3, 0.0));
            QVERIFY(chromaOf(shown) < last);
            last = chromaOf(shown);
        }
        QVERIFY(last < 0.6F);
    }

    /// The tone curve shows it so, but for a little paleness of what is bright.
    void lightIsFoundForWhatIsPainted()
    {
        for (const float brightest : {0.01F, 0.3F, 0.5F, 0.7F, 0.87F}) {
            const simd::Triple<float> painted{brightest, brightest * 0.6F, brightest * 0.4F};
            const auto shown = simd::toneOf(simd::lightShownAs(painted));
            QVERIFY(isNear(static_cast<double>(shown.x), static_cast<double>(painted.x), 1e-3, 0.0));
            QVERIFY(isNear(static_cast<double>(shown.z), static_cast<double>(painted.z), 0.25, 0.0));
        }
        const simd::Triple<float> white{1.0F, 1.0F, 1.0F};
        QCOMPARE(simd::lightShownAs(white).x, 2.0F);
    }

    void aFloatAndALaneGiveTheSameBits()
    {
        RandomNumbers random;
        FrameConstants constants{};
        constants.eyeWo = glm::vec4(0.1F, 0.0F, 0.7F, 1.0F);
        constants.headWo = glm::vec4(0.0F, 0.0F, 0.0F, 0.09F);
        for (glm::vec4* lamp : {&constants.keyWo, &constants.fillWo, &constants.rimWo})
            *lamp = glm::vec4(random.direction(), 0.0F);
        constants.keyColour = constants.fillColour = constants.rimColour = glm::vec4(0.7F);
        const hairpaint::sim::StrandMaterial material;
        for (int model = 0; model < 3; ++model) {
            constants.keyWo.w = static_cast<float>(model);
            const HairLighting lighting = hairLighting(constants, material);
            for (int i = 0; i < 500; ++i) {
                const glm::vec3 position = random.direction() * 0.12F;
                const glm::vec3 tangent = random.direction();
                const auto colour = static_cast<float>(random.between(0.0, 1.0));
                const auto crossed = static_cast<float>(random.between(0.0, 9.0));
                const auto pointOf = [&]<class F>(F) {
                    const simd::Triple<F> c{F(colour), F(colour * 0.7F), F(colour * 0.2F)};
                    return simd::HairPoint<F>{simd::tripleOf<F>(position),
                                              simd::tripleOf<F>(tangent),
                                              c,
                                              simd::fibreDepth(c),
                                              F(0.1F),
                                              F(crossed),
                                              F(crossed * 0.5F),
                                              F(crossed * 0.3F)};
                };
                const auto one = simd::hairLight(lighting, pointOf(0.0F));
                const auto many = simd::hairLight(lighting, pointOf(simd::Lanes(0.0F)));
                HWY_ALIGN float lane[simd::kMostLanes];
                simd::stored(many.y, lane);
                QCOMPARE(lane[0], one.y);
            }
        }
    }
};

HAIRPAINT_TEST(TestHairLight, None)
#include "test_hair_light.moc"
