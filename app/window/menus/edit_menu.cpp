// The Edit menu: see the header.
#include "app/window/menus/edit_menu.h"

#include <QUndoStack>

namespace hairpaint::app {

EditMenu::EditMenu(const QString& title, ActionSet& actions, Session& session, ClipCommands& clip,
                   view::LayersPanel& layers, WindowDialogs& dialogs, QWidget* parent)
    : QMenu(title, parent)
{
    view::EditorState& editor = session.editor();
    addUndo(actions, session);
    addSeparator();
    addClipboard(actions, clip, layers);
    addSeparator();
    addSelection(actions, editor);
    addSeparator();
    actions.add(*this, {{.id = "edit.mirror",
                         .text = tr("&Mirror painting"),
                         .keys = {Qt::Key_L},
                         .run = [&editor] { editor.options().setMirror(!editor.options().mirror()); },
                         .icon = "mirror",
                         .on = [&editor] { return editor.options().mirror(); }}});
    addSeparator();
    actions.add(*this, {{"edit.preferences",
                         tr("Pre&ferences…"),
                         {Qt::CTRL | Qt::Key_Comma},
                         [&dialogs] { dialogs.showPreferences(); },
                         "settings"}});
}

void EditMenu::addUndo(ActionSet& actions, Session& session)
{
    model::Document& document = session.document();
    view::EditorState& editor = session.editor();
    QUndoStack& stack = document.undoStack();
    actions.add(
        *this,
        {{.id = "edit.undo",
          .text = tr("&Undo"),
          .keys = {Qt::CTRL | Qt::Key_Z},
          .run = [&document] { document.undo(); },
          .icon = "undo",
          // While a tool runs, undo cancels it or its last part, whatever the stack holds.
          .enabled = [&document, &editor] { return document.canUndo() || editor.tools().stroking(); },
          .label = [&stack] { return stack.canUndo() ? tr("&Undo %1").arg(inMenu(stack.undoText())) : tr("&Undo"); }},
         {.id = "edit.redo",
          .text = tr("&Redo"),
          .keys = {Qt::CTRL | Qt::SHIFT | Qt::Key_Z, Qt::CTRL | Qt::Key_Y},
          .run = [&document] { document.redo(); },
          .icon = "redo",
          .enabled = [&stack] { return stack.canRedo(); },
          .label = [&stack] { return stack.canRedo() ? tr("&Redo %1").arg(inMenu(stack.redoText())) : tr("&Redo"); }}});
}

void EditMenu::addClipboard(ActionSet& actions, ClipCommands& clip, view::LayersPanel& layers)
{
    actions.add(
        *this,
        {{"edit.cut", tr("Cu&t"), {QKeySequence::Cut}, [&clip] { clip.cut(); }},
         {"edit.copy", tr("&Copy"), {QKeySequence::Copy}, [&clip] { clip.copy(); }},
         {"edit.paste", tr("&Paste"), {QKeySequence::Paste}, [&clip] { clip.paste(); }},
         {"edit.duplicate",
          tr("&Duplicate layer"),
          {Qt::CTRL | Qt::Key_J},
          [&layers] { layers.duplicateLayer(); },
          "duplicate"},
         {"edit.fill", tr("Fill &with the value"), {Qt::ALT | Qt::Key_Backspace}, [&clip] { clip.fill(); }, "fill"},
         {"edit.clear", tr("C&lear"), {Qt::Key_Delete}, [&clip] { clip.clear(); }}});
}

void EditMenu::addSelection(ActionSet& actions, view::EditorState& editor)
{
    actions.add(*this, {{"edit.all",
                         tr("Select &all"),
                         {Qt::CTRL | Qt::Key_A},
                         [&editor] { editor.tools().selection().setRectangle(QRectF(0.0, 0.0, 1.0, 1.0)); }},
                        {"edit.none",
                         tr("Select &none"),
                         {Qt::CTRL | Qt::SHIFT | Qt::Key_A},
                         [&editor] { editor.tools().selection().setRectangle({}); }},
                        {"edit.invert", tr("&Invert selection"), {Qt::CTRL | Qt::SHIFT | Qt::Key_I}, [&editor] {
                             editor.tools().selection().invert();
                         }}});
}

} // namespace hairpaint::app
