// The real window at its smallest, in every language and in long words: nothing is cut off, and no underlined letters
// collide.
#include "app/session/libraries.h"
#include "app/settings/languages.h"
#include "app/styles/library.h"
#include "app/window/main_window.h"
#include "tests/support/clipping.h"
#include "tests/support/import_sample.h"
#include "tests/support/pseudo_languages.h"
#include "tests/support/seen_text.h"
#include "tests/support/test_heads.h"
#include "tests/support/test_program.h"
#include "view/dialogs/about_dialog.h"
#include "view/dialogs/hair_import_dialog.h"
#include "view/dialogs/head_import_dialog.h"
#include "view/head_area/head_view.h"
#include "view/look/resources.h"
#include "view/panels/sidebar.h"
#include "view/panels/status_readout.h"

#include <QDialog>
#include <QMenuBar>
#include <QStandardPaths>
#include <QTranslator>
#include <QtTest>

#include <algorithm>

namespace hairpaint::app {

namespace {

const QString kLongWords = QStringLiteral("long words");

} // namespace

class TestWindowFit : public QObject
{
    Q_OBJECT
private:
    std::unique_ptr<MainWindow> m_window;

    void openWindow(QSize size)
    {
        m_window = std::make_unique<MainWindow>(starterProject());
        m_window->resize(size);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    }

private Q_SLOTS:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        view::initResources();
    }
    void init() { SettingsStore().clear(); }
    void cleanup()
    {
        m_window.reset();
        qDeleteAll(qApp->findChildren<QTranslator*>(Qt::FindDirectChildrenOnly));
        QLocale::setDefault(QLocale::system());
    }

    void theChosenLanguageIsSpoken()
    {
        const auto all = languages();
        const auto spanish = std::pair(QStringLiteral("es"), QStringLiteral("Español"));
        QVERIFY(std::ranges::find(all, spanish) != all.end());
        QCOMPARE(all.front(), std::pair(QStringLiteral("en"), QStringLiteral("English")));

        QCOMPARE(speak(QStringLiteral("es")), QStringLiteral("es"));
        QCOMPARE(MainWindow::tr("&File"), QStringLiteral("&Archivo"));
        QCOMPARE(QCoreApplication::translate("QPlatformTheme", "Cancel"), QStringLiteral("Cancelar")); // Qt's own.
        if (QLocale::system().language() != QLocale::Spanish)
            QCOMPARE(QLocale().toString(2.5), QStringLiteral("2,5"));
    }

    void englishKnowsOneHairFromTwo()
    {
        QCOMPARE(speak(QStringLiteral("en")), QStringLiteral("en"));
        QCOMPARE(view::StatusReadout::tr("%Ln hairs", nullptr, 1), QStringLiteral("1 hair"));
        QCOMPARE(view::StatusReadout::tr("%Ln hairs", nullptr, 2), QStringLiteral("2 hairs"));
        QCOMPARE(MainWindow::tr("&File"), QStringLiteral("&File"));
    }

