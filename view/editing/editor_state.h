// The state of the editor that every view reads and changes; not undone.
#pragma once

#include "view/editing/edit_target.h"
#include "view/editing/hover.h"
#include "view/editing/tool_box.h"
#include "view/editing/view_options.h"

#include <QObject>

namespace hairpaint::view {

/// Four parts, each with its own signals, and the messages for the user. GUI thread.
class EditorState : public QObject
{
    Q_OBJECT
public:
    explicit EditorState(model::Document& document, QObject* parent = nullptr);

    [[nodiscard]] model::Document& document() const { return m_target.document(); }
    [[nodiscard]] EditTarget& target() { return m_target; }
    [[nodiscard]] const EditTarget& target() const { return m_target; }
    [[nodiscard]] ToolBox& tools() { return m_tools; }
    [[nodiscard]] const ToolBox& tools() const { return m_tools; }
    [[nodiscard]] ViewOptions& options() { return m_options; }
    [[nodiscard]] const ViewOptions& options() const { return m_options; }
    [[nodiscard]] Hover& hover() { return m_hover; }
    [[nodiscard]] const Hover& hover() const { return m_hover; }

    void tell(const QString& text) { Q_EMIT told(text); }

Q_SIGNALS:
    void refused(const QString& reason);
    void told(const QString& text); ///< A message that the user did not ask for.

private:
    EditTarget m_target;
    ViewOptions m_options{m_target.document()};
    ToolBox m_tools{m_target, m_options};
    Hover m_hover{m_target, m_tools, m_options};
};

} // namespace hairpaint::view
