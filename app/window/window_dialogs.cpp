// The window's dialogs: see the header.
#include "app/window/window_dialogs.h"

#include "app/session/libraries.h"
#include "app/settings/languages.h"
#include "view/dialogs/about_dialog.h"
#include "view/dialogs/light_dialog.h"
#include "view/dialogs/repeat_rows_dialog.h"
#include "view/dialogs/scale_hair_dialog.h"
#include "view/dialogs/wind_dialog.h"
#include "view/look/theme.h"

#include <QApplication>
#include <QKeyEvent>

namespace hairpaint::app {

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

WindowDialogs::WindowDialogs(QWidget& window, view::EditorState& editor, ActionSet& actions,
                             LivePreferences& preferences)
    : m_window(window), m_editor(editor), m_actions(actions), m_preferences(preferences)
{}

template<typename Dialog>
void WindowDialogs::showOnly(view::HelpDialog::Topic topic)
{
    auto* dialog = m_window.findChild<Dialog*>();
    if (dialog == nullptr) {
        dialog = new Dialog(m_editor, &m_window);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        addHelpKey(*dialog, topic);
    }
    dialog->show();
    dialog->raise();
    dialog->activateWindow();
}

void WindowDialogs::showWind()
{
    showOnly<view::WindDialog>(view::HelpDialog::Topic::Wind);
}

void WindowDialogs::showLight()
{
    showOnly<view::LightDialog>(view::HelpDialog::Topic::Light);
}

void WindowDialogs::showScaleHair()
{
    openInCorner(*new view::ScaleHairDialog(m_editor, &m_window), view::HelpDialog::Topic::ScaleHair);
}

void WindowDialogs::showRepeatRows()
{
    m_editor.tools().commitStroke();
    if (!m_editor.tools().mayPaint({model::MapKind::Braid}))
        return;
    auto dialog = std::make_unique<view::RepeatRowsDialog>(m_editor, &m_window);
    if (!dialog->problem().isEmpty())
        return m_editor.tell(dialog->problem());
    openInCorner(*dialog.release(), view::HelpDialog::Topic::Rows);
}

void WindowDialogs::showCut(view::HairCut kind, std::shared_ptr<const sim::StrandFrame> hair)
{
    auto dialog = std::make_unique<view::CutDialog>(m_editor, kind, std::move(hair), &m_window);
    if (!dialog->canCut())
        return m_editor.tell(view::CutDialog::nothingToCutText());
    openInCorner(*dialog.release(), view::HelpDialog::Topic::Cut);
}

void WindowDialogs::openInCorner(QDialog& dialog, view::HelpDialog::Topic topic)
{
    dialog.setAttribute(Qt::WA_DeleteOnClose);
    addHelpKey(dialog, topic);
    // In the corner of the areas, so that the hair is seen while it changes.
    constexpr int kMenuBar = 24;
    constexpr int kAway = 16;
    dialog.move(m_window.mapToGlobal(QPoint(view::metrics::kToolBar, kMenuBar + view::metrics::kOptionBar) +
                                     QPoint(kAway, kAway)));
    dialog.open();
}

void WindowDialogs::showPreferences()
{
    auto* dialog = new view::PreferencesDialog(m_preferences.current(), languages(), m_actions.bindings(), &m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    addHelpKey(*dialog, view::HelpDialog::Topic::Preferences);
    QObject::connect(dialog, &view::PreferencesDialog::preferencesChanged, &m_preferences, &LivePreferences::set);
    QObject::connect(dialog, &view::PreferencesDialog::keyChanged, &m_actions, &ActionSet::remember);
    QObject::connect(dialog, &view::PreferencesDialog::keyReset, &m_actions, &ActionSet::forget);
    dialog->show();
    dialog->activateWindow();
}

void WindowDialogs::showHelp(view::HelpDialog::Topic topic)
{
    showHelpOver(m_window, topic);
}

void WindowDialogs::showHelpOver(QWidget& over, view::HelpDialog::Topic topic)
{
    auto* dialog = over.findChild<view::HelpDialog*>(QString(), Qt::FindDirectChildrenOnly);
    if (dialog == nullptr)
        dialog = new view::HelpDialog(m_editor, m_actions.bindings(), &over);
    dialog->showTopic(topic);
}

void WindowDialogs::showAbout(const QString& renderer)
{
    view::AboutDialog(QApplication::applicationVersion(), librariesInUse(), renderer, &m_window).exec();
}

void WindowDialogs::addHelpKey(QDialog& dialog, view::HelpDialog::Topic topic)
{
    dialog.installEventFilter(new HelpKey(dialog, [this, topic, &dialog] { showHelpOver(dialog, topic); }));
}

} // namespace hairpaint::app
