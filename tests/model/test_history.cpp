// The history to the byte: strokes of every tool between commands of every kind, saved, undone, saved, redone, saved.
#include "model/document/group_commands.h"
#include "model/document/layer_commands.h"
#include "model/document/scene_commands.h"
#include "model/files/head_file.h"
#include "model/files/project_file.h"
#include "model/styles/preset.h"
#include "model/tools/selecting/clipboard.h"
#include "tests/model/archive_maker.h"
#include "tests/model/tool_studio.h"
#include "tests/support/test_program.h"

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

    /// Two groups, two layers in each map.
    static Project startProject()
    {
        Project project = patchProject();
        project.head = defaultHead();
        project.groups.push_back(makeGroup(project, QStringLiteral("Fringe"), 256));
        for (HairGroup& group : project.groups)
            for (SharedStack& map : group.maps) {
                MapStack& stack = map.write();
                stack.layers.push_back(stack.layers.front());
                stack.layers.back().id = project.takeId();
            }
        return project;
    }

    static void stroke(Studio& studio, std::mt19937& random)
    {
        const auto fraction = [&random] { return 0.1F + 0.8F * static_cast<float>(random() % 1000) / 1000.0F; };
        const QString tool = QLatin1String(studio.tools[random() % studio.tools.size()]->name());
        studio.map = static_cast<MapKind>(random() % kMapKindCount);
        studio.mirror = random() % 2 == 0;
        studio.settings.brushSizeM = 0.01F + 0.03F * fraction();
        studio.settings.opacity = fraction();
        studio.settings.value(studio.map).scalar = fraction();
        studio.press(tool, fraction(), fraction());
        for (int i = 0; i < 3; ++i)
            studio.move(tool, fraction(), fraction());
        studio.release(tool, fraction(), fraction());
        ToolContext context = studio.context();
        studio.tool(tool).commit(context);
    }

    /// Pushes an edit of the project or a group by chance.
    static void changeScene(Document& document, std::mt19937& random)
    {
        const Project& project = document.committed();
        const HairGroup& group = project.groups[random() % project.groups.size()];
        switch (random() % 11) {
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
            return document.push(
                moveGroupCommand(document, group.id, static_cast<int>(random() % project.groups.size())));
        case 5:
            // The first is the one that strokes go to.
            if (project.groups.size() > 1)
                document.push(removeGroupCommand(document, project.groups.back().id));
            return;
        case 6:
            return document.push(
                renameGroupCommand(document, group.id, QStringLiteral("Named %1").arg(random() % 100)));
        case 7:
            return document.push(showGroupCommand(document, group.id, !group.visible));
        case 8:
            return document.push(setBackgroundCommand(document, qRgb(static_cast<int>(random() % 256), 20, 30)));
        case 9:
            if (project.head->builtIn)
                return document.push(setHeadCommand(document, headOf(makeBallHead(8), false), {}));
            return document.push(setHeadCommand(document, defaultHead(), builtInEllipsoids()));
        default:
            return document.push(applyPresetCommand(document, presetFrom(project, QStringLiteral("Style"))));
        }
    }

    static void changeLayers(Document& document, std::mt19937& random)
    {
        const Project& project = document.committed();
        const HairGroup& group = project.groups[random() % project.groups.size()];
        const auto map = static_cast<MapKind>(random() % kMapKindCount);
        const std::vector<Layer>& layers = group.map(map).layers;
        const Layer& layer = layers[random() % layers.size()];
        const LayerAddress at{.group = group.id, .map = map, .layer = layer.id};
        const auto change = [&](const char* text, const auto& edit) {
            LayerProperties properties = propertiesOf(layer);
            edit(properties);
            document.push(setLayerPropertiesCommand(document, at, properties, QLatin1String(text)));
        };
        switch (random() % 9) {
        case 0:
            return document.push(
                addLayerCommand(document, group.id, map, QStringLiteral("Layer %1").arg(random() % 9)));
        case 1: {
            Layer copy = layer;
            copy.name += QStringLiteral(" copy");
            const int index = static_cast<int>(random() % (layers.size() + 1));
            return document.push(insertLayerCommand(document, group.id, map, copy, index, QStringLiteral("Duplicate")));
        }
        case 2:
            if (layers.size() > 1)
                document.push(removeLayerCommand(document, at));
            return;
        case 3:
            return document.push(moveLayerCommand(document, at, static_cast<int>(random() % layers.size())));
        case 4:
            return change("Show layer", [](LayerProperties& p) { p.visible = !p.visible; });
        case 5:
            return change("Opacity",
                          [&](LayerProperties& p) { p.opacity = static_cast<float>(random() % 11) / 10.0F; });
        case 6:
            return change("Blend", [&](LayerProperties& p) {
                const std::span<const BlendMode> modes = mapSpec(map).blendModes;
                p.blend = modes[random() % modes.size()];
            });
        case 7:
            return change("Rename layer",
                          [&](LayerProperties& p) { p.name = QStringLiteral("L%1").arg(random() % 9); });
        default:
            return change("Lock", [](LayerProperties& p) { p.locked = !p.locked; });
        }
    }

    /// Copy, cut, clear and paste, inside a map and between maps, with something selected and without.
    static void useClipboard(Studio& studio, std::mt19937& random)
    {
        const auto select = [&] {
            const double left = 0.1 + 0.05 * static_cast<double>(random() % 8);
            const bool all = random() % 4 == 0;
            studio.selection.setRectangle(all ? std::nullopt : std::optional(QRectF(left, 0.7 - left, 0.3, 0.4)));
        };
        studio.map = static_cast<MapKind>(random() % kMapKindCount);
        select();
        const LayerAddress from = studio.context().target;
        const Clip clip = copyClip(studio.document, from, studio.selection);
        const auto take = static_cast<int>(random() % 3);
        if (take != 0)
            studio.document.push(clearCommand(studio.document, from, studio.selection,
                                              take == 1 ? QStringLiteral("Cut") : QStringLiteral("Clear")));
        if (random() % 2 == 0)
            studio.map = static_cast<MapKind>(random() % kMapKindCount);
        select();
        if (take != 2)
            studio.document.push(pasteCommand(studio.document, studio.context().target, clip, studio.selection));
        studio.selection.setRectangle(std::nullopt);
    }

