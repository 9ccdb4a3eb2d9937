// Another range of a map keeps what is painted in its own unit, in every layer and however it is blended.
#include "model/document/group_commands.h"
#include "model/document/range_change.h"

#include "model/maps/compositor.h"
#include "model/project/group_schema.h"
#include "model/tools/selecting/clipboard.h"
#include "tests/model/fixtures.h"
#include "tests/sim/groom_reading.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <random>
#include <utility>

using namespace hairpaint;
using namespace hairpaint::model;
using namespace hairpaint::test;

namespace {

/// A layer with values and coverages of every size, some tiles of one value, some unpainted.
sim::TiledRaster motley(std::mt19937& random, double greatest)
{
    sim::TiledRaster raster(256, 2);
    const auto value = [&](double most) {
        return static_cast<std::uint16_t>(static_cast<double>(random() % 65536) * most);
    };
    for (int index = 0; index < raster.tileCount(); ++index) {
        if (index % 4 == 0)
            continue;
        if (index % 4 == 1) {
            raster.setUniform(index, {value(greatest), 65535, 0, 0});
            continue;
        }
        const std::span<std::uint16_t> pixels = raster.writableTile(index);
        for (std::size_t i = 0; i < pixels.size(); i += 2) {
            pixels[i] = value(greatest);
            pixels[i + 1] = random() % 3 == 0 ? 65535 : value(1.0);
        }
    }
    return raster;
}

/// The group's amount of a resolved texel.
double amountAt(const HairGroup& group, MapKind map, int x, int y)
{
    const double value = static_cast<double>(resolveTexel(group.map(map), x, y)[0]) / 65535.0;
    return mapSpec(map).scale->amount(group.settings, value);
}

} // namespace

