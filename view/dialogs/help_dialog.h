// What every tool does, every key, and what the dialogs are for.
#pragma once

#include "view/dialogs/keys_page.h"
#include "view/editing/editor_state.h"

#include <QDialog>
#include <QString>
#include <QTimer>

class QTextBrowser;

namespace hairpaint::view {

/// Not modal. Written from the tools' own rows and the keys as they are bound, anew when one is bound anew. The
/// actions outlive it.
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
        ScaleHair,
        Cut,
        Rows,
        HeadImport,
        HairImport,
        HairExport,
        MapExport,
        Picture,
        Preferences
    };

    HelpDialog(const EditorState& state, std::vector<KeyBinding> bindings, QWidget* parent = nullptr);
    /// Of the tools, the one in hand.
    void showTopic(Topic topic);
    /// All of it, as plain text.
    [[nodiscard]] QString text() const;

private:
    void write();

    const EditorState& m_state;
    std::vector<KeyBinding> m_bindings;
    QTextBrowser* m_browser = nullptr;
    QString m_html; ///< Last set text.
    QTimer m_rewrite;
};

} // namespace hairpaint::view
