// Two sliders over the colours that hair grows in.
#pragma once

#include "view/editing/editor_state.h"
#include "view/widgets/melanin.h"

#include <QWidget>

#include <functional>

namespace hairpaint::view {

class BarSlider;

/// Melanin and its redness of a colour in the tool settings. Each slider is filled with the colours that it leads to.
class MelaninSliders : public QWidget
{
    Q_OBJECT
public:
    /// `set` writes the colour that the sliders are moved to.
    MelaninSliders(EditorState& state, std::function<void(model::ToolSettings& settings, const QColor& colour)> set,
                   QWidget* parent = nullptr);
    /// The natural colour nearest to `colour`; sliders that stand for it already stay.
    void showColour(const QColor& colour);

private:
    [[nodiscard]] Melanin shown() const;

    BarSlider* m_melanin; ///< Percent, as the next.
    BarSlider* m_redness;
};

} // namespace hairpaint::view
