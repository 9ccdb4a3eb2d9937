// The user's own styles in the window: renamed, tagged, replaced, deleted and brought back; in and out as files.
#include "app/styles/library.h"
#include "model/files/preset_file.h"
#include "model/files/project_file.h"
#include "model/styles/preset.h"
#include "tests/app/exchange_fixture.h"
#include "tests/app/thin_project.h"
#include "tests/support/test_program.h"
#include "view/panels/style_notice.h"
#include "view/panels/style_strip.h"
#include "view/panels/style_tile.h"

#include <QLineEdit>

namespace hairpaint::app {

class TestStyleFiles : public QObject, private ExchangeFixture
{
    Q_OBJECT
private:
    using Order = view::StyleOrder;

    [[nodiscard]] view::StyleStrip& strip() { return *m_window->findChild<view::StyleStrip*>(); }
    [[nodiscard]] view::StyleTile* tile(const QString& path)
    {
        for (view::StyleTile* one : strip().findChildren<view::StyleTile*>())
            if (one->path() == path)
                return one;
        return nullptr;
    }
    [[nodiscard]] QPushButton* undoButton()
    {
        auto* notice = strip().findChild<view::StyleNotice*>();
        return notice->isVisible() ? notice->findChild<QPushButton*>() : nullptr;
    }
    /// Saves a style among the user's own; returns its path.
    [[nodiscard]] QString makeOwn(const QString& name)
    {
        const QString path = ownStylePath(name);
        return QDir().mkpath(ownPresetFolder()) &&
                       model::savePreset(model::presetFrom(test::thinned(model::newProject()), name), path)
                   ? path
                   : QString();
    }
    void beginWith(const QString& own)
    {
        open(model::newProject());
        QTRY_VERIFY_WITH_TIMEOUT(tile(own) != nullptr, kPatienceMs);
    }
    static QByteArray bytesOf(const QString& path)
    {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

private Q_SLOTS:
    void initTestCase() { prepareDialogs(); }
    void init() { QDir(ownPresetFolder()).removeRecursively(); }
    void cleanup()
    {
        closeWindow();
        QDir(ownPresetFolder()).removeRecursively();
    }

    void favouritesAndWhatWasPutOnAreKeptOverRestarts()
    {
        const QString bob = QStringLiteral(":/presets/bob.hairpreset");
        open(model::newProject());
        tile(bob)->setFocus();
        QTest::keyClick(tile(bob), Qt::Key_D, Qt::ControlModifier);
        QTest::mouseClick(tile(bob), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(stack().count(), 1, kPatienceMs);
        closeWindow();
        open(model::newProject());
        QTRY_VERIFY_WITH_TIMEOUT(tile(bob) != nullptr && tile(bob)->isFavourite(), kPatienceMs);
        QVERIFY(Settings().styleMarks().recent.startsWith(bob));
        SettingsStore().clear();
    }

    void theSearchIsReachedByKeyAndFromTheMenu()
    {
        open(model::newProject());
        m_window->paintView().setFocus();
        key(Qt::Key_F, Qt::ControlModifier);
        const auto* search = qobject_cast<QLineEdit*>(QApplication::focusWidget());
        QVERIFY(search != nullptr && strip().isAncestorOf(search));
        trigger("view.panels");
        trigger("hair.findStyle");
        QVERIFY(search->isVisible() && search->hasFocus());
    }

    void aRenamedFavouriteStaysOne()
    {
        const QString path = makeOwn(QStringLiteral("First"));
        beginWith(path);
        tile(path)->setFocus();
        QTest::keyClick(tile(path), Qt::Key_D, Qt::ControlModifier);
        m_answers->name = QStringLiteral("Second");
        QTest::keyClick(tile(path), Qt::Key_F2);
        const QString renamed = ownStylePath(QStringLiteral("Second"));
        QTRY_VERIFY_WITH_TIMEOUT(tile(renamed) != nullptr && tile(path) == nullptr, kPatienceMs);
        QVERIFY(tile(renamed)->isFavourite());
        SettingsStore().clear();
    }

    void tagsAreWrittenAsPeopleSayThem()
    {
        const QString path = makeOwn(QStringLiteral("Tagged"));
        beginWith(path);
        m_answers->name = QStringLiteral(" Curly,  my own  words, curly,, Long");
        Q_EMIT strip().ordered(path, Order::Tag);
        const QStringList tags{QStringLiteral("curly"), QStringLiteral("my own words"), QStringLiteral("long")};
        QCOMPARE(model::presetEntry(path)->tags, tags);
        QCOMPARE(shownTags(tags), QStringLiteral("curly, my own words, long"));
        QVERIFY(undoButton() != nullptr);
        undoButton()->click();
        QVERIFY(model::presetEntry(path)->tags.isEmpty());
        QVERIFY(undoButton() == nullptr);
    }

    void aReplacedStyleIsTheHairThatIsOpenUntilThatIsTakenBack()
    {
        const QString path = makeOwn(QStringLiteral("Replaced"));
        const QByteArray before = bytesOf(path);
        beginWith(path);
        session().document().replace(test::thinned(starterProject()));
        Q_EMIT strip().ordered(path, Order::Replace);
        const model::Result<model::Preset> now = model::loadPreset(path);
        QVERIFY(now && model::growsHair(now->groups.front()));
        QCOMPARE(now->name, QStringLiteral("Replaced"));
        undoButton()->click();
        QCOMPARE(bytesOf(path), before);
    }

    void aDeletedStyleComesBack()
    {
        const QString path = makeOwn(QStringLiteral("Deleted"));
        const QByteArray before = bytesOf(path);
        beginWith(path);
        QTest::keyClick(tile(path), Qt::Key_Delete);
        QVERIFY(!QFile::exists(path));
        QVERIFY(m_answers->said.isEmpty()); // Nobody is asked about what can be undone.
        QTRY_VERIFY_WITH_TIMEOUT(tile(path) == nullptr, kPatienceMs);
        QVERIFY(undoButton() != nullptr);
        undoButton()->click();
        QTRY_VERIFY_WITH_TIMEOUT(tile(path) != nullptr, kPatienceMs);
        QCOMPARE(bytesOf(path), before);
    }

    void aPictureIsTakenFromWhereTheHeadIsLookedAt()
    {
        const QString path = makeOwn(QStringLiteral("Pictured"));
        beginWith(path);
        QList<QImage> pictures;
        for (const char* side : {"look.front", "look.left"}) {
            trigger(side);
            Q_EMIT strip().ordered(path, Order::Picture);
            pictures.append(model::presetEntry(path)->picture);
            QVERIFY(!pictures.back().isNull());
        }
        QVERIFY(pictures.front() != pictures.back());
    }

    void manyComeInAndABrokenOneIsLeftOutAndNamed()
    {
        open(model::newProject());
        QStringList files;
        for (const char* name : {"One", "Two"}) {
            files.append(path(name) + QStringLiteral(".hairpreset"));
            QVERIFY(model::savePreset(model::presetFrom(model::newProject(), QLatin1String(name)), files.back()));
        }
        files.insert(1, path("broken.hairpreset"));
        QFile broken(files[1]);
        QVERIFY(broken.open(QIODevice::WriteOnly) && broken.write("no style") > 0);
        broken.close();
        m_window->openFiles(files);
        QCOMPARE(m_answers->said.size(), 1);
        QVERIFY2(m_answers->said.front().contains(QStringLiteral("broken.hairpreset")),
                 qPrintable(m_answers->said.front()));
        QVERIFY(m_done.contains(QStringLiteral("2 styles added to yours")));
        for (const char* name : {"One", "Two"})
            QTRY_VERIFY_WITH_TIMEOUT(tile(ownStylePath(QLatin1String(name))) != nullptr, kPatienceMs);
        // The same once more adds nothing; another of that name gets a number.
        m_answers->file = files.front();
        trigger("hair.importStyles");
        QCOMPARE(m_done.back(), QStringLiteral("You have these styles already"));
        QVERIFY(model::savePreset(model::presetFrom(test::thinned(starterProject()), QStringLiteral("One")), files[0]));
        trigger("hair.importStyles");
        QVERIFY(QFile::exists(ownStylePath(QStringLiteral("One 2"))));
        QVERIFY(!QFile::exists(ownStylePath(QStringLiteral("One 2 2"))));
    }

    void oneAndAllGoOut()
    {
        const QString own = makeOwn(QStringLiteral("Mine"));
        beginWith(own);
        m_answers->file = path("bob-out.hairpreset");
        Q_EMIT strip().ordered(QStringLiteral(":/presets/bob.hairpreset"), Order::Export);
        QCOMPARE(model::presetEntry(m_answers->file)->name, QStringLiteral("Bob"));
        QVERIFY(QDir(m_folder.path()).mkpath(QStringLiteral("out")));
        m_answers->file = path("out");
        trigger("hair.exportStyles");
        trigger("hair.exportStyles"); // What is there stays.
        QCOMPARE(QDir(path("out")).entryList(QDir::Files, QDir::Name),
                 (QStringList{QStringLiteral("mine-2.hairpreset"), QStringLiteral("mine.hairpreset")}));
    }
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestStyleFiles, Widgets)
#include "test_style_files.moc"
