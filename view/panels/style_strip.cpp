// Hairstyles side by side.
#include "view/panels/style_strip.h"

#include "model/commands/commands.h"
#include "model/names.h"
#include "model/style_transfer.h"
#include "view/panels/style_tile.h"
#include "view/theme.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QMenu>
#include <QScrollArea>
#include <QScrollBar>
#include <QWheelEvent>

#include <algorithm>
#include <utility>

namespace hairpaint::view {

using model::Change;
using model::Preset;

namespace {

constexpr int kHoverMs = 120;
constexpr std::size_t kKept = 10; ///< Styles that stay in memory.

/// Here and not when it is shown: it takes a while.
model::Result<Preset> onHead(model::Result<Preset> read, const std::shared_ptr<const model::Head>& head)
{
    if (!read)
        return read;
    return *model::carriedPreset(std::move(*read), head);
}

} // namespace

StyleStrip::StyleStrip(EditorState& state, Loader loader, Start start, QWidget* parent)
    : QWidget(parent), m_state(state), m_loader(std::move(loader)), m_start(std::move(start))
{
    setObjectName(QStringLiteral("styleStrip"));
    setAttribute(Qt::WA_StyledBackground);
    setAccessibleName(tr("Styles"));
    setFixedHeight(metrics::kStyleStrip);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 1, 0, 0);
    m_scroll = new QScrollArea(this);
    m_scroll->setWidgetResizable(true);
    m_scroll->setFocusPolicy(Qt::NoFocus);
    m_scroll->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scroll->setFrameShape(QFrame::NoFrame);
    auto* content = new QWidget(m_scroll);
    content->setObjectName(QStringLiteral("panel"));
    m_row = new QHBoxLayout(content);
    m_row->setContentsMargins(metrics::kGap, 0, metrics::kGap, 0);
    m_row->setSpacing(metrics::kGrid);
    m_row->setAlignment(Qt::AlignVCenter);
    m_scroll->setWidget(content);
    m_scroll->viewport()->installEventFilter(this);
    m_scroll->horizontalScrollBar()->setAccessibleName(tr("Styles"));
    layout->addWidget(m_scroll);
    m_pause.setSingleShot(true);
    m_pause.setInterval(kHoverMs);
    connect(&m_pause, &QTimer::timeout, this, [this] { wish(m_hovered, false); });
    connect(&state.document(), &model::Document::editEnded, this, &StyleStrip::restoreTarget);
    setEntries({});
}

