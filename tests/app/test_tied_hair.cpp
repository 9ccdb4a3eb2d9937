// Hair tied in the real window, by mouse and menus.
#include "tests/app/window_fixture.h"
#include "tests/support/test_program.h"

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
