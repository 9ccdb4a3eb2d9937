// The history to the byte: strokes of every tool between commands of every kind, saved, undone, saved, redone, saved.
#include "model/files/head_file.h"
#include "model/files/project_file.h"
#include "model/preset.h"
#include "tests/model/archive_maker.h"
#include "tests/model/tool_studio.h"

#include <QTemporaryDir>
#include <QTest>

#include <random>

using namespace hairpaint;
using namespace hairpaint::model;
using namespace hairpaint::test;

class TestHistory : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_folder;

    /// What saving writes now.
    [[nodiscard]] QByteArray saved(const Studio& studio) const
    {
        const QString path = m_folder.filePath(QStringLiteral("history.hairpaint"));
        return saveProject(studio.document.committed(), path, {}) ? readBytes(path) : QByteArray();
    }

    static void stroke(Studio& studio, std::mt19937& random)
    {
        const auto share = [&random] { return 0.1F + 0.8F * static_cast<float>(random() % 1000) / 1000.0F; };
        const QString tool = QLatin1String(studio.tools[random() % studio.tools.size()]->id());
        studio.map = static_cast<MapKind>(random() % kMapKindCount);
        studio.mirror = random() % 2 == 0;
        studio.settings.brushSizeM = 0.01F + 0.03F * share();
        studio.settings.opacity = share();
        studio.settings.value(studio.map).scalar = share();
        studio.press(tool, share(), share());
        for (int i = 0; i < 3; ++i)
            studio.move(tool, share(), share());
        studio.release(tool, share(), share());
        ToolContext context = studio.context();
        studio.tool(tool).commit(context);
    }

    static void command(Document& document, std::mt19937& random)
    {
        const Project& project = document.committed();
        const HairGroup& group = project.groups[random() % project.groups.size()];
        switch (random() % 6) {
        case 0: {
            sim::GroupSettings settings = group.settings;
            settings.greatestLengthM = static_cast<float>(1 + random() % 50) / 100.0F;
            return document.push(setSettingsCommand(document, group.id, settings, QStringLiteral("Length")));
        }
        case 1: {
            sim::Wind wind = project.wind;
            wind.velocity.z = static_cast<float>(random() % 9);
            return document.push(setWindCommand(document, wind));
        }
        case 2: {
            LightSettings light = project.light;
            light.azimuthRad = static_cast<float>(random() % 6);
            return document.push(setLightCommand(document, light));
        }
        case 3:
            return document.push(addGroupCommand(document, QStringLiteral("Group %1").arg(random() % 100)));
        case 4:
            return document.push(moveGroupCommand(document, group.id, static_cast<int>(random() % 3)));
        default:
            return document.push(applyPresetCommand(document, presetFrom(project, QStringLiteral("Style"))));
        }
    }

private Q_SLOTS:
    void undoingAllGivesTheFirstBytesAndRedoingAllTheLast_data()
    {
        QTest::addColumn<int>("seed");
        for (int seed = 1; seed <= 4; ++seed)
            QTest::addRow("seed %d", seed) << seed;
    }
    void undoingAllGivesTheFirstBytesAndRedoingAllTheLast()
    {
        QFETCH(int, seed);
        std::mt19937 random(static_cast<unsigned>(seed));
        Project start = patchProject();
        start.head = builtInHead();
        Studio studio(start);
        const QByteArray first = saved(studio);
        for (int step = 0; step < 40; ++step)
            if (random() % 4 == 0)
                command(studio.document, random);
            else
                stroke(studio, random);
        QVERIFY2(studio.document.undoStack().count() > 15,
                 qPrintable(QString::number(studio.document.undoStack().count())));
        const QByteArray last = saved(studio);
        QVERIFY(!first.isEmpty() && !last.isEmpty() && first != last);
        for (int round = 0; round < 2; ++round) {
            while (studio.document.canUndo())
                studio.document.undo();
            QVERIFY(saved(studio) == first);
            while (studio.document.undoStack().canRedo())
                studio.document.redo();
            QVERIFY(saved(studio) == last);
        }
    }
};

QTEST_GUILESS_MAIN(TestHistory)
#include "test_history.moc"
