// The tip colour map shows the colour map where nothing is painted on it.
#include "model/files/group_json.h"
#include "model/files/project_json.h"
#include "model/styles/preset.h"
#include "tests/model/tool_studio.h"
#include "tests/support/test_program.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

using namespace hairpaint;
using namespace hairpaint::model;
using namespace hairpaint::test;

class TestTipColour : public QObject
{
    Q_OBJECT
private:
    static sim::MapRaster shown(const Document& document, MapKind map)
    {
        return document.resolved(document.project().groups.front().id, map);
    }
    static void paint(Studio& studio, MapKind map, float u, float v, QColor colour)
    {
        studio.map = map;
        studio.settings.value(map).colour = colour;
        studio.press(kBrush, u, v);
        studio.release(kBrush, u, v);
    }

private Q_SLOTS:
    void unpaintedItIsTheColourMapItself()
    {
        Studio studio;
        QVERIFY(shown(studio.document, MapKind::TipColour) == shown(studio.document, MapKind::Colour));
        paint(studio, MapKind::Colour, 0.5F, 0.5F, Qt::red);
        QCOMPARE(shown(studio.document, MapKind::Colour)->sampleNearest({0.5F, 0.5F}), (sim::Texel{65535, 0, 0}));
        QVERIFY(shown(studio.document, MapKind::TipColour) == shown(studio.document, MapKind::Colour));
        studio.document.undo();
        QVERIFY(shown(studio.document, MapKind::TipColour) == shown(studio.document, MapKind::Colour));
    }

    void paintedItIsItsOwnThereAndFollowsElsewhere()
    {
        Studio studio;
        paint(studio, MapKind::TipColour, 0.25F, 0.25F, Qt::yellow);
        paint(studio, MapKind::Colour, 0.25F, 0.25F, Qt::red);
        paint(studio, MapKind::Colour, 0.75F, 0.75F, Qt::blue);
        const sim::MapRaster tip = shown(studio.document, MapKind::TipColour);
        QCOMPARE(tip->sampleNearest({0.25F, 0.25F}), (sim::Texel{65535, 65535, 0}));
        QCOMPARE(tip->sampleNearest({0.75F, 0.75F}), (sim::Texel{0, 0, 65535}));

        studio.map = MapKind::TipColour;
        studio.press(QStringLiteral("eraser"), 0.25F, 0.25F);
        studio.release(QStringLiteral("eraser"), 0.25F, 0.25F);
        QCOMPARE(shown(studio.document, MapKind::TipColour)->sampleNearest({0.25F, 0.25F}), (sim::Texel{65535, 0, 0}));
    }

    void aRunningStrokeOnColourShowsAtTheTipsAsItsCommitDoes()
    {
        Studio studio;
        paint(studio, MapKind::TipColour, 0.3F, 0.3F, Qt::yellow);
        studio.map = MapKind::Colour;
        studio.press(kBrush, 0.5F, 0.5F);
        studio.move(kBrush, 0.6F, 0.55F);
        const sim::TiledRaster before = *shown(studio.document, MapKind::TipColour);
        studio.release(kBrush, 0.6F, 0.55F);
        QCOMPARE(*shown(studio.document, MapKind::TipColour), before);
        QVERIFY(shown(Studio(studio.document.project()).document, MapKind::TipColour)->texel(0, 0) ==
                before.texel(0, 0));
        QCOMPARE(*shown(Studio(studio.document.project()).document, MapKind::TipColour), before);
    }

    void aFileWithoutItHasTipsAsItsColours()
    {
        Project project = patchProject(512);
        QJsonObject root = QJsonDocument::fromJson(projectToJson(project).value_or(QByteArray())).object();
        QJsonArray groups = root.value(QLatin1String("groups")).toArray();
        QJsonObject group = groups.first().toObject();
        QJsonObject maps = group.value(QLatin1String("maps")).toObject();
        maps.remove(QStringLiteral("tip_colour"));
        maps.remove(QStringLiteral("curl_size"));
        group.insert(QStringLiteral("maps"), maps);
        groups.replace(0, group);
        const auto read = groupsFromJson(groups, project.nextId);
        QVERIFY(read.has_value());
        QCOMPARE(read->front().map(MapKind::TipColour).size, 512);
        QCOMPARE(read->front().map(MapKind::CurlSize).size, 512);
        QCOMPARE(read->front().map(MapKind::TipColour).layers.size(), std::size_t{1});
    }

    void aStyleKeepsTipsThatFollow()
    {
        Studio studio;
        paint(studio, MapKind::Colour, 0.5F, 0.5F, Qt::red);
        const Preset plain = presetFrom(studio.document.project(), QStringLiteral("Plain"));
        const Layer& tip = plain.groups.front().map(MapKind::TipColour).layers.front();
        QCOMPARE(tip.raster.texel(128, 128)[3], std::uint16_t{0});

        paint(studio, MapKind::TipColour, 0.25F, 0.25F, Qt::yellow);
        const Preset dyed = presetFrom(studio.document.project(), QStringLiteral("Dyed"));
        const Layer& painted = dyed.groups.front().map(MapKind::TipColour).layers.front();
        QCOMPARE(painted.raster.texel(64, 192), (sim::Texel{65535, 65535, 0, 65535}));
        QCOMPARE(painted.raster.texel(128, 128), (sim::Texel{65535, 0, 0, 65535}));
    }
};

HAIRPAINT_TEST(TestTipColour, Gui)
#include "test_tip_colour.moc"