private Q_SLOTS:
    void undoingAllGivesTheFirstBytesAndRedoingAllTheLast()
    {
        QStringList steps;
        for (int seed = 1; seed <= 5; ++seed) {
            walk(seed, steps);
            if (QTest::currentTestFailed())
                return;
        }
        // Every kind of change was among them.
        for (const char* kind : {"Brush",        "Eraser",       "Fill",
                                 "Gradient",     "Shape",        "Cut",
                                 "Clear",        "Paste",        "Add layer",
                                 "Duplicate",    "Remove layer", "Move layer",
                                 "Show layer",   "Opacity",      "Blend",
                                 "Rename layer", "Lock",         "Add group",
                                 "Remove group", "Rename group", "Move group",
                                 "Hide group",   "Show group",   "Length",
                                 "Change wind",  "Change light", "Change background",
                                 "Change head",  "Apply style"}) {
            const auto isOfKind = [kind](const QString& step) { return step.startsWith(QLatin1String(kind)); };
            QVERIFY2(std::ranges::any_of(steps, isOfKind), kind);
        }
    }

private:
    void walk(int seed, QStringList& steps)
    {
        std::mt19937 random(static_cast<unsigned>(seed));
        Studio studio(startProject());
        const QByteArray first = saved(studio);
        for (int step = 0; step < 80; ++step)
            switch (random() % 8) {
            case 0:
            case 1:
                changeScene(studio.document, random);
                break;
            case 2:
            case 3:
                changeLayers(studio.document, random);
                break;
            case 4:
                useClipboard(studio, random);
                break;
            default:
                stroke(studio, random);
            }
        QVERIFY2(studio.document.undoStack().count() > 30, qPrintable(QStringLiteral("seed %1").arg(seed)));
        for (int i = 0; i < studio.document.undoStack().count(); ++i)
            steps += studio.document.undoStack().text(i);
        const QByteArray last = saved(studio);
        QVERIFY(!first.isEmpty() && !last.isEmpty() && first != last);
        for (int round = 0; round < 2; ++round) {
            while (studio.document.canUndo())
                studio.document.undo();
            QVERIFY2(saved(studio) == first, qPrintable(QStringLiteral("seed %1").arg(seed)));
            while (studio.document.undoStack().canRedo())
                studio.document.redo();
            QVERIFY2(saved(studio) == last, qPrintable(QStringLiteral("seed %1").arg(seed)));
        }
    }
};

HAIRPAINT_TEST(TestHistory, Core)
#include "test_history.moc"
