// Hair that was exported in braids comes back in braids, and only that.
#include "model/importing/curve_import.h"
#include "sim/groom/strand_style.h"
#include "tests/model/exported_hair.h"
#include "tests/model/fixtures.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <numeric>

using namespace hairpaint;
using namespace hairpaint::model;
using test::flat;
using test::frameOf;
using test::hairGroup;

namespace {

constexpr float kLengthM = 0.2F;
constexpr float kRadiusM = 0.007F;
constexpr float kSpacingM = 0.08F;
constexpr float kDensityPerM2 = 50'000.0F; ///< With more hairs the maps are of 512 texels a side.
constexpr float kHairWidthM = 1.2e-4F;     ///< Thick enough that these hairs fill a plait of kRadiusM.
constexpr std::uint16_t kAll = 65535;

/// Numbers of texels, by sim::BraidKind.
using KindCounts = std::array<int, static_cast<std::size_t>(sim::kLastBraidKind) + 1>;

} // namespace

class TestBraidImport : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_folder;

    /// The group as it comes back from an export; none where it does not come back.
    [[nodiscard]] std::optional<HairGroup> back(const sim::GroomInput::Group& group) const
    {
        const auto head = test::headOf(test::makeBallHead(), false);
        const QString path = m_folder.filePath(QStringLiteral("a.hair"));
        if (!test::exported(frameOf({group}), path))
            return std::nullopt;
        Result<std::vector<HairGroup>> groups = groupsFromCurves(path, {}, head);
        return groups && groups->size() == 1 ? std::optional<HairGroup>(std::move(groups->front())) : std::nullopt;
    }
    /// How many texels of the skin have each kind of braid.
    [[nodiscard]] static KindCounts kindsIn(const HairGroup& group)
    {
        const sim::TiledRaster& raster = group.map(MapKind::Braid).layers.front().raster;
        KindCounts counts{};
        for (int y = 0; y < raster.size(); y += 4)
            for (int x = 0; x < raster.size(); x += 4)
                ++counts.at(raster.texel(x, y)[0]);
        return counts;
    }
    [[nodiscard]] static sim::GroomInput::Group braided(sim::BraidKind kind)
    {
        sim::GroomInput::Group group = hairGroup(1, kAll, kAll, 0);
        group.settings.greatestDensityPerM2 = kDensityPerM2;
        group.settings.greatestLengthM = kLengthM;
        group.settings.braidRadiusM = kRadiusM;
        group.settings.material.widthM = kHairWidthM;
        group.settings.braidSpacingM = kSpacingM;
        group.settings.basisHairs = 2000;
        group.settings.nodesPerHair = 16;
        group.maps[sim::MapSlot::Braid] = flat(1, {static_cast<std::uint16_t>(kind)});
        return group;
    }

private Q_SLOTS:
    void kindRadiusLengthAndSpacingComeBack_data()
    {
        QTest::addColumn<int>("kind");
        QTest::newRow("plaits") << static_cast<int>(sim::BraidKind::Plait);
        QTest::newRow("twists") << static_cast<int>(sim::BraidKind::Twist);
        QTest::newRow("locs") << static_cast<int>(sim::BraidKind::Loc);
    }
    void kindRadiusLengthAndSpacingComeBack()
    {
        QFETCH(int, kind);
        const std::optional<HairGroup> group = back(braided(static_cast<sim::BraidKind>(kind)));
        QVERIFY(group);
        const KindCounts counts = kindsIn(*group);
        for (int other = 0; other < static_cast<int>(counts.size()); ++other)
            QVERIFY2(counts.at(static_cast<std::size_t>(other)) * 20 < counts.at(static_cast<std::size_t>(kind)) ||
                         other == kind,
                     qPrintable(QStringLiteral("%1: %2").arg(other).arg(counts.at(static_cast<std::size_t>(other)))));
        const auto isNear = [](float found, float wanted, float by) { return std::abs(found - wanted) < by * wanted; };
        QVERIFY2(isNear(group->settings.braidRadiusM, kRadiusM, 0.15F),
                 qPrintable(QString::number(group->settings.braidRadiusM)));
        QVERIFY2(isNear(group->settings.braidSpacingM, kSpacingM, 0.2F),
                 qPrintable(QString::number(group->settings.braidSpacingM)));
        const glm::vec4 length = group->map(MapKind::Length).layers.front().raster.sampleBilinear({0.5F, 0.5F});
        const float lengthM = sim::lengthOf(group->settings, length.x);
        QVERIFY2(isNear(lengthM, kLengthM, 0.08F), qPrintable(QString::number(lengthM)));
    }

    void hairThatOnlyHangsTogetherIsNoBraid_data()
    {
        QTest::addColumn<int>("curl");
        QTest::addColumn<int>("clump");
        QTest::newRow("straight") << 0 << 0;
        QTest::newRow("straight locks") << 0 << 65535;
        QTest::newRow("ringlets") << 45000 << 0;
        QTest::newRow("locks of ringlets") << 45000 << 60000;
        QTest::newRow("tight locks of ringlets") << 45000 << 65535;
    }
    void hairThatOnlyHangsTogetherIsNoBraid()
    {
        QFETCH(int, curl);
        QFETCH(int, clump);
        sim::GroomInput::Group group = braided(sim::BraidKind::None);
        group.settings.basisHairs = 256; // Locks of some 25 hairs.
        group.maps[sim::MapSlot::Curl] = flat(1, {static_cast<std::uint16_t>(curl)});
        group.maps[sim::MapSlot::Clump] = flat(1, {static_cast<std::uint16_t>(clump)});
        const std::optional<HairGroup> found = back(group);
        QVERIFY(found);
        const KindCounts counts = kindsIn(*found);
        QCOMPARE(std::accumulate(counts.begin() + 1, counts.end(), 0), 0);
    }
};

HAIRPAINT_TEST(TestBraidImport, Core)
#include "test_braid_import.moc"
