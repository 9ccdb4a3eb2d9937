// Folders, search, favourites, what was put on last and parts of styles, by mouse and by keys alone.
#include "tests/support/test_program.h"
#include "tests/view/strip_fixture.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTabBar>
#include <QToolButton>
#include <QTranslator>

using namespace hairpaint;
using namespace hairpaint::view;
using model::MapKind;

namespace {

class SomeSpanish : public QTranslator
{
public:
    QString translate(const char* context, const char* source, const char* /*comment*/, int /*n*/) const override
    {
        const bool isName = qstrcmp(context, "Names") == 0;
        return isName && qstrcmp(source, "Bob") == 0     ? QStringLiteral("Melena cortísima")
               : isName && qstrcmp(source, "curly") == 0 ? QStringLiteral("rizado")
                                                         : QString();
    }
    bool isEmpty() const override { return false; }
};

struct LibraryFixture : StripFixture
{
    LibraryFixture()
    {
        strip.resize(1040, strip.height());
        const auto entry = [](const char* path, const char* name, const QStringList& tags, bool own) {
            return model::PresetEntry{.path = QLatin1String(path),
                                      .name = QLatin1String(name),
                                      .tags = tags,
                                      .folder = own ? QStringLiteral("own") : QStringLiteral("built-in"),
                                      .picture = {}};
        };
        strip.setEntries({entry("bob", "Bob", {QStringLiteral("medium")}, false),
                          entry("waves", "Ringlets", {QStringLiteral("medium"), QStringLiteral("curly")}, false),
                          entry("goatee", "My chin", {QStringLiteral("face")}, true)});
        strip.activateWindow();
    }
    [[nodiscard]] QTabBar& folders() { return *strip.findChild<QTabBar*>(); }
    [[nodiscard]] QLineEdit& search() { return *strip.findChild<QLineEdit*>(QStringLiteral("styleSearch")); }
    [[nodiscard]] QComboBox& part() { return *strip.findChild<QComboBox*>(QStringLiteral("stylePart")); }
    void choose(const char* folder)
    {
        for (int tab = 0; tab < folders().count(); ++tab)
            if (folders().tabText(tab) == QLatin1String(folder))
                QTest::mouseClick(&folders(), Qt::LeftButton, {}, folders().tabRect(tab).center());
    }
    [[nodiscard]] QString shown() const
    {
        QStringList paths;
        for (const QString& path : strip.shownPaths())
            paths.append(path);
        return paths.join(QLatin1Char(' '));
    }
    [[nodiscard]] StyleTile& named(const char* path)
    {
        const QList<StyleTile*> all = strip.findChildren<StyleTile*>();
        return **std::ranges::find(all, QLatin1String(path), &StyleTile::path);
    }
    static void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::keyClick(QApplication::focusWidget(), key, modifiers);
    }
    [[nodiscard]] static QString focused()
    {
        const auto* tile = qobject_cast<const StyleTile*>(QApplication::focusWidget());
        return tile != nullptr ? tile->path() : QStringLiteral("none");
    }
    [[nodiscard]] QPushButton* way()
    {
        for (QPushButton* button : strip.findChildren<QPushButton*>())
            if (button->isVisible())
                return button;
        return nullptr;
    }
};

} // namespace

