// What is worn and drawn: chosen, coloured and sized.
#pragma once

#include "model/document/edit_session.h"
#include "view/editing/editor_state.h"

#include <QWidget>

#include <functional>
#include <vector>

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;

namespace hairpaint::view {

class BarSlider;
class Swatch;

/// A swatch for each thing, and the controls of the chosen one. Each change is one undo step. Hidden while nothing that
/// is drawn is worn.
class WornPanel : public QWidget
{
    Q_OBJECT
public:
    explicit WornPanel(EditorState& state, QWidget* parent = nullptr);

private:
    using Edit = std::function<void(model::Worn&)>;
    using Step = const char* model::WornSpec::*;

    /// `step`: its undo text.
    void bind(BarSlider& slider, Step step, const std::function<void(model::Worn&, double)>& set);
    void chooseColour();
    void choose(int make);
    void setPassable(bool passable);
    void followMaking(const model::Worn& worn);
    /// Shows an edit of the worn thing with that id.
    void showEdit(model::EditSession& session, model::Id id, Step step, const Edit& edit);
    void follow();
    void followSwatches();
    [[nodiscard]] const model::Worn* chosen() const; ///< Null where it is not drawn.

    EditorState& m_state;
    QGridLayout* m_all;
    std::vector<Swatch*> m_swatches; ///< As many as were ever needed; the first m_ids.size() are in use.
    std::vector<model::Id> m_ids;    ///< Ids of the things whose swatches are shown.
    QWidget* m_look;                 ///< The controls of the chosen thing.
    Swatch* m_colour;
    QLabel* m_name;    ///< The chosen one.
    QComboBox* m_make; ///< Shown for kinds that can be made of one thing or another.
    BarSlider* m_sheen;
    BarSlider* m_radius;
    BarSlider* m_tightness; ///< Shown for a tie.
    BarSlider* m_coil;      ///< Shown for a bun.
    QCheckBox* m_passable;  ///< Shown for an own mesh.
    model::Id m_shown = 0;  ///< The thing that the controls show.
    model::EditSession m_colourEdit;
};

} // namespace hairpaint::view
