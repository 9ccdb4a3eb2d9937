// The hair groups and the active group's settings.
#pragma once

#include "model/document/range_change.h"
#include "model/values/error.h"
#include "view/editing/editor_state.h"

#include <QWidget>

#include <functional>
#include <memory>
#include <optional>
#include <utility>

class QToolButton;
class QVBoxLayout;

namespace hairpaint::model {
struct GroupSetting;
struct HairKind;
} // namespace hairpaint::model

namespace hairpaint::view {

class BarSlider;
class LayerList;
class Section;

class HairPanel : public QWidget
{
    Q_OBJECT
public:
    explicit HairPanel(EditorState& state, QWidget* parent = nullptr);

    /// Shows a list of what can grow; the one chosen is added.
    void askWhatGrows();
    /// A group as it grows on a head; none where that is not known; an error where it was stopped.
    using Grown = std::optional<model::HairGroup>;
    using Grow = std::function<model::Result<Grown>(const model::HairKind& kind,
                                                    const std::shared_ptr<const model::Head>& head)>;
    /// Sets how groups are grown, which takes a moment; by default on this thread.
    void setGrow(Grow grow) { m_grow = std::move(grow); }
    /// Adds a group of that kind, ready to be painted: its Density is the map that is painted then. Brows, lashes and
    /// beards are there where they grow, as far as that is known on the head.
    void addGroup(const model::HairKind& kind);
    void removeGroup();

Q_SIGNALS:
    void groupChanged(); ///< Its controls stand for another group from here on.

private:
    void buildGroups(QVBoxLayout& layout);
    void buildSettings(QVBoxLayout& layout);
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
    void rebuildGroups();
    void follow();
    [[nodiscard]] const model::HairGroup* group() const;
    [[nodiscard]] double scalpFraction() const;
    [[nodiscard]] static QString settingText(const model::GroupSetting& row, const model::HairGroup& group);

    EditorState& m_state;
    Grow m_grow;
    LayerList* m_groups = nullptr;
    QToolButton* m_add = nullptr;
    QToolButton* m_remove = nullptr;
    std::vector<QWidget*> m_settings; ///< Sections that need a group.
    /// Each shows the group's settings in its control.
    std::vector<std::function<void(const sim::GroupSettings&)>> m_followers;
    model::Id m_shownGroup = 0;
    bool m_filling = false;
};

} // namespace hairpaint::view
