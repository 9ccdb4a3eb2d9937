// Hair tied in the real window, by mouse and menus.
#include "tests/app/window_fixture.h"
#include "tests/support/test_program.h"
#include "view/dialogs/repeat_rows_dialog.h"
#include "view/widgets/bar_slider.h"

#include <QDialogButtonBox>
#include <QPushButton>

#include <cmath>

namespace hairpaint::app {

class TestTiedHair : public QObject, private WindowFixture
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { prepareApplication(); }
    void cleanup() { m_window.reset(); }

    /// Density painted, then one click and one choice.
    void aPonytailByOneClick()
    {
        openWindow(model::newProject());
        editor().target().setMap(model::MapKind::Density);
        drag(m_window->paintView(), paintPoint(0.45F, 0.7F), paintPoint(0.55F, 0.7F));
        const QByteArray before = savedBytes("before.hairpaint");
        const auto [area, at] = onHead(0.5F, 0.7F);
        QTest::mouseMove(area, at);
        m_window->actions().find(QLatin1StringView("hair.addPonytail"))->trigger();
        QCOMPARE(stack().undoText(), QStringLiteral("Gather hair into a ponytail"));
        const model::Project& project = session().document().project();
        QCOMPARE(model::countOf(project.worn, model::WornKind::Ponytail), std::size_t{1});
        const model::Worn tie = project.worn.back();
        QCOMPARE(editor().options().chosenWorn(), tie.id);
        QCOMPARE(session().document().groomInput().groups.front().ties.size(), std::size_t{1});
        QVERIFY(!m_window->headView().pictureScene().solids.empty());
        QTRY_VERIFY_WITH_TIMEOUT(!session().document().resolving(), kPatienceMs);
        m_window->actions().find(QLatin1StringView("hair.removeWorn"))->trigger();
        QCOMPARE(model::countOf(session().document().project().worn, model::WornKind::Ponytail), std::size_t{0});
        QVERIFY(session().document().groomInput().groups.front().gathered == nullptr);
        session().document().undo();
        QVERIFY(session().document().project().worn.back() == tie);
        session().document().undo();
        QCOMPARE(savedBytes("after.hairpaint"), before);
    }

    /// A bow that is put on where the tail hangs lies on its ring, and the brush offers what was put on.
    void aBowSitsOnTheTie()
    {
        openWindow(model::newProject());
        editor().target().setMap(model::MapKind::Density);
        m_window->actions().find(QLatin1StringView("edit.fill"))->trigger();
        const auto [area, at] = onHead(0.5F, 0.7F);
        QTest::mouseMove(area, at);
        m_window->actions().find(QLatin1StringView("hair.addBun"))->trigger();
        const model::Worn tie = session().document().project().worn.back();
        QCOMPARE(tie.kind, model::WornKind::Bun);
        QCOMPARE(model::wornOfPalette(editor().tools().settings().value(model::MapKind::Accessory).index),
                 &model::wornSpec(model::WornKind::Bun));
        m_window->actions().find(QLatin1StringView("hair.addBow"))->trigger();
        const model::Worn& bow = *session().document().project().wornThing(editor().options().chosenWorn());
        QCOMPARE(bow.kind, model::WornKind::Bow);
        const glm::vec3 off = bow.shape.centreHd - tie.shape.centreHd;
        QVERIFY(std::abs(glm::length(off) - 0.9F * tie.shape.semiAxesM.x) < 1e-4F);
        const auto axisOf = [](const model::Worn& worn, glm::vec3 axis) {
            return glm::normalize(worn.shape.rotation) * axis;
        };
        QVERIFY(glm::dot(axisOf(bow, {0.0F, 0.0F, 1.0F}), glm::normalize(off)) > 0.999F);              // Face up,
        QVERIFY(glm::dot(axisOf(bow, {0.0F, -1.0F, 0.0F}), axisOf(tie, {0.0F, 0.0F, 1.0F})) > 0.999F); // tails along.
        QVERIFY(bow.anchor == tie.anchor);
        // Elsewhere it stands on the skin.
        const auto [other, beside] = onHead(0.35F, 0.6F);
        QTest::mouseMove(other, beside);
        m_window->actions().find(QLatin1StringView("hair.addBow"))->trigger();
        QVERIFY(session().document().project().wornThing(editor().options().chosenWorn())->anchor != tie.anchor);
    }

