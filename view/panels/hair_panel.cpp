// The hair groups and the active group's settings.
#include "view/panels/hair_panel.h"

#include "model/document/hair_type_command.h"
#include "model/growth/face_hair.h"
#include "model/project/group_schema.h"
#include "model/project/hair_types.h"
#include "model/styles/hair_kinds.h"
#include "model/values/names.h"
#include "view/look/theme.h"
#include "view/look/value_text.h"
#include "view/panels/layer_list.h"
#include "view/panels/worn_panel.h"
#include "view/widgets/action_button.h"
#include "view/widgets/bar_slider.h"
#include "view/widgets/section.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace hairpaint::view {

using model::Change;
using model::GroupSetting;
using model::schemaText;
using model::SettingSection;
using sim::GroupSettings;
using sim::TurnsMode;

namespace {

/// Settings without effect on the curls that the group has are not shown.
bool isShown(const GroupSetting& row, const GroupSettings& settings)
{
    const bool areCoils = settings.turnsMode == TurnsMode::Coils;
    if (row.member == model::SettingMember(&GroupSettings::turnsPerLengthM))
        return settings.turnsMode == TurnsMode::PerLength;
    if (row.member == model::SettingMember(&GroupSettings::steppedTurns) ||
        row.member == model::SettingMember(&GroupSettings::greatestCurlRadiusM))
        return !areCoils;
    return row.section != SettingSection::Curl || areCoils ||
           row.member == model::SettingMember(&sim::CurlSettings::gather);
}

} // namespace

