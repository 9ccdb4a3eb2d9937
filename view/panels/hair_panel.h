// The hair groups and the active group's settings.
#pragma once

#include "view/editor_state.h"

#include <QWidget>

#include <functional>

class QCheckBox;
class QComboBox;
class QToolButton;
class QVBoxLayout;

namespace hairpaint::view {

class BarSlider;
class LayerList;
class Section;
struct HairKind;
struct SettingRow;

class HairPanel : public QWidget
{
    Q_OBJECT
public:
    explicit HairPanel(EditorState& state, QWidget* parent = nullptr);

    /// Shows a list of what can grow; the one chosen is added.
    void askWhatGrows();
    /// Adds a group of that kind, ready to be painted: its Density is the map that is painted then.
    void addGroup(const HairKind& kind);
    void removeGroup();

private:
    void buildGroups(QVBoxLayout& layout);
    void buildSettings(QVBoxLayout& layout);
    void buildTurns(Section& section);
    [[nodiscard]] BarSlider* makeSlider(const SettingRow& row, QWidget* parent);
    /// Previews while the slider moves, one command when it is let go.
    void bind(BarSlider& slider, void (*write)(sim::GroupSettings&, double));
    void rebuildGroups();
    void follow();
    [[nodiscard]] const model::HairGroup* group() const;
    void changeSettings(const QString& what, const std::function<void(sim::GroupSettings&)>& edit);

    EditorState& m_state;
    LayerList* m_groups = nullptr;
    QToolButton* m_add = nullptr;
    QToolButton* m_remove = nullptr;
    std::vector<QWidget*> m_settings; ///< Sections that need a group.
    std::vector<std::pair<const SettingRow*, BarSlider*>> m_sliders;
    QComboBox* m_turnsMode = nullptr;
    QCheckBox* m_stepped = nullptr;
    BarSlider* m_turnsPerLength = nullptr;
    bool m_filling = false;
};

} // namespace hairpaint::view
