// The built-in styles are what their recordings make: played again, they are the committed files.
#include "model/files/preset_file.h"
#include "resources/presets/baker/styles.h"
#include "tests/support/test_program.h"

#include <QtTest>

using namespace hairpaint;

class TestBuiltInStyles : public QObject
{
    Q_OBJECT
private:
    presets::GrownHair m_grown;

private Q_SLOTS:
    void theStripShowsEveryStyleInOrder()
    {
        QStringList wanted;
        for (const presets::Style& style : presets::builtInStyles())
            wanted << QString::fromLatin1(style.name);
        QStringList got;
        for (const model::PresetEntry& entry : model::listPresets({})) {
            got << entry.name;
            QVERIFY(!entry.picture.isNull());
        }
        QCOMPARE(got, wanted);
    }

    void playedAgainItIsTheCommittedFile_data()
    {
        QTest::addColumn<int>("index");
        int index = 0;
        for (const presets::Style& style : presets::builtInStyles())
            QTest::newRow(style.id) << index++;
    }
    void playedAgainItIsTheCommittedFile()
    {
        QFETCH(int, index);
        const presets::Style style = presets::builtInStyles().at(static_cast<std::size_t>(index));
        presets::Recording user(m_grown.of(style), style.settings);
        style.record(user);
        // Each action has done something.
        QCOMPARE(user.document().undoStack().count(), user.actions());
        const model::Preset played = user.preset(QString::fromLatin1(style.name));
        const model::Result<model::Preset> committed =
            model::loadPreset(QStringLiteral(":/presets/%1.hairpreset").arg(QLatin1StringView(style.id)));
        QVERIFY(committed.has_value());
        QCOMPARE(committed->name, played.name);
        QCOMPARE(committed->tags, style.tags);
        QVERIFY(!played.steps.empty() && committed->steps == played.steps);
        QCOMPARE(committed->groups.size(), std::size_t{1});
        QVERIFY(committed->worn == played.worn);
        QVERIFY(committed->groups.front().settings == played.groups.front().settings);
        for (const model::MapSpec& spec : model::mapSpecs()) {
            const auto& wanted = played.groups.front().map(spec.kind).layers;
            const auto& got = committed->groups.front().map(spec.kind).layers;
            QCOMPARE(got.size(), wanted.size());
            for (std::size_t i = 0; i < got.size(); ++i)
                QVERIFY2(got[i].raster == wanted[i].raster, spec.id);
        }
    }
};

HAIRPAINT_TEST(TestBuiltInStyles, Core)
#include "test_built_in_styles.moc"
