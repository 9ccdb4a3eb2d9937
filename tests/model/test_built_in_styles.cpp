// The built-in styles are what their descriptions say: baked again, they are the committed files.
#include "model/files/head_file.h"
#include "model/files/preset_file.h"
#include "resources/presets/baker/bake.h"
#include "tests/support/test_program.h"

#include <QtTest>

using namespace hairpaint;

class TestBuiltInStyles : public QObject
{
    Q_OBJECT
private:
    presets::SkinPoints m_points;

private Q_SLOTS:
    void initTestCase() { m_points = presets::pointsOn(*model::builtInHead()->skin); }

    void theStripShowsEveryStyleInOrder()
    {
        QStringList wanted;
        for (const presets::Style& style : presets::builtInStyles())
            wanted << style.name;
        QStringList got;
        for (const model::PresetEntry& entry : model::listPresets({})) {
            got << entry.name;
            QVERIFY(!entry.picture.isNull());
        }
        QCOMPARE(got, wanted);
    }

    void bakedAgainItIsTheCommittedFile_data()
    {
        QTest::addColumn<int>("index");
        int index = 0;
        for (const presets::Style& style : presets::builtInStyles())
            QTest::newRow(style.id) << index++;
    }
    void bakedAgainItIsTheCommittedFile()
    {
        QFETCH(int, index);
        const presets::Style style = presets::builtInStyles().at(static_cast<std::size_t>(index));
        const model::Preset baked = presets::bake(style, m_points);
        const model::Result<model::Preset> committed =
            model::loadPreset(QStringLiteral(":/presets/%1.hairpreset").arg(QLatin1StringView(style.id)));
        QVERIFY(committed.has_value());
        QCOMPARE(committed->name, baked.name);
        QCOMPARE(committed->tags, baked.tags);
        QCOMPARE(committed->groups.size(), std::size_t{1});
        QVERIFY(committed->groups.front().settings == baked.groups.front().settings);
        for (const model::MapSpec& spec : model::mapSpecs()) {
            const auto& wanted = baked.groups.front().map(spec.kind).layers;
            const auto& got = committed->groups.front().map(spec.kind).layers;
            QCOMPARE(got.size(), wanted.size());
            for (std::size_t i = 0; i < got.size(); ++i)
                QVERIFY2(got[i].raster == wanted[i].raster, spec.id);
        }
    }
};

HAIRPAINT_TEST(TestBuiltInStyles, Core)
#include "test_built_in_styles.moc"
