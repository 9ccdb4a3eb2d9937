// How many cornrows are repeated between two.
#pragma once

#include "model/tools/rows/row_repeat.h"
#include "view/editing/editor_state.h"

#include <QDialog>

namespace hairpaint::view {

class BarSlider;

/// Repeats rows of the active group. What is set is shown on the hair at once; accepting it is one undo step, closing
/// it none.
class RepeatRowsDialog : public QDialog
{
    Q_OBJECT
public:
    explicit RepeatRowsDialog(EditorState& state, QWidget* parent = nullptr);
    void accept() override;
    void reject() override;

    /// Why there is nothing to repeat; empty where there is.
    [[nodiscard]] const QString& problem() const { return m_repeat.problem(); }

private:
    void preview();

    model::ToolSettings m_settings;
    model::RowRepeat m_repeat;
    BarSlider* m_count = nullptr;
};

} // namespace hairpaint::view
