// Tools of the real window that work with the hair that is drawn: holding it as it lies, grabbing it, and the hairs
// that tell its directions.
#include "model/document/layer_commands.h"
#include "model/tools/lying/lying_hair.h"
#include "sim/groom/direction_texel.h"
#include "tests/app/window_fixture.h"
#include "tests/support/test_program.h"
#include "view/dialogs/cut_dialog.h"
#include "view/head_area/head_overlay.h"
#include "view/widgets/bar_slider.h"

#include <QMenu>
#include <QPointer>
#include <QPushButton>

#include <algorithm>

namespace hairpaint::app {

class TestWindowHair : public QObject, private WindowFixture
{
    Q_OBJECT
private:
    [[nodiscard]] std::shared_ptr<const sim::TiledRaster> map(model::MapKind kind)
    {
        return session().document().resolved(editor().target().group(), kind);
    }
    [[nodiscard]] glm::vec2 directionAt(glm::vec2 uv)
    {
        return sim::directionOf(map(model::MapKind::Direction)->sampleNearest(uv));
    }
    [[nodiscard]] QAction& action(const char* id) { return *m_window->actions().find(QLatin1StringView(id)); }
    [[nodiscard]] view::CutDialog* cutDialog() { return m_window->findChild<view::CutDialog*>(); }
    void openCut(const char* command)
    {
        action(command).trigger();
        QTRY_VERIFY_WITH_TIMEOUT(cutDialog() != nullptr, kPatienceMs);
    }
    void pressInCut(const QString& text)
    {
        for (QPushButton* button : cutDialog()->findChildren<QPushButton*>())
            if (button->text() == text)
                return QTest::mouseClick(button, Qt::LeftButton);
        QFAIL(qPrintable(text));
    }
    /// Cut or Cancel.
    void endCut(const QString& button)
    {
        pressInCut(button);
        QTRY_VERIFY_WITH_TIMEOUT(cutDialog() == nullptr, kPatienceMs);
    }

private Q_SLOTS:
    void initTestCase() { prepareApplication(); }
    void cleanup() { m_window.reset(); }

    /// Moving hair is positioned as far as it is drawn; what is exported or saved has every hair.
    void whatIsMadeOfMovingHairHasAllOfIt()
    {
        model::Project project = starterProject();
        project.wind = {.enabled = true, .velocity = {3.0F, 0.0F, 0.0F}, .gustiness = 0.5F, .turbulence = 0.3F};
        openWindow(std::move(project));
        awaitNewestHair();
        const auto detail = [this] { return sim::frameDetail(*session().frame()); };
        QTRY_VERIFY_WITH_TIMEOUT(detail() < 1.0F, kPatienceMs);
        {
            const std::shared_ptr<const void> whole = session().wholeHair();
            QVERIFY(session().hair() == Session::Hair::Underway);
            QTRY_VERIFY_WITH_TIMEOUT(session().hair() == Session::Hair::Current, kPatienceMs);
            QCOMPARE(detail(), 1.0F);
        }
        QTRY_VERIFY_WITH_TIMEOUT(detail() < 1.0F, kPatienceMs);
    }

    /// From a bald head: the menu, and what grows.
    void aBeardIsTwoChoicesAway()
    {
        openWindow(model::newProject());
        awaitNewestHair();
        action("hair.addGroup").trigger();
        const QPointer<QMenu> menu = m_window->findChild<QMenu*>(QStringLiteral("whatGrows"));
        QVERIFY(menu != nullptr);
        const auto actions = menu->actions();
        const auto beard = std::ranges::find(actions, QStringLiteral("Beard"), &QAction::text);
        QVERIFY(beard != actions.end());
        (*beard)->trigger();
        if (menu) // It may end while the hair is grown.
            menu->close();
        QCOMPARE(session().document().project().groups.size(), std::size_t{2});
        QTRY_VERIFY_WITH_TIMEOUT(hairs() > 500, kPatienceMs);
        QCOMPARE(stack().count(), 1);
        const auto density = map(model::MapKind::Density);
        const auto at = [&](glm::vec3 positionHd) {
            return density->sampleScalar(session().document().project().head->skin->nearest(positionHd).uv);
        };
        QVERIFY(at({0.005F, -0.095F, 0.1F}) > 0.9F && at({0.045F, -0.07F, 0.07F}) > 0.7F); // Chin and cheek.
        QVERIFY(at({0.01F, 0.06F, 0.1F}) == 0.0F && at({0.03F, 0.10F, 0.0F}) == 0.0F);
        session().document().undo();
        QCOMPARE(session().document().project().groups.size(), std::size_t{1});
    }

