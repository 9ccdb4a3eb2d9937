// Makes all hair of a group longer, denser or more widely curled by a percentage.
#pragma once

#include "view/editing/editor_state.h"

#include <QDialog>

namespace hairpaint::view {

class BarSlider;

/// Changes the active group. What is set is shown on the hair at once; accepting it is one undo step, closing it none.
class ScaleHairDialog : public QDialog
{
    Q_OBJECT
public:
    explicit ScaleHairDialog(EditorState& state, QWidget* parent = nullptr);
    void accept() override;
    void reject() override;

private:
    void preview();

    EditorState& m_state;
    model::Id m_group = 0;
    sim::GroupSettings m_before;
    QString m_step; ///< Text of the undo step.
    model::EditSession m_edit;
    std::vector<BarSlider*> m_factors; ///< One a row of model::hairScales(), in per cent.
};

} // namespace hairpaint::view
