// The window: connects what it shows with what it works on, and takes dropped files.
#pragma once

#include "app/background/journal.h"
#include "app/background/journal_folder.h"
#include "app/exchange/exchange.h"
#include "app/project/project_files.h"
#include "app/session/freed_memory.h"
#include "app/session/session.h"
#include "app/settings/dialog_positions.h"
#include "app/settings/settings.h"
#include "app/window/action_set.h"
#include "app/window/clip_commands.h"
#include "app/window/first_hair.h"
#include "app/window/focus_return.h"
#include "app/window/live_preferences.h"
#include "app/window/position_keys.h"
#include "app/window/window_dialogs.h"

#include <QMainWindow>

#include <memory>

namespace hairpaint::view {
class HeadView;
class PaintView;
} // namespace hairpaint::view

namespace hairpaint::app {

class FileMenu;
class Workspace;

/// Owns the session and everything that works on it. GUI thread.
class MainWindow : public QMainWindow
{
    Q_OBJECT
public:
    /// `project`: what it opens with, a new one; files are opened afterwards.
    explicit MainWindow(model::Project project, std::unique_ptr<Settings> settings = std::make_unique<Settings>());
    ~MainWindow() override;

    [[nodiscard]] Session& session() { return m_session; }
    [[nodiscard]] ProjectFiles& files() { return m_files; }
    [[nodiscard]] Jobs& jobs() { return m_jobs; }
    [[nodiscard]] ActionSet& actions() { return m_actions; }
    [[nodiscard]] view::PaintView& paintView();
    [[nodiscard]] view::HeadView& headView();

    /// The first action: offers unsaved work, then opens `file`, if any. A project whose unsaved work was
    /// restored is open then; nor is what was restored replaced by another one.
    void begin(const QString& file);
    /// Offers the unsaved work of windows that ended; does nothing if there is none. That on
    /// `file` is offered first. Returns whether some was restored.
    bool offerUnsavedWork(const QString& file = {});
    /// For ending without asking: writes all steps to the journal before it returns.
    void keepWork();
    /// Whether all steps are in the journal.
    [[nodiscard]] Journal& journal() { return m_journal; }
    [[nodiscard]] bool isWorkKept() { return m_journal.idle() && !m_journal.isStopped(); }

    /// Opens a project, applies a style, imports a mesh or an image: whatever the file is.
    void openFile(const QString& path);
    /// Several images go to the maps that their names tell; of anything else the first is opened.
    void openFiles(const QStringList& paths);

protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dragLeaveEvent(QDragLeaveEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;

private:
    void buildMenus();
    void offerActions();
    void followActions();
    void connectSession();
    void connectAreas();
    void connectFiles();

    void applyPreferences();
    /// Where the window lies, and what the tools are set to.
    void rememberGeometry();
    void showTitle();
    /// Called when restored work has been kept elsewhere.
    void forgetRestored();

    std::unique_ptr<Settings> m_ownSettings;
    Settings& m_settings;
    Session m_session;
    FirstHair m_firstHair;
    Jobs m_jobs;
    FreedMemory m_freedMemory;
    ProjectFiles m_files;
    Journal m_journal;
    std::unique_ptr<JournalFolder> m_restored; ///< Whence this window's work came, until that is kept elsewhere.
    Exchange m_exchange;
    ActionSet m_actions;
    LivePreferences m_preferences;
    ClipCommands m_clipCommands;
    WindowDialogs m_dialogs;
    FocusReturn m_focusReturn;
    DialogPositions m_dialogPositions;

    Workspace* m_workspace = nullptr;
    std::unique_ptr<PositionKeys> m_keys;
    FileMenu* m_fileMenu = nullptr;
};

} // namespace hairpaint::app
