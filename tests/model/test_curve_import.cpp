// Hair that was exported and comes back: its maps are those that it was grown from.
#include "model/importing/curve_import.h"
#include "model/maps/compositor.h"
#include "sim/groom/growth_direction.h"
#include "sim/groom/strand_style.h"
#include "tests/model/archive_maker.h"
#include "tests/model/exported_hair.h"
#include "tests/model/fixtures.h"
#include "tests/model/sample_project.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>

using namespace hairpaint;
using namespace hairpaint::model;
using test::flat;
using test::frameOf;
using test::hairGroup;

namespace {

const std::shared_ptr<const Head>& ball()
{
    static const std::shared_ptr<const Head> head = test::headOf(test::makeBallHead(), false);
    return head;
}

/// The front half of the ball, where nothing is pinched.
constexpr std::array kRootUvs{glm::vec2(0.5F, 0.5F), glm::vec2(0.4F, 0.6F), glm::vec2(0.62F, 0.45F),
                              glm::vec2(0.55F, 0.7F)};

glm::vec4 valueAt(const HairGroup& group, MapKind kind, glm::vec2 uv)
{
    return group.map(kind).layers.front().raster.sampleBilinear(uv);
}

} // namespace

class TestCurveImport : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_folder;

    [[nodiscard]] QString path(const char* name = "a.hair") const { return m_folder.filePath(QLatin1StringView(name)); }
    /// What comes back of a group; none where it does not.
    [[nodiscard]] std::optional<HairGroup> back(const sim::GroomInput::Group& group, const char* name = "a.hair",
                                                const char* target = "any") const
    {
        if (!test::exported(frameOf({group}), path(name), {}, target))
            return std::nullopt;
        Result<std::vector<HairGroup>> groups = groupsFromCurves(path(name), {}, ball());
        if (!groups)
            qWarning("%s", qPrintable(groups.error().message));
        return groups && groups->size() == 1 ? std::optional<HairGroup>(std::move(groups->front())) : std::nullopt;
    }