    /// By mouse: the tie is dragged, and taken off; the bow goes along.
    void aBowGoesWithItsTie()
    {
        openWindow(model::newProject());
        editor().target().setMap(model::MapKind::Density);
        m_window->actions().find(QLatin1StringView("edit.fill"))->trigger();
        const auto [area, at] = onHead(0.5F, 0.7F);
        QTest::mouseMove(area, at);
        m_window->actions().find(QLatin1StringView("hair.addPonytail"))->trigger();
        const model::Id tieId = session().document().project().worn.back().id;
        m_window->actions().find(QLatin1StringView("hair.addBow"))->trigger();
        const model::Id bowId = editor().options().chosenWorn();
        const auto thing = [this](model::Id id) { return session().document().project().wornThing(id); };
        QCOMPARE(thing(bowId)->tie, tieId);
        const model::Worn bow = *thing(bowId);
        const model::Worn tie = *thing(tieId);
        const float awayM = glm::distance(bow.shape.centreHd, tie.shape.centreHd);
        editor().options().setChosenWorn(tieId);
        // By its ring, between its handles.
        const glm::vec3 aside = glm::normalize(tie.shape.rotation) * glm::vec3(0.7071F, -0.7071F, 0.0F);
        view::HeadView& head = m_window->headView();
        const auto ring = head.positionOf(tie.shape.centreHd + tie.shape.semiAxesM.x * aside);
        QVERIFY(ring.has_value());
        const QPoint grip = area->mapFrom(&head, ring->toPoint());
        drag(*area, grip, grip + QPoint(30, 10));
        QVERIFY(glm::distance(thing(tieId)->shape.centreHd, tie.shape.centreHd) > 0.005F);
        QVERIFY(glm::distance(thing(bowId)->shape.centreHd, bow.shape.centreHd) > 0.005F);
        QVERIFY(std::abs(glm::distance(thing(bowId)->shape.centreHd, thing(tieId)->shape.centreHd) - awayM) < 1e-4F);
        stack().undo();
        QVERIFY(*thing(bowId) == bow && *thing(tieId) == tie);
        editor().options().setChosenWorn(tieId);
        m_window->actions().find(QLatin1StringView("hair.removeWorn"))->trigger();
        QVERIFY(thing(bowId) == nullptr && thing(tieId) == nullptr);
        stack().undo();
        QVERIFY(*thing(bowId) == bow);
    }

