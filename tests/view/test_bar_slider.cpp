// The filled bar answers mouse, wheel, keys and typing, and tells of each change once.
#include "panel_fixture.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"
#include "view/look/theme.h"
#include "view/widgets/bar_picture.h"
#include "view/widgets/field_hint.h"

#include <QLineEdit>
#include <QPainter>
#include <QPointer>
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
        QTest::newRow("in another unit") << QStringLiteral("120 mm") << 12.0;
        QTest::newRow("a decimal comma") << QStringLiteral("0,5") << 0.5;
        QTest::newRow("a sum") << QStringLiteral("10 cm - 5 mm") << 9.5;
        QTest::newRow("the same value") << QStringLiteral("500 mm") << 50.0;
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
        QVERIFY(!editor->isVisible());
        QCOMPARE(FieldHint::textAt(*m_slider), text == QStringLiteral("1000")
                                                   ? QStringLiteral("100.0\u2009cm is the most that can be set here.")
                                                   : QString());
    }

    void a_double_click_changes_nothing_data()
    {
        QTest::addColumn<int>("tremble");
        QTest::newRow("with a calm hand") << 0;
        QTest::newRow("with a hand that trembles") << 3;
    }
    void a_double_click_changes_nothing()
    {
        QFETCH(int, tremble);
        QTest::mousePress(m_slider.get(), Qt::LeftButton, Qt::NoModifier, at(0.9));
        dragTo(*m_slider, at(0.9) + QPoint(tremble, 0));
        QTest::mouseRelease(m_slider.get(), Qt::LeftButton, Qt::NoModifier, at(0.9) + QPoint(tremble, 0));
        QVERIFY(m_slider->value() > 85.0);
        QTest::mouseDClick(m_slider.get(), Qt::LeftButton, Qt::NoModifier, at(0.9));
        QTest::mouseRelease(m_slider.get(), Qt::LeftButton, Qt::NoModifier, at(0.9));
        QCOMPARE(m_slider->value(), 50.0);
        QCOMPARE(m_finished->count(), 0);
        QCOMPARE(m_cancelled->count(), 1);
        auto* editor = m_slider->findChild<QLineEdit*>();
        QVERIFY(editor != nullptr && editor->isVisible());
        QCOMPARE(editor->text(), QStringLiteral("50.0"));
        QTest::keyClick(editor, Qt::Key_Return);
        QCOMPARE(m_slider->value(), 50.0);
        QCOMPARE(m_finished->count(), 0);
    }

    void what_can_not_be_read_is_said_and_stays_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("says");
        QTest::newRow("nonsense") << QStringLiteral("long")
                                  << QStringLiteral("“long” is not a number; type one such as 12 or 0.5.");
        QTest::newRow("nothing") << QString() << QStringLiteral("There is no number.");
        QTest::newRow("an angle") << QStringLiteral("3°") << QStringLiteral("“°” is no unit for this");
    }
    void what_can_not_be_read_is_said_and_stays()
    {
        QFETCH(QString, text);
        QFETCH(QString, says);
        m_slider->setFocus();
        QTest::keyClick(m_slider.get(), Qt::Key_Return);
        QPointer<QLineEdit> editor = m_slider->findChild<QLineEdit*>();
        QVERIFY(editor != nullptr);
        editor->setText(text);
        QTest::keyClick(editor, Qt::Key_Return);
        QVERIFY(editor != nullptr && editor->isVisible());
        QCOMPARE(editor->text(), text);
        QVERIFY(editor->property("refused").toBool());
        QVERIFY2(FieldHint::textAt(*m_slider).startsWith(says), qPrintable(FieldHint::textAt(*m_slider)));
        QTest::keyClick(editor, Qt::Key_7);
        QCOMPARE(FieldHint::textAt(*m_slider), QString());
        QVERIFY(!editor->property("refused").toBool());
        QTest::keyClick(editor, Qt::Key_Escape);
        QVERIFY(editor == nullptr || !editor->isVisible());
        QCOMPARE(m_slider->value(), 50.0);
        QCOMPARE(m_changed->count(), 0);
    }

    void leaving_what_can_not_be_read_says_what_stays()
    {
        QTest::mouseDClick(m_slider.get(), Qt::LeftButton, Qt::NoModifier, at(0.9));
        auto* editor = m_slider->findChild<QLineEdit*>();
        QVERIFY(editor != nullptr);
        editor->setText(QStringLiteral("long"));
        editor->clearFocus();
        QVERIFY(!editor->isVisible());
        QCOMPARE(m_slider->value(), 50.0);
        QCOMPARE(FieldHint::textAt(*m_slider),
                 QStringLiteral("“long” is not a number; type one such as 12 or 0.5. It stays 50.0\u2009cm."));
    }

    void leaving_takes_what_can_be_read()
    {
        QTest::mouseDClick(m_slider.get(), Qt::LeftButton, Qt::NoModifier, at(0.9));
        auto* editor = m_slider->findChild<QLineEdit*>();
        QVERIFY(editor != nullptr);
        editor->setText(QStringLiteral("4 mm"));
        editor->clearFocus();
        QCOMPARE(m_slider->value(), 0.4);
        QCOMPARE(m_finished->count(), 1);
    }

    void what_it_is_told_meanwhile_is_shown_afterwards()
    {
        QTest::mouseClick(m_slider.get(), Qt::LeftButton, Qt::NoModifier, at(0.25));
        m_slider->setValue(60.0);
        QCOMPARE(m_slider->value(), 25.0);
        m_slider->release();
        QCOMPARE(m_slider->value(), 60.0);
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

    void nothing_crosses_the_words_data()
    {
        QTest::addColumn<int>("theme");
        QTest::addColumn<bool>("scale");
        QTest::newRow("dark") << int(ThemeKind::Dark) << false;
        QTest::newRow("dark, with a scale") << int(ThemeKind::Dark) << true;
        QTest::newRow("light") << int(ThemeKind::Light) << false;
        QTest::newRow("light, with a scale") << int(ThemeKind::Light) << true;
    }
    void nothing_crosses_the_words()
    {
        QFETCH(int, theme);
        QFETCH(bool, scale);
        const QPalette before = QApplication::palette();
        QApplication::setPalette(Theme::of(static_cast<ThemeKind>(theme)).palette());
        constexpr int kSide = 24;
        constexpr int kWordsEnd = 18; // With what hangs below the line.
        const auto painted = [scale](double fraction, const QString& label) {
            QImage image(200, kSide, QImage::Format_RGB32);
            image.fill(Qt::black);
            QPainter painter(&image);
            painter.setFont(themeFont(TextRole::Label));
            paintBar(painter, image.rect(),
                     {.label = label,
                      .value = label,
                      .fraction = fraction,
                      .gradient = scale ? QList<QColor>{Qt::black, Qt::blue} : QList<QColor>()});
            return image;
        };
        const QImage none = painted(0.0, {});
        const QImage empty = painted(0.0, QStringLiteral("Spacing"));
        for (const double fraction : {0.07, 0.15, 0.5, 0.9, 1.0}) {
            const QImage image = painted(fraction, QStringLiteral("Spacing"));
            QCOMPARE(image.copy(0, 0, 200, kWordsEnd), empty.copy(0, 0, 200, kWordsEnd));
            QVERIFY(image != empty);
        }
        QCOMPARE(empty.copy(0, kWordsEnd, 200, kSide - kWordsEnd), none.copy(0, kWordsEnd, 200, kSide - kWordsEnd));
        QApplication::setPalette(before);
    }

    void it_is_named_for_screen_readers()
    {
        QCOMPARE(m_slider->accessibleName(), QStringLiteral("Length"));
        QVERIFY(m_slider->accessibleDescription().contains(QStringLiteral("cm")));
    }
};

HAIRPAINT_TEST(TestBarSlider, Widgets)
#include "test_bar_slider.moc"
