// The real window in other languages: in one whose every letter is marked no plain word is seen, and nothing is cut
// off.
#include "app/session/libraries.h"
#include "app/styles/library.h"
#include "app/window/main_window.h"
#include "model/document/group_commands.h"
#include "model/styles/hair_kinds.h"
#include "model/values/names.h"
#include "tests/support/import_sample.h"
#include "tests/support/patience.h"
#include "tests/support/pseudo_languages.h"
#include "tests/support/seen_text.h"
#include "tests/support/test_heads.h"
#include "tests/support/test_program.h"
#include "view/dialogs/hair_import_dialog.h"
#include "view/dialogs/head_import_dialog.h"
#include "view/head_area/head_view.h"
#include "view/look/resources.h"
#include "view/paint_area/paint_view.h"
#include "view/panels/sidebar.h"

#include <QDialog>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QLabel>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QPainter>
#include <QStandardPaths>
#include <QSysInfo>
#include <QTemporaryDir>
#include <QUndoStack>
#include <QtTest>

namespace hairpaint::app {

namespace {

using test::kPatienceMs;

/// What is the same in every language. Everything else that is seen must have gone through the translation.
QString withoutExceptions(QString text, const QString& driver)
{
    static const QList<QRegularExpression> kExceptions = {
        QRegularExpression(QStringLiteral("Hair Paint|OpenGL|Qt \\d[\\d.]*")), // Products.
        QRegularExpression(QStringLiteral("English|Español")),                 // Languages call themselves so.
        QRegularExpression(QStringLiteral("#[0-9a-f]{6}")),                    // Colours.
        QRegularExpression(
            QStringLiteral("[\\w/\\\\:.-]*\\.(hairpaint|hairpreset|png|obj|hair|glb|vrm|usda|usdz)\\b")), // Files.
        QRegularExpression(QStringLiteral("\\b(PNG|TIF|EXR|TGA)\\b")),                                    // Formats.
        QRegularExpression(QStringLiteral("\\bScalp\\b")),    // What the user calls a group.
        QRegularExpression(QStringLiteral("\\(\\*[^)]*\\)")), // Endings of files.
    };
    for (const QRegularExpression& exception : kExceptions)
        text.remove(exception);
    for (const QString& library : librariesInUse()) // A line may break at each of its spaces.
        for (const QString& word : library.section(QLatin1Char(' '), 0, -2).split(QLatin1Char(' ')))
            text.remove(word);
    return text.remove(QSysInfo::prettyProductName()).remove(driver);
}

/// A plain word of two letters or more; a single letter is a key or a map's sign.
bool isForeign(const QString& text, const QString& driver = {})
{
    static const QRegularExpression word(QStringLiteral("[A-Za-z]{2,}"));
    return withoutExceptions(text, driver).contains(word);
}

QStringList foreignOf(QStringList texts, const QString& driver = {})
{
    texts.removeIf([&driver](const QString& text) { return !isForeign(text, driver); });
    texts.removeDuplicates();
    return texts;
}

QStringList foreignIn(QWidget& widget, const QString& driver = {})
{
    return foreignOf(test::paintedTexts(widget) + test::carriedTexts(widget), driver);
}

/// Lets go of every dialog that waits for an answer, after a look at it.
class DialogCloser : public QObject
{
public:
    explicit DialogCloser(std::function<void(QDialog&)> look) : m_look(std::move(look)) { m_timer = startTimer(20); }
    [[nodiscard]] int closed() const { return m_closed; }

protected:
    void timerEvent(QTimerEvent* /*event*/) override
    {
        auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
        if (dialog == nullptr)
            return;
        m_look(*dialog);
        ++m_closed;
        dialog->reject();
    }

private:
    std::function<void(QDialog&)> m_look;
    int m_timer = 0;
    int m_closed = 0;
};

} // namespace

class TestSpokenWindow : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_folder;
    std::unique_ptr<QTranslator> m_language;
    std::unique_ptr<MainWindow> m_window;
    QStringList m_foreign;
    QString m_driver; ///< What the graphics driver calls itself.

    [[nodiscard]] view::EditorState& editor() { return m_window->session().editor(); }
    [[nodiscard]] QUndoStack& stack() { return m_window->session().document().undoStack(); }

    void speakLanguage(std::unique_ptr<QTranslator> language)
    {
        m_language = std::move(language);
        if (m_language)
            QCoreApplication::installTranslator(m_language.get());
    }