class TestStyleLibrary : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void a_folder_shows_what_lies_in_it_data()
    {
        QTest::addColumn<QByteArray>("folder");
        QTest::addColumn<QString>("shown");
        QTest::newRow("all") << QByteArray("All") << QStringLiteral("bob waves goatee");
        QTest::newRow("by a tag") << QByteArray("Medium") << QStringLiteral("bob waves");
        QTest::newRow("by another tag of the same style") << QByteArray("Curly and coily") << QStringLiteral("waves");
        QTest::newRow("the user's own") << QByteArray("Mine") << QStringLiteral("goatee");
        QTest::newRow("empty") << QByteArray("Long") << QString();
    }
    void a_folder_shows_what_lies_in_it()
    {
        QFETCH(QByteArray, folder);
        QFETCH(QString, shown);
        LibraryFixture f;
        f.choose(folder.constData());
        QCOMPARE(f.shown(), shown);
        for (const char* path : {"bob", "waves", "goatee"})
            QCOMPARE(f.named(path).isVisible(), shown.contains(QLatin1String(path)));
        QCOMPARE(f.way() != nullptr, shown.isEmpty());
    }

    void a_search_is_in_the_users_language_data()
    {
        QTest::addColumn<QString>("words");
        QTest::addColumn<QString>("shown");
        QTest::newRow("by name, without accents") << QStringLiteral("cortisima") << QStringLiteral("bob");
        QTest::newRow("by tag") << QStringLiteral("rizad") << QStringLiteral("waves");
        QTest::newRow("by name and tag, in any order") << QStringLiteral("medium melena") << QStringLiteral("bob");
        QTest::newRow("by folder") << QStringLiteral("mine") << QStringLiteral("goatee");
        QTest::newRow("no more in English") << QStringLiteral("bob") << QString();
    }
    void a_search_is_in_the_users_language()
    {
        QFETCH(QString, words);
        QFETCH(QString, shown);
        SomeSpanish spanish;
        QCoreApplication::installTranslator(&spanish);
        LibraryFixture f;
        QTest::keyClicks(&f.search(), words);
        QCoreApplication::removeTranslator(&spanish);
        QCOMPARE(f.shown(), shown);
    }

    void where_nothing_is_found_there_is_a_way_on()
    {
        LibraryFixture f;
        f.choose("Long");
        QTest::keyClicks(&f.search(), QStringLiteral("ringlets"));
        QVERIFY(f.way() != nullptr);
        QTest::mouseClick(f.way(), Qt::LeftButton); // In all folders, for the same words.
        QCOMPARE(f.shown(), QStringLiteral("waves"));
        QTest::keyClicks(&f.search(), QStringLiteral("zzz"));
        QVERIFY(f.way() != nullptr);
        QTest::mouseClick(f.way(), Qt::LeftButton); // All that there are.
        QCOMPARE(f.shown(), QStringLiteral("bob waves goatee"));
        QVERIFY(f.search().text().isEmpty());
    }

    void keys_alone_find_and_put_on()
    {
        LibraryFixture f;
        QVERIFY(QTest::qWaitForWindowActive(&f.strip));
        f.strip.startSearch();
        QTest::keyClicks(QApplication::focusWidget(), QStringLiteral("medium"));
        LibraryFixture::press(Qt::Key_Down);
        QCOMPARE(LibraryFixture::focused(), QStringLiteral("bob"));
        LibraryFixture::press(Qt::Key_Right);
        QCOMPARE(LibraryFixture::focused(), QStringLiteral("waves"));
        LibraryFixture::press(Qt::Key_Right); // There is no further one.
        QCOMPARE(LibraryFixture::focused(), QStringLiteral("waves"));
        LibraryFixture::press(Qt::Key_Home);
        QCOMPARE(LibraryFixture::focused(), QStringLiteral("bob"));
        LibraryFixture::press(Qt::Key_End);
        LibraryFixture::press(Qt::Key_Return);
        QTRY_COMPARE_WITH_TIMEOUT(f.steps(), 1, test::kPatienceMs);
        LibraryFixture::press(Qt::Key_Up);
        QVERIFY(f.folders().hasFocus());
        LibraryFixture::press(Qt::Key_Left); // The first one: it stays.
        LibraryFixture::press(Qt::Key_Down);
        QCOMPARE(LibraryFixture::focused(), QStringLiteral("waves"));
        f.strip.startSearch();
        LibraryFixture::press(Qt::Key_Escape);
        QCOMPARE(f.shown(), QStringLiteral("bob waves goatee"));
    }

    void space_and_a_button_tell_of_a_style()
    {
        LibraryFixture f;
        QVERIFY(QTest::qWaitForWindowActive(&f.strip));
        QStringList told;
        QObject::connect(&f.strip, &StyleStrip::ordered, &f.strip, [&told](const QString& path, StyleOrder order) {
            if (order == StyleOrder::About)
                told << path;
        });
        f.named("waves").setFocus();
        LibraryFixture::press(Qt::Key_Space);
        QCOMPARE(told, QStringList{QStringLiteral("waves")});
        QTest::mouseClick(f.named("waves").findChild<QToolButton*>(QStringLiteral("styleAbout")), Qt::LeftButton);
        QCOMPARE(told.size(), 2);
        QCOMPARE(f.steps(), 0); // It is not put on.
    }

    void a_single_picture_takes_tab()
    {
        LibraryFixture f;
        QVERIFY(QTest::qWaitForWindowActive(&f.strip));
        f.named("waves").setFocus();
        int stops = 0;
        for (const StyleTile* tile : f.strip.findChildren<StyleTile*>())
            stops += (tile->focusPolicy() & Qt::TabFocus) == Qt::TabFocus ? 1 : 0;
        QCOMPARE(stops, 1);
        QCOMPARE(f.named("waves").focusPolicy(), Qt::TabFocus);
    }

    void a_favourite_is_marked_by_star_and_by_key()
    {
        LibraryFixture f;
        QVERIFY(QTest::qWaitForWindowActive(&f.strip));
        StyleMarks marks;
        QObject::connect(&f.strip, &StyleStrip::marksChanged, &f.strip,
                         [&marks](const StyleMarks& now) { marks = now; });
        f.named("waves").setFocus();
        QTest::mouseClick(f.named("waves").findChild<QToolButton*>(QStringLiteral("styleStar")), Qt::LeftButton);
        QCOMPARE(marks.favourites, QStringList{QStringLiteral("waves")});
        QCOMPARE(f.steps(), 0); // It is not put on.
        f.named("goatee").setFocus();
        LibraryFixture::press(Qt::Key_D, Qt::ControlModifier);
        QCOMPARE(marks.favourites.size(), 2);
        f.choose("Favourites");
        QCOMPARE(f.shown(), QStringLiteral("waves goatee"));
        f.named("waves").setFocus();
        LibraryFixture::press(Qt::Key_D, Qt::ControlModifier);
        QCOMPARE(marks.favourites, QStringList{QStringLiteral("goatee")});
        f.choose("All");
        f.choose("Favourites");
        QCOMPARE(f.shown(), QStringLiteral("goatee"));
        QVERIFY(f.named("goatee").isFavourite());
        // What was kept is shown as it was.
        marks.favourites = {QStringLiteral("bob"), QStringLiteral("gone")};
        f.strip.setMarks(marks);
        QCOMPARE(f.shown(), QStringLiteral("bob"));
    }

    void what_was_put_on_last_comes_first()
    {
        LibraryFixture f;
        f.choose("Recent");
        QVERIFY(f.shown().isEmpty() && f.way() != nullptr);
        f.choose("All");
        for (const char* path : {"bob", "waves", "bob", "goatee"}) {
            QTest::mouseClick(&f.named(path), Qt::LeftButton);
            QCoreApplication::processEvents();
        }
        f.choose("Recent");
        QCOMPARE(f.shown(), QStringLiteral("goatee bob waves"));
        StyleMarks marks;
        for (int i = 0; i < 100; ++i)
            marks.addRecent(QString::number(i));
        QCOMPARE(marks.recent.size(), StyleMarks::kMostRecent);
        QCOMPARE(marks.recent.front(), QStringLiteral("99"));
    }

    void the_box_tells_what_a_click_takes()
    {
        LibraryFixture f;
        const auto length = f.document.resolved(f.scalp().id, MapKind::Length);
        const auto colour = f.document.resolved(f.scalp().id, MapKind::Colour);
        f.part().setCurrentIndex(static_cast<int>(model::StylePart::Colour));
        f.enter(1);
        QTRY_VERIFY_WITH_TIMEOUT(f.document.previewing(), test::kPatienceMs);
        const auto shown = f.document.project().groups;
        QTest::mouseClick(&f.named("waves"), Qt::LeftButton);
        QCOMPARE(f.steps(), 1);
        QVERIFY(sameGroups(f.document.project().groups, shown)); // What was shown is what is kept.
        QCOMPARE(f.document.resolved(f.scalp().id, MapKind::Length), length);
        QVERIFY(f.document.resolved(f.scalp().id, MapKind::Colour) != colour);
        f.leave(1);
    }

    void delete_on_a_picture_is_no_key_of_the_windows()
    {
        LibraryFixture f;
        QVERIFY(QTest::qWaitForWindowActive(&f.strip));
        QSignalSpy ordered(&f.strip, &StyleStrip::ordered);
        for (const char* path : {"bob", "goatee"}) {
            QKeyEvent press(QEvent::ShortcutOverride, Qt::Key_Delete, Qt::NoModifier);
            press.ignore();
            QApplication::sendEvent(&f.named(path), &press);
            QVERIFY(press.isAccepted());
            QTest::keyClick(&f.named(path), Qt::Key_Delete);
        }
        QCOMPARE(ordered.count(), 1); // A built-in one stays.
        QCOMPARE(ordered.front().front().toString(), QStringLiteral("goatee"));
    }

    void what_was_done_can_be_taken_back()
    {
        LibraryFixture f;
        QSignalSpy undo(&f.strip, &StyleStrip::undoWanted);
        f.strip.offerUndo(QStringLiteral("'My chin' is in the trash."));
        QVERIFY(f.way() != nullptr);
        QTest::mouseClick(f.way(), Qt::LeftButton);
        QCOMPARE(undo.count(), 1);
        f.strip.offerUndo({});
        QVERIFY(f.way() == nullptr);
    }
};

HAIRPAINT_TEST(TestStyleLibrary, Widgets)
#include "test_style_library.moc"
