// What fills the window: the two areas and the panels around them.
#pragma once

#include "app/background/jobs.h"
#include "app/window/focus_areas.h"
#include "view/dialogs/preferences_dialog.h"
#include "view/editing/editor_state.h"

#include <QSplitter>
#include <QWidget>

namespace hairpaint::view {
class DropHint;
class HeadView;
class MapLegend;
class OptionBar;
class PaintView;
class Sidebar;
class StatusReadout;
class StyleStrip;
class ToolBar;
} // namespace hairpaint::view

namespace hairpaint::app {

class FirstHair;

/// Owns them. GUI thread.
class Workspace : public QWidget
{
    Q_OBJECT
public:
    /// Which of the two areas are shown.
    enum class Areas
    {
        Both,
        Head,
        Paint
    };

    /// Backdrops and styles are made by `jobs`, the first backdrop after the first hair; they and the editor outlive
    /// it.
    Workspace(view::EditorState& editor, Jobs& jobs, FirstHair& firstHair, const view::Preferences& preferences);

    [[nodiscard]] view::ToolBar& toolBar() const { return *m_toolBar; }
    [[nodiscard]] view::OptionBar& optionBar() const { return *m_optionBar; }
    [[nodiscard]] view::PaintView& paintView() const { return *m_paintView; }
    [[nodiscard]] view::HeadView& headView() const { return *m_headView; }
    [[nodiscard]] view::MapLegend& legend() const { return *m_legend; } ///< Over the 3D area.
    [[nodiscard]] view::Sidebar& sidebar() const { return *m_sidebar; }
    [[nodiscard]] view::StyleStrip& styleStrip() const { return *m_styleStrip; }
    [[nodiscard]] view::StatusReadout& status() const { return *m_status; }
    [[nodiscard]] view::DropHint& dropHint() const { return *m_dropHint; }
    [[nodiscard]] FocusAreas& focusAreas() const { return *m_focusAreas; }

    [[nodiscard]] Areas areas() const { return m_areas; }
    void showAreas(Areas areas);
    void swapAreas();
    [[nodiscard]] bool panelsHidden() const { return m_panelsHidden; }
    void setPanelsHidden(bool hidden);
    void findStyle(); ///< Gives the strip's search the keys; hidden panels come back.
    void setTheme(const view::Theme& theme);

Q_SIGNALS:
    void arranged(); ///< Other areas are shown, or the panels are hidden or back.

protected:
    bool focusNextPrevChild(bool next) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void layOut();
    void nameFocusAreas();

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
    FocusAreas* m_focusAreas = nullptr;
    Areas m_areas = Areas::Both;
    bool m_panelsHidden = false;
};

} // namespace hairpaint::app
