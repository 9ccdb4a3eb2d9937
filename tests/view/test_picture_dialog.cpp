// The dialog of a saved picture: sizes and their shape, keys, and one small picture at a time.
#include "tests/support/await.h"
#include "tests/support/test_program.h"
#include "view/dialogs/picture_dialog.h"
#include "view/widgets/field_hint.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QtTest>

#include <algorithm>

using namespace hairpaint;
using namespace hairpaint::view;

namespace {

constexpr QSize kView(600, 800);

void choose(QComboBox& box, int index)
{
    box.setCurrentIndex(index);
    Q_EMIT box.activated(index);
}

QComboBox& boxAt(const PictureDialog& dialog, qsizetype index)
{
    return *dialog.findChildren<QComboBox*>().at(index);
}

QSpinBox& sideAt(const PictureDialog& dialog, qsizetype index)
{
    return *dialog.findChildren<QSpinBox*>().at(index);
}

void showActive(PictureDialog& dialog)
{
    dialog.show();
    dialog.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&dialog));
}

void type(QSpinBox& side, const QString& text, Qt::Key end)
{
    side.setFocus();
    side.selectAll();
    QTest::keyClicks(&side, text);
    QTest::keyClick(&side, end);
}

} // namespace

class TestPictureDialog : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void a_side_reads_what_people_type()
    {
        PictureDialog dialog({.keepsShape = false}, kView);
        showActive(dialog);
        QSpinBox& width = sideAt(dialog, 0);
        for (const auto& [text, px] : {std::pair("1024*2", 2048), std::pair("1,920", 1920), std::pair("640 px", 640),
                                       std::pair("1000+24px", 1024)}) {
            type(width, QString::fromLatin1(text), Qt::Key_Tab);
            QCOMPARE(width.value(), px);
        }
        type(width, QStringLiteral("wide"), Qt::Key_Tab);
        QCOMPARE(width.value(), 1024);
        const QString told = FieldHint::textAt(*width.findChild<QLineEdit*>());
        QVERIFY2(told.contains(QStringLiteral("wide")) && told.contains(QStringLiteral("1024 px")), qPrintable(told));
        type(width, QStringLiteral("99999"), Qt::Key_Tab);
        QCOMPARE(width.value(), PictureChoice::kMostPx);
    }

    void what_was_chosen_is_offered_again()
    {
        const PictureChoice chosen{.isAsView = false,
                                   .size = {640, 480},
                                   .keepsShape = false,
                                   .framing = PictureFraming::Head,
                                   .background = PictureBackground::Colour,
                                   .colour = QColor(12, 34, 56),
                                   .samples = 16};
        QVERIFY(PictureDialog(chosen, kView).choice() == chosen);
        QVERIFY(PictureDialog({}, kView).choice() == PictureChoice{});
        PictureChoice asView;
        asView.isAsView = true;
        QCOMPARE(PictureDialog(asView, kView).picturePx(), kView);
    }

    void sizes_of_the_list_set_both_sides_and_typed_ones_keep_their_shape()
    {
        PictureDialog dialog({}, kView);
        showActive(dialog);
        QComboBox& sizes = boxAt(dialog, 0);
        choose(sizes, 0);
        QCOMPARE(dialog.picturePx(), kView);
        dialog.setViewPx({500, 500});
        QCOMPARE(dialog.picturePx(), QSize(500, 500));
        choose(sizes, sizes.findText(QStringLiteral("1080p"), Qt::MatchStartsWith));
        QCOMPARE(dialog.picturePx(), QSize(1920, 1080));
        type(sideAt(dialog, 0), QStringLiteral("960"), Qt::Key_Tab);
        QCOMPARE(dialog.picturePx(), QSize(960, 540));
        QCOMPARE(sizes.currentIndex(), sizes.count() - 1); // The last entry is a size of the user's own.
        type(sideAt(dialog, 1), QStringLiteral("1080"), Qt::Key_Tab);
        QCOMPARE(dialog.picturePx(), QSize(1920, 1080));
        QVERIFY(sizes.currentText().startsWith(QStringLiteral("1080p")));
        dialog.findChild<QCheckBox*>()->setChecked(false);
        type(sideAt(dialog, 0), QStringLiteral("1000"), Qt::Key_Tab);
        QCOMPARE(dialog.picturePx(), QSize(1000, 1080));
    }

    void large_pictures_have_one_sample()
    {
        PictureDialog dialog({}, kView);
        showActive(dialog);
        QVERIFY(boxAt(dialog, 3).isEnabled());
        type(sideAt(dialog, 0), QStringLiteral("5000"), Qt::Key_Tab);
        QVERIFY(!boxAt(dialog, 3).isEnabled());
        QVERIFY(!boxAt(dialog, 3).toolTip().isEmpty());
    }

    void enter_in_a_field_saves_with_it_and_esc_leaves()
    {
        PictureDialog dialog({}, kView);
        QSignalSpy saves(&dialog, &PictureDialog::saveWanted);
        showActive(dialog);
        QVERIFY(!dialog.isModal());
        type(sideAt(dialog, 0), QStringLiteral("300"), Qt::Key_Return);
        QCOMPARE(saves.size(), 1);
        QCOMPARE(dialog.picturePx(), QSize(300, 300));
        QTest::keyClick(&boxAt(dialog, 1), Qt::Key_Return);
        QCOMPARE(saves.size(), 2);
        QVERIFY(dialog.isVisible()); // It is done when there is a picture.
        QTest::keyClick(&sideAt(dialog, 0), Qt::Key_Escape);
        QVERIFY(!dialog.isVisible());
        QCOMPARE(saves.size(), 2);
    }

    void one_small_picture_is_drawn_at_a_time()
    {
        PictureDialog dialog({}, kView);
        QSignalSpy wanted(&dialog, &PictureDialog::previewWanted);
        dialog.show();
        test::handleDueEvents();
        QCOMPARE(wanted.size(), 1);
        // While it is drawn, others are chosen.
        choose(boxAt(dialog, 1), 1);
        choose(boxAt(dialog, 1), 2);
        choose(boxAt(dialog, 0), 4);
        test::handleDueEvents();
        QCOMPARE(wanted.size(), 1);
        QCOMPARE(dialog.previewPx(), QSize(260, 146));
        QImage picture(dialog.previewPx(), QImage::Format_ARGB32);
        picture.fill(Qt::transparent);
        dialog.showPreview(picture);
        test::handleDueEvents();
        QCOMPARE(wanted.size(), 2);
        // Squares show through where there is no background.
        QVERIFY(std::ranges::any_of(dialog.findChildren<QLabel*>(), [](const QLabel* label) {
            const QImage seen = label->pixmap().toImage();
            return !seen.isNull() && seen.pixel(0, 0) != seen.pixel(8, 0);
        }));
        dialog.showPreview(picture);
        test::handleDueEvents();
        QCOMPARE(wanted.size(), 2);
    }
};

HAIRPAINT_TEST(TestPictureDialog, Widgets)
#include "test_picture_dialog.moc"