private Q_SLOTS:
    void densityAndLengthComeBack_data()
    {
        QTest::addColumn<int>("density");
        QTest::addColumn<int>("length");
        QTest::addColumn<int>("curl");
        QTest::newRow("dense and long") << 65535 << 65535 << 0;
        QTest::newRow("thin and short") << 16384 << 3277 << 0;
        QTest::newRow("ringlets") << 65535 << 49152 << 45000;
    }
    void densityAndLengthComeBack()
    {
        QFETCH(int, density);
        QFETCH(int, length);
        QFETCH(int, curl);
        const auto input = hairGroup(1, static_cast<std::uint16_t>(density), static_cast<std::uint16_t>(length),
                                     static_cast<std::uint16_t>(curl));
        const std::optional<HairGroup> group = back(input);
        QVERIFY(group);
        QCOMPARE(group->name, QStringLiteral("a"));
        const float wantedDensity = input.settings.greatestDensityPerM2 * static_cast<float>(density) / 65535.0F;
        const float wantedLengthM = input.settings.greatestLengthM * static_cast<float>(length) / 65535.0F;
        float foundDensity = 0.0F;
        for (const glm::vec2& uv : kRootUvs) {
            foundDensity += valueAt(*group, MapKind::Density, uv).x * group->settings.greatestDensityPerM2 /
                            static_cast<float>(kRootUvs.size());
            const float lengthM = sim::lengthOf(group->settings, valueAt(*group, MapKind::Length, uv).x);
            QVERIFY2(std::abs(lengthM - wantedLengthM) < 0.05F * wantedLengthM, qPrintable(QString::number(lengthM)));
            const sim::Coil wanted =
                sim::coilOf(input.settings, static_cast<float>(curl) / 65535.0F, 0.5F, wantedLengthM);
            const sim::Coil coil = sim::coilOf(group->settings, valueAt(*group, MapKind::Curl, uv).x,
                                               valueAt(*group, MapKind::CurlSize, uv).x, lengthM);
            QVERIFY2(std::abs(coil.turns - wanted.turns) <= 0.06F * wanted.turns,
                     qPrintable(QString::number(coil.turns)));
            QVERIFY2(std::abs(coil.radiusM - wanted.radiusM) <= 0.1F * wanted.radiusM,
                     qPrintable(QString::number(coil.radiusM)));
        }
        QVERIFY2(std::abs(foundDensity - wantedDensity) < 0.15F * wantedDensity,
                 qPrintable(QString::number(foundDensity)));
    }

    void whatThinsOutBetweenHairsHasNoHoles()
    {
        const auto input = hairGroup(1, 6554, 32768, 0);
        const std::optional<HairGroup> group = back(input);
        QVERIFY(group);
        int empty = 0;
        for (int i = 0; i < 400; ++i) {
            const int row = i / 20;
            const glm::vec2 uv(0.3F + 0.4F * static_cast<float>(i % 20) / 20.0F,
                               0.4F + 0.3F * static_cast<float>(row) / 20.0F);
            empty += valueAt(*group, MapKind::Density, uv).x * group->settings.greatestDensityPerM2 < 200.0F ? 1 : 0;
        }
        QCOMPARE(empty, 0);
    }

    void directionComesBackInTheFrameOfTheRoot_data()
    {
        QTest::addColumn<float>("x");
        QTest::addColumn<float>("y");
        QTest::newRow("upright") << 0.0F << 0.0F;
        QTest::newRow("down and flat") << 0.0F << -0.9F;
        QTest::newRow("aside, leaning") << 0.5F << 0.2F;
    }
    void directionComesBackInTheFrameOfTheRoot()
    {
        QFETCH(float, x);
        QFETCH(float, y);
        auto input = hairGroup(1, 65535, 3277, 0); // 1 cm
        input.maps[sim::MapSlot::Direction] = flat(2, sim::texelOfDirection({x, y}));
        input.settings.physics.volumeM = 0.0F;
        const std::optional<HairGroup> group = back(input);
        QVERIFY(group);
        for (const glm::vec2& uv : kRootUvs) {
            const sim::TiledRaster& raster = group->map(MapKind::Direction).layers.front().raster;
            const glm::vec2 found = sim::directionAt(raster, uv);
            QVERIFY2(glm::distance(found, glm::vec2(x, y)) < 0.12F,
                     qPrintable(QStringLiteral("%1 %2").arg(found.x).arg(found.y)));
            QCOMPARE(valueAt(*group, MapKind::Direction, uv).z, 1.0F);
        }
    }

    void coloursComeBackAtBothEnds()
    {
        auto input = hairGroup(1, 65535, 32768, 0);
        input.maps[sim::MapSlot::Colour] = flat(3, {65535, 32896, 0});
        input.maps[sim::MapSlot::TipColour] = flat(3, {0, 32896, 65535});
        input.settings.material.widthM = 70e-6F;
        input.settings.material.tipAlpha = 0.5F;
        const std::optional<HairGroup> group = back(input);
        QVERIFY(group);
        const glm::vec3 root(valueAt(*group, MapKind::Colour, kRootUvs[1]));
        const glm::vec3 tip(valueAt(*group, MapKind::TipColour, kRootUvs[1]));
        QVERIFY(glm::distance(root, glm::vec3(1.0F, 128.0F / 255.0F, 0.0F)) < 0.01F);
        QVERIFY(glm::distance(tip, glm::vec3(0.0F, 128.0F / 255.0F, 1.0F)) < 0.01F);
        QVERIFY(std::abs(group->settings.material.widthM - 70e-6F) < 1e-6F);
        QVERIFY(std::abs(group->settings.material.tipAlpha - 0.5F) < 0.01F);
    }

    void theProgramItWasExportedForMakesNoDifference_data()
    {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<QByteArray>("target");
        for (const char* target : {"any", "blender", "unreal", "maya"})
            for (const char* name : {"a.hair", "a.usda", "a.usdz"})
                QTest::newRow((QByteArray(target) + ", " + name).constData()) << QByteArray(name) << QByteArray(target);
    }
    void theProgramItWasExportedForMakesNoDifference()
    {
        QFETCH(QByteArray, name);
        QFETCH(QByteArray, target);
        auto input = hairGroup(1, 65535, 32768, 0);
        input.maps[sim::MapSlot::Colour] = flat(3, {65535, 32896, 0});
        const std::optional<HairGroup> group = back(input, name.constData(), target.constData());
        QVERIFY(group);
        const float lengthM = sim::lengthOf(group->settings, valueAt(*group, MapKind::Length, kRootUvs[0]).x);
        QVERIFY2(std::abs(lengthM - 0.1F) < 0.003F, qPrintable(QString::number(lengthM)));
        QVERIFY(glm::distance(glm::vec3(valueAt(*group, MapKind::Colour, kRootUvs[1])),
                              glm::vec3(1.0F, 128.0F / 255.0F, 0.0F)) < 0.01F);
    }

    void cancellingStopsItWherever()
    {
        QVERIFY(test::exported(frameOf({hairGroup(1, 20000, 32768, 0)}), path()));
        int asked = 0;
        QVERIFY(groupsFromCurves(path(), {}, ball(), [&asked](double) { return ++asked > 0; }));
        QVERIFY(asked > 4);
        for (const int stopAt : {1, asked / 2, asked}) {
            int count = 0;
            QVERIFY(!groupsFromCurves(path(), {}, ball(), [&](double) { return ++count < stopAt; }));
        }
    }

    void progressNeverStepsBack()
    {
        QVERIFY(test::exported(frameOf({hairGroup(1, 20000, 32768, 0)}), path()));
        std::vector<double> told;
        QVERIFY(groupsFromCurves(path(), {}, ball(), [&told](double fraction) {
            told.push_back(fraction);
            return true;
        }));
        QVERIFY(std::ranges::is_sorted(told) && told.front() >= 0.0 && told.back() <= 1.0);
    }

    void hairsThatAllStandAtOnePointAreRead()
    {
        // Each has all the others as neighbours: looked through one by one they would take minutes.
        constexpr quint32 kStrands = 200'000;
        QByteArray bytes(128, '\0');
        bytes.replace(0, 4, "HAIR");
        const std::array<quint32, 4> header{kStrands, 2 * kStrands, 2, 1};
        std::memcpy(bytes.data() + 4, header.data(), sizeof(header));
        const std::array<glm::vec3, 2> hair{glm::vec3(0.0F, 0.0F, 0.1F), glm::vec3(0.0F, 0.0F, 0.15F)};
        bytes += QByteArray(reinterpret_cast<const char*>(hair.data()), sizeof(hair)).repeated(kStrands);
        test::writeBytes(path(), bytes);
        const Result<std::vector<HairGroup>> groups = groupsFromCurves(path(), {}, ball());
        QVERIFY(groups && groups->size() == 1);
        QVERIFY(groups->front().settings.greatestDensityPerM2 <= 4e6F);
    }

    void aTuftThatStandsIsHeldAndStraysAreNot_data()
    {
        QTest::addColumn<bool>("together");
        QTest::newRow("a tuft") << true;
        QTest::newRow("strays") << false;
    }
    void aTuftThatStandsIsHeldAndStraysAreNot()
    {
        QFETCH(bool, together);
        // One hair of twenty stands, the others lie along the ball.
        constexpr int kStrands = 8000;
        constexpr int kSegments = 6;
        constexpr float kRadiusM = 0.1F;
        constexpr float kLengthM = 0.06F;
        QByteArray bytes(128, '\0');
        bytes.replace(0, 4, "HAIR");
        const std::array<quint32, 4> header{kStrands, (kSegments + 1) * kStrands, 2, kSegments};
        std::memcpy(bytes.data() + 4, header.data(), sizeof(header));
        for (int i = 0; i < kStrands; ++i) {
            const float y = 1.0F - 2.0F * (static_cast<float>(i) + 0.5F) / kStrands;
            const float turn = 2.4F * static_cast<float>(i);
            const glm::vec3 up(std::sqrt(1.0F - y * y) * std::cos(turn), y, std::sqrt(1.0F - y * y) * std::sin(turn));
            const glm::vec3 along = glm::normalize(glm::cross(up, glm::vec3(0.0F, 1.0F, 0.0F)));
            const bool stands = together ? up.z > 0.9F : i % 20 == 0;
            for (int point = 0; point <= kSegments; ++point) {
                const float far = kLengthM * static_cast<float>(point) / kSegments;
                const float angle = far / kRadiusM;
                const glm::vec3 positionHd = stands ? up * (kRadiusM + far)
                                                    : (up * std::cos(angle) + along * std::sin(angle)) *
                                                          (kRadiusM + 0.002F * std::min(angle, 1.0F));
                bytes.append(reinterpret_cast<const char*>(&positionHd), sizeof(positionHd));
            }
        }
        test::writeBytes(path(), bytes);
        const Result<std::vector<HairGroup>> groups = groupsFromCurves(path(), {}, ball());
        QVERIFY(groups && groups->size() == 1);
        const auto gelAt = [&](const glm::vec3& positionHd) {
            return valueAt(groups->front(), MapKind::Gel, ball()->skin->nearest(positionHd).uv).x;
        };
        const float top = gelAt({0.0F, 0.0F, kRadiusM});
        QVERIFY2(together ? top > 0.6F : top < 0.01F, qPrintable(QString::number(top)));
        QVERIFY(gelAt({0.7F * kRadiusM, 0.0F, -0.7F * kRadiusM}) < 0.1F);
    }

    void manyPrimsAreOneGroup()
    {
        QByteArray text = "#usda 1.0\n(\n metersPerUnit = 1\n)\n";
        for (int i = 0; i < 40; ++i) {
            const QByteArray x = QByteArray::number(0.002 * (i - 20));
            text += "def BasisCurves \"lock" + QByteArray::number(i) +
                    "\" {\nint[] curveVertexCounts = [2]\npoint3f[] points = [(" + x + ",0,0.1),(" + x +
                    ",0,0.15)]\nuniform token type = \"linear\"\n}\n";
        }
        test::writeBytes(path("locks.usda"), text);
        const Result<std::vector<HairGroup>> groups = groupsFromCurves(path("locks.usda"), {}, ball());
        QVERIFY(groups && groups->size() == 1);
        QCOMPARE(groups->front().name, QStringLiteral("locks"));
    }

    void hairInAnotherSpaceIsFitted()
    {
        // As of a program that tells no unit, on a head a third as large that stands elsewhere.
        QVERIFY(test::exported(frameOf({hairGroup(1, 20000, 32768, 0)}), path()));
        QByteArray bytes = test::readBytes(path());
        const auto strands = qFromLittleEndian<quint32>(bytes.constData() + 4);
        const auto points = qFromLittleEndian<quint32>(bytes.constData() + 8);
        std::memset(bytes.data() + 40, 0, 88);
        for (std::size_t i = 0; i < points; ++i) {
            glm::vec3 point;
            char* const at = bytes.data() + 128 + 2 * static_cast<std::size_t>(strands) + 12 * i;
            std::memcpy(&point, at, sizeof(point));
            point = point * 7.0F + glm::vec3(3.0F, 40.0F, -2.0F);
            std::memcpy(at, &point, sizeof(point));
        }
        test::writeBytes(path(), bytes);
        const Result<std::vector<HairGroup>> groups = groupsFromCurves(path(), {}, ball());
        QVERIFY(groups);
        const HairGroup& group = groups->front();
        const float lengthM = sim::lengthOf(group.settings, valueAt(group, MapKind::Length, kRootUvs[0]).x);
        QVERIFY2(std::abs(lengthM - 0.1F) < 0.01F, qPrintable(QString::number(lengthM)));
    }
};

HAIRPAINT_TEST(TestCurveImport, Core)
#include "test_curve_import.moc"
