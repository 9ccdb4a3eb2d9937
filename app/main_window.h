// The window: the paper's three zones, their menus and keys.
#pragma once

#include "app/action_set.h"
#include "app/exchange.h"
#include "app/physical_keys.h"
#include "app/project_files.h"
#include "app/session.h"
#include "app/settings.h"
#include "app/style_pictures.h"
#include "model/tools/clipboard.h"
#include "view/dialogs/help_dialog.h"
#include "view/rendering/renderer.h"

#include <QElapsedTimer>
#include <QMainWindow>
#include <QSplitter>

namespace hairpaint::view {
class HeadView;
class DropHint;
class MapLegend;
class OptionBar;
class PaintView;
class Sidebar;
class StatusReadout;
class StyleStrip;
class ToolBar;
} // namespace hairpaint::view

namespace hairpaint::app {

class MainWindow : public QMainWindow
{
    Q_OBJECT
public:
    /// `project`: what it opens with; `path`: where that came from, empty for a new one.
    MainWindow(model::Project project, const QString& path, QWidget* parent = nullptr);
    ~MainWindow() override;

    [[nodiscard]] Session& session() { return m_session; }
    [[nodiscard]] ProjectFiles& files() { return m_files; }
    [[nodiscard]] ActionSet& actions() { return m_actions; }
    [[nodiscard]] view::PaintView& paintView() { return *m_paintView; }
    [[nodiscard]] view::HeadView& headView() { return *m_headView; }

    /// Opens a project, applies a style, imports a mesh or an image: whatever the file is.
    void openFile(const QString& path);

protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dragLeaveEvent(QDragLeaveEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// Which of the two areas are shown.
    enum class Areas
    {
        Both,
        Head,
        Paint
    };

    void buildLayout();
    void connectViews();
    void buildMenus();
    void addFileActions(QMenu& menu);
    void addEditActions(QMenu& menu);
    void addMapActions(QMenu& menu);
    void fillMapSizeMenu(QMenu& menu);
    void addToolActions(QMenu& menu);
    void addViewActions(QMenu& menu);
    void addHairActions(QMenu& menu);
    void addHelpActions(QMenu& menu);
    void fillRecentMenu();

    void showAreas(Areas areas);
    void swapAreas();
    void setPanelsHidden(bool hidden);
    void applyTheme();
    void showTitle();
    void refreshStyles();
    void showAreaMenu(const QPoint& globalPosition);
    void onFrameDrawn(const rendering::FrameStatistics& statistics);

    /// Alt and a digit: strands take that map's colours while both are held.
    void lookAt(std::optional<model::MapKind> map);
    /// Brackets and digits go by their place on the keyboard, since many layouts can't type them: the action that has
    /// that key, null where it has been given another.
    [[nodiscard]] QAction* actionAt(PhysicalKey key) const;
    void changeBrushSize(float factor);
    void selectAll();
    void copySelection();
    void cutSelection();
    void pasteClip();
    void clearSelection();

    void showPreferences();
    void showWind();
    void showLight();
    void showHelp(view::HelpDialog::Topic topic, QWidget* over);
    void addHelpKey(QDialog& dialog, view::HelpDialog::Topic topic);
    void setPreferences(const view::Preferences& preferences);

    Settings m_settings;
    Session m_session;
    Jobs m_jobs;
    ProjectFiles m_files;
    Exchange m_exchange;
    StylePictures m_stylePictures;
    ActionSet m_actions;
    view::Preferences m_preferences;

    view::ToolBar* m_toolBar = nullptr;
    view::OptionBar* m_optionBar = nullptr;
    QSplitter* m_splitter = nullptr;
    view::PaintView* m_paintView = nullptr;
    view::HeadView* m_headView = nullptr;
    view::MapLegend* m_legend = nullptr;
    view::Sidebar* m_sidebar = nullptr;
    view::StyleStrip* m_styleStrip = nullptr;
    view::StatusReadout* m_status = nullptr;
    view::DropHint* m_dropHint = nullptr;
    QMenu* m_recentMenu = nullptr;
    QMenu* m_areaMenu = nullptr;
    std::optional<model::Clip> m_clip;
    Areas m_areas = Areas::Both;
    bool m_panelsHidden = false;
    int m_libraryNumber = 0; ///< Of the newest list of styles asked for.
    double m_frameRate = 0.0;
    QElapsedTimer m_sinceFrame;
};

} // namespace hairpaint::app
