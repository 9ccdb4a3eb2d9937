// The window's own dialogs: wind, light, preferences, help.
#pragma once

#include "app/window/action_set.h"
#include "app/window/live_preferences.h"
#include "view/dialogs/cut_dialog.h"
#include "view/dialogs/help_dialog.h"

namespace hairpaint::app {

/// Opens them over `window`, which owns them. Everything named to it outlives them. GUI thread.
class WindowDialogs
{
public:
    WindowDialogs(QWidget& window, view::EditorState& editor, ActionSet& actions, LivePreferences& preferences);

    void showWind();
    void showLight();
    void showScaleHair(); ///< Modal.
    /// Modal; `hair`: of the document as it is, every hair positioned.
    void showRepeatRows();
    void showCut(view::HairCut kind, std::shared_ptr<const sim::StrandFrame> hair);
    void showPreferences();
    void showHelp(view::HelpDialog::Topic topic);
    void showAbout(const QString& renderer); ///< `renderer`: what draws the 3D area.
    /// F1 in a dialog opens the help about it.
    void addHelpKey(QDialog& dialog, view::HelpDialog::Topic topic);

private:
    /// Opens the one dialog of its kind over the window, or brings it to the front.
    template<typename Dialog>
    void showOnly(view::HelpDialog::Topic topic);
    void openInCorner(QDialog& dialog, view::HelpDialog::Topic topic);
    void showHelpOver(QWidget& over, view::HelpDialog::Topic topic);

    QWidget& m_window;
    view::EditorState& m_editor;
    ActionSet& m_actions;
    LivePreferences& m_preferences;
};

} // namespace hairpaint::app