void StyleStrip::setEntries(const std::vector<model::PresetEntry>& entries)
{
    endPreview();
    while (QLayoutItem* item = m_row->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    m_tiles.clear();
    m_recent.clear();
    for (const model::PresetEntry& entry : entries)
        addTile(new StyleTile(entry.path, model::shownName(entry.name), entry.folder == QLatin1String("own"), this),
                entry.picture);
    auto* save = new StyleTile({}, tr("Save style"), false, this);
    save->setToolTip(tr("Save this hair as a style of your own"));
    connect(save, &StyleTile::clicked, this, &StyleStrip::saveStyleRequested);
    m_row->addWidget(save);
    m_row->addStretch(1);
}

void StyleStrip::addTile(StyleTile* tile, const QImage& picture)
{
    tile->setPicture(picture);
    tile->setToolTip(tr("%1. Point to see it, click to keep it").arg(tile->text()));
    m_row->addWidget(tile);
    m_tiles.push_back(tile);
    const QString path = tile->path();
    connect(tile, &StyleTile::entered, this, [this, path] {
        m_hovered = path;
        m_pause.start();
    });
    connect(tile, &StyleTile::left, this, [this, path] {
        if (m_hovered == path)
            endPreview();
    });
    connect(tile, &StyleTile::clicked, this, [this, path] { wish(path, true); });
    tile->installEventFilter(this);
    if (tile->own()) {
        tile->setContextMenuPolicy(Qt::CustomContextMenu);
        connect(tile, &QWidget::customContextMenuRequested, this, [this, tile, path](QPoint position) {
            auto* menu = new QMenu(this);
            menu->setAttribute(Qt::WA_DeleteOnClose);
            menu->addAction(tr("Rename style…"), this, [this, path] { Q_EMIT renameStyleRequested(path); });
            menu->addAction(tr("Delete style"), this, [this, path] { Q_EMIT deleteStyleRequested(path); });
            menu->popup(tile->mapToGlobal(position));
        });
    }
    // Queued, so that whoever fills the strip can connect first.
    if (picture.isNull())
        QMetaObject::invokeMethod(
            this, [this, path] { Q_EMIT pictureWanted(path); }, Qt::QueuedConnection);
}

std::vector<QString> StyleStrip::paths() const
{
    std::vector<QString> all;
    for (const StyleTile* tile : m_tiles)
        all.push_back(tile->path());
    return all;
}

StyleTile* StyleStrip::tile(const QString& path) const
{
    const auto found = std::ranges::find(m_tiles, path, &StyleTile::path);
    return found != m_tiles.end() ? *found : nullptr;
}

void StyleStrip::setPicture(const QString& path, const QImage& picture)
{
    if (StyleTile* found = tile(path))
        found->setPicture(picture);
}

void StyleStrip::wish(const QString& path, bool commit)
{
    if (path.isEmpty())
        return;
    m_pause.stop();
    if (commit)
        m_toCommit = path;
    const auto known = std::ranges::find(m_recent, path, &std::pair<QString, PresetPtr>::first);
    const std::shared_ptr<const model::Head> head = m_state.document().committed().head;
    if (known != m_recent.end() && !model::canCarry(known->second->head, head)) {
        arrived(path, known->second);
        return;
    }
    if (StyleTile* shown = tile(path))
        shown->setBusy(true);
    if (std::ranges::find(m_loading, path) != m_loading.end())
        return;
    m_loading.push_back(path);
    m_start(
        tr("Reading %1").arg(QFileInfo(path).fileName()),
        [path, head, load = m_loader] { return onHead(load(path), head); }, this,
        [this, path](model::Result<Preset> read) { loaded(path, std::move(read)); });
}

void StyleStrip::loaded(const QString& path, model::Result<Preset> read)
{
    std::erase(m_loading, path);
    if (StyleTile* shown = tile(path))
        shown->setBusy(false);
    if (!read) {
        if (m_toCommit == path)
            m_toCommit.clear();
        Q_EMIT failed(read.error().message);
        return;
    }
    if (model::canCarry(read->head, m_state.document().committed().head)) {
        wish(path, m_toCommit == path); // Another head has come meanwhile.
        return;
    }
    const auto preset = std::make_shared<const Preset>(std::move(*read));
    std::erase_if(m_recent, [&path](const auto& one) { return one.first == path; }); // On another head.
    m_recent.emplace_back(path, preset);
    if (m_recent.size() > kKept)
        m_recent.erase(m_recent.begin());
    arrived(path, preset);
}

void StyleStrip::arrived(const QString& path, const PresetPtr& preset)
{
    if (m_toCommit == path)
        apply(preset);
    else if (m_hovered == path)
        preview(preset);
}

void StyleStrip::preview(const PresetPtr& preset)
{
    if (!m_edit.active()) {
        m_state.document().endEdit(); // First: the end of another one's edit is not the end of this.
        m_before = m_state.target();
    }
    showStyle(preset);
}

void StyleStrip::restoreTarget()
{
    if (m_edit.active() || !m_before)
        return;
    const model::LayerAddress before = *std::exchange(m_before, std::nullopt);
    m_state.setActiveGroup(before.group);
    if (m_state.activeGroup() == before.group && m_state.activeMap() == before.map)
        m_state.setActiveLayer(before.layer);
}

void StyleStrip::showStyle(const PresetPtr& preset)
{
    // Only looked at: whoever changes something else goes on from the hair that was there.
    m_state.document().show(m_edit, {.policy = model::EditPolicy::Drop}, {.aspect = Change::Aspect::GroupList},
                            [preset](model::Project& project) { applyPreset(project, *preset); });
}

void StyleStrip::apply(const PresetPtr& preset)
{
    m_toCommit.clear();
    m_hovered.clear();
    showStyle(preset);
    m_edit.setText(applyPresetText(*preset));
    m_before.reset(); // The style's own is kept.
    m_edit.commit();
    // On a bald head only Density makes hair.
    const auto density = m_state.document().resolvedNow(m_state.activeGroup(), model::MapKind::Density);
    if (density != nullptr && density->uniformValue() == sim::Texel{})
        m_state.setActiveMap(model::MapKind::Density);
}

void StyleStrip::endPreview()
{
    m_pause.stop();
    m_hovered.clear();
    m_edit.drop();
}

bool StyleStrip::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == m_scroll->viewport() && event->type() == QEvent::Wheel) {
        const auto* wheel = static_cast<QWheelEvent*>(event);
        const QPoint angle = wheel->angleDelta();
        QScrollBar* bar = m_scroll->horizontalScrollBar();
        bar->setValue(bar->value() - (angle.x() != 0 ? angle.x() : angle.y()));
        return true;
    }
    if (event->type() == QEvent::FocusIn) {
        if (auto* focused = qobject_cast<StyleTile*>(watched))
            m_scroll->ensureWidgetVisible(focused);
    } else if (event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        const auto* focused = qobject_cast<StyleTile*>(watched);
        if (focused != nullptr && (key == Qt::Key_Return || key == Qt::Key_Enter)) {
            wish(focused->path(), true);
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

void StyleStrip::hideEvent(QHideEvent* event)
{
    endPreview();
    QWidget::hideEvent(event);
}

} // namespace hairpaint::view
