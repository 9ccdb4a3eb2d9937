// The hair groups: listed, added, removed.
#include "view/panels/hair_panel.h"

#include "model/document/group_commands.h"
#include "model/project/group_schema.h"
#include "model/project/hair_types.h"
#include "model/styles/hair_kinds.h"
#include "model/values/names.h"
#include "view/look/theme.h"
#include "view/panels/group_settings_panel.h"
#include "view/panels/layer_list.h"
#include "view/panels/worn_panel.h"
#include "view/widgets/action_button.h"
#include "view/widgets/section.h"

#include <QHBoxLayout>
#include <QMenu>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace hairpaint::view {

using model::Change;

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
    layout->addWidget(new WornPanel(state, content));
    layout->addWidget(new GroupSettingsPanel(state, content));
    layout->addStretch(1);
    scroll->setWidget(content);

    connect(&state.target(), &EditTarget::changed, this, &HairPanel::rebuildGroups);
    connect(&state.document(), &model::Document::changed, this, [this](const Change& change) {
        if (change.aspect == Change::Aspect::GroupList || change.aspect == Change::Aspect::Everything)
            rebuildGroups();
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

const model::HairGroup* HairPanel::group() const
{
    return m_state.document().project().group(m_state.target().group());
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
        if (one.id == m_state.target().group())
            m_groups->setCurrentRow(row);
    }
    constexpr int kMostRows = 5;
    m_groups->setFixedHeight(std::clamp(count, 1, kMostRows) * m_groups->rowHeight() + 2);
    m_filling = false;
    m_remove->setEnabled(group() != nullptr && count > 1);
}

void HairPanel::askWhatGrows()
{
    m_menu = std::make_unique<QMenu>(this);
    QMenu* menu = m_menu.get();
    menu->setObjectName(QStringLiteral("whatGrows"));
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
    sim::GroupSettings settings = model::newGroupSettings(m_state.document().committed().scalpFraction());
    model::makeNatural(settings);
    model::setHairType(settings, model::hairType("3B"));
    kind.apply(settings);
    const model::Result<Grown> made =
        m_grow ? m_grow(kind, m_state.document().committed().head) : model::Result<Grown>(Grown());
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
    m_state.tools().choose(m_state.tools().with(&model::ToolTraits::isFirst));
}

void HairPanel::removeGroup()
{
    m_state.document().endEdit();
    if (group() != nullptr)
        m_state.document().push(removeGroupCommand(m_state.document(), m_state.target().group()));
}

} // namespace hairpaint::view
