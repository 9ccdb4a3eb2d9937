// The hair groups and the active group's settings.
#pragma once

#include "view/editor_state.h"

#include <QScrollArea>

class QCheckBox;
class QComboBox;
class QListWidget;
class QToolButton;
class QVBoxLayout;

namespace hairpaint::view {

class BarSlider;
struct SettingRow;

class HairPanel : public QWidget
{
    Q_OBJECT
public:
    explicit HairPanel(EditorState& state, QWidget* parent = nullptr);

    void addGroup();
    void removeGroup();

private:
    void buildGroups(QVBoxLayout& layout);
    void buildSettings(QVBoxLayout& layout);
    void rebuildGroups();
    void follow();
    [[nodiscard]] const model::HairGroup* group() const;
    void changeSettings(const QString& text, const std::function<void(sim::GroupSettings&)>& edit);

    EditorState& m_state;
    QListWidget* m_groups = nullptr;
    QToolButton* m_remove = nullptr;
    std::vector<std::pair<const SettingRow*, BarSlider*>> m_sliders;
    QComboBox* m_turnsMode = nullptr;
    QCheckBox* m_stepped = nullptr;
    BarSlider* m_turnsPerLength = nullptr;
    bool m_filling = false;
};

} // namespace hairpaint::view
