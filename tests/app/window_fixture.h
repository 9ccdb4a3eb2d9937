// The real window with a project in it, driven by mouse and keys.
#pragma once

#include "app/styles/library.h"
#include "app/window/main_window.h"
#include "model/files/preset_file.h"
#include "model/files/project_file.h"
#include "model/styles/style_use.h"
#include "tests/app/thin_project.h"
#include "tests/support/await.h"
#include "tests/support/head_picture.h"
#include "view/head_area/head_view.h"
#include "view/look/resources.h"
#include "view/paint_area/paint_view.h"
#include "view/panels/style_strip.h"

#include <QDialog>
#include <QElapsedTimer>
#include <QFile>
#include <QPointer>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QUndoStack>
#include <QtTest>

#include <memory>

namespace hairpaint::app {

using test::kPatienceMs;

/// Fraction of pixels that differ, by more than `least` of all channels, between two pictures of one size.
inline double difference(const QImage& a, const QImage& b, int least = 40)
{
    if (a.size() != b.size() || a.isNull())
        return 1.0;
    int differing = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            const QRgb p = a.pixel(x, y);
            const QRgb q = b.pixel(x, y);
            if (std::abs(qRed(p) - qRed(q)) + std::abs(qGreen(p) - qGreen(q)) + std::abs(qBlue(p) - qBlue(q)) > least)
                ++differing;
        }
    return static_cast<double>(differing) / (static_cast<double>(a.width()) * a.height());
}

/// Those beside the window that keep nothing waiting. They go when they are done.
inline QList<QPointer<QDialog>> openDialogs(const QWidget& window)
{
    QList<QPointer<QDialog>> open;
    for (QDialog* dialog : window.findChildren<QDialog*>(Qt::FindDirectChildrenOnly))
        if (dialog->isVisible() && !dialog->isModal())
            open.append(dialog);
    return open;
}

class WindowFixture
{
protected:
    QTemporaryDir m_folder;
    std::unique_ptr<MainWindow> m_window;
    float m_stepM = 0.0F;

    [[nodiscard]] Session& session() { return m_window->session(); }
    [[nodiscard]] view::EditorState& editor() { return m_window->session().editor(); }
    [[nodiscard]] QUndoStack& stack() { return session().document().undoStack(); }
    [[nodiscard]] std::size_t hairs() { return session().frame() ? session().frame()->hairCount : 0; }

    /// Few hairs do for most of what a window shows.
    void openWindow(model::Project project) { openWholeWindow(test::thinned(std::move(project))); }

    void openWholeWindow(model::Project project)
    {
        m_window = std::make_unique<MainWindow>(std::move(project));
        m_window->resize(1280, 800);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        m_window->activateWindow();
        QTRY_VERIFY_WITH_TIMEOUT(session().frame() != nullptr, kPatienceMs);
        auto* styles = m_window->findChild<view::StyleStrip*>();
        QTRY_VERIFY_WITH_TIMEOUT(!styles->paths().empty(), kPatienceMs); // They are read in the background.
        editor().options().setMirror(false);
    }

    /// A built-in style on the built-in head, by its file's name.
    void openWithStyle(const char* id)
    {
        model::Project project = model::newProject();
        const auto preset = model::loadPreset(QStringLiteral(":/presets/%1.hairpreset").arg(QLatin1StringView(id)));
        QVERIFY(preset.has_value());
        model::applyPreset(project, *preset);
        openWindow(std::move(project));
        awaitNewestHair();
        QVERIFY(hairs() > 500);
    }

    /// Waits for the hair of the newest content, at rest: a step of the head that is too small to be seen goes to the
    /// simulation after that content and comes back with its frame.
    void awaitNewestHair()
    {
        test::handleDueEvents(); // Content is sent when the event loop has nothing else to do.
        m_stepM += 1e-6F;
        session().setPose({.rotation = {1.0F, 0.0F, 0.0F, 0.0F}, .positionWo = {m_stepM, 0.0F, 0.0F}});
        session().resetHair();
        QTRY_COMPARE_WITH_TIMEOUT(session().frame()->pose.positionWo.x, m_stepM, kPatienceMs);
    }

    /// Until nothing is seen to move and the 3D area's picture is as fine as it gets.
    void awaitFinePicture()
    {
        view::HeadView& head = m_window->headView();
        const auto isFine = [&head] { return !head.awake() && !head.refining(); };
        QTRY_VERIFY_WITH_TIMEOUT(isFine(), kPatienceMs);
        // One that was asked for is begun before this one, and has told so then.
        QVERIFY(!test::pictureOf(head, QSize(8, 8)).isNull());
        test::handleDueEvents();
        QTRY_VERIFY_WITH_TIMEOUT(isFine(), kPatienceMs);
    }

    /// What takes long is shown, and left after Cancel, fifty times as soon.
    void hurryJobs()
    {
        QElapsedTimer clock;
        clock.start();
        m_window->jobs().setClock([clock] { return 50 * clock.elapsed(); });
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

    /// The widget of the 3D area that takes the pointer, and where it shows a point of the skin.
    [[nodiscard]] std::pair<QWidget*, QPoint> onHead(float u, float v)
    {
        view::HeadView& head = m_window->headView();
        const sim::SurfacePoint point = *session().document().project().head->skin->atUv({u, v});
        const QPoint position = head.positionOf(point.positionHd).value().toPoint();
        QWidget* target = head.childAt(position) != nullptr ? head.childAt(position) : &head;
        return {target, target->mapFrom(&head, position)};
    }

    /// The active layer's value and coverage there, as committed.
    [[nodiscard]] sim::Texel texelAt(float u, float v)
    {
        const model::LayerAddress at = editor().target().address();
        const sim::TiledRaster& raster = session().document().committed().layer(at.group, at.map, at.layer)->raster;
        const auto size = static_cast<float>(raster.size());
        return raster.texel(static_cast<int>(u * size), static_cast<int>((1.0F - v) * size));
    }

    [[nodiscard]] QImage picture() { return test::pictureOf(m_window->headView(), QSize(320, 320)); }

    [[nodiscard]] QByteArray savedBytes(const char* name)
    {
        const QString path = m_folder.filePath(QString::fromLatin1(name));
        if (!model::saveProject(session().document().committed(), path, {}))
            return {};
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

    /// Settings and styles of the test's own.
    static void prepareApplication()
    {
        QStandardPaths::setTestModeEnabled(true);
        SettingsStore().clear();
        for (const auto& folder : JournalFolder::abandoned(JournalFolder::root()))
            folder->remove(); // Former tests left windows open, whose journals are still there.
        // A display can carry the QOpenGLWidget, also where OpenGL is software.
        if (QGuiApplication::platformName() == QLatin1String("xcb")) {
            view::Preferences preferences;
            preferences.presenter = view::PresenterChoice::Gl;
            Settings().setPreferences(preferences);
        }
        view::initResources();
    }
};

} // namespace hairpaint::app
