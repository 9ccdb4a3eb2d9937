// What a click on a style replaces, what it asks about, and what of it can be taken alone.
#include "model/document/group_commands.h"
#include "tests/support/test_program.h"
#include "tests/view/strip_fixture.h"

#include <QContextMenuEvent>
#include <QMenu>
#include <QSignalSpy>

using namespace hairpaint;
using namespace hairpaint::view;
using model::MapKind;

class TestStyleParts : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void a_style_replaces_what_it_is_about_and_nothing_else_data()
    {
        QTest::addColumn<int>("style");
        QTest::addColumn<QStringList>("replaced");
        QTest::addColumn<QStringList>("groups");
        const QString scalp = QStringLiteral("Scalp");
        const QString beard = QStringLiteral("Beard");
        QTest::newRow("the scalp") << 1 << QStringList{scalp} << QStringList{scalp, beard};
        QTest::newRow("a beard") << 4 << QStringList{beard} << QStringList{scalp, beard};
        QTest::newRow("the scalp and a group of its own")
            << 0 << QStringList{scalp} << QStringList{scalp, beard, QStringLiteral("Ponytail")};
        QTest::newRow("a group of its own") << 5 << QStringList{} << QStringList{scalp, beard, QStringLiteral("Crest")};
    }
    void a_style_replaces_what_it_is_about_and_nothing_else()
    {
        QFETCH(int, style);
        QFETCH(QStringList, replaced);
        QFETCH(QStringList, groups);
        StripFixture f;
        for (const char* name : {"Scalp", "Beard"})
            f.paintOn(f.group(name).id, MapKind::Density, 20000);
        const auto before = f.document.project().groups;
        const int steps = f.steps();
        f.click(style);
        QCOMPARE(f.steps(), steps + 1);
        QVERIFY(!f.question().isVisible());
        QCOMPARE(f.groupNames(), groups);
        for (std::size_t i = 0; i < before.size(); ++i) {
            QCOMPARE(f.document.project().groups[i].id, before[i].id);
            QCOMPARE(f.document.project().groups[i] == before[i], !replaced.contains(before[i].name));
        }
    }

    void a_bald_head_saved_with_a_beard_is_a_beard()
    {
        model::Project saved = smallProject();
        paint(saved.groups[1], MapKind::Density, 50000);
        const model::Preset style = model::presetFrom(saved, QStringLiteral("Viking"));
        model::Project project = smallProject();
        paint(project.groups[0], MapKind::Density, 20000);
        const model::HairGroup scalp = project.groups[0];
        applyPreset(project, style);
        QVERIFY(project.groups[0] == scalp);
        QVERIFY(model::growsHair(project.groups[1]));
    }

    void a_style_asks_before_it_replaces_the_beard_too_data()
    {
        QTest::addColumn<Qt::Key>("key");
        QTest::addColumn<bool>("scalpReplaced");
        QTest::addColumn<bool>("beardReplaced");
        QTest::newRow("Esc keeps it") << Qt::Key_Escape << true << false;
        QTest::newRow("so does Return") << Qt::Key_Return << true << false;
        QTest::newRow("the second button replaces it") << Qt::Key_Right << true << true;
        QTest::newRow("the third leaves all as it was") << Qt::Key_Left << false << false;
    }
    void a_style_asks_before_it_replaces_the_beard_too()
    {
        QFETCH(Qt::Key, key);
        QFETCH(bool, scalpReplaced);
        QFETCH(bool, beardReplaced);
        StripFixture f;
        f.paintOn(f.group("Beard").id, MapKind::Density, 20000);
        f.strip.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&f.strip));
        f.tile(3).setFocus();
        const auto before = f.document.project().groups;
        const int steps = f.steps();
        f.click(3);
        QVERIFY(f.question().isVisible());
        QVERIFY(f.question().accessibleName().contains(QStringLiteral("Beard")));
        QCOMPARE(f.steps(), steps); // Nothing is done yet, but the scalp is shown as it will be.
        QVERIFY(!(f.document.project().groups[0] == before[0]));
        QVERIFY(f.document.project().groups[1] == before[1]);
        QTest::keyClick(QApplication::focusWidget(), key);
        if (key == Qt::Key_Right || key == Qt::Key_Left)
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
        QVERIFY(!f.question().isVisible());
        QVERIFY(f.tile(3).hasFocus());
        QCOMPARE(f.steps(), steps + (scalpReplaced ? 1 : 0));
        QCOMPARE(f.document.project().groups[0] == before[0], !scalpReplaced);
        QCOMPARE(f.document.project().groups[1] == before[1], !beardReplaced);
        QVERIFY(!f.document.previewing());
        if (scalpReplaced) {
            f.document.undo();
            QVERIFY(sameGroups(f.document.project().groups, before));
        }
    }

    void what_a_style_brought_needs_no_question_until_it_is_changed()
    {
        StripFixture f;
        f.click(3); // The beard is empty.
        QCOMPARE(f.steps(), 1);
        f.click(4);
        QCOMPARE(f.steps(), 2);
        f.click(3);
        QCOMPARE(f.steps(), 3);
        QVERIFY(!f.question().isVisible());
        f.paintOn(f.group("Beard").id, MapKind::Length, 1000);
        f.click(3);
        QVERIFY(f.question().isVisible());
        // Whoever changes something else has not answered it.
        f.document.push(renameGroupCommand(f.document, f.scalp().id, QStringLiteral("Top")));
        QVERIFY(!f.question().isVisible());
        QCOMPARE(f.steps(), 5);
    }

    void a_group_of_the_users_own_of_that_name_is_asked_about()
    {
        StripFixture f;
        f.document.push(addGroupCommand(f.document, QStringLiteral("Crest")));
        f.paintOn(f.group("Crest").id, MapKind::Density, 20000);
        f.click(5);
        QVERIFY(f.question().isVisible());
    }

    void a_part_of_a_style_leaves_the_others_data()
    {
        QTest::addColumn<QString>("entry"); // Empty: Shift+click.
        QTest::addColumn<QList<int>>("changed");
        QTest::addColumn<QString>("step");
        const auto maps = [](std::initializer_list<MapKind> kinds) {
            QList<int> all;
            for (const MapKind kind : kinds)
                all.append(static_cast<int>(kind));
            return all;
        };
        QTest::newRow("Shift+click") << QString() << maps({MapKind::Colour})
                                     << QStringLiteral("Style \"waves\" (colour only)");
        QTest::newRow("colour") << QStringLiteral("Only its colour\tShift+click") << maps({MapKind::Colour})
                                << QStringLiteral("Style \"waves\" (colour only)");
        QTest::newRow("cut") << QStringLiteral("Only its cut") << maps({MapKind::Density, MapKind::Length})
                             << QStringLiteral("Style \"waves\" (cut only)");
        QTest::newRow("curl") << QStringLiteral("Only its curl") << maps({MapKind::Curl})
                              << QStringLiteral("Style \"waves\" (curl only)");
        QTest::newRow("all") << QStringLiteral("All of it")
                             << maps({MapKind::Density, MapKind::Length, MapKind::Curl, MapKind::Colour})
                             << QStringLiteral("Apply style \"waves\"");
    }
    void a_part_of_a_style_leaves_the_others()
    {
        QFETCH(QString, entry);
        QFETCH(QList<int>, changed);
        QFETCH(QString, step);
        StripFixture f;
        const auto shown = [&f](MapKind kind) { return f.document.resolved(f.scalp().id, kind); };
        std::vector<std::shared_ptr<const sim::TiledRaster>> before;
        before.reserve(model::kMapKindCount);
        for (int kind = 0; kind < model::kMapKindCount; ++kind)
            before.push_back(shown(static_cast<MapKind>(kind)));
        const sim::GroupSettings settings = f.scalp().settings;
        if (entry.isEmpty()) {
            f.click(1, Qt::ShiftModifier);
        } else {
            QContextMenuEvent wanted(QContextMenuEvent::Keyboard, QPoint(), QPoint());
            QApplication::sendEvent(&f.tile(1), &wanted);
            const QMenu* menu = f.strip.findChild<QMenu*>();
            QVERIFY(menu != nullptr);
            const auto actions = menu->actions();
            const auto action = std::ranges::find(actions, entry, &QAction::text);
            QVERIFY(action != actions.end());
            (*action)->trigger();
            QCoreApplication::processEvents();
        }
        QCOMPARE(f.steps(), 1);
        QCOMPARE(f.document.undoStack().undoText(), step);
        for (int kind = 0; kind < model::kMapKindCount; ++kind)
            if (const auto map = static_cast<MapKind>(kind); map != MapKind::TipColour) // It follows the colour.
                QVERIFY2((*shown(map) == *before[static_cast<std::size_t>(kind)]) == !changed.contains(kind),
                         model::mapSpec(map).id);
        const sim::GroupSettings after = f.scalp().settings;
        const auto has = [&](MapKind kind) { return changed.contains(static_cast<int>(kind)); };
        QCOMPARE(after.greatestLengthM != settings.greatestLengthM, has(MapKind::Length));
        QCOMPARE(after.greatestCurlRadiusM != settings.greatestCurlRadiusM, has(MapKind::Curl));
        QCOMPARE(after.material.colourVariation != settings.material.colourVariation, has(MapKind::Colour));
    }

    void a_part_for_hair_that_is_not_there_is_refused()
    {
        StripFixture f;
        QSignalSpy failed(&f.strip, &StyleStrip::failed);
        f.click(5, Qt::ShiftModifier);
        QCOMPARE(failed.count(), 1);
        QCOMPARE(f.steps(), 0);
        QVERIFY(!f.document.previewing());
    }
};

HAIRPAINT_TEST(TestStyleParts, Widgets)
#include "test_style_parts.moc"
