// The active group's settings.
#pragma once

#include "model/document/range_change.h"
#include "view/editing/editor_state.h"

#include <QWidget>

#include <functional>
#include <memory>
#include <vector>

namespace hairpaint::model {
struct GroupSetting;
} // namespace hairpaint::model

namespace hairpaint::view {

class BarSlider;

/// A control for each row of model/project/group_schema.h, in sections, and the choice of a hair type. Disabled without
/// a group.
class GroupSettingsPanel : public QWidget
{
    Q_OBJECT
public:
    explicit GroupSettingsPanel(EditorState& state, QWidget* parent = nullptr);

Q_SIGNALS:
    void groupChanged(); ///< Its controls stand for another group from here on.

private:
    void build();
    [[nodiscard]] QWidget* makeChoice(const model::GroupSetting& row, QWidget* parent);
    [[nodiscard]] QWidget* makeHairTypes(QWidget* parent);
    [[nodiscard]] QWidget* makeSwitch(const model::GroupSetting& row, QWidget* parent);
    [[nodiscard]] QWidget* makeSlider(const model::GroupSetting& row, QWidget* parent);
    /// A slider of a map's range keeps what is painted on it (model/document/range_change.h). `edited`: the group that
    /// it is of.
    void bindRange(BarSlider& slider, const model::GroupSetting& row,
                   const std::shared_ptr<model::EditSession>& session, const std::shared_ptr<model::Id>& edited);
    void tellClamped(const model::RangeChange& change, const model::RangeChange::Clamped& clamped);
    /// One command; `value` in SI units.
    void change(const model::GroupSetting& row, double value);
    void setHairType(std::size_t index);
    void follow();
    [[nodiscard]] const model::HairGroup* group() const;
    [[nodiscard]] double scalpFraction() const;
    [[nodiscard]] static QString settingText(const model::GroupSetting& row, const model::HairGroup& group);

    EditorState& m_state;
    /// Each shows the group's settings in its control.
    std::vector<std::function<void(const sim::GroupSettings&)>> m_followers;
    model::Id m_shownGroup = 0;
};

} // namespace hairpaint::view
