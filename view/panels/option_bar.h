// The bar over the areas: the settings of the active tool and the value it paints.
#pragma once

#include "view/editor_state.h"

#include <QWidget>

#include <functional>

class QHBoxLayout;
class QLabel;
class QToolButton;

namespace hairpaint::view {

class BarSlider;
class MapBadge;

/// 40 px high. Shows exactly the active tool's options.
class OptionBar : public QWidget
{
    Q_OBJECT
public:
    explicit OptionBar(EditorState& state, QWidget* parent = nullptr);
    /// Opens the value palette under its button, as the picker's key may.
    void showPalette();
    /// Adds a button that is there while the Select tool is in use: what a selection is for.
    void addSelectionAction(QAction* action);

protected:
    void changeEvent(QEvent* event) override;

private:
    void buildValue();
    void buildBrush();
    void buildParting();
    void buildKinds();
    void showOptions();
    void follow();
    void change(const std::function<void(model::ToolSettings&)>& edit);

    EditorState& m_state;
    QHBoxLayout* m_row = nullptr;
    QLabel* m_toolIcon = nullptr;
    QLabel* m_toolName = nullptr;
    QWidget* m_valueBox = nullptr;
    QLabel* m_revealed = nullptr; ///< What the eraser leaves.
    MapBadge* m_badge = nullptr;
    std::pair<model::Id, model::MapKind> m_stands{}; ///< The group and the map whose value m_scalar shows.
    BarSlider* m_scalar = nullptr;
    QToolButton* m_valueButton = nullptr;
    BarSlider* m_size = nullptr;
    BarSlider* m_hardness = nullptr;
    BarSlider* m_opacity = nullptr;
    BarSlider* m_tolerance = nullptr;
    BarSlider* m_flatness = nullptr;
    BarSlider* m_reach = nullptr;
    BarSlider* m_gap = nullptr;
    BarSlider* m_zigzag = nullptr;
    BarSlider* m_lift = nullptr;
    BarSlider* m_holdGel = nullptr;
    BarSlider* m_grabGel = nullptr;
    QWidget* m_pressureBox = nullptr;
    QToolButton* m_pressureSize = nullptr;
    QToolButton* m_pressureOpacity = nullptr;
    QWidget* m_shapeBox = nullptr;
    QWidget* m_gradientBox = nullptr;
    QWidget* m_combBox = nullptr;
    QWidget* m_selectionBox = nullptr;
    std::vector<QToolButton*> m_shapes;
    std::vector<QToolButton*> m_gradients;
    std::vector<QToolButton*> m_combs;
};

} // namespace hairpaint::view