    void nothingIsCutOff_data()
    {
        QTest::addColumn<QString>("language");
        QTest::addColumn<bool>("light");
        std::vector<std::pair<QString, QString>> all = languages();
        all.emplace_back(kLongWords, kLongWords);
        for (const auto& [code, name] : all)
            for (const bool light : {false, true})
                QTest::addRow("%s, %s", qPrintable(name), light ? "light" : "dark") << code << light;
    }
    void nothingIsCutOff()
    {
        QFETCH(QString, language);
        QFETCH(bool, light);
        if (language == kLongWords)
            QCoreApplication::installTranslator(new test::LongWords(qApp));
        else
            QCOMPARE(speak(language), language);
        view::Preferences preferences;
        preferences.theme = light ? view::ThemeKind::Light : view::ThemeKind::Dark;
        Settings().setPreferences(preferences);
        openWindow({400, 300});
        QCOMPARE(m_window->size(), QSize(960, 600)); // Its words do not widen it.
        QStringList cut;
        const auto measure = [&cut, &language](QWidget& widget) {
            // A new layout takes its time where the hair is drawn by the same processor.
            if (!QTest::qWaitFor([&widget] { return test::clipped(widget).isEmpty(); }, 2000))
                cut += test::clipped(widget);
            if (language == kLongWords)
                return;
            // What the panels draw by themselves they shorten where it does not fit.
            for (const QString& text : test::paintedTexts(widget))
                if (text.endsWith(QChar(0x2026)) &&
                    text != QCoreApplication::translate("hairpaint::view::ValuePalette", "Custom…") &&
                    text != QCoreApplication::translate("hairpaint::view::PictureDialog", "Save…") &&
                    text != QCoreApplication::translate("hairpaint::view::ViewSigns", "Refining…"))
                    cut.append(text);
        };
        view::EditorState& editor = m_window->session().editor();
        for (const auto& tool : editor.tools().all()) {
            editor.tools().choose(tool->id());
            for (const model::MapSpec& spec : model::mapSpecs()) {
                editor.target().setMap(spec.kind);
                measure(*m_window);
            }
        }
        auto* sidebar = m_window->findChild<view::Sidebar*>();
        sidebar->showHair();
        measure(*m_window);
        for (const char* id : {"hair.windDialog", "hair.lightDialog", "edit.preferences", "help.help", "file.picture"})
            m_window->actions().find(QLatin1StringView(id))->trigger();
        for (QDialog* dialog : m_window->findChildren<QDialog*>()) {
            QVERIFY(QTest::qWaitForWindowExposed(dialog));
            measure(*dialog);
            for (auto* pages : dialog->findChildren<QTabWidget*>())
                for (int i = 0; i < pages->count(); ++i) {
                    pages->setCurrentIndex(i);
                    measure(*dialog);
                }
        }
        view::AboutDialog about(QStringLiteral("0.1.0"), librariesInUse(), m_window->headView().rendererDescription());
        view::HeadImportDialog import(test::makeBallHead(), QStringLiteral("head.obj"));
        view::HairImportDialog hair(test::importSample(), QStringLiteral("long.hair"));
        for (QDialog* dialog : std::initializer_list<QDialog*>{&about, &import, &hair}) {
            dialog->show();
            QVERIFY(QTest::qWaitForWindowExposed(dialog));
            measure(*dialog);
        }
        cut.removeDuplicates();
        QVERIFY2(cut.isEmpty(), qPrintable(cut.join(QStringLiteral("; "))));
    }

    void underlinedLettersDoNotCollideInAMenu_data()
    {
        QTest::addColumn<QString>("language");
        for (const auto& [code, name] : languages())
            QTest::newRow(qPrintable(name)) << code;
    }
    void underlinedLettersDoNotCollideInAMenu()
    {
        QFETCH(QString, language);
        speak(language);
        openWindow({1280, 800});
        QStringList collisions;
        const auto check = [&collisions](const QList<QAction*>& actions) {
            QHash<QChar, QString> owners;
            static const QRegularExpression underlined(QStringLiteral("(?<!&)&(\\w)"));
            for (const QAction* action : actions) {
                const QString text = QString(action->text()).remove(QStringLiteral("&&"));
                const QRegularExpressionMatch match = underlined.match(text);
                if (!match.hasMatch())
                    continue;
                const QChar letter = match.captured(1).at(0).toLower();
                if (owners.contains(letter))
                    collisions.append(owners.value(letter) + QStringLiteral(" and ") + text);
                owners.insert(letter, text);
            }
        };
        check(m_window->menuBar()->actions());
        QVERIFY(m_window->menuBar()->actions().size() > 5);
        for (const QMenu* menu : m_window->menuBar()->findChildren<QMenu*>())
            check(menu->actions());
        QVERIFY2(collisions.isEmpty(), qPrintable(collisions.join(QStringLiteral("; "))));
    }
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestWindowFit, Widgets)
#include "test_window_fit.moc"