    /// Two strokes of the brush, a menu, and a number.
    void rowsBetweenTwoByMouse()
    {
        openWindow(model::newProject());
        const QSignalSpy told(&editor(), &view::EditorState::told);
        editor().target().setMap(model::MapKind::Density);
        m_window->actions().find(QLatin1StringView("edit.fill"))->trigger();
        editor().target().setMap(model::MapKind::Braid);
        model::ToolSettings settings = editor().tools().settings();
        settings.value(model::MapKind::Braid).index = static_cast<int>(sim::BraidKind::Cornrow);
        settings.brushSizeM = 0.008F;
        settings.hardness = 1.0F;
        editor().tools().setSettings(settings);
        editor().options().setMirror(false);
        const auto repeat = [this] { m_window->actions().find(QLatin1StringView("hair.repeatRows"))->trigger(); };
        const auto dialog = [this] { return m_window->findChild<view::RepeatRowsDialog*>(); };
        repeat();
        QCOMPARE(told.count(), 1);
        QVERIFY(dialog() == nullptr);
        drag(m_window->paintView(), paintPoint(0.42F, 0.62F), paintPoint(0.42F, 0.8F));
        drag(m_window->paintView(), paintPoint(0.52F, 0.62F), paintPoint(0.52F, 0.8F));
        const int steps = stack().count();
        const QByteArray before = savedBytes("before.hairpaint");
        const model::Id group = session().document().project().groups.front().id;
        const auto numberAt = [&](float u) {
            return session().document().resolvedNow(group, model::MapKind::Braid)->sampleNearest({u, 0.7F})[0];
        };
        repeat();
        QTRY_VERIFY_WITH_TIMEOUT(dialog() != nullptr && dialog()->isVisible(), kPatienceMs);
        auto* count = dialog()->findChild<view::BarSlider*>();
        const double fitting = count->value();
        QVERIFY(fitting > 1.0);
        while (count->value() > 1.0)
            QTest::keyClick(count, Qt::Key_Left);
        QVERIFY(numberAt(0.47F) > static_cast<int>(sim::BraidKind::Cornrow) + 1); // Shown before it is accepted.
        QTest::keyClick(dialog(), Qt::Key_Escape);
        QTRY_VERIFY_WITH_TIMEOUT(dialog() == nullptr, kPatienceMs);
        QCOMPARE(savedBytes("dropped.hairpaint"), before);
        repeat();
        QTRY_VERIFY_WITH_TIMEOUT(dialog() != nullptr && dialog()->isVisible(), kPatienceMs);
        QCOMPARE(dialog()->findChild<view::BarSlider*>()->value(), fitting);
        QTest::mouseClick(dialog()->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok), Qt::LeftButton);
        QCOMPARE(stack().count(), steps + 1);
        QCOMPARE(stack().undoText(), QStringLiteral("Repeat between two rows"));
        QVERIFY(numberAt(0.47F) != 0);
        stack().undo();
        QCOMPARE(savedBytes("after.hairpaint"), before);
    }

    void cornrowsThatATieTakesAreTold()
    {
        openWindow(model::newProject());
        const QSignalSpy told(&editor(), &view::EditorState::told);
        editor().target().setMap(model::MapKind::Density);
        m_window->actions().find(QLatin1StringView("edit.fill"))->trigger();
        const auto [area, at] = onHead(0.5F, 0.7F);
        QTest::mouseMove(area, at);
        m_window->actions().find(QLatin1StringView("hair.addBun"))->trigger();
        QCOMPARE(told.count(), 0);
        session().document().undo();
        editor().target().setMap(model::MapKind::Braid);
        model::ToolSettings settings = editor().tools().settings();
        settings.value(model::MapKind::Braid).index = static_cast<int>(sim::BraidKind::Cornrow);
        editor().tools().setSettings(settings);
        drag(m_window->paintView(), paintPoint(0.45F, 0.7F), paintPoint(0.45F, 0.8F));
        QTest::mouseMove(area, at);
        m_window->actions().find(QLatin1StringView("hair.addBun"))->trigger();
        QCOMPARE(told.count(), 1);
    }

    void whereNoHairIsItSaysSo()
    {
        openWindow(model::newProject());
        const QSignalSpy refused(&editor(), &view::EditorState::refused);
        m_window->actions().find(QLatin1StringView("hair.addBun"))->trigger();
        QCOMPARE(refused.count(), 1);
        QCOMPARE(stack().count(), 0);
    }

    /// Where the pointer was on one side of the head, or in its middle.
    void twinTailsByOneClick_data()
    {
        QTest::addColumn<float>("at");
        QTest::addColumn<bool>("isFilled");
        QTest::newRow("at a side") << 0.7F << true;
        QTest::newRow("in the middle") << 0.5F << true;
        // The paint of the accessory map goes on around it.
        QTest::newRow("hair with a rim") << 0.56F << false;
    }

    void twinTailsByOneClick()
    {
        QFETCH(float, at);
        QFETCH(bool, isFilled);
        openWindow(model::newProject());
        editor().target().setMap(model::MapKind::Density);
        if (isFilled)
            m_window->actions().find(QLatin1StringView("edit.fill"))->trigger();
        else
            drag(m_window->paintView(), paintPoint(0.4F, 0.7F), paintPoint(0.6F, 0.7F));
        const int steps = stack().count();
        const auto [area, point] = onHead(at, 0.7F);
        QTest::mouseMove(area, point);
        m_window->actions().find(QLatin1StringView("hair.addTwinTails"))->trigger();
        QCOMPARE(stack().count(), steps + 1);
        QCOMPARE(stack().undoText(), QStringLiteral("Gather hair into twin tails"));
        const std::vector<model::Worn>& worn = session().document().project().worn;
        QCOMPARE(model::countOf(worn, model::WornKind::Ponytail), std::size_t{2});
        const glm::vec3 one = worn[worn.size() - 2].shape.centreHd;
        const glm::vec3 other = worn.back().shape.centreHd;
        QVERIFY(std::abs(one.x) > 0.02F && glm::distance(one * glm::vec3(-1.0F, 1.0F, 1.0F), other) < 4e-3F);
        QCOMPARE(session().document().groomInput().groups.front().ties.size(), std::size_t{2});
        stack().undo();
        QCOMPARE(model::countOf(session().document().project().worn, model::WornKind::Ponytail), std::size_t{0});
    }

    /// The brush in the paint area, mirrored: twin tails.
    void twinTailsByAMirroredBrush()
    {
        openWindow(model::newProject());
        editor().target().setMap(model::MapKind::Accessory);
        editor().options().setMirror(true);
        drag(m_window->paintView(), paintPoint(0.40F, 0.7F), paintPoint(0.43F, 0.72F));
        QCOMPARE(stack().undoText(), QStringLiteral("Brush on Accessories"));
        const std::vector<model::Worn>& worn = session().document().project().worn;
        QCOMPARE(model::countOf(worn, model::WornKind::Ponytail), std::size_t{2});
        const model::Worn& left = worn[worn.size() - 2];
        const model::Worn& right = worn.back();
        QVERIFY(glm::distance(left.shape.centreHd * glm::vec3(-1.0F, 1.0F, 1.0F), right.shape.centreHd) < 2e-3F);
        stack().undo();
        QCOMPARE(model::countOf(session().document().project().worn, model::WornKind::Ponytail), std::size_t{0});
    }
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestTiedHair, Widgets)
#include "test_tied_hair.moc"
