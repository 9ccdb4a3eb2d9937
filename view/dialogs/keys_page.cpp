// The tree of actions and their keys.
#include "view/dialogs/keys_page.h"

#include "view/look/theme.h"
#include "view/widgets/action_button.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace hairpaint::view {

namespace {

constexpr int kNameColumn = 0;
constexpr int kKeyColumn = 1;

bool hasOwnKeys(const KeyBinding& binding)
{
    return binding.action->shortcuts() == binding.defaultKeys;
}

QString keyText(const QList<QKeySequence>& keys)
{
    return keys.value(0).toString(QKeySequence::NativeText);
}

} // namespace

KeysPage::KeysPage(std::vector<KeyBinding> bindings, QWidget* parent) : QWidget(parent), m_bindings(std::move(bindings))
{
    setObjectName(QStringLiteral("panel"));
    build();
    fill();
    connect(m_filter, &QLineEdit::textChanged, this, &KeysPage::filter);
    connect(m_keys, &QTreeWidget::currentItemChanged, this, &KeysPage::follow);
    connect(m_newKey, &QKeySequenceEdit::keySequenceChanged, this, &KeysPage::follow);
    connect(m_assign, &QPushButton::clicked, this, [this] { setKey(current(), m_newKey->keySequence()); });
    connect(m_clear, &QPushButton::clicked, this, [this] { setKey(current(), {}); });
    connect(m_reset, &QPushButton::clicked, this, [this] { resetKey(current()); });
    connect(m_resetAll, &QPushButton::clicked, this, &KeysPage::resetAll);
    follow();
}

void KeysPage::build()
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(metrics::kPadding, metrics::kPadding, metrics::kPadding, metrics::kPadding);
    layout->setSpacing(metrics::kGap);
    m_filter = new QLineEdit(this);
    m_filter->setPlaceholderText(tr("Search by name or key"));
    m_filter->setAccessibleName(m_filter->placeholderText());
    m_filter->setClearButtonEnabled(true);
    layout->addWidget(m_filter);
    m_keys = new QTreeWidget(this);
    m_keys->setAccessibleName(tr("Keys"));
    m_keys->setColumnCount(2);
    m_keys->setHeaderLabels({tr("Action"), tr("Key")});
    m_keys->header()->setSectionResizeMode(kNameColumn, QHeaderView::Stretch);
    m_keys->header()->setSectionResizeMode(kKeyColumn, QHeaderView::ResizeToContents);
    m_keys->setSelectionMode(QAbstractItemView::SingleSelection);
    layout->addWidget(m_keys, 1);

    auto* row = new QHBoxLayout;
    row->setSpacing(metrics::kGap);
    auto* label = new QLabel(tr("&New key"), this);
    m_newKey = new QKeySequenceEdit(this);
    m_newKey->setAccessibleName(tr("New key of the chosen action"));
    label->setBuddy(m_newKey);
    m_assign = new QPushButton(tr("Assign"), this);
    m_clear = new QPushButton(tr("Clear"), this);
    m_reset = new QPushButton(tr("Reset"), this);
    m_resetAll = new QPushButton(tr("Reset all"), this);
    m_resetAll->setToolTip(tr("Gives every action its own key again"));
    for (QPushButton* button : {m_assign, m_clear, m_reset, m_resetAll})
        button->setAutoDefault(false);
    row->addWidget(label);
    row->addWidget(m_newKey, 1);
    layout->addLayout(row);
    m_remark = new QLabel(this);
    m_remark->setProperty("role", QStringLiteral("dim"));
    m_remark->setWordWrap(true);
    auto* foot = new QHBoxLayout;
    foot->setSpacing(metrics::kGap);
    foot->addWidget(m_remark, 1);
    for (QPushButton* button : {m_assign, m_clear, m_reset, m_resetAll})
        foot->addWidget(button);
    layout->addLayout(foot);
}

void KeysPage::fill()
{
    m_items.clear();
    m_keys->clear();
    QTreeWidgetItem* section = nullptr;
    for (std::size_t i = 0; i < m_bindings.size(); ++i) {
        const KeyBinding& binding = m_bindings[i];
        if (section == nullptr || section->text(kNameColumn) != binding.section) {
            section = new QTreeWidgetItem(m_keys, {binding.section});
            section->setFlags(Qt::ItemIsEnabled);
            section->setExpanded(true);
        }
        auto* item = new QTreeWidgetItem(section, {binding.name});
        item->setText(kKeyColumn, keyText(binding.action->shortcuts()));
        item->setData(kNameColumn, Qt::UserRole, static_cast<int>(i));
        m_items.push_back(item);
    }
}

