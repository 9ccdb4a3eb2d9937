// The real window, driven with mouse and keys, 3D pixels included. Runs on platforms offscreen and xcb alike.
#include "app/library.h"
#include "app/main_window.h"
#include "model/files/project_file.h"
#include "view/head_view.h"
#include "view/paint_view.h"
#include "view/resources.h"

#include <QFile>
#include <QMessageBox>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QUndoStack>
#include <QtTest>

namespace hairpaint::app {

namespace {

constexpr int kPatienceMs = 60'000;

/// Share of pixels that differ clearly between two pictures of one size.
double difference(const QImage& a, const QImage& b)
{
    if (a.size() != b.size() || a.isNull())
        return 1.0;
    int differing = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            const QRgb p = a.pixel(x, y);
            const QRgb q = b.pixel(x, y);
            if (std::abs(qRed(p) - qRed(q)) + std::abs(qGreen(p) - qGreen(q)) + std::abs(qBlue(p) - qBlue(q)) > 40)
                ++differing;
        }
    return static_cast<double>(differing) / (static_cast<double>(a.width()) * a.height());
}

} // namespace

class TestWindow : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_folder;
    std::unique_ptr<MainWindow> m_window;

    [[nodiscard]] Session& session() { return m_window->session(); }
    [[nodiscard]] view::EditorState& editor() { return m_window->session().editor(); }
    [[nodiscard]] std::size_t hairs() { return session().frame() ? session().frame()->hairCount : 0; }

    void openWindow(model::Project project)
    {
        m_window = std::make_unique<MainWindow>(std::move(project), QString());
        m_window->resize(1280, 800);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        m_window->activateWindow();
        QTRY_VERIFY_WITH_TIMEOUT(session().frame() != nullptr, kPatienceMs);
        editor().setMirror(false);
    }

    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
    {
        m_window->paintView().setFocus();
        QTest::keyClick(&m_window->paintView(), key, modifiers);
    }

    void drag(QWidget& area, QPoint from, QPoint to)
    {
        QTest::mouseMove(&area, from);
        QTest::mousePress(&area, Qt::LeftButton, {}, from);
        for (int i = 1; i <= 12; ++i)
            QTest::mouseMove(&area, from + (to - from) * i / 12);
        QTest::mouseRelease(&area, Qt::LeftButton, {}, to);
    }

    [[nodiscard]] QPoint paintPoint(float u, float v) { return m_window->paintView().positionOf({u, v}).toPoint(); }

    [[nodiscard]] QImage picture() { return m_window->headView().grabPicture(QSize(320, 320)); }

    [[nodiscard]] QByteArray savedBytes(const char* name)
    {
        const QString path = m_folder.filePath(QString::fromLatin1(name));
        if (!model::saveProject(session().document().committed(), path, {}))
            return {};
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

private Q_SLOTS:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        QSettings().clear();
        // A display can carry the QOpenGLWidget, also where OpenGL is software.
        if (QGuiApplication::platformName() == QLatin1String("xcb")) {
            view::Preferences preferences;
            preferences.presenter = view::PresenterChoice::Gl;
            Settings().setPreferences(preferences);
        }
        view::initResources();
    }

    void cleanup() { m_window.reset(); }

    void paintingDensityGrowsHairAndUndoTakesItAway()
    {
        openWindow(model::newProject());
        session().toggleWind();
        const QByteArray before = savedBytes("before.hairpaint");
        const QImage bald = picture();
        QCOMPARE(hairs(), std::size_t{0});

        key(Qt::Key_1);
        QCOMPARE(editor().activeMap(), model::MapKind::Density);
        key(Qt::Key_B);
        drag(m_window->paintView(), paintPoint(0.40F, 0.5F), paintPoint(0.60F, 0.5F));
        QTRY_VERIFY_WITH_TIMEOUT(hairs() > 500, kPatienceMs);
        QVERIFY(!bald.isNull());
        QTRY_VERIFY_WITH_TIMEOUT(difference(bald, picture()) > 0.005, kPatienceMs);
        QCOMPARE(session().document().undoStack().undoText(), QStringLiteral("Brush on Density"));

        key(Qt::Key_Z, Qt::ControlModifier);
        QTRY_COMPARE_WITH_TIMEOUT(hairs(), std::size_t{0}, kPatienceMs);
        QVERIFY(savedBytes("after.hairpaint") == before);
        key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_VERIFY_WITH_TIMEOUT(hairs() > 500, kPatienceMs);
    }

    void paintingOnTheHeadGrowsHairThere()
    {
        openWindow(model::newProject());
        key(Qt::Key_1);
        view::HeadView& head = m_window->headView();
        const sim::SurfacePoint crown = *session().document().project().head->skin->atUv({0.5F, 0.47F});
        const QPoint place = head.positionOf(crown.positionHd).value().toPoint();
        QWidget* target = head.childAt(place) != nullptr ? head.childAt(place) : &head;
        const QPoint local = target->mapFrom(&head, place);
        drag(*target, local, local + QPoint(12, 4));
        QTRY_VERIFY_WITH_TIMEOUT(hairs() > 100, kPatienceMs);
        QCOMPARE(session().document().undoStack().count(), 1);
    }

    void gradientCopyAndPasteAreOneStepEach()
    {
        openWindow(starterProject());
        QUndoStack& stack = session().document().undoStack();
        key(Qt::Key_2);
        key(Qt::Key_G);
        drag(m_window->paintView(), paintPoint(0.5F, 0.65F), paintPoint(0.5F, 0.35F));
        QCOMPARE(stack.count(), 1);
        key(Qt::Key_M);
        drag(m_window->paintView(), paintPoint(0.45F, 0.55F), paintPoint(0.55F, 0.45F));
        QVERIFY(editor().selection().rectangle().has_value());
        key(Qt::Key_C, Qt::ControlModifier);
        key(Qt::Key_3);
        key(Qt::Key_V, Qt::ControlModifier);
        QCOMPARE(stack.count(), 2);
        QVERIFY(stack.undoText().contains(QStringLiteral("Curl")));
        key(Qt::Key_Delete);
        QCOMPARE(stack.count(), 3);
    }

    void aStyleSavesAndReopensTheSame()
    {
        openWindow(model::newProject());
        const QString path = m_folder.filePath(QStringLiteral("style.hairpaint"));
        const QString style = model::listPresets({}).at(1).path;
        m_window->openFile(style);
        QCOMPARE(session().document().undoStack().count(), 1);
        QTRY_VERIFY_WITH_TIMEOUT(hairs() > 10'000, kPatienceMs);
        const std::size_t count = hairs();
        const QByteArray bytes = savedBytes("style.hairpaint");
        QVERIFY(!bytes.isEmpty());
        session().document().markSaved();

        m_window->files().newProject();
        QVERIFY(m_window->files().openPath(path));
        QTRY_COMPARE_WITH_TIMEOUT(hairs(), count, kPatienceMs);
        QVERIFY(savedBytes("again.hairpaint") == bytes);
        QVERIFY(!session().document().modified());
    }

    void escapeCancelsAStroke()
    {
        openWindow(starterProject());
        const QByteArray before = savedBytes("escape-before.hairpaint");
        key(Qt::Key_2);
        view::PaintView& area = m_window->paintView();
        QTest::mousePress(&area, Qt::LeftButton, {}, paintPoint(0.5F, 0.5F));
        QTest::mouseMove(&area, paintPoint(0.55F, 0.5F));
        QVERIFY(editor().stroking());
        QTest::keyClick(&area, Qt::Key_Escape);
        QVERIFY(!editor().stroking());
        QTest::mouseRelease(&area, Qt::LeftButton, {}, paintPoint(0.55F, 0.5F));
        QCOMPARE(session().document().undoStack().count(), 0);
        QVERIFY(savedBytes("escape-after.hairpaint") == before);
    }

    void theHairMovesInTheWindAndStopsWhenPaused()
    {
        openWindow(starterProject());
        QTRY_VERIFY_WITH_TIMEOUT(hairs() > 10'000, kPatienceMs);
        const std::uint64_t first = session().frame()->number;
        QTRY_VERIFY_WITH_TIMEOUT(session().frame()->number > first + 3, kPatienceMs);
        key(Qt::Key_F8);
        QVERIFY(session().paused());
        // Frames that were on their way still come.
        std::uint64_t last = 0;
        for (int tries = 0; tries < 20 && last != session().frame()->number; ++tries) {
            last = session().frame()->number;
            QTest::qWait(500);
        }
        QCOMPARE(session().frame()->number, last);
        QTest::qWait(500);
        QCOMPARE(session().frame()->number, last);
    }

    void aBrokenFileLeavesTheOpenProjectUntouched()
    {
        openWindow(starterProject());
        const QByteArray before = savedBytes("kept.hairpaint");
        const QString broken = m_folder.filePath(QStringLiteral("broken.hairpaint"));
        QFile file(broken);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("no project");
        file.close();
        QString said;
        QTimer closer;
        connect(&closer, &QTimer::timeout, this, [&said] {
            if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
                said = box->text();
                box->accept();
            }
        });
        closer.start(50);
        QVERIFY(!m_window->files().openPath(broken));
        QVERIFY2(said.contains(QStringLiteral("broken.hairpaint")), qPrintable(said));
        QVERIFY(savedBytes("kept-after.hairpaint") == before);
    }

    void everyActionHasATextAndKeysAreUnique()
    {
        openWindow(model::newProject());
        QHash<QKeySequence, QString> owners;
        for (const view::KeyBinding& binding : m_window->actions().bindings()) {
            QVERIFY(!binding.action->text().isEmpty());
            if (binding.defaultKey.isEmpty())
                continue;
            QVERIFY2(!owners.contains(binding.defaultKey),
                     qPrintable(binding.action->objectName() + QLatin1Char(' ') + owners.value(binding.defaultKey)));
            owners.insert(binding.defaultKey, binding.action->objectName());
        }
        QVERIFY(owners.size() > 30);
    }
};

} // namespace hairpaint::app

QTEST_MAIN(hairpaint::app::TestWindow)
#include "test_window.moc"