    void hairThatTheWindBlewIsHeldAsItLies()
    {
        openWithStyle("bob");
        // What is held is compared with every hair.
        const std::shared_ptr<const void> whole = session().wholeHair();
        QTRY_VERIFY_WITH_TIMEOUT(session().hair() == Session::Hair::Current, kPatienceMs);
        const std::shared_ptr<const sim::StrandFrame> still = session().frame();
        session().changeWind({.enabled = true, .velocity = {12.0F, 0.0F, -4.0F}}, true);
        const auto blown = [&] {
            const auto before = model::lyingHairs(still->groups.front(), still->pose);
            const auto now = model::lyingHairs(session().frame()->groups.front(), session().frame()->pose);
            double turned = 0.0;
            for (std::size_t i = 0; i < std::min(before.size(), now.size()); ++i)
                turned += static_cast<double>(glm::distance(before[i].direction, now[i].direction));
            return turned / static_cast<double>(before.size());
        };
        QTRY_VERIFY_WITH_TIMEOUT(blown() > 0.05, kPatienceMs);
        // So that what is held is what is compared with: no frame is still to come.
        session().setPaused(true);
        QTRY_VERIFY_WITH_TIMEOUT(session().resting(), kPatienceMs);
        const model::LyingField field(model::lyingHairs(session().frame()->groups.front(), session().frame()->pose));
        const auto directions = map(model::MapKind::Direction);
        const auto gel = map(model::MapKind::Gel);
        const int steps = stack().count();
        key(Qt::Key_H, Qt::ShiftModifier);
        QTRY_COMPARE_WITH_TIMEOUT(stack().count(), steps + 1, kPatienceMs);
        QCOMPARE(stack().undoText(), QStringLiteral("Hold as it lies"));
        QCOMPARE(editor().target().map(), model::MapKind::Direction);

        for (const glm::vec2 uv : {glm::vec2(0.45F, 0.5F), glm::vec2(0.55F, 0.55F), glm::vec2(0.5F, 0.6F)}) {
            const std::optional<glm::vec2> lies = field.at(uv);
            QVERIFY(lies && glm::distance(directionAt(uv), *lies) < 0.1F);
            QVERIFY(map(model::MapKind::Gel)->sampleScalar(uv) > 0.49F);
        }
        key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(*map(model::MapKind::Direction) == *directions);
        QVERIFY(*map(model::MapKind::Gel) == *gel);
    }

    void withoutHairNothingIsHeldAndALockedLayerSaysSo()
    {
        openWindow(model::newProject());
        awaitNewestHair();
        QStringList told;
        connect(&editor(), &view::EditorState::told, this, [&told](const QString& text) { told << text; });
        connect(&editor(), &view::EditorState::refused, this, [&told](const QString& text) { told << text; });
        action("hair.hold").trigger();
        QTRY_COMPARE_WITH_TIMEOUT(told.size(), 1, kPatienceMs);
        QCOMPARE(told.front(), QStringLiteral("There is no hair to hold in this group."));
        model::Document& document = session().document();
        const model::LayerAddress gel{.group = editor().target().group(),
                                      .map = model::MapKind::Gel,
                                      .layer = editor().target().layer(model::MapKind::Gel)};
        model::LayerProperties locked = model::propertiesOf(*document.project().layer(gel.group, gel.map, gel.layer));
        locked.locked = true;
        document.push(model::setLayerPropertiesCommand(document, gel, locked, QStringLiteral("lock")));
        action("hair.hold").trigger();
        QVERIFY(told.size() == 2 && told.back().contains(QStringLiteral("locked")));
        QCOMPARE(stack().count(), 1);
    }

