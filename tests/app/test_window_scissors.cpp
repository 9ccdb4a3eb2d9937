// Cutting hair in the real window, by mouse.
#include "tests/app/window_fixture.h"
#include "tests/model/hair_colour.h"
#include "tests/model/side_view.h"
#include "tests/support/test_program.h"
#include "view/head_area/head_overlay.h"
#include "view/head_area/turn_hint.h"

#include <algorithm>

namespace hairpaint::app {

class TestWindowScissors : public QObject, private WindowFixture
{
    Q_OBJECT
private:
    [[nodiscard]] view::HeadView& head() { return m_window->headView(); }
    [[nodiscard]] std::shared_ptr<const sim::TiledRaster> lengths()
    {
        return session().document().resolved(editor().target().group(), model::MapKind::Length);
    }
    [[nodiscard]] const sim::GroupFrame& hair() { return session().frame()->groups.front(); }
    /// Looks at the left side, at the height of a level, where a line across the picture is level everywhere.
    void lookFromTheSide(float levelM)
    {
        rendering::Camera camera = head().camera();
        camera.targetWo = {0.0F, levelM, 0.0F};
        camera.azimuthRad = 1.5707963F;
        camera.elevationRad = 0.0F;
        camera.distanceM = 1.2F;
        head().setCamera(camera);
        awaitFinePicture();
    }
    void mouse(QEvent::Type type, QPointF at, Qt::KeyboardModifiers modifiers = {})
    {
        QWidget* area = head().childAt(at.toPoint()) != nullptr ? head().childAt(at.toPoint()) : &head();
        QMouseEvent event(type, area->mapFrom(&head(), at), head().mapToGlobal(at),
                          type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton,
                          type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, modifiers);
        QApplication::sendEvent(area, &event);
    }
    /// Ends of the picture at that height of the head.
    [[nodiscard]] std::pair<QPointF, QPointF> levelLine(float levelM)
    {
        const double y = head().positionOf({0.0F, levelM, 0.0F}).value_or(QPointF()).y();
        return {{12.0, y}, {head().width() - 12.0, y}};
    }

private Q_SLOTS:
    void initTestCase() { prepareApplication(); }
    void cleanup() { m_window.reset(); }

    void aLevelCutFromTheSideIsStraight_data()
    {
        QTest::addColumn<QByteArray>("style");
        QTest::addColumn<float>("levelM");
        QTest::addColumn<double>("mostEndsM"); ///< The distance from their median that most ends stay within.
        QTest::newRow("straight") << QByteArray("long-straight") << -0.09F << 0.005;
        QTest::newRow("waved") << QByteArray("bob") << -0.02F << 0.005;
        QTest::newRow("ringlets") << QByteArray("ringlets") << -0.05F << 0.008;
    }
    void aLevelCutFromTheSideIsStraight()
    {
        QFETCH(QByteArray, style);
        QFETCH(float, levelM);
        QFETCH(double, mostEndsM);
        openWithStyle(style.constData());
        lookFromTheSide(levelM);
        const auto lengthsBefore = lengths();
        const auto before = session().frame();
        key(Qt::Key_K);
        QCOMPARE(editor().tools().active().id(), model::ToolId::Scissors);
        QCOMPARE(editor().target().map(), model::MapKind::Length);
        const auto [from, to] = levelLine(levelM);
        const int steps = stack().count();
        mouse(QEvent::MouseButtonPress, from);
        QVERIFY(editor().tools().stroking());
        mouse(QEvent::MouseMove, (from + to) / 2.0);
        // Not quite level; Shift makes it so.
        mouse(QEvent::MouseMove, to + QPointF(0.0, 9.0), Qt::ShiftModifier);
        const auto* overlay = head().findChild<view::HeadOverlay*>();
        QCOMPARE(overlay->pictureLine().line, (QPolygonF{from, to}));
        const auto live = lengths();
        QVERIFY(*live != *lengthsBefore);
        mouse(QEvent::MouseButtonRelease, to + QPointF(0.0, 9.0), Qt::ShiftModifier);
        QVERIFY(*lengths() == *live);
        QCOMPARE(stack().count(), steps + 1);
        QCOMPARE(stack().undoText(), QStringLiteral("Cut hair"));
        QVERIFY(overlay->pictureLine().line.isEmpty());
        QVERIFY(!overlay->falling().empty());

        awaitNewestHair();
        const sim::GroupFrame& was = before->groups.front();
        std::vector<double> endsM;
        for (std::uint32_t slot = 0; slot < was.groom->roots->count(); ++slot) {
            if (!was.isPositioned(slot) || !hair().groom->isDrawn(slot))
                continue;
            if (!test::isSame(was.groom->style(slot), hair().groom->style(slot)))
                endsM.push_back(static_cast<double>(test::drawnPoints(hair(), slot).back().y));
        }
        QVERIFY(endsM.size() > 200);
        std::ranges::sort(endsM);
        const double medianM = endsM[endsM.size() / 2];
        QVERIFY2(std::abs(medianM - static_cast<double>(levelM)) < 0.005, qPrintable(QString::number(medianM)));
        const auto near =
            std::ranges::count_if(endsM, [&](double endM) { return std::abs(endM - medianM) < mostEndsM; });
        QVERIFY2(static_cast<double>(near) > 0.85 * static_cast<double>(endsM.size()),
                 qPrintable(QStringLiteral("%1 of %2").arg(near).arg(endsM.size())));
        QTRY_VERIFY_WITH_TIMEOUT(overlay->falling().empty(), kPatienceMs);
        key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(*lengths() == *lengthsBefore);
    }