void KeysPage::filter(const QString& text)
{
    for (int i = 0; i < m_keys->topLevelItemCount(); ++i) {
        QTreeWidgetItem* section = m_keys->topLevelItem(i);
        bool any = false;
        for (int j = 0; j < section->childCount(); ++j) {
            QTreeWidgetItem* item = section->child(j);
            const bool fits = text.isEmpty() || item->text(kNameColumn).contains(text, Qt::CaseInsensitive) ||
                              item->text(kKeyColumn).contains(text, Qt::CaseInsensitive);
            item->setHidden(!fits);
            any = any || fits;
        }
        section->setHidden(!any);
    }
}

int KeysPage::current() const
{
    const QTreeWidgetItem* item = m_keys->currentItem();
    return item != nullptr && item->parent() != nullptr ? item->data(kNameColumn, Qt::UserRole).toInt() : -1;
}

int KeysPage::ownerOf(const QKeySequence& key, int except) const
{
    for (std::size_t i = 0; i < m_bindings.size(); ++i)
        if (static_cast<int>(i) != except && !key.isEmpty() && m_bindings[i].action->shortcuts().contains(key))
            return static_cast<int>(i);
    return -1;
}

void KeysPage::follow()
{
    const int binding = current();
    const bool chosen = binding >= 0;
    const QKeySequence wanted = m_newKey->keySequence();
    m_newKey->setEnabled(chosen);
    m_assign->setEnabled(chosen && !wanted.isEmpty());
    m_clear->setEnabled(chosen && !m_bindings[static_cast<std::size_t>(binding)].action->shortcut().isEmpty());
    m_reset->setEnabled(chosen && !hasOwnKeys(m_bindings[static_cast<std::size_t>(binding)]));
    m_resetAll->setEnabled(!std::ranges::all_of(m_bindings, hasOwnKeys));
    const int owner = chosen ? ownerOf(wanted, binding) : -1;
    if (!chosen)
        m_remark->setText(tr("Choose an action, then press its new key."));
    else if (owner >= 0)
        m_remark->setText(
            tr("“%1” has this key now and will lose it.").arg(m_bindings[static_cast<std::size_t>(owner)].name));
    else
        m_remark->setText(tr("Press the new key in the field, then Assign."));
}

void KeysPage::put(int binding, const QList<QKeySequence>& keys)
{
    const auto index = static_cast<std::size_t>(binding);
    m_bindings[index].action->setShortcuts(keys);
    m_items[index]->setText(kKeyColumn, keyText(keys));
    if (hasOwnKeys(m_bindings[index]))
        Q_EMIT keyReset(m_bindings[index].action);
    else
        Q_EMIT keyChanged(m_bindings[index].action, keys.value(0));
}

void KeysPage::setKey(int binding, const QKeySequence& key)
{
    if (binding < 0)
        return;
    if (const int owner = ownerOf(key, binding); owner >= 0)
        put(owner, {});
    put(binding, key.isEmpty() ? QList<QKeySequence>() : QList<QKeySequence>{key});
    m_newKey->clear();
    follow();
}

/// Nobody is left without a key by it: whoever took one of its keys gets its own ones back that are free, or where all
/// are taken too the key that becomes free; and whoever has none and would have that key by itself gets it back.
void KeysPage::resetKey(int binding)
{
    if (binding < 0)
        return;
    const KeyBinding& wanted = m_bindings[static_cast<std::size_t>(binding)];
    const QKeySequence freed = wanted.action->shortcut();
    std::vector<int> losers;
    for (const QKeySequence& key : wanted.defaultKeys)
        if (const int owner = ownerOf(key, binding); owner >= 0)
            losers.push_back(owner);
    put(binding, wanted.defaultKeys);
    for (const int loser : losers) {
        QList<QKeySequence> next = m_bindings[static_cast<std::size_t>(loser)].defaultKeys;
        next.removeIf([this, loser](const QKeySequence& key) { return ownerOf(key, loser) >= 0; });
        if (next.isEmpty() && !freed.isEmpty() && ownerOf(freed, loser) < 0)
            next = {freed};
        put(loser, next);
    }
    for (std::size_t i = 0; i < m_bindings.size(); ++i)
        if (m_bindings[i].action->shortcut().isEmpty() && !freed.isEmpty() && m_bindings[i].defaultKey() == freed &&
            ownerOf(freed, static_cast<int>(i)) < 0)
            put(static_cast<int>(i), m_bindings[i].defaultKeys);
    follow();
}

void KeysPage::resetAll()
{
    for (std::size_t i = 0; i < m_bindings.size(); ++i)
        put(static_cast<int>(i), m_bindings[i].defaultKeys);
    follow();
}

} // namespace hairpaint::view
