// What every tool does, every key, and what the dialogs are for.
#pragma once

#include "view/dialogs/preferences_dialog.h"
#include "view/editor_state.h"

#include <QDialog>

class QTextBrowser;

namespace hairpaint::view {

/// Not modal. Written anew each time it is made, from the tools' own hints and the keys as they are bound.
class HelpDialog : public QDialog
{
    Q_OBJECT
public:
    enum class Topic
    {
        Tools,
        Pointer,
        Keys,
        Wind,
        Light,
        HeadImport,
        Preferences
    };

    HelpDialog(const EditorState& state, const std::vector<KeyBinding>& bindings, QWidget* parent = nullptr);
    void showTopic(Topic topic);
    /// All of it, as plain text.
    [[nodiscard]] QString text() const;

private:
    QTextBrowser* m_browser = nullptr;
};

} // namespace hairpaint::view