    void openWindow()
    {
        m_window = std::make_unique<MainWindow>(starterProject());
        m_window->resize(1280, 800);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        QTRY_VERIFY_WITH_TIMEOUT(m_window->session().frame() != nullptr, kPatienceMs);
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->headView().rendererDescription().isEmpty(), kPatienceMs);
        m_driver = m_window->headView().rendererDescription();
    }

    void look(QWidget& widget)
    {
        m_foreign += foreignIn(widget, m_driver);
        m_foreign.removeDuplicates();
    }

    /// File dialogs show the machine's own files, so only their words are read.
    void lookAtDialog(QDialog& dialog)
    {
        if (const auto* files = qobject_cast<QFileDialog*>(&dialog))
            m_foreign += foreignOf(files->nameFilters() << files->windowTitle());
        else if (qobject_cast<QMessageBox*>(&dialog) != nullptr) // Wraps names of files anywhere.
            m_foreign += foreignOf(test::carriedTexts(dialog), m_driver);
        else
            look(dialog);
    }

    void drag(QPoint from, QPoint to)
    {
        view::PaintView& area = m_window->paintView();
        QTest::mouseMove(&area, from);
        QTest::mousePress(&area, Qt::LeftButton, {}, from);
        for (int i = 1; i <= 4; ++i)
            QTest::mouseMove(&area, from + (to - from) * i / 4);
        QTest::mouseRelease(&area, Qt::LeftButton, {}, to);
    }

    [[nodiscard]] QPoint paintPoint(float u, float v) { return m_window->paintView().positionOf({u, v}).toPoint(); }

    [[nodiscard]] QList<QAction*> everyAction() const
    {
        QList<QAction*> actions;
        for (QMenu* menu : m_window->findChildren<QMenu*>())
            for (QAction* action : menu->actions())
                if (!action->isSeparator() && action->menu() == nullptr && !actions.contains(action))
                    actions.append(action);
        return actions;
    }

    [[nodiscard]] QString broken(const char* name, const QByteArray& content)
    {
        const QString path = m_folder.filePath(QString::fromLatin1(name));
        QFile file(path);
        if (file.open(QIODevice::WriteOnly))
            file.write(content);
        return path;
    }