class TestRangeChange : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void the_ranges_of_maps_are_known()
    {
        QStringList keys;
        for (const GroupSetting& row : groupSchema())
            if (setsRange(row))
                keys.append(QLatin1StringView(row.key));
        QCOMPARE(keys, (QStringList{QStringLiteral("greatest_length_m"), QStringLiteral("greatest_density_per_m2"),
                                    QStringLiteral("greatest_curl_radius_m"), QStringLiteral("shortest_length_m"),
                                    QStringLiteral("greatest_frizz_m")}));
    }

    void a_wider_range_keeps_every_amount_data()
    {
        QTest::addColumn<int>("mode");
        for (const BlendRule& rule : blendRules())
            QTest::newRow(rule.id) << static_cast<int>(rule.mode);
    }
    void a_wider_range_keeps_every_amount()
    {
        QFETCH(int, mode);
        std::mt19937 random(7);
        Project project = filledPatch(MapKind::Density, 40000);
        HairGroup& group = project.groups.front();
        MapStack& stack = group.map(MapKind::Length);
        stack.layers.front().raster = motley(random, 1.0);
        Layer over = makeLayer(project, mapSpec(MapKind::Length), 256, QStringLiteral("Over"));
        over.blend = static_cast<BlendMode>(mode);
        over.opacity = 0.8F;
        over.raster = motley(random, 1.0);
        stack.layers.push_back(over);
        sim::GroupSettings settings = group.settings;
        settings.greatestLengthM *= 2.0F;
        const RangeChange change = withRange(group, settings);
        QVERIFY(change.clamped.empty());
        Project after = project;
        change.applyTo(after);
        const HairGroup& wider = after.groups.front();
        QCOMPARE(wider.settings.greatestLengthM, 0.6F);
        double worst = 0.0;
        for (int y = 0; y < 256; y += 3)
            for (int x = 0; x < 256; x += 3)
                worst = std::max(
                    worst, std::abs(amountAt(wider, MapKind::Length, x, y) - amountAt(group, MapKind::Length, x, y)));
        // A few of the 65,535 steps of 60 cm.
        QVERIFY2(worst < 0.6 * 4.0 / 65535.0, qPrintable(QString::number(worst)));
    }

    void the_hair_stays_as_it_is()
    {
        std::mt19937 random(5);
        Project project = filledPatch(MapKind::Density, 30000);
        HairGroup& group = project.groups.front();
        group.settings.greatestDensityPerM2 = 1e5F;
        group.settings.basisHairs = 256;
        group.map(MapKind::Length).layers.front().raster = motley(random, 1.0);
        group.map(MapKind::Curl).layers.front().raster = sim::TiledRaster(256, 2, {40000, 65535});
        sim::GroupSettings settings = group.settings;
        settings.greatestDensityPerM2 *= 2.0F;
        settings.greatestLengthM *= 1.7F;
        settings.greatestCurlRadiusM *= 3.0F;
        Project wider = project;
        withRange(group, settings).applyTo(wider);
        const auto before = sim::GroomBuilder().update(Document(project).groomInput()).grooms.front();
        const auto after = sim::GroomBuilder().update(Document(wider).groomInput()).grooms.front();
        int hairs = 0;
        int other = 0;
        for (std::uint32_t rank = 0; rank < before->roots->count(); ++rank) {
            const std::uint32_t from = before->roots->slotOfRank[rank];
            const std::uint32_t to = after->roots->slotOfRank[rank];
            const sim::StrandStyle* was = styleAt(*before, from);
            const sim::StrandStyle* is = styleAt(*after, to);
            hairs += was != nullptr ? 1 : 0;
            const bool same =
                (was == nullptr) == (is == nullptr) &&
                (was == nullptr || (std::abs(was->lengthM - is->lengthM) < 2e-5F &&
                                    std::abs(was->curlRadiusM - is->curlRadiusM) < 2e-6F &&
                                    glm::distance(restNode(*before, from, 7), restNode(*after, to, 7)) < 2e-4F));
            other += same ? 0 : 1;
        }
        QVERIFY(hairs > 1000);
        QCOMPARE(other, 0);
    }

    void what_unpainted_skin_has_stays_where_hair_grows_data()
    {
        QTest::addColumn<bool>("grows");
        QTest::addColumn<bool>("painted");
        QTest::addColumn<int>("layers");
        QTest::newRow("nothing grows") << false << false << 1;
        QTest::newRow("nothing painted") << true << false << 1;
        QTest::newRow("painted") << true << true << 2;
    }
    void what_unpainted_skin_has_stays_where_hair_grows()
    {
        QFETCH(bool, grows);
        QFETCH(bool, painted);
        QFETCH(int, layers);
        Project project = grows ? filledPatch(MapKind::Density, 40000) : patchProject();
        HairGroup& group = project.groups.front();
        if (painted)
            group.map(MapKind::CurlSize).layers.front().raster.setTexel(1, 1, {10000, 65535, 0, 0});
        sim::GroupSettings settings = group.settings;
        settings.greatestCurlRadiusM *= 3.0F;
        const Id next = project.nextId;
        Project after = project;
        withRange(group, settings).applyTo(after);
        const MapStack& stack = std::as_const(after.groups.front()).map(MapKind::CurlSize);
        QCOMPARE(stack.layers.size(), static_cast<std::size_t>(layers));
        QCOMPARE(stack.layers.front().id, layers > 1 ? next : group.map(MapKind::CurlSize).layers.front().id);
        QCOMPARE(after.nextId, layers > 1 ? next + 1 : next);
        const double before = amountAt(group, MapKind::CurlSize, 100, 100);
        QVERIFY(std::abs(amountAt(after.groups.front(), MapKind::CurlSize, 100, 100) -
                         (grows ? before : 3.0 * before)) < before * 1e-3);
    }

    void other_maps_and_unpainted_tiles_are_shared()
    {
        std::mt19937 random(3);
        Project project = patchProject();
        HairGroup& group = project.groups.front();
        group.map(MapKind::Length).layers.front().raster = motley(random, 1.0);
        sim::GroupSettings settings = group.settings;
        settings.greatestLengthM = 0.5F;
        const RangeChange change = withRange(group, settings);
        for (const MapSpec& spec : mapSpecs()) {
            const auto index = static_cast<std::size_t>(spec.kind);
            QCOMPARE(change.maps[index].sharesWith(group.maps[index]), spec.kind != MapKind::Length);
        }
        const auto index = static_cast<std::size_t>(MapKind::Length);
        QCOMPARE(change.maps[index]->layers[0].raster.tile(0), group.maps[index]->layers[0].raster.tile(0));
        QVERIFY(change.maps[index]->layers[0].raster.tile(1) != group.maps[index]->layers[0].raster.tile(1));
    }

    void each_range_keeps_its_own_map_data()
    {
        QTest::addColumn<QString>("key");
        QTest::addColumn<int>("map");
        QTest::addColumn<double>("to");
        QTest::newRow("greatest length") << QStringLiteral("greatest_length_m") << int(MapKind::Length) << 0.77;
        QTest::newRow("shortest length") << QStringLiteral("shortest_length_m") << int(MapKind::Length) << 0.05;
        QTest::newRow("density") << QStringLiteral("greatest_density_per_m2") << int(MapKind::Density) << 3.1e6;
        QTest::newRow("frizz") << QStringLiteral("greatest_frizz_m") << int(MapKind::Frizz) << 0.01;
        QTest::newRow("curl size") << QStringLiteral("greatest_curl_radius_m") << int(MapKind::CurlSize) << 0.05;
    }
    void each_range_keeps_its_own_map()
    {
        QFETCH(QString, key);
        QFETCH(int, map);
        QFETCH(double, to);
        const auto kind = static_cast<MapKind>(map);
        const Project project = filledPatch(kind, 32768);
        const HairGroup& group = project.groups.front();
        sim::GroupSettings settings = group.settings;
        groupSetting(QLatin1StringView(key.toLatin1())).write(settings, to);
        Project after = project;
        withRange(group, settings).applyTo(after);
        const double before = amountAt(group, kind, 5, 5);
        QVERIFY(std::abs(amountAt(after.groups.front(), kind, 5, 5) - before) < before * 1e-3);
        QVERIFY(after.groups.front().map(kind).layers[0].raster.texel(5, 5)[0] != 32768);
    }

    void a_narrower_range_clamps_and_says_so()
    {
        const Project project = filledPatch(MapKind::Length, 32768); // 15 cm.
        const HairGroup& group = project.groups.front();
        sim::GroupSettings settings = group.settings;
        settings.greatestLengthM = 0.16F;
        QVERIFY(withRange(group, settings).clamped.empty());
        settings.greatestLengthM = 0.10F;
        const RangeChange change = withRange(group, settings);
        QCOMPARE(change.clamped.size(), std::size_t{1});
        QVERIFY(change.clamped[0].map == MapKind::Length && change.clamped[0].beyond && !change.clamped[0].below);
        Project after = project;
        change.applyTo(after);
        QVERIFY(std::abs(amountAt(after.groups.front(), MapKind::Length, 5, 5) - 0.10) < 1e-6);
        settings.greatestLengthM = 0.30F;
        settings.shortestLengthM = 0.20F;
        const RangeChange raised = withRange(group, settings);
        QVERIFY(raised.clamped.size() == 1 && raised.clamped[0].below && !raised.clamped[0].beyond);
    }

    void a_range_of_one_amount_keeps_the_texels()
    {
        const Project project = filledPatch(MapKind::CurlSize, 32768);
        const HairGroup& group = project.groups.front();
        sim::GroupSettings settings = group.settings;
        settings.greatestCurlRadiusM = 0.0F;
        const RangeChange none = withRange(group, settings);
        const auto index = static_cast<std::size_t>(MapKind::CurlSize);
        QVERIFY(none.maps[index].sharesWith(group.maps[index]));
        Project after = project;
        none.applyTo(after);
        const RangeChange back = withRange(after.groups.front(), group.settings);
        QVERIFY(back.maps[index].sharesWith(group.maps[index]));
    }

    void what_was_copied_before_is_pasted_as_the_same_amount()
    {
        Document document(filledPatch(MapKind::Length, 32768)); // 15 cm.
        const LayerAddress at = firstLayer(document, MapKind::Length);
        Selection selection;
        selection.setRectangle(QRectF(0.25, 0.25, 0.5, 0.5));
        const Clip clip = copyClip(document, at, selection);
        document.push(clearCommand(document, at, selection, QStringLiteral("Clear")));
        sim::GroupSettings settings = document.committed().groups.front().settings;
        settings.greatestLengthM = 0.6F;
        document.push(setRangeCommand(document, withRange(document.committed().groups.front(), settings),
                                      QStringLiteral("Greatest length")));
        document.push(pasteCommand(document, at, clip, selection));
        const HairGroup& group = document.committed().groups.front();
        QCOMPARE(int(group.map(MapKind::Length).layers.front().raster.texel(128, 128)[1]), 65535);
        QVERIFY(std::abs(amountAt(group, MapKind::Length, 128, 128) - 0.15) < 1e-4);
    }

    void it_is_one_step_and_undone_to_the_byte()
    {
        std::mt19937 random(11);
        Project project = patchProject();
        HairGroup& group = project.groups.front();
        group.map(MapKind::Length).layers.front().raster = motley(random, 1.0);
        Document document(project);
        sim::GroupSettings settings = group.settings;
        settings.greatestLengthM = 0.2F;
        document.push(setRangeCommand(document, withRange(document.committed().groups.front(), settings),
                                      QStringLiteral("Greatest length")));
        QCOMPARE(document.undoStack().count(), 1);
        const Project after = document.committed();
        QVERIFY(!sameProjects(after, project));
        document.undo();
        QVERIFY(sameProjects(document.committed(), project));
        document.redo();
        QVERIFY(sameProjects(document.committed(), after));
        QVERIFY(setRangeCommand(document, withRange(document.committed().groups.front(), settings), {}) == nullptr);
    }
};

HAIRPAINT_TEST(TestRangeChange, None)
#include "test_range_change.moc"
