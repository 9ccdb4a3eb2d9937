// Picks what the active map is painted with: numbers in the map's own unit, named kinds, hair colours, or directions.
#pragma once

#include "view/editing/editor_state.h"

#include <QWidget>

class QLabel;
class QVBoxLayout;

namespace hairpaint::view {

class BarSlider;
class HexField;
class MelaninSliders;
class Swatch;

/// Follows the active map and group and edits the value that is painted, or the second one. Also keys: X swaps the two,
/// D resets both.
class ValuePalette : public QWidget
{
    Q_OBJECT
public:
    explicit ValuePalette(EditorState& state, QWidget* parent = nullptr);
    void setSecond(bool second);
    [[nodiscard]] bool second() const { return m_second; }
    /// Opens one as a popup under `anchor`, or beside it where it would leave the screen.
    static ValuePalette* openUnder(QWidget& anchor, EditorState& state, bool second = false);

Q_SIGNALS:
    void picked(); ///< A swatch was clicked: popups close.

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    void rebuild();
    void refresh();
    [[nodiscard]] model::PaintValue edited(model::MapKind map) const;
    [[nodiscard]] model::PaintValue& edited(model::ToolSettings& settings, model::MapKind map) const;
    void setValue(const model::PaintValue& value);
    void buildScalar(QVBoxLayout& layout);
    void buildIndex(QVBoxLayout& layout);
    void buildColour(QVBoxLayout& layout);
    void buildVector(QVBoxLayout& layout);
    void chooseColour();
    Swatch* addSwatch(const model::PaintValue& value, const QString& name);

    EditorState& m_state;
    bool m_second = false;
    QWidget* m_body = nullptr;
    BarSlider* m_slider = nullptr;
    BarSlider* m_angle = nullptr; ///< Angle of a direction, degrees.
    BarSlider* m_flatness = nullptr;
    MelaninSliders* m_melanin = nullptr;
    QLabel* m_title = nullptr;
    HexField* m_hex = nullptr;
    std::vector<std::pair<Swatch*, model::PaintValue>> m_swatches;
    QString m_builtFor; ///< Map and units that the swatches stand for.
};

} // namespace hairpaint::view