    void hairIsCutToALevelInOneStep()
    {
        openWithStyle("bob");
        const auto length = map(model::MapKind::Length);
        openCut("hair.cutToLevel");
        QVERIFY(*map(model::MapKind::Length) == *length); // As it opens nothing hangs lower.
        pressInCut(QStringLiteral("Ears"));
        const auto preview = map(model::MapKind::Length);
        QVERIFY(!(*preview == *length));
        endCut(QStringLiteral("Cancel"));
        QVERIFY(*map(model::MapKind::Length) == *length);
        QCOMPARE(stack().count(), 0);

        openCut("hair.cutToLevel");
        pressInCut(QStringLiteral("Ears"));
        const auto shown = map(model::MapKind::Length);
        endCut(QStringLiteral("Cut"));
        QCOMPARE(stack().count(), 1);
        QCOMPARE(stack().undoText(), QStringLiteral("Cut hair to a level"));
        QVERIFY(*map(model::MapKind::Length) == *shown);
        session().document().undo();
        QVERIFY(*map(model::MapKind::Length) == *length);
    }

    void hairIsTrimmedLayeredAndFadedInOneStep_data()
    {
        QTest::addColumn<QByteArray>("style");
        QTest::addColumn<QByteArray>("command");
        QTest::addColumn<QString>("step");
        QTest::newRow("trim") << QByteArray("bob") << QByteArray("hair.trim") << QStringLiteral("Trim hair");
        QTest::newRow("layers") << QByteArray("long-straight") << QByteArray("hair.layers")
                                << QStringLiteral("Cut layers");
        QTest::newRow("fade") << QByteArray("side-part") << QByteArray("hair.fade") << QStringLiteral("Cut a fade");
    }
    void hairIsTrimmedLayeredAndFadedInOneStep()
    {
        QFETCH(QByteArray, style);
        QFETCH(QByteArray, command);
        QFETCH(QString, step);
        openWithStyle(style.constData());
        const auto length = map(model::MapKind::Length);
        const auto mean = [this] {
            double sum = 0.0;
            const auto now = map(model::MapKind::Length);
            for (int y = 0; y < now->size(); y += 8)
                for (int x = 0; x < now->size(); x += 8)
                    sum += now->texel(x, y)[0];
            return sum;
        };
        const double before = mean();
        for (const bool keeps : {false, true}) {
            openCut(command.constData());
            // As it opens it cuts; the first slider, by key, cuts otherwise.
            const double opened = mean();
            QVERIFY(opened < before);
            auto* slider = cutDialog()->findChild<view::BarSlider*>();
            slider->setFocus();
            QTest::keyClick(slider, Qt::Key_Left);
            const auto shown = map(model::MapKind::Length);
            QVERIFY(mean() != opened);
            endCut(keeps ? QStringLiteral("Cut") : QStringLiteral("Cancel"));
            QVERIFY(*map(model::MapKind::Length) == (keeps ? *shown : *length));
            QCOMPARE(stack().count(), keeps ? 1 : 0);
        }
        QCOMPARE(stack().undoText(), step);
        session().document().undo();
        QVERIFY(*map(model::MapKind::Length) == *length);
    }

