// Unit and axis of imported hair, with the hair on the head beside them.
#include "tests/support/import_sample.h"
#include "tests/support/test_program.h"
#include "view/dialogs/hair_on_head.h"
#include "view/look/theme.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QTest>

#include <algorithm>

using namespace hairpaint;
using namespace hairpaint::view;

namespace {

/// The dialog with what the user sees of it.
struct Shown
{
    HairImportDialog dialog{test::importSample(), QStringLiteral("long.hair")};
    QComboBox* unit = dialog.findChildren<QComboBox*>().at(0);
    QComboBox* axis = dialog.findChildren<QComboBox*>().at(1);
    QPushButton* import = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);

    Shown()
    {
        dialog.show();
        (void)QTest::qWaitForWindowExposed(&dialog);
    }
    [[nodiscard]] bool says(const QString& words) const
    {
        return std::ranges::any_of(dialog.findChildren<QLabel*>(),
                                   [&](const QLabel* label) { return label->text().contains(words); });
    }
    /// Pixels of the front or the side that have the hair's colour, as parts of the picture.
    [[nodiscard]] QRectF hairSeen(int side) const
    {
        const QImage picture = dialog.findChild<HairOnHead*>()->grab().toImage();
        const QColor accent = Theme::current().accent;
        QRect seen;
        for (int y = 2; y < picture.height() - 2; ++y)
            for (int x = picture.width() * side / 2 + 2; x < picture.width() * (side + 1) / 2 - 2; ++x) {
                const QColor pixel = picture.pixelColor(x, y);
                if (std::abs(pixel.hslHue() - accent.hslHue()) < 12 && pixel.hslSaturation() > 60)
                    seen |= QRect(x, y, 1, 1);
            }
        return {2.0 * seen.x() / picture.width() - side, 1.0 * seen.y() / picture.height(),
                2.0 * seen.width() / picture.width(), 1.0 * seen.height() / picture.height()};
    }
};

} // namespace

class TestHairImportDialog : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void automaticTellsWhatItTook()
    {
        const Shown shown;
        QVERIFY(shown.says(QStringLiteral("12 strands")));
        QVERIFY(shown.says(QStringLiteral("Centimetres")));
        QVERIFY(shown.says(QStringLiteral("Z (Blender")));
        QVERIFY(shown.import->isEnabled());
        QVERIFY(!shown.dialog.choice().metresPerUnit && !shown.dialog.choice().upAxis);
    }

    void hairIsSeenAroundTheUpperHead()
    {
        const Shown shown;
        for (const int side : {0, 1}) {
            const QRectF hair = shown.hairSeen(side);
            QVERIFY2(hair.width() > 0.3 && hair.left() > 0.05 && hair.right() < 0.95,
                     qPrintable(QString::number(side)));
            QVERIFY2(hair.bottom() < 0.55 && hair.top() > 0.02, qPrintable(QString::number(hair.bottom())));
        }
    }

    void aWrongAxisIsSeenAndRefused()
    {
        Shown shown;
        shown.axis->setCurrentIndex(1);
        shown.unit->setCurrentIndex(shown.unit->findData(0.01));
        QVERIFY(shown.import->isEnabled());        // A ball has its roots on the skin whichever is up;
        QVERIFY(shown.hairSeen(0).bottom() > 0.6); // but it is seen to lie aside.
        shown.unit->setCurrentIndex(shown.unit->findData(0.001));
        QVERIFY(!shown.import->isEnabled());
        QVERIFY(shown.says(QStringLiteral("9.0 cm off")));
        QVERIFY(shown.hairSeen(0).width() < 0.2);
        QVERIFY(shown.dialog.choice().metresPerUnit == 0.001F);
        shown.unit->setCurrentIndex(0);
        QVERIFY(shown.import->isEnabled());
    }

    void hairOfHugeUnitsIsDrawnWithoutHarm()
    {
        Shown shown;
        shown.unit->setCurrentIndex(shown.unit->findData(1.0));
        QVERIFY(!shown.import->isEnabled());
        (void)shown.hairSeen(0);
    }
};

HAIRPAINT_TEST(TestHairImportDialog, Widgets)
#include "test_hair_import_dialog.moc"
