// The hair groups and the active group's settings.
#include "view/panels/hair_panel.h"

#include "model/names.h"
#include "view/panels/hair_kinds.h"
#include "view/panels/hair_settings.h"
#include "view/panels/layer_list.h"
#include "view/theme.h"
#include "view/widgets/action_button.h"
#include "view/widgets/bar_slider.h"
#include "view/widgets/live_edit.h"
#include "view/widgets/section.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace hairpaint::view {

using model::Change;
using sim::GroupSettings;
using sim::TurnsMode;

HairPanel::HairPanel(EditorState& state, QWidget* parent) : QWidget(parent), m_state(state)
{
    setObjectName(QStringLiteral("panel"));
    setAttribute(Qt::WA_StyledBackground);
    setAccessibleName(tr("Hair"));
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    auto* scroll = new QScrollArea(this);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    outer->addWidget(scroll);
    auto* content = new QWidget(scroll);
    content->setObjectName(QStringLiteral("panel"));
    auto* layout = new QVBoxLayout(content);
    layout->setContentsMargins(metrics::kPadding, metrics::kGap, metrics::kPadding, metrics::kGap);
    layout->setSpacing(metrics::kGrid);
    buildGroups(*layout);
    buildSettings(*layout);
    layout->addStretch(1);
    scroll->setWidget(content);

    connect(&state, &EditorState::targetChanged, this, &HairPanel::rebuildGroups);
    connect(&state.document(), &model::Document::changed, this, [this](const Change& change) {
        switch (change.aspect) {
        case Change::Aspect::Settings:
            follow();
            break;
        case Change::Aspect::GroupList:
        case Change::Aspect::Everything:
            rebuildGroups();
            break;
        default:
            break;
        }
    });
    rebuildGroups();
}

void HairPanel::buildGroups(QVBoxLayout& layout)
{
    auto* section = new Section(tr("Groups"), this);
    m_groups = new LayerList(LayerList::Rows::Groups, section);
    m_groups->setAccessibleName(tr("Hair groups"));
    section->body().addWidget(m_groups);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(metrics::kGrid);
    m_add = makeActionButton(QStringLiteral("group-add"), tr("Add hair group: choose what grows"), section);
    m_remove = makeActionButton(QStringLiteral("remove"), tr("Remove hair group (Delete)"), section);
    buttons->addWidget(m_add);
    buttons->addStretch(1);
    buttons->addWidget(m_remove);
    section->body().addLayout(buttons);
    layout.addWidget(section);
    connect(m_add, &QToolButton::clicked, this, &HairPanel::askWhatGrows);
    connect(m_remove, &QToolButton::clicked, this, &HairPanel::removeGroup);
    connect(m_groups, &LayerList::removeWanted, this, &HairPanel::removeGroup);
    connect(m_groups, &LayerList::currentRowChanged, this, [this](int row) {
        if (!m_filling && row >= 0)
            m_state.setActiveGroup(m_groups->idAt(row));
    });
    connect(m_groups, &LayerList::visibleWanted, this, [this](int id, bool visible) {
        m_state.document().push(showGroupCommand(m_state.document(), id, visible));
    });
    // Queued: the list is still in its drop, or closing its editor.
    connect(
        m_groups, &LayerList::moveWanted, this,
        [this](int id, int row) { m_state.document().push(moveGroupCommand(m_state.document(), id, row)); },
        Qt::QueuedConnection);
    connect(
        m_groups, &LayerList::renameWanted, this,
        [this](int id, const QString& name) {
            m_state.document().push(renameGroupCommand(m_state.document(), id, name));
        },
        Qt::QueuedConnection);
}

void HairPanel::buildSettings(QVBoxLayout& layout)
{
    const std::pair<SettingSection, QString> titles[] = {{SettingSection::Shape, tr("Shape")},
                                                         {SettingSection::Braid, tr("Braids")},
                                                         {SettingSection::Physics, tr("Motion")},
                                                         {SettingSection::Look, tr("Look")}};
    for (const auto& [kind, title] : titles) {
        auto* section = new Section(title, this);
        for (const SettingRow& row : settingRows()) {
            if (row.section == kind)
                section->body().addWidget(makeSlider(row, section));
        }
        if (kind == SettingSection::Shape)
            buildTurns(*section);
        layout.addWidget(section);
        m_settings.push_back(section);
    }
}

BarSlider* HairPanel::makeSlider(const SettingRow& row, QWidget* parent)
{
    auto* slider = new BarSlider(settingText(row.label), parent);
    slider->setRange(row.minimum, row.maximum, row.decimals);
    slider->setExponent(row.exponent);
    slider->setUnit(*row.unit != '\0' ? settingText(row.unit) : QString());
    slider->setDefaultValue(row.read(GroupSettings{}));
    slider->setHint(settingText(row.hint));
    bind(*slider, row.write);
    m_sliders.emplace_back(&row, slider);
    return slider;
}

void HairPanel::bind(BarSlider& slider, void (*write)(GroupSettings&, double))
{
    connect(&slider, &BarSlider::valueChanged, this, [this, write](double value) {
        const model::Id id = m_state.activeGroup();
        previewEdit(m_state.document(), {.aspect = Change::Aspect::Settings, .group = id},
                    [id, write, value](model::Project& project) {
                        if (model::HairGroup* one = project.group(id))
                            write(one->settings, value);
                    });
    });
    connect(&slider, &BarSlider::editingFinished, this, [this, &slider, write](double value) {
        changeSettings(slider.label(), [=](GroupSettings& settings) { write(settings, value); });
    });
    connect(&slider, &BarSlider::editingCancelled, this, [this] { m_state.document().clearPreview(); });
}