private Q_SLOTS:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        view::initResources();
    }
    void init()
    {
        SettingsStore().clear();
        m_foreign.clear();
    }
    void cleanup()
    {
        m_window.reset();
        m_language.reset();
    }

    void aPlainWordIsFoundWhereverItStands()
    {
        QLabel label(QStringLiteral("No one translated this"));
        QVERIFY(!foreignOf(test::paintedTexts(label)).isEmpty());
        label.setText(test::MarkedLetters().translate("", "Brush on %1", nullptr, -1));
        QVERIFY(foreignIn(label).isEmpty());
        label.setToolTip(QStringLiteral("nor this"));
        QCOMPARE(foreignIn(label), QStringList{QStringLiteral("nor this")});
        label.setToolTip({});

        struct Painter : QWidget
        {
            void paintEvent(QPaintEvent* /*event*/) override
            {
                QPainter(this).drawText(10, 20, QStringLiteral("painted by hand"));
            }
        } painter;
        painter.resize(200, 40);
        QCOMPARE(foreignIn(painter), QStringList{QStringLiteral("painted by hand")});
    }

    void everyWordOfTheWindowIsTranslated()
    {
        speakLanguage(std::make_unique<test::MarkedLetters>());
        openWindow();
        look(*m_window);
        auto* sidebar = m_window->findChild<view::Sidebar*>();
        for (const model::MapSpec& spec : model::mapSpecs()) {
            editor().target().setMap(spec.kind);
            QTest::mouseMove(&m_window->paintView(), paintPoint(0.5F, 0.5F));
            for (const auto& tool : editor().tools().all()) {
                editor().tools().choose(tool->id());
                look(*m_window);
            }
        }
        sidebar->showHair();
        look(*sidebar);
        m_window->headView().setWeatherShown(true);
        look(*m_window);
        for (const char* file : {"a.hairpaint", "a.hairpreset", "a.glb", "a.png"}) {
            QMimeData dragged;
            dragged.setUrls({QUrl::fromLocalFile(m_folder.filePath(QString::fromLatin1(file)))});
            QDragEnterEvent enter(QPoint(300, 300), Qt::CopyAction, &dragged, Qt::LeftButton, Qt::NoModifier);
            QApplication::sendEvent(m_window.get(), &enter);
            QVERIFY(enter.isAccepted());
            look(*m_window);
        }
        QVERIFY2(m_foreign.isEmpty(), qPrintable(m_foreign.join(QStringLiteral(" | "))));
    }

    void everyActionAndItsDialogIsTranslated()
    {
        speakLanguage(std::make_unique<test::MarkedLetters>());
        openWindow();
        DialogCloser closer([this](QDialog& dialog) { lookAtDialog(dialog); });
        editor().target().setMap(model::MapKind::Length);
        for (QAction* action : everyAction()) {
            if (action->objectName() == QLatin1String("file.quit"))
                continue;
            action->trigger();
            for (QDialog* dialog : m_window->findChildren<QDialog*>())
                if (dialog->isVisible()) {
                    lookAtDialog(*dialog);
                    dialog->close();
                }
            look(*m_window);
        }
        QVERIFY(closer.closed() > 5);
        QVERIFY(stack().count() > 4);
        for (int i = 0; i < stack().count(); ++i)
            m_foreign += foreignOf({stack().text(i)});
        QVERIFY2(m_foreign.isEmpty(), qPrintable(m_foreign.join(QStringLiteral(" | "))));
    }

    void whatUndoCallsEachChangeIsTranslated()
    {
        speakLanguage(std::make_unique<test::MarkedLetters>());
        openWindow();
        editor().target().setMap(model::MapKind::Density);
        const auto use = [this](model::ToolId tool) {
            editor().tools().choose(tool);
            drag(paintPoint(0.45F, 0.5F), paintPoint(0.55F, 0.52F));
        };
        using enum model::ToolId;
        for (const model::ToolId tool : {Brush, Eraser, Gradient, Fill, Shape, Select})
            use(tool);
        auto* sidebar = m_window->findChild<view::Sidebar*>();
        sidebar->layers().addLayer();
        sidebar->layers().duplicateLayer();
        sidebar->layers().moveLayer(-1);
        sidebar->layers().removeLayer();
        sidebar->hair().addGroup(model::hairKinds().back());
        look(*m_window);
        sidebar->showHair();
        look(*m_window);
        m_window->openFile(model::listPresets({}).at(2).path);
        m_window->session().toggleWind();
        m_window->session().changeLight({}, true);
        look(*m_window);
        QVERIFY2(stack().count() >= 10, qPrintable(QString::number(stack().count())));
        for (int i = 0; i < stack().count(); ++i)
            m_foreign += foreignOf({stack().text(i)});
        QVERIFY2(m_foreign.isEmpty(), qPrintable(m_foreign.join(QStringLiteral(" | "))));
    }

    void everyErrorIsTranslated()
    {
        speakLanguage(std::make_unique<test::MarkedLetters>());
        openWindow();
        DialogCloser closer([this](QDialog& dialog) { lookAtDialog(dialog); });
        const QStringList files = {
            m_folder.filePath(QStringLiteral("missing.hairpaint")),
            broken("empty.hairpaint", {}),
            broken("text.hairpaint", "no project"),
            broken("zip.hairpaint", QByteArray("PK\003\004") + QByteArray(200, 'x')),
            broken("style.hairpreset", "no style"),
            broken("picture.png", "no picture"),
            broken("mesh.obj", "no mesh"),
            broken("flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
        };
        for (const QString& file : files)
            m_window->openFile(file);
        QCOMPARE(closer.closed(), static_cast<int>(files.size()));

        model::Document& document = m_window->session().document();
        model::HairGroup group = document.project().groups.front();
        document.push(model::showGroupCommand(document, group.id, false));
        editor().tools().choose(model::ToolId::Brush);
        drag(paintPoint(0.45F, 0.5F), paintPoint(0.55F, 0.52F));
        look(*m_window);
        QVERIFY2(m_foreign.isEmpty(), qPrintable(m_foreign.join(QStringLiteral(" | "))));
    }

    void theImportDialogsAreTranslated()
    {
        speakLanguage(std::make_unique<test::MarkedLetters>());
        view::HeadImportDialog head(test::makeBallHead(), QStringLiteral("head.obj"));
        view::HairImportDialog hair(test::importSample(), QStringLiteral("long.hair"));
        for (QDialog* dialog : std::initializer_list<QDialog*>{&head, &hair}) {
            dialog->show();
            look(*dialog);
        }
        QVERIFY2(m_foreign.isEmpty(), qPrintable(m_foreign.join(QStringLiteral(" | "))));
    }

    void namesThatTheProgramGaveAreTranslatedWhereTheyAreShown()
    {
        speakLanguage(std::make_unique<test::MarkedLetters>());
        for (const model::PresetEntry& entry : model::listPresets({})) {
            QVERIFY2(!isForeign(model::shownName(entry.name)), qPrintable(entry.name));
            for (const QString& tag : entry.tags)
                QVERIFY2(!isForeign(model::shownName(tag)), qPrintable(tag));
        }
        QVERIFY(!isForeign(model::shownName(model::layerName(12))));
        QVERIFY(model::shownName(model::layerName(12)).endsWith(QStringLiteral("12")));
        QCOMPARE(model::shownName(QStringLiteral("My own")), QStringLiteral("My own"));
        // Files are the same in every language.
        const model::Project project = model::newProject();
        QCOMPARE(project.groups.front().name, QStringLiteral("Scalp"));
        QCOMPARE(project.groups.front().maps.front()->layers.front().name, QStringLiteral("Layer 1"));
    }
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestSpokenWindow, Widgets)
#include "test_spoken_window.moc"
