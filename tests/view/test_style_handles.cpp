// A style at a fraction, and the handles of the haircut that is on the head, beside the pictures of styles.
#include "tests/support/test_program.h"
#include "tests/view/strip_fixture.h"
#include "view/panels/handle_panel.h"

#include <QComboBox>

using namespace hairpaint;
using namespace hairpaint::view;
using model::MapKind;

namespace {

/// The scalp is the active group, as big as its buttons need.
struct HandleFixture : StripFixture
{
    BarSlider& length = *sliderNamed(strip, QStringLiteral("Length all over"));
    BarSlider& fraction = *strip.findChild<BarSlider*>(QStringLiteral("styleFraction"));

    HandleFixture()
    {
        strip.resize(900, 164);
        state.target().setGroup(group("Scalp").id);
        QCoreApplication::processEvents();
    }
    [[nodiscard]] float longestM() const { return group("Scalp").settings.greatestLengthM; }
    void setTo(BarSlider& slider, double fraction)
    {
        holdAt(slider, fraction);
        letGo(slider);
        QCoreApplication::processEvents();
    }
};

} // namespace

class TestStyleHandles : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hair_has_a_handle_and_a_bald_group_has_none()
    {
        HandleFixture f;
        QVERIFY(!f.length.isVisible());
        f.click(1);
        QTRY_VERIFY(f.length.isVisible());
        QVERIFY(!sliderNamed(f.strip, QStringLiteral("Fringe length"))->isVisible()); // There is no head.
    }

    void a_handle_is_seen_while_it_moves_and_is_one_step()
    {
        HandleFixture f;
        f.click(1);
        QTRY_VERIFY(f.length.isVisible());
        const float beforeM = f.longestM();
        const int steps = f.steps();
        holdAt(f.length, 0.9);
        QVERIFY(f.longestM() > 1.4F * beforeM);
        dragTo(f.length, QPoint(f.length.width() / 3, f.length.height() / 2));
        QVERIFY(f.longestM() < beforeM);
        QCOMPARE(f.steps(), steps);
        const float shownM = f.longestM();
        letGo(f.length);
        QCOMPARE(f.steps(), steps + 1);
        QCOMPARE(f.longestM(), shownM);
        QCOMPARE(f.document.undoStack().undoText(), QStringLiteral("Length of \"Scalp\""));
    }

    void a_handle_brings_back_what_it_took_and_follows_undo()
    {
        HandleFixture f;
        f.click(1);
        QTRY_VERIFY(f.length.isVisible());
        const model::HairGroup before = f.group("Scalp");
        f.setTo(f.length, 0.2);
        const double shortened = f.length.value();
        QVERIFY(shortened < 100.0);
        QVERIFY(!(f.group("Scalp") == before));
        f.document.undo();
        QTRY_COMPARE(f.length.value(), 100.0);
        f.document.redo();
        QTRY_COMPARE(f.length.value(), shortened);
        QTest::mouseClick(&f.length, Qt::RightButton); // To its usual value.
        QTRY_VERIFY(f.group("Scalp") == before);
    }

    void what_is_painted_is_the_new_beginning_and_colour_is_not()
    {
        HandleFixture f;
        f.click(1);
        QTRY_VERIFY(f.length.isVisible());
        f.setTo(f.length, 0.2);
        const double shortened = f.length.value();
        f.paintOn(f.group("Scalp").id, MapKind::Colour, 12345);
        QCoreApplication::processEvents();
        QCOMPARE(f.length.value(), shortened);
        f.paintOn(f.group("Scalp").id, MapKind::Length, 12345);
        QTRY_COMPARE(f.length.value(), 100.0);
    }

    void a_style_is_put_on_in_part()
    {
        HandleFixture f;
        f.click(1);
        const float fromM = f.longestM();
        f.document.undo();
        const float baldM = f.longestM();
        QVERIFY(baldM != fromM);
        f.setTo(f.fraction, 0.5);
        const double fraction = f.fraction.value() / 100.0;
        f.enter(1);
        QTRY_VERIFY(f.longestM() != baldM);
        const std::vector<model::HairGroup> shown = f.document.project().groups;
        const int steps = f.document.undoStack().index();
        f.click(1);
        QCOMPARE(f.document.undoStack().index(), steps + 1);
        QVERIFY(sameGroups(f.document.project().groups, shown));
        QVERIFY(std::abs(f.longestM() - std::lerp(baldM, fromM, static_cast<float>(fraction))) < 1e-3F);
        QCOMPARE(f.document.undoStack().undoText(),
                 QStringLiteral("Apply style \"waves\", %1%").arg(f.fraction.value()));
    }

    void the_last_style_is_mixed_anew_while_the_slider_moves()
    {
        HandleFixture f;
        const float baldM = f.longestM();
        f.click(1);
        const float wholeM = f.longestM();
        const int steps = f.steps();
        holdAt(f.fraction, 0.25);
        const float quarterM = f.longestM();
        QVERIFY(std::abs(quarterM - std::lerp(baldM, wholeM, static_cast<float>(f.fraction.value()) / 100.0F)) < 1e-3F);
        QCOMPARE(f.steps(), steps);
        letGo(f.fraction);
        QCOMPARE(f.steps(), steps + 1);
        QCOMPARE(f.longestM(), quarterM);
        f.document.undo();
        QCOMPARE(f.longestM(), wholeM);
    }

    void the_slider_is_of_the_next_style_once_another_part_is_chosen()
    {
        HandleFixture f;
        f.click(1);
        const std::vector<model::HairGroup> before = f.document.project().groups;
        const int steps = f.steps();
        f.strip.findChild<QComboBox*>(QStringLiteral("stylePart"))->setCurrentIndex(1);
        f.setTo(f.fraction, 0.3);
        QVERIFY(sameGroups(f.document.project().groups, before));
        QCOMPARE(f.steps(), steps);
    }

    void hair_that_was_painted_since_is_left_alone()
    {
        HandleFixture f;
        f.click(1);
        f.paintOn(f.group("Scalp").id, MapKind::Colour, 12345);
        const std::vector<model::HairGroup> before = f.document.project().groups;
        f.setTo(f.fraction, 0.3);
        QVERIFY(sameGroups(f.document.project().groups, before));
    }
};

HAIRPAINT_TEST(TestStyleHandles, Widgets)
#include "test_style_handles.moc"
