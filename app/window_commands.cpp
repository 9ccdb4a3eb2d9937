// What the window's actions do that is a few lines of its own: clipboard, dialogs, preferences.
#include "app/main_window.h"

#include "app/languages.h"
#include "model/commands/commands.h"
#include "view/dialogs/light_dialog.h"
#include "view/dialogs/wind_dialog.h"
#include "view/head_view.h"
#include "view/panels/status_readout.h"

#include <QKeyEvent>

#include <algorithm>

namespace hairpaint::app {

void MainWindow::changeBrushSize(float factor)
{
    model::ToolSettings settings = m_session.editor().toolSettings();
    settings.brushSizeM = std::clamp(settings.brushSizeM * factor, 0.001F, 0.3F);
    m_session.editor().setToolSettings(settings);
}

void MainWindow::selectAll()
{
    m_session.editor().selection().setRectangle(QRectF(0.0, 0.0, 1.0, 1.0));
}

void MainWindow::copySelection()
{
    m_session.document().endEdit(); // What is cut is what is there then.
    m_clip = model::copyClip(m_session.document(), m_session.editor().target(), m_session.editor().selection());
    m_status->showMessage(tr("Copied from %1").arg(model::mapSpec(m_clip->map).titleText()));
}

void MainWindow::cutSelection()
{
    copySelection();
    const model::LayerAddress target = m_session.editor().target();
    m_session.document().push(model::clearCommand(m_session.document(), target, m_session.editor().selection(),
                                                  tr("Cut %1").arg(model::mapSpec(target.map).titleText())));
}

void MainWindow::pasteClip()
{
    if (!m_clip) {
        m_status->showMessage(tr("Nothing was copied yet: select a part of a map and copy it first"));
        return;
    }
    m_session.document().push(model::pasteCommand(m_session.document(), m_session.editor().target(), *m_clip,
                                                  m_session.editor().selection()));
}

void MainWindow::clearSelection()
{
    const model::LayerAddress target = m_session.editor().target();
    m_session.document().push(model::clearCommand(m_session.document(), target, m_session.editor().selection(),
                                                  tr("Clear %1").arg(model::mapSpec(target.map).titleText())));
}

namespace {

/// Opens the one dialog of its kind over the window, or brings it to the front.
template<typename Dialog>
void showOnly(QWidget* window, view::EditorState& editor, const std::function<void(QDialog&)>& prepare)
{
    auto* dialog = window->findChild<Dialog*>();
    if (dialog == nullptr) {
        dialog = new Dialog(editor, window);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        prepare(*dialog);
    }
    dialog->show();
    dialog->raise();
    dialog->activateWindow();
}

} // namespace

void MainWindow::showWind()
{
    showOnly<view::WindDialog>(this, m_session.editor(),
                               [this](QDialog& dialog) { addHelpKey(dialog, view::HelpDialog::Topic::Wind); });
}

void MainWindow::showLight()
{
    showOnly<view::LightDialog>(this, m_session.editor(),
                                [this](QDialog& dialog) { addHelpKey(dialog, view::HelpDialog::Topic::Light); });
}

void MainWindow::showPreferences()
{
    auto* dialog = new view::PreferencesDialog(m_preferences, languages(), m_actions.bindings(), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    addHelpKey(*dialog, view::HelpDialog::Topic::Preferences);
    connect(dialog, &view::PreferencesDialog::preferencesChanged, this, &MainWindow::setPreferences);
    connect(dialog, &view::PreferencesDialog::keyChanged, &m_actions, &ActionSet::remember);
    connect(dialog, &view::PreferencesDialog::keyReset, &m_actions, &ActionSet::forget);
    dialog->show();
}

namespace {

/// F1 in a dialog. No shortcut: the window's own F1 reaches into its tool windows, and two of them are none.
class HelpKey : public QObject
{
public:
    HelpKey(QDialog& dialog, std::function<void()> show) : QObject(&dialog), m_show(std::move(show)) {}

protected:
    bool eventFilter(QObject* watched, QEvent* event) override
    {
        const bool isKey = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
        if (!isKey || static_cast<QKeyEvent*>(event)->key() != Qt::Key_F1)
            return QObject::eventFilter(watched, event);
        if (event->type() == QEvent::KeyPress)
            m_show();
        event->accept();
        return true;
    }

private:
    std::function<void()> m_show;
};

} // namespace

void MainWindow::showHelp(view::HelpDialog::Topic topic, QWidget* over)
{
    auto* dialog = over->findChild<view::HelpDialog*>(QString(), Qt::FindDirectChildrenOnly);
    if (dialog == nullptr)
        dialog = new view::HelpDialog(m_session.editor(), m_actions.bindings(), over);
    dialog->showTopic(topic);
}

void MainWindow::addHelpKey(QDialog& dialog, view::HelpDialog::Topic topic)
{
    dialog.installEventFilter(new HelpKey(dialog, [this, topic, over = &dialog] { showHelp(topic, over); }));
}

void MainWindow::setPreferences(const view::Preferences& preferences)
{
    if (preferences == m_preferences)
        return;
    m_preferences = preferences;
    m_settings.setPreferences(preferences);
    m_session.editor().setNightPaper(!preferences.whitePaper);
    applyTheme();
    m_actions.follow();
}

} // namespace hairpaint::app