HairPanel::HairPanel(EditorState& state, QWidget* parent)
    : QWidget(parent), m_state(state),
      m_grow([](const model::HairKind& kind, const std::shared_ptr<const model::Head>& head) {
          return model::Result<Grown>(model::grownHair(kind, head));
      })
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
    layout->addWidget(new WornPanel(state, content));
    buildSettings(*layout);
    layout->addStretch(1);
    scroll->setWidget(content);

    connect(&state.target(), &EditTarget::changed, this, &HairPanel::rebuildGroups);
    connect(&state.document(), &model::Document::changed, this, [this](const Change& change) {
        switch (change.aspect) {
        case Change::Aspect::Settings:
        case Change::Aspect::Head: // Counts are shown for its scalp.
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
            m_state.target().setGroup(m_groups->idAt(row));
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
    const std::pair<SettingSection, QString> titles[] = {
        {SettingSection::Shape, tr("Shape")},  {SettingSection::Curl, tr("Curl")},
        {SettingSection::Locks, tr("Locks")},  {SettingSection::Variation, tr("Variation")},
        {SettingSection::Braid, tr("Braids")}, {SettingSection::Physics, tr("Motion")},
        {SettingSection::Look, tr("Look")}};
    for (const auto& [kind, title] : titles) {
        auto* section = new Section(title, this);
        if (kind == SettingSection::Curl)
            section->body().addWidget(makeHairTypes(section));
        for (const GroupSetting& row : model::groupSchema()) {
            if (row.section != kind)
                continue;
            if (!row.choices.empty())
                section->body().addWidget(makeChoice(row, section));
            else if (row.isSwitch())
                section->body().addWidget(makeSwitch(row, section));
            else
                section->body().addWidget(makeSlider(row, section));
        }
        layout.addWidget(section);
        m_settings.push_back(section);
    }
}

QWidget* HairPanel::makeChoice(const GroupSetting& row, QWidget* parent)
{
    auto* box = new QComboBox(parent);
    box->setAccessibleName(schemaText(row.hint));
    box->setToolTip(box->accessibleName());
    for (const model::SettingChoice& choice : row.choices)
        box->addItem(schemaText(choice.title));
    connect(box, &QComboBox::activated, this, [this, &row](int index) { change(row, index); });
    m_followers.emplace_back(
        [box, &row](const GroupSettings& settings) { box->setCurrentIndex(static_cast<int>(row.read(settings))); });
    return box;
}

QWidget* HairPanel::makeHairTypes(QWidget* parent)
{
    auto* line = new QWidget(parent);
    auto* layout = new QHBoxLayout(line);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(metrics::kGap);
    auto* label = new QLabel(tr("Hair type"), line);
    auto* box = new QComboBox(line);
    box->setObjectName(QStringLiteral("hairType"));
    box->setAccessibleName(tr("Hair type"));
    box->setToolTip(tr("From straight (1) by wavy (2) and curly (3) to coily (4): sets the numbers below"));
    // Of numbers of one's own there is an entry only while they are there: it is not to be chosen.
    const auto fill = [box](bool isCustom) {
        box->clear();
        for (const model::HairType& type : model::hairTypes())
            box->addItem(QLatin1StringView(type.name));
        if (isCustom)
            box->addItem(tr("Custom"));
    };
    fill(true);
    label->setBuddy(box);
    layout->addWidget(label);
    layout->addWidget(box, 1);
    connect(box, &QComboBox::activated, this, [this](int index) {
        if (index < static_cast<int>(model::hairTypes().size()))
            setHairType(static_cast<std::size_t>(index));
    });
    m_followers.emplace_back([box, fill](const GroupSettings& settings) {
        const auto count = static_cast<int>(model::hairTypes().size());
        const std::optional<std::size_t> type = model::hairTypeOf(settings);
        if ((box->count() > count) != !type)
            fill(!type);
        box->setCurrentIndex(type ? static_cast<int>(*type) : count);
    });
    return line;
}

void HairPanel::setHairType(std::size_t index)
{
    const model::HairGroup* edited = group();
    if (edited == nullptr)
        return;
    const QString text = tr("Hair type of \"%1\"").arg(model::shownName(edited->name));
    m_state.document().push(model::setHairTypeCommand(m_state.document(), edited->id, model::hairTypes()[index], text));
}

QWidget* HairPanel::makeSwitch(const GroupSetting& row, QWidget* parent)
{
    auto* box = new QCheckBox(schemaText(row.hint), parent);
    connect(box, &QCheckBox::clicked, this, [this, &row](bool on) { change(row, on ? 1.0 : 0.0); });
    m_followers.emplace_back([box, &row](const GroupSettings& settings) {
        box->setChecked(row.read(settings) != 0.0);
        box->setVisible(isShown(row, settings));
    });
    return box;
}

QWidget* HairPanel::makeSlider(const GroupSetting& row, QWidget* parent)
{
    auto* slider = new BarSlider(schemaText(row.label), parent);
    slider->setRange(row.sliderLeast, row.sliderGreatest, row.decimals);
    slider->setExponent(row.exponent);
    slider->setUnit(schemaText(row.unit));
    slider->setHint(schemaText(row.hint));
    // A session a slider: moving one ends, and keeps, what another one left open.
    auto session = std::make_shared<model::EditSession>();
    auto edited = std::make_shared<model::Id>(0); // Also when another group becomes the active one meanwhile.
    const auto show = [this, &row, session, edited](double value) {
        if (!session->active())
            m_state.document().endEdit(); // What somebody only looks at may have another group.
        const model::HairGroup* shown = m_state.document().project().group(*edited);
        if (shown == nullptr)
            return;
        m_state.document().show(*session, {.text = settingText(row, *shown)},
                                {.aspect = Change::Aspect::Settings, .group = shown->id},
                                [id = shown->id, &row, value, fraction = scalpFraction()](model::Project& project) {
                                    if (model::HairGroup* one = project.group(id))
                                        row.writeShown(one->settings, value, fraction);
                                });
    };
    connect(slider, &BarSlider::editingBegan, this, [this, edited] { *edited = m_state.target().group(); });
    connect(this, &HairPanel::groupChanged, slider, &BarSlider::release);
    if (model::setsRange(row)) {
        bindRange(*slider, row, session, edited);
    } else {
        connect(slider, &BarSlider::valueChanged, this, show);
        connect(slider, &BarSlider::editingFinished, this, [session] { session->commit(); });
        connect(slider, &BarSlider::editingCancelled, this, [session] { session->drop(); });
    }
    m_followers.emplace_back([this, slider, &row](const GroupSettings& settings) {
        slider->setDefaultValue(row.shown(model::newGroupSettings(scalpFraction()), scalpFraction()));
        slider->setValue(row.shown(settings, scalpFraction()));
        slider->setVisible(isShown(row, settings));
    });
    return slider;
}

void HairPanel::bindRange(BarSlider& slider, const GroupSetting& row,
                          const std::shared_ptr<model::EditSession>& session, const std::shared_ptr<model::Id>& edited)
{
    constexpr std::size_t kMostShownTexels = 4'000'000; ///< Rescaled while it moves; more of them when it is let go.
    auto change = std::make_shared<model::RangeChange>();
    auto waits = std::make_shared<bool>(false);
    const auto settingsAt = [this, &row](const model::HairGroup& before, double value) {
        GroupSettings settings = before.settings;
        row.writeShown(settings, value, scalpFraction());
        return settings;
    };
    const auto show = [this, &row, settingsAt, session, edited, change, waits](double value) {
        if (!session->active())
            m_state.document().endEdit(); // What somebody only looks at may have another group.
        const model::HairGroup* before = m_state.document().committed().group(*edited);
        if (before == nullptr)
            return;
        const GroupSettings settings = settingsAt(*before, value);
        *waits = texelsToRescale(*before, settings) > kMostShownTexels;
        if (*waits)
            return;
        *change = withRange(*before, settings);
        m_state.document().show(*session, {.text = settingText(row, *before)},
                                {.aspect = Change::Aspect::GroupList, .group = before->id},
                                [change = *change](model::Project& project) { change.applyTo(project); });
    };
    connect(&slider, &BarSlider::valueChanged, this, show);
    connect(&slider, &BarSlider::editingCancelled, this, [session, waits] {
        *waits = false;
        session->drop();
    });
    connect(&slider, &BarSlider::editingFinished, this,
            [this, &row, settingsAt, session, edited, change, waits](double value) {
                const model::HairGroup* before = m_state.document().committed().group(*edited);
                if (std::exchange(*waits, false) && before != nullptr) {
                    session->drop();
                    QGuiApplication::setOverrideCursor(Qt::WaitCursor);
                    *change = withRange(*before, settingsAt(*before, value));
                    m_state.document().push(setRangeCommand(m_state.document(), *change, settingText(row, *before)));
                    QGuiApplication::restoreOverrideCursor();
                } else if (session->active()) {
                    session->commit();
                } else {
                    return; // Undo took it back meanwhile.
                }
                for (const model::RangeChange::Clamped& clamped : change->clamped)
                    tellClamped(*change, clamped);
            });
}

void HairPanel::tellClamped(const model::RangeChange& change, const model::RangeChange::Clamped& clamped)
{
    const model::MapSpec& spec = model::mapSpec(clamped.map);
    const QString end = valueText(change.settings, spec, {.scalar = clamped.beyond ? 1.0F : 0.0F});
    m_state.tell((clamped.beyond ? tr("What was painted on %1 beyond %2 is %2 now; undo brings it back.")
                                 : tr("What was painted on %1 below %2 is %2 now; undo brings it back."))
                     .arg(spec.titleText(), end));
}

const model::HairGroup* HairPanel::group() const
{
    return m_state.document().project().group(m_state.target().group());
}

double HairPanel::scalpFraction() const
{
    const auto& head = m_state.document().project().head;
    return head ? head->scalpFraction : 1.0;
}

QString HairPanel::settingText(const GroupSetting& row, const model::HairGroup& group)
{
    return tr("%1 of \"%2\"").arg(schemaText(row.label), model::shownName(group.name));
}

void HairPanel::change(const GroupSetting& row, double value)
{
    m_state.document().endEdit();
    const model::Id id = m_state.target().group();
    const model::HairGroup* found = m_state.document().committed().group(id);
    if (found == nullptr)
        return;
    GroupSettings settings = found->settings;
    row.write(settings, value);
    m_state.document().push(setSettingsCommand(m_state.document(), id, settings, settingText(row, *found)));
}

void HairPanel::rebuildGroups()
{
    if (std::exchange(m_shownGroup, m_state.target().group()) != m_state.target().group())
        Q_EMIT groupChanged();
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
        if (one.id == m_state.target().group())
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
    m_remove->setEnabled(shown != nullptr && m_groups->count() > 1);
    for (QWidget* section : m_settings)
        section->setEnabled(shown != nullptr);
    if (shown == nullptr)
        return;
    for (const auto& follower : m_followers)
        follower(shown->settings);
}

void HairPanel::askWhatGrows()
{
    auto* menu = new QMenu(this);
    menu->setObjectName(QStringLiteral("whatGrows"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(tr("What grows?"))->setEnabled(false); // A section's title shows in few styles.
    menu->addSeparator();
    for (const model::HairKind& kind : model::hairKinds())
        menu->addAction(titleOf(kind), this, [this, &kind] { addGroup(kind); });
    menu->popup(m_add->mapToGlobal(QPoint(0, m_add->height())));
}

void HairPanel::addGroup(const model::HairKind& kind)
{
    m_state.document().endEdit();
    const auto& groups = m_state.document().committed().groups;
    const QString first = QLatin1StringView(kind.name);
    const auto numbered = [&](qsizetype number) {
        if (first.isEmpty())
            return model::groupName(number);
        return number > 1 ? model::numberedName(first, number) : first;
    };
    qsizetype number = first.isEmpty() ? static_cast<qsizetype>(groups.size()) + 1 : 1;
    while (std::ranges::find(groups, numbered(number), &model::HairGroup::name) != groups.end())
        ++number;
    const QString name = numbered(number);
    GroupSettings settings = model::newGroupSettings(scalpFraction());
    model::makeNatural(settings);
    model::setHairType(settings, model::hairType("3B"));
    kind.apply(settings);
    const model::Result<Grown> made = m_grow(kind, m_state.document().committed().head);
    if (!made)
        return; // Cancelled.
    if (Grown grown = *made) {
        grown->name = name;
        grown->settings = settings;
        m_state.document().push(addGroupCommand(m_state.document(), std::move(*grown)));
    } else {
        m_state.document().push(addGroupCommand(m_state.document(), name, settings));
    }
    m_state.target().setGroup(m_state.document().project().groups.back().id);
    m_state.target().setMap(model::MapKind::Density);
    m_state.tools().choose(model::ToolId::Brush);
}

void HairPanel::removeGroup()
{
    m_state.document().endEdit();
    if (group() != nullptr)
        m_state.document().push(removeGroupCommand(m_state.document(), m_state.target().group()));
}

} // namespace hairpaint::view
