// A new user's minute with styles in the real window: one is liked, coloured, given another fringe, and kept; and the
// card of a style.
#include "tests/app/box_answer.h"
#include "tests/app/window_fixture.h"
#include "tests/support/test_program.h"
#include "view/dialogs/style_card.h"
#include "view/panels/style_tile.h"
#include "view/widgets/bar_slider.h"

#include <QInputDialog>
#include <QLabel>
#include <QPushButton>

#include <algorithm>

namespace hairpaint::app {

namespace {

/// Types a name and presses Enter.
class Namer : public BoxAnswer
{
public:
    explicit Namer(QString name) : BoxAnswer(QString()), m_name(std::move(name)) {}
    int actions = 0;

protected:
    bool ends(QWidget& dialog) override
    {
        auto* input = qobject_cast<QInputDialog*>(&dialog);
        if (input == nullptr)
            return false;
        input->setTextValue(m_name);
        actions += 2;
        input->accept();
        return true;
    }

private:
    QString m_name;
};

} // namespace

class TestStyleMinute : public QObject, private WindowFixture
{
    Q_OBJECT
private:
    [[nodiscard]] view::StyleTile* tile(const QString& name)
    {
        for (view::StyleTile* one : m_window->findChildren<view::StyleTile*>())
            if (one->text() == name)
                return one;
        return nullptr;
    }
    [[nodiscard]] view::BarSlider* handle(const QString& label)
    {
        for (view::BarSlider* one : m_window->findChild<view::StyleStrip*>()->findChildren<view::BarSlider*>())
            if (one->label() == label)
                return one;
        return nullptr;
    }
    [[nodiscard]] const model::HairGroup& scalp()
    {
        return *std::ranges::find(session().document().committed().groups, QStringLiteral("Scalp"),
                                  &model::HairGroup::name);
    }

private Q_SLOTS:
    void initTestCase() { prepareApplication(); }
    void cleanup() { m_window.reset(); }

    void takesFewerThanFifteenActions()
    {
        openWindow(model::newProject());
        int actions = 0;
        QTest::mouseClick(tile(QStringLiteral("Jaw bob with fringe")), Qt::LeftButton);
        ++actions;
        QTRY_COMPARE_WITH_TIMEOUT(stack().count(), 1, kPatienceMs);
        QTest::mouseClick(tile(QStringLiteral("Split dye")), Qt::LeftButton, Qt::ShiftModifier);
        ++actions;
        QTRY_COMPARE_WITH_TIMEOUT(stack().count(), 2, kPatienceMs);
        view::BarSlider& fringe = *handle(QStringLiteral("Fringe length"));
        QTRY_VERIFY_WITH_TIMEOUT(fringe.isVisible(), kPatienceMs);
        const model::HairGroup before = scalp();
        const int middle = fringe.height() / 2;
        drag(fringe, QPoint(fringe.width() / 2, middle), QPoint(fringe.width() / 5, middle));
        ++actions;
        QTRY_COMPARE_WITH_TIMEOUT(stack().count(), 3, kPatienceMs);
        QCOMPARE(stack().undoText(), QStringLiteral("Fringe of \"Scalp\""));
        QVERIFY(!(scalp().map(model::MapKind::Length) == before.map(model::MapKind::Length)));
        QVERIFY(scalp().map(model::MapKind::Colour) == before.map(model::MapKind::Colour));
        Namer namer(QStringLiteral("My fringe"));
        QTest::mouseClick(tile(QStringLiteral("Save style")), Qt::LeftButton);
        actions += 1 + namer.actions;
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(ownStylePath(QStringLiteral("My fringe"))), kPatienceMs);
        QTRY_VERIFY_WITH_TIMEOUT(tile(QStringLiteral("My fringe")) != nullptr, kPatienceMs);
        qInfo("actions: %d", actions);
        QVERIFY(actions < 15);
    }

    void aCardComesWithFourPicturesWhileTheWindowGoesOn()
    {
        openWindow(model::newProject());
        view::StyleTile* bob = tile(QStringLiteral("Bob"));
        bob->setFocus(Qt::TabFocusReason);
        QTest::keyClick(bob, Qt::Key_I, Qt::ControlModifier);
        const QPointer<view::StyleCard> card = m_window->findChild<view::StyleCard*>();
        QVERIFY(card != nullptr);
        QVERIFY(card->isVisible());
        QVERIFY(!card->isModal());
        const QList<QLabel*> views = card->findChildren<QLabel*>(QStringLiteral("styleView"));
        QCOMPARE(views.size(), 4);
        for (const QLabel* view : views)
            QTRY_VERIFY_WITH_TIMEOUT(!view->pixmap().isNull(), 2 * kPatienceMs);
        // Each from another side.
        QVERIFY(difference(views[0]->pixmap().toImage(), views[3]->pixmap().toImage()) > 0.02);
        QVERIFY(difference(views[1]->pixmap().toImage(), views[2]->pixmap().toImage()) > 0.02);
        QStringList texts;
        for (const QLabel* label : card->findChildren<QLabel*>())
            texts.append(label->text());
        for (const char* wanted : {"Hair type", "Longest hair", "Hairs", "Cost", "Painted"})
            QVERIFY2(texts.contains(QLatin1StringView(wanted)), wanted);
        const qsizetype made = texts.indexOf(QStringLiteral("How it was made"));
        QVERIFY(made >= 0);
        for (const char* wanted : {"Fill on Colour", " → Brush on Length × ", "Comb × "})
            QVERIFY2(texts[made + 1].contains(QString::fromUtf8(wanted)), qPrintable(texts[made + 1]));
        QVERIFY(card->findChild<QPushButton*>(QStringLiteral("styleLandmarks")) == nullptr);
        QCOMPARE(stack().count(), 0);
        QTest::mouseClick(card->findChild<QPushButton*>(QStringLiteral("stylePutOn")), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(stack().count(), 1, kPatienceMs);
        QTRY_VERIFY_WITH_TIMEOUT(card == nullptr, kPatienceMs);
    }

    void aCardOverAForeignHeadOffersItsLandmarks()
    {
        view::StyleCard card(QStringLiteral("Bob"), true, nullptr);
        int wanted = 0;
        connect(&card, &view::StyleCard::landmarksWanted, this, [&wanted] { ++wanted; });
        card.show();
        QTest::mouseClick(card.findChild<QPushButton*>(QStringLiteral("styleLandmarks")), Qt::LeftButton);
        QCOMPARE(wanted, 1);
    }

    void aCardThatIsClosedDropsWhatIsUnderWay()
    {
        openWindow(model::newProject());
        view::StyleTile* bob = tile(QStringLiteral("Bob"));
        bob->setFocus(Qt::TabFocusReason);
        QTest::keyClick(bob, Qt::Key_I, Qt::ControlModifier);
        QPointer<view::StyleCard> card = m_window->findChild<view::StyleCard*>();
        QVERIFY(card != nullptr);
        QTest::keyClick(card, Qt::Key_Escape);
        QTRY_VERIFY_WITH_TIMEOUT(card == nullptr, kPatienceMs);
        QCOMPARE(stack().count(), 0);
    }
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestStyleMinute, Widgets)
#include "test_style_minute.moc"
