// Presets on disk, and the library of them.
#include "model/files/preset_file.h"
#include "model/files/project_file.h"
#include "model/files/project_json.h"
#include "tests/model/archive_maker.h"
#include "tests/model/sample_project.h"
#include "tests/support/test_program.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

using namespace hairpaint;
using namespace hairpaint::model;

class TestPresetFile : public QObject
{
    Q_OBJECT
private:
    static Preset samplePreset(const QString& name)
    {
        Preset preset = presetFrom(test::makeSampleProject(), name);
        preset.tags = {QStringLiteral("long"), QStringLiteral("Zöpfe")};
        addStep(preset.steps, QStringLiteral("brush"), QStringLiteral("length"));
        addStep(preset.steps, QStringLiteral("brush"), QStringLiteral("length"));
        addStep(preset.steps, {}, QStringLiteral("bow"));
        preset.picture = QImage(120, 100, QImage::Format_ARGB32);
        preset.picture.fill(Qt::green);
        return preset;
    }

private Q_SLOTS:
    void everythingInAPresetComesBack()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("two plaits.hairpreset"));
        const Preset preset = samplePreset(QStringLiteral("Two plaits"));
        QVERIFY(savePreset(preset, path));
        const Result<Preset> back = loadPreset(path);
        QVERIFY2(back, back ? "" : qPrintable(back.error().message));
        QCOMPARE(back->name, preset.name);
        QCOMPARE(back->tags, preset.tags);
        QCOMPARE(back->steps.size(), std::size_t{2}); // Those in a row count as one.
        QVERIFY(back->steps == preset.steps);
        QCOMPARE(back->folder, path);
        QCOMPARE(back->picture.size(), preset.picture.size());
        Project one = newProject();
        Project other = newProject();
        one.groups = preset.groups;
        other.groups = back->groups;
        QCOMPARE(test::difference(one, other), QString());
    }

    void stepsThatAreNoneAreRefused()
    {
        const QByteArray good = *presetToJson(samplePreset(QStringLiteral("x")));
        for (const auto& steps : {QJsonValue(5), QJsonValue(QJsonArray{1}),
                                  QJsonValue(QJsonArray{QJsonObject{{QStringLiteral("tool"), 1}}})}) {
            QJsonObject json = QJsonDocument::fromJson(good).object();
            json.insert(QLatin1String("steps"), steps);
            QVERIFY(!presetFromJson(QJsonDocument(json).toJson()));
            json.remove(QLatin1String("steps"));
            QVERIFY(presetFromJson(QJsonDocument(json).toJson())->preset.steps.empty());
        }
    }

    void savingTwiceWritesTheSameBytes()
    {
        QTemporaryDir folder;
        const QString a = folder.filePath(QStringLiteral("a.hairpreset"));
        const QString b = folder.filePath(QStringLiteral("b.hairpreset"));
        QVERIFY(savePreset(samplePreset(QStringLiteral("x")), a));
        QVERIFY(savePreset(*loadPreset(a), b));
        QVERIFY(test::readBytes(a) == test::readBytes(b));
    }

    void whatIsNoPresetIsRefused()
    {
        QTemporaryDir folder;
        const QString project = folder.filePath(QStringLiteral("a.hairpaint"));
        QVERIFY(saveProject(newProject(), project, {}));
        const QString text = folder.filePath(QStringLiteral("b.hairpreset"));
        test::writeBytes(text, "hello");
        for (const QString& path : {project, text, folder.filePath(QStringLiteral("none.hairpreset"))}) {
            const Result<Preset> preset = loadPreset(path);
            QVERIFY(!preset);
            QVERIFY2(test::isOneSentenceNaming(preset.error().message, path), qPrintable(preset.error().message));
        }
    }

    void theLibraryListsOwnStylesByNameAndNamesBrokenFiles()
    {
        QTemporaryDir folder;
        QVERIFY(savePreset(samplePreset(QStringLiteral("zebra")), folder.filePath(QStringLiteral("1.hairpreset"))));
        QVERIFY(savePreset(samplePreset(QStringLiteral("Ape")), folder.filePath(QStringLiteral("2.hairpreset"))));
        test::writeBytes(folder.filePath(QStringLiteral("3.hairpreset")), "broken");
        test::writeBytes(folder.filePath(QStringLiteral("readme.txt")), "not a style");
        QStringList problems;
        std::vector<PresetEntry> own = listPresets(folder.path(), &problems);
        std::erase_if(own, [](const PresetEntry& entry) { return entry.folder == QStringLiteral("built-in"); });
        QCOMPARE(own.size(), std::size_t{2});
        QCOMPARE(own[0].name, QStringLiteral("Ape"));
        QCOMPARE(own[1].name, QStringLiteral("zebra"));
        QCOMPARE(own[1].folder, QStringLiteral("own"));
        QVERIFY(!own[1].picture.isNull());
        QCOMPARE(problems.size(), 1);
        QVERIFY(problems.front().contains(QStringLiteral("3.hairpreset")));
    }
};

HAIRPAINT_TEST(TestPresetFile, Core)
#include "test_preset_file.moc"