    void theCombHoldsUnderItsDabs()
    {
        openWithStyle("bob");
        key(Qt::Key_C);
        model::ToolSettings settings = editor().tools().settings();
        settings.comb = model::CombKind::Hold;
        settings.holdGel = 0.8F;
        editor().tools().setSettings(settings);
        QCOMPARE(map(model::MapKind::Gel)->sampleScalar({0.5F, 0.5F}), 0.0F);
        drag(m_window->paintView(), paintPoint(0.47F, 0.5F), paintPoint(0.53F, 0.5F));
        QCOMPARE(stack().count(), 1);
        QCOMPARE(stack().undoText(), QStringLiteral("Hold as it lies"));
        QVERIFY(map(model::MapKind::Gel)->sampleScalar({0.5F, 0.5F}) > 0.79F);
        QCOMPARE(map(model::MapKind::Gel)->sampleScalar({0.5F, 0.6F}), 0.0F);
        QCOMPARE(editor().target().map(), model::MapKind::Direction); // Not the other one that changed.
        key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(map(model::MapKind::Gel)->sampleScalar({0.5F, 0.5F}), 0.0F);
    }

    void hairThatIsSeenIsGrabbedWithTheMouse_data()
    {
        QTest::addColumn<bool>("ctrl");
        QTest::newRow("its direction") << false;
        QTest::newRow("with Ctrl its length, too") << true;
    }
    void hairThatIsSeenIsGrabbedWithTheMouse()
    {
        QFETCH(bool, ctrl);
        openWithStyle("quiff");
        session().setPaused(true);
        key(Qt::Key_Y);
        QCOMPARE(editor().tools().active().id(), model::ToolId::Grab);
        QCOMPARE(editor().target().map(), model::MapKind::Direction);
        view::HeadView& head = m_window->headView();
        QTRY_VERIFY_WITH_TIMEOUT(head.skinAt(QRectF(head.rect()).center()).has_value(), kPatienceMs);
        const auto directions = map(model::MapKind::Direction);
        const auto lengths = map(model::MapKind::Length);
        // Above the forehead there is hair.
        const auto [area, from] = onHead(0.52F, 0.44F);
        const QPoint to = from + QPoint(90, -60);
        const auto send = [area = area](QEvent::Type type, QPoint at, bool withCtrl) {
            QMouseEvent event(type, at, area->mapToGlobal(at),
                              type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton,
                              type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton,
                              withCtrl ? Qt::ControlModifier : Qt::NoModifier);
            QApplication::sendEvent(area, &event);
        };
        send(QEvent::MouseButtonPress, from, false);
        QVERIFY(editor().tools().stroking());
        for (int i = 1; i <= 10; ++i)
            send(QEvent::MouseMove, from + (to - from) * i / 10, ctrl);
        QVERIFY(!(*map(model::MapKind::Direction) == *directions));
        send(QEvent::MouseButtonRelease, to, ctrl);
        QCOMPARE(stack().count(), 1);
        QCOMPARE(stack().undoText(), QStringLiteral("Grab"));
        QCOMPARE(*map(model::MapKind::Length) == *lengths, !ctrl);
        QCOMPARE(editor().target().map(), model::MapKind::Direction);
        key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(*map(model::MapKind::Direction) == *directions);
        QVERIFY(*map(model::MapKind::Length) == *lengths);
    }

    void aKeyShowsAndHidesTheDirectionsOnTheHead()
    {
        openWindow(model::newProject());
        const auto* overlay = m_window->headView().findChild<view::HeadOverlay*>();
        key(Qt::Key_0);
        QTRY_VERIFY_WITH_TIMEOUT(!overlay->directions().empty(), kPatienceMs);
        QVERIFY(action("view.directions").isChecked());
        key(Qt::Key_D, Qt::ShiftModifier);
        QTRY_VERIFY_WITH_TIMEOUT(overlay->directions().empty(), kPatienceMs);
        QVERIFY(!action("view.directions").isChecked());
        key(Qt::Key_D, Qt::ShiftModifier);
        QTRY_VERIFY_WITH_TIMEOUT(!overlay->directions().empty(), kPatienceMs);
        key(Qt::Key_2);
        QTRY_VERIFY_WITH_TIMEOUT(overlay->directions().empty(), kPatienceMs);
    }
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestWindowHair, Widgets)
#include "test_window_hair.moc"
