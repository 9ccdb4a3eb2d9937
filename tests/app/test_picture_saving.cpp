// Pictures from the window: what the dialog chooses is what is saved, seen small before, and offered again.
#include "tests/app/exchange_fixture.h"
#include "tests/support/test_program.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QSpinBox>

#include <cmath>

namespace hairpaint::app {

using view::PictureBackground;
using view::PictureDialog;
using view::PictureFraming;

class TestPictureSaving : public QObject, private ExchangeFixture
{
    Q_OBJECT
private:
    [[nodiscard]] PictureDialog* dialog() const { return m_window->findChild<PictureDialog*>(); }
    [[nodiscard]] QComboBox& boxAt(qsizetype index) const { return *dialog()->findChildren<QComboBox*>().at(index); }
    [[nodiscard]] QImage preview() const
    {
        for (const QLabel* label : dialog()->findChildren<QLabel*>())
            if (const QPixmap shown = label->pixmap(); !shown.isNull())
                return shown.toImage();
        return {};
    }
    void chooseSize(QSize px)
    {
        dialog()->findChild<QCheckBox*>()->setChecked(false);
        dialog()->findChildren<QSpinBox*>().at(0)->setValue(px.width());
        dialog()->findChildren<QSpinBox*>().at(1)->setValue(px.height());
    }
    void save(const char* name)
    {
        m_answers->file = path(name);
        QTest::keyClick(dialog(), Qt::Key_Return);
    }

private Q_SLOTS:
    void initTestCase() { prepareDialogs(); }
    void cleanup() { closeWindow(); }

    void aPictureIsSavedAsItWasChosen_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<PictureBackground>("background");
        QTest::addColumn<QColor>("corner");
        QTest::newRow("as shown") << QStringLiteral("shown.png") << PictureBackground::Shown
                                  << QColor(0x11, 0x22, 0x33);
        QTest::newRow("transparent") << QStringLiteral("clear.png") << PictureBackground::Transparent
                                     << QColor(0, 0, 0, 0);
        QTest::newRow("a colour") << QStringLiteral("white.png") << PictureBackground::Colour << QColor(255, 255, 255);
        QTest::newRow("JPEG has a background")
            << QStringLiteral("clear.jpeg") << PictureBackground::Transparent << QColor(0x11, 0x22, 0x33);
    }
    void aPictureIsSavedAsItWasChosen()
    {
        QFETCH(QString, name);
        QFETCH(PictureBackground, background);
        QFETCH(QColor, corner);
        model::Project project = model::newProject();
        project.background = 0xFF112233U;
        open(std::move(project));
        trigger("file.picture", Beside::Leave);
        QVERIFY(dialog() != nullptr && dialog()->isVisible() && !dialog()->isModal());
        chooseSize({160, 90});
        boxAt(2).setCurrentIndex(static_cast<int>(background));
        boxAt(3).setCurrentIndex(0);
        save(qPrintable(name));
        QCOMPARE(m_done, QStringList(QStringLiteral("%1 written").arg(name)));
        QTRY_VERIFY_WITH_TIMEOUT(dialog() == nullptr, kPatienceMs);
        const QImage saved(path(qPrintable(name)));
        QCOMPARE(saved.size(), QSize(160, 90));
        const QColor seen = saved.pixelColor(2, 2);
        QCOMPARE(seen.alpha(), corner.alpha());
        if (corner.alpha() > 0)
            QVERIFY2(std::abs(seen.red() - corner.red()) + std::abs(seen.green() - corner.green()) +
                             std::abs(seen.blue() - corner.blue()) <
                         30,
                     qPrintable(seen.name()));
        // The next one begins so.
        trigger("file.picture", Beside::Leave);
        QCOMPARE(dialog()->picturePx(), QSize(160, 90));
        QCOMPARE(dialog()->choice().background, background);
        QCOMPARE(dialog()->choice().samples, 1);
    }

    void aSmallPictureFollowsWhatIsChosenAndTheView()
    {
        open(model::newProject());
        awaitFinePicture();
        trigger("file.picture", Beside::Leave);
        QTRY_VERIFY_WITH_TIMEOUT(!preview().isNull(), kPatienceMs); // It is drawn elsewhere meanwhile.
        const QImage first = preview();
        boxAt(1).setCurrentIndex(static_cast<int>(PictureFraming::Head));
        QTRY_VERIFY_WITH_TIMEOUT(difference(preview(), first) > 0.05, kPatienceMs);
        boxAt(1).setCurrentIndex(static_cast<int>(PictureFraming::Shown));
        QTRY_VERIFY_WITH_TIMEOUT(difference(preview(), first) == 0.0, kPatienceMs);
        // The head can be turned while the dialog is open.
        view::HeadView& head = m_window->headView();
        rendering::Camera camera = head.camera();
        camera.azimuthRad += 1.0F;
        head.setCamera(camera);
        QTRY_VERIFY_WITH_TIMEOUT(difference(preview(), first) > 0.05, kPatienceMs);
        QTest::keyClick(dialog(), Qt::Key_Escape);
        QTRY_VERIFY_WITH_TIMEOUT(dialog() == nullptr, kPatienceMs);
        QVERIFY(m_done.isEmpty());
    }

    void aFileDialogThatIsLeftLeavesTheDialogOpen()
    {
        open(model::newProject());
        trigger("file.picture", Beside::Leave);
        m_answers->file.clear();
        QTest::keyClick(dialog(), Qt::Key_Return);
        QVERIFY(dialog()->isVisible());
        QVERIFY(m_done.isEmpty());
        // Closed at once, it asks for nothing more.
        dialog()->close();
        test::handleDueEvents();
        trigger("file.picture", Beside::Leave);
        // There is one dialog, however often it is asked for.
        trigger("file.picture", Beside::Leave);
        QCOMPARE(m_window->findChildren<PictureDialog*>().size(), 1);
    }

    void aNarrowPictureSeesTheWholeWidth()
    {
        const model::Project project = model::newProject();
        ShownScene shown;
        shown.px = {400, 200};
        const auto halfWidth = [](const rendering::Scene& scene, QSize px) {
            return std::tan(0.5F * scene.camera.fieldOfViewRad) * static_cast<float>(px.width()) /
                   static_cast<float>(px.height());
        };
        const float wide = halfWidth(shown.scene, shown.px);
        for (const QSize px : {QSize(100, 100), QSize(100, 300)})
            QVERIFY(std::abs(halfWidth(chosenScene(shown, {}, px, *project.head), px) - wide) < 1e-4F);
        // A wider one sees more at its sides, and as much upward.
        QCOMPARE(chosenScene(shown, {}, {800, 200}, *project.head).camera, shown.scene.camera);
    }
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestPictureSaving, Widgets)
#include "test_picture_saving.moc"