    /// Dyed over their lower half: what is left of them looks as before, and what was cut off is gone.
    void cutHairKeepsTheColoursThatItsPointsHad()
    {
        constexpr float kLevelM = -0.16F;
        model::Project dyed = model::newProject();
        const auto preset = model::loadPreset(QStringLiteral(":/presets/long-straight.hairpreset"));
        QVERIFY(preset.has_value());
        model::applyPreset(dyed, *preset);
        sim::TiledRaster& tips = dyed.groups.front().map(model::MapKind::TipColour).layers.front().raster;
        for (int index = 0; index < tips.tileCount(); ++index)
            tips.setUniform(index, {65535, 65535, 0, 65535});
        dyed.groups.front().settings.material.tipFrom = 0.5F;
        openWindow(std::move(dyed));
        awaitNewestHair();
        lookFromTheSide(kLevelM);
        const auto before = session().frame();
        const sim::GroupFrame& was = before->groups.front();
        key(Qt::Key_K);
        const auto [from, to] = levelLine(kLevelM);
        mouse(QEvent::MouseButtonPress, from);
        mouse(QEvent::MouseMove, to);
        mouse(QEvent::MouseButtonRelease, to);
        awaitNewestHair();
        std::size_t looked = 0;
        std::size_t changed = 0;
        float brightest = 0.0F;
        for (std::uint32_t slot = 0; slot < was.groom->roots->count(); ++slot) {
            const float keptM = hair().groom->style(slot).lengthM;
            if (!was.isPositioned(slot) || was.groom->style(slot).lengthM - keptM < 0.01F)
                continue;
            for (const float alongM : {0.3F * keptM, 0.8F * keptM, keptM}) {
                ++looked;
                const float wasGreen = test::greenAt(*was.groom, slot, alongM);
                brightest = std::max(brightest, wasGreen);
                changed += std::abs(test::greenAt(*hair().groom, slot, alongM) - wasGreen) > 0.04F ? 1 : 0;
            }
        }
        QVERIFY2(looked > 300 && brightest > 0.3F, qPrintable(QStringLiteral("%1 %2").arg(looked).arg(brightest)));
        QVERIFY2(changed * 50 < looked, qPrintable(QStringLiteral("%1 of %2").arg(changed).arg(looked)));
        key(Qt::Key_Z, Qt::ControlModifier);
        awaitNewestHair();
        for (std::uint32_t slot = 0; slot < was.groom->roots->count(); ++slot)
            if (was.isPositioned(slot))
                QVERIFY(test::isSame(was.groom->style(slot), hair().groom->style(slot)));
    }

    void theSignThatTellsHowToTurnTheHeadGoesWhileScissorsAreInHand()
    {
        openWithStyle("bob");
        const auto* sign = head().findChild<view::TurnHint*>();
        QVERIFY(sign != nullptr && sign->isVisible());
        key(Qt::Key_K);
        QVERIFY(!sign->isVisible());
        key(Qt::Key_B);
        QVERIFY(sign->isVisible());
    }

    void escapeLeavesNoTraceAndTheFlatMapSaysWhereToCut()
    {
        openWithStyle("bob");
        lookFromTheSide(-0.02F);
        key(Qt::Key_K);
        const auto before = lengths();
        const int steps = stack().count();
        const auto [from, to] = levelLine(-0.02F);
        mouse(QEvent::MouseButtonPress, from);
        mouse(QEvent::MouseMove, to);
        QVERIFY(*lengths() != *before);
        head().setFocus();
        QTest::keyClick(&head(), Qt::Key_Escape);
        QVERIFY(!editor().tools().stroking());
        mouse(QEvent::MouseButtonRelease, to);
        QVERIFY(*lengths() == *before);
        QCOMPARE(stack().count(), steps);
        QStringList told;
        connect(&editor(), &view::EditorState::refused, this, [&told](const QString& text) { told << text; });
        QTest::mouseClick(&m_window->paintView(), Qt::LeftButton, {}, paintPoint(0.5F, 0.5F));
        QCOMPARE(told, QStringList{QStringLiteral("Scissors: draw over the hair in the 3D area.")});
        QCOMPARE(stack().count(), steps);
    }

    void withCtrlTheScissorsTakeTheValueUnderThePointer()
    {
        openWithStyle("bob");
        key(Qt::Key_K);
        const auto length = [this] { return editor().tools().settings().value(model::MapKind::Length).scalar; };
        const float before = length();
        QTest::mouseClick(&m_window->paintView(), Qt::LeftButton, Qt::ControlModifier, paintPoint(0.5F, 0.5F));
        const float inTheMap = length();
        QVERIFY(inTheMap != before);
        model::ToolSettings settings = editor().tools().settings();
        settings.value(model::MapKind::Length).scalar = before;
        editor().tools().setSettings(settings);
        lookFromTheSide(-0.02F);
        QTest::mouseClick(&head(), Qt::LeftButton, Qt::ControlModifier, head().rect().center());
        QVERIFY(length() != before);
        QCOMPARE(stack().count(), 0);
    }
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestWindowScissors, Widgets)
#include "test_window_scissors.moc"
