// The filled bar answers mouse, wheel, keys and typing, and tells of each change once.
#include "panel_fixture.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"
#include "view/theme.h"

#include <QLineEdit>
#include <QSignalSpy>
#include <QWheelEvent>

#include <memory>

using namespace hairpaint::view;

class TestBarSlider : public QObject
{
    Q_OBJECT

    std::unique_ptr<BarSlider> m_slider;
    std::unique_ptr<QSignalSpy> m_changed;
    std::unique_ptr<QSignalSpy> m_finished;
    std::unique_ptr<QSignalSpy> m_cancelled;

    [[nodiscard]] QPoint at(double fraction) const { return {qRound(m_slider->width() * fraction), 12}; }

private Q_SLOTS:
    void init()
    {
        m_slider = std::make_unique<BarSlider>(QStringLiteral("Length"));
        m_slider->setRange(0.0, 100.0, 1);
        m_slider->setUnit(QStringLiteral("cm"));
        m_slider->setValue(50.0);
        m_slider->setDefaultValue(30.0);
        m_slider->resize(200, 24);
        m_slider->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_slider.get()));
        m_changed = std::make_unique<QSignalSpy>(m_slider.get(), &BarSlider::valueChanged);
        m_finished = std::make_unique<QSignalSpy>(m_slider.get(), &BarSlider::editingFinished);
        m_cancelled = std::make_unique<QSignalSpy>(m_slider.get(), &BarSlider::editingCancelled);
    }

    void dragging_tells_of_every_value_and_once_of_the_end()
    {
        holdAt(*m_slider, 0.6);
        dragTo(*m_slider, at(0.8));
        QCOMPARE(m_slider->value(), 80.0);
        QVERIFY(m_changed->count() >= 2);
        QCOMPARE(m_finished->count(), 0);
        letGo(*m_slider, at(0.8));
        QCOMPARE(m_finished->count(), 1);
        QCOMPARE(m_finished->first().first().toDouble(), 80.0);
        QCOMPARE(m_cancelled->count(), 0);
    }

    void dragging_back_to_the_old_value_changes_nothing()
    {
        holdAt(*m_slider, 0.8);
        dragTo(*m_slider, at(0.5));
        letGo(*m_slider, at(0.5));
        QCOMPARE(m_slider->value(), 50.0);
        QCOMPARE(m_finished->count(), 0);
        QCOMPARE(m_cancelled->count(), 1);
    }

    void escape_and_right_button_take_a_drag_back_data()
    {
        QTest::addColumn<bool>("byKey");
        QTest::newRow("Esc") << true;
        QTest::newRow("right button") << false;
    }
    void escape_and_right_button_take_a_drag_back()
    {
        QFETCH(bool, byKey);
        holdAt(*m_slider, 0.9);
        QVERIFY(m_slider->value() > 80.0);
        if (byKey)
            QTest::keyClick(m_slider.get(), Qt::Key_Escape);
        else
            QTest::mousePress(m_slider.get(), Qt::RightButton, Qt::NoModifier, at(0.9));
        QCOMPARE(m_slider->value(), 50.0);
        QCOMPARE(m_cancelled->count(), 1);
        letGo(*m_slider, at(0.9));
        QCOMPARE(m_finished->count(), 0);
        QCOMPARE(m_slider->value(), 50.0);
    }

    void ctrl_makes_dragging_ten_times_finer()
    {
        QTest::mousePress(m_slider.get(), Qt::LeftButton, Qt::ControlModifier, at(0.5));
        QMouseEvent move(QEvent::MouseMove, at(0.7), m_slider->mapToGlobal(at(0.7)), Qt::NoButton, Qt::LeftButton,
                         Qt::ControlModifier);
        QApplication::sendEvent(m_slider.get(), &move);
        QCOMPARE(m_slider->value(), 52.0);
        letGo(*m_slider, at(0.7));
    }

    void a_right_click_resets_as_one_change()
    {
        QTest::mouseClick(m_slider.get(), Qt::RightButton, Qt::NoModifier, at(0.5));
        QCOMPARE(m_slider->value(), 30.0);
        QCOMPARE(m_finished->count(), 1);
    }

    void a_click_sets_once_it_is_no_double_click()
    {
        QTest::mouseClick(m_slider.get(), Qt::LeftButton, Qt::NoModifier, at(0.25));
        QCOMPARE(m_slider->value(), 25.0);
        QCOMPARE(m_finished->count(), 0);
        QTRY_COMPARE_WITH_TIMEOUT(m_finished->count(), 1, hairpaint::test::kPatienceMs);
    }

    void typing_sets_a_value_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<double>("value");
        QTest::newRow("number") << QStringLiteral("72") << 72.0;
        QTest::newRow("with unit") << QStringLiteral("12.5 cm") << 12.5;
        QTest::newRow("beyond the range") << QStringLiteral("1000") << 100.0;
        QTest::newRow("nonsense") << QStringLiteral("long") << 50.0;
        QTest::newRow("nothing") << QString() << 50.0;
    }
    void typing_sets_a_value()
    {
        QFETCH(QString, text);
        QFETCH(double, value);
        QTest::mouseDClick(m_slider.get(), Qt::LeftButton, Qt::NoModifier, at(0.9));
        auto* editor = m_slider->findChild<QLineEdit*>();
        QVERIFY(editor != nullptr);
        editor->setText(text);
        QTest::keyClick(editor, Qt::Key_Return);
        QCOMPARE(m_slider->value(), value);
        QCOMPARE(m_finished->count(), value == 50.0 ? 0 : 1);
    }

    void escape_leaves_the_field_without_a_change()
    {
        m_slider->setFocus();
        QTest::keyClick(m_slider.get(), Qt::Key_Return);
        auto* editor = m_slider->findChild<QLineEdit*>();
        QVERIFY(editor != nullptr);
        editor->setText(QStringLiteral("99"));
        QTest::keyClick(editor, Qt::Key_Escape);
        QCOMPARE(m_slider->value(), 50.0);
        QCOMPARE(m_finished->count(), 0);
    }

    void holding_an_arrow_is_one_change()
    {
        m_slider->setFocus();
        QTest::keyPress(m_slider.get(), Qt::Key_Right);
        QTest::keyPress(m_slider.get(), Qt::Key_Right);
        QTest::keyPress(m_slider.get(), Qt::Key_Right, Qt::ShiftModifier);
        QCOMPARE(m_slider->value(), 62.0);
        QTest::keyRelease(m_slider.get(), Qt::Key_Right);
        QCOMPARE(m_finished->count(), 1);
    }

    void the_wheel_works_only_with_the_focus()
    {
        const auto turn = [this] {
            QWheelEvent wheel(QPointF(50, 12), m_slider->mapToGlobal(QPointF(50, 12)), QPoint(), QPoint(0, 120),
                              Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
            QApplication::sendEvent(m_slider.get(), &wheel);
            return wheel.isAccepted();
        };
        m_slider->clearFocus();
        QVERIFY(!turn());
        QCOMPARE(m_slider->value(), 50.0);
        m_slider->setFocus();
        QVERIFY(turn());
        QVERIFY(turn());
        QCOMPARE(m_slider->value(), 52.0);
        QTRY_COMPARE_WITH_TIMEOUT(m_finished->count(), 1, hairpaint::test::kPatienceMs);
    }

    void the_mark_leaves_the_words_alone_data()
    {
        QTest::addColumn<double>("value");
        QTest::addColumn<bool>("whole");
        QTest::newRow("under the label") << 10.0 << false;
        QTest::newRow("between") << 50.0 << true;
        QTest::newRow("under the value") << 93.0 << false;
    }
    void the_mark_leaves_the_words_alone()
    {
        QFETCH(double, value);
        QFETCH(bool, whole);
        m_slider->setLabel(QStringLiteral("||||||||||||||"));
        m_slider->setValue(value);
        const QImage image = m_slider->grab().toImage();
        const int x = qRound(value / 100.0 * image.width()) - 1;
        const QColor accent = Theme::current().accent;
        const auto marked = [&](int y) {
            const QColor pixel = image.pixelColor(x, y * image.height() / 24);
            return std::abs(pixel.red() - accent.red()) + std::abs(pixel.blue() - accent.blue()) < 40;
        };
        QVERIFY(marked(2) && marked(21));
        for (int y = 7; y < 17; ++y)
            QCOMPARE(marked(y), whole);
    }

    void it_is_named_for_screen_readers()
    {
        QCOMPARE(m_slider->accessibleName(), QStringLiteral("Length"));
        QVERIFY(m_slider->accessibleDescription().contains(QStringLiteral("cm")));
    }
};

HAIRPAINT_TEST(TestBarSlider, Widgets)
#include "test_bar_slider.moc"
