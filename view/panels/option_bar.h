// The bar over the areas: the settings of the active tool and the value it paints.
#pragma once

#include "view/editing/editor_state.h"

#include <QWidget>

#include <utility>
#include <vector>

class QHBoxLayout;
class QLabel;
class QToolButton;

namespace hairpaint::view {

class BarSlider;
class MapBadge;

/// 40 px high. Shows exactly the active tool's options, by the rows that the tool names (model/tools/tool_options.h).
class OptionBar : public QWidget
{
    Q_OBJECT
public:
    explicit OptionBar(EditorState& state, QWidget* parent = nullptr);
    ~OptionBar() override;
    /// Opens the value palette under its button, as the picker's key may.
    void showPalette();
    /// Adds a button that is there while the Select tool is in use: what a selection is for.
    void addSelectionAction(QAction* action);

protected:
    void changeEvent(QEvent* event) override;

private:
    struct Option; ///< A row and its widget.

    void buildValue();
    void buildOptions();
    void build(Option& option, const model::ToolNumber& number);
    void build(Option& option, const model::ToolSwitch& one);
    void build(Option& option, const model::ToolChoice& choice);
    void showOptions();
    void follow();
    void followValue();
    void change(const model::ToolOption& option, double value);

    EditorState& m_state;
    QHBoxLayout* m_row = nullptr;
    QLabel* m_toolIcon = nullptr;
    QLabel* m_toolName = nullptr;
    QWidget* m_valueBox = nullptr;
    QLabel* m_revealed = nullptr; ///< Shows what the eraser leaves behind.
    MapBadge* m_badge = nullptr;
    std::pair<model::Id, model::MapKind> m_stands{}; ///< The group and the map whose value m_scalar shows.
    BarSlider* m_scalar = nullptr;
    QToolButton* m_valueButton = nullptr;
    std::vector<Option> m_options; ///< The options of all tools.
    QWidget* m_selectionBox = nullptr;
};

} // namespace hairpaint::view