void HairPanel::buildTurns(Section& section)
{
    m_turnsMode = new QComboBox(&section);
    m_turnsMode->setAccessibleName(tr("What the turns of a curl are counted by"));
    m_turnsMode->setToolTip(m_turnsMode->accessibleName());
    m_turnsMode->addItem(tr("Turns per hair"));
    m_turnsMode->addItem(tr("Turns per length"));
    m_turnsPerLength = new BarSlider(tr("Turns are for"), &section);
    m_turnsPerLength->setRange(1.0, 100.0, 1);
    m_turnsPerLength->setExponent(2.0);
    m_turnsPerLength->setUnit(tr("cm"));
    m_turnsPerLength->setDefaultValue(10.0);
    bind(*m_turnsPerLength,
         [](GroupSettings& settings, double cm) { settings.turnsPerLengthM = static_cast<float>(cm / 100.0); });
    m_stepped = new QCheckBox(tr("Whole curl levels only"), &section);
    section.body().addWidget(m_turnsMode);
    section.body().addWidget(m_turnsPerLength);
    section.body().addWidget(m_stepped);
    connect(m_turnsMode, &QComboBox::activated, this, [this](int index) {
        changeSettings(tr("Turns mode"), [index](GroupSettings& settings) {
            settings.turnsMode = index == 0 ? TurnsMode::PerHair : TurnsMode::PerLength;
        });
    });
    connect(m_stepped, &QCheckBox::clicked, this, [this](bool on) {
        changeSettings(tr("Curl levels"), [on](GroupSettings& settings) { settings.steppedTurns = on; });
    });
}

const model::HairGroup* HairPanel::group() const
{
    return m_state.document().project().group(m_state.activeGroup());
}

void HairPanel::changeSettings(const QString& what, const std::function<void(GroupSettings&)>& edit)
{
    const model::Id id = m_state.activeGroup();
    commitEdit(m_state.document(), [&]() -> model::CommandPtr {
        const model::HairGroup* found = m_state.document().committed().group(id);
        if (found == nullptr)
            return nullptr;
        GroupSettings settings = found->settings;
        edit(settings);
        return setSettingsCommand(m_state.document(), id, settings,
                                  tr("%1 of \"%2\"").arg(what, model::shownName(found->name)));
    });
}

void HairPanel::rebuildGroups()
{
    m_filling = true;
    const auto& groups = m_state.document().project().groups;
    const int count = static_cast<int>(groups.size());
    while (m_groups->count() > count)
        delete m_groups->takeItem(m_groups->count() - 1);
    for (int row = 0; row < count; ++row) {
        const model::HairGroup& one = groups[static_cast<std::size_t>(row)];
        QListWidgetItem* item = m_groups->item(row);
        if (item == nullptr) {
            item = new QListWidgetItem(m_groups);
            item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable | Qt::ItemIsDragEnabled);
        }
        item->setText(model::shownName(one.name));
        item->setData(LayerList::IdRole, one.id);
        item->setData(LayerList::VisibleRole, one.visible);
        item->setData(Qt::AccessibleTextRole, one.visible ? item->text() : tr("%1, hidden").arg(item->text()));
        if (one.id == m_state.activeGroup())
            m_groups->setCurrentRow(row);
    }
    constexpr int kMostRows = 5;
    m_groups->setFixedHeight(std::clamp(count, 1, kMostRows) * m_groups->rowHeight() + 2);
    m_filling = false;
    follow();
}

void HairPanel::follow()
{
    const model::HairGroup* shown = group();
    m_remove->setEnabled(shown != nullptr);
    for (QWidget* section : m_settings)
        section->setEnabled(shown != nullptr);
    if (shown == nullptr)
        return;
    const GroupSettings& settings = shown->settings;
    for (const auto& [row, slider] : m_sliders)
        slider->setValue(row->read(settings));
    m_turnsMode->setCurrentIndex(settings.turnsMode == TurnsMode::PerHair ? 0 : 1);
    m_turnsPerLength->setVisible(settings.turnsMode == TurnsMode::PerLength);
    m_turnsPerLength->setValue(static_cast<double>(settings.turnsPerLengthM) * 100.0);
    m_stepped->setChecked(settings.steppedTurns);
}

void HairPanel::askWhatGrows()
{
    auto* menu = new QMenu(this);
    menu->setObjectName(QStringLiteral("whatGrows"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addSection(tr("What grows?"));
    for (const HairKind& kind : hairKinds())
        menu->addAction(titleOf(kind), this, [this, &kind] { addGroup(kind); });
    menu->popup(m_add->mapToGlobal(QPoint(0, m_add->height())));
}

void HairPanel::addGroup(const HairKind& kind)
{
    const auto& groups = m_state.document().committed().groups;
    QString name = QLatin1StringView(kind.name);
    if (name.isEmpty() || std::ranges::find(groups, name, &model::HairGroup::name) != groups.end())
        name = model::groupName(static_cast<qsizetype>(groups.size()) + 1);
    GroupSettings settings;
    kind.apply(settings);
    m_state.document().push(addGroupCommand(m_state.document(), name, settings));
    m_state.setActiveGroup(m_state.document().project().groups.back().id);
    m_state.setActiveMap(model::MapKind::Density);
    m_state.setActiveTool(QLatin1StringView("brush"));
}

void HairPanel::removeGroup()
{
    if (group() != nullptr)
        m_state.document().push(removeGroupCommand(m_state.document(), m_state.activeGroup()));
}

} // namespace hairpaint::view
