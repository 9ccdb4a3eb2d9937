// The layers of the active map.
#include "view/panels/layers_panel.h"

#include "model/document/layer_commands.h"
#include "model/project/blend_modes.h"
#include "model/values/names.h"
#include "view/look/theme.h"
#include "view/panels/layer_list.h"
#include "view/panels/map_thumbnail.h"
#include "view/widgets/action_button.h"
#include "view/widgets/bar_slider.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>

#include <utility>

namespace hairpaint::view {

using model::Change;
using model::Layer;
using model::LayerProperties;

namespace {

constexpr int kThumbnailMs = 120;

} // namespace

LayersPanel::LayersPanel(EditorState& state, QWidget* parent) : QWidget(parent), m_state(state)
{
    setObjectName(QStringLiteral("panel"));
    setAttribute(Qt::WA_StyledBackground);
    setAccessibleName(tr("Layers"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(metrics::kPadding, metrics::kGap, metrics::kPadding, metrics::kGap);
    layout->setSpacing(metrics::kGap);

    auto* top = new QHBoxLayout;
    top->setSpacing(metrics::kGap);
    m_blend = new QComboBox(this);
    m_blend->setMaxVisibleItems(static_cast<int>(model::kBlendModeCount)); // All modes at a glance.
    m_blend->setAccessibleName(tr("Blend mode"));
    m_blend->setToolTip(tr("How the layer mixes with those below it"));
    m_opacity = new BarSlider(tr("Opacity"), this);
    m_opacity->setRange(0.0, 100.0);
    m_opacity->setUnit(QStringLiteral("%"));
    m_opacity->setDefaultValue(100.0);
    top->addWidget(m_blend);
    top->addWidget(m_opacity, 1);
    layout->addLayout(top);

    m_list = new LayerList(LayerList::Rows::Layers, this);
    m_list->setAccessibleName(tr("Layers, topmost first"));
    layout->addWidget(m_list, 1);

    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(metrics::kGrid);
    QToolButton* add = makeActionButton(QStringLiteral("add"), tr("Add layer"), this);
    m_duplicate = makeActionButton(QStringLiteral("duplicate"), tr("Duplicate layer"), this);
    m_up = makeActionButton(QStringLiteral("up"), tr("Move layer up (Alt+Up)"), this);
    m_down = makeActionButton(QStringLiteral("down"), tr("Move layer down (Alt+Down)"), this);
    m_remove = makeActionButton(QStringLiteral("remove"), tr("Remove layer (Delete)"), this);
    buttons->addWidget(add);
    buttons->addWidget(m_duplicate);
    buttons->addWidget(m_up);
    buttons->addWidget(m_down);
    buttons->addStretch(1);
    buttons->addWidget(m_remove);
    layout->addLayout(buttons);

    connect(add, &QToolButton::clicked, this, &LayersPanel::addLayer);
    connect(m_duplicate, &QToolButton::clicked, this, &LayersPanel::duplicateLayer);
    connect(m_remove, &QToolButton::clicked, this, &LayersPanel::removeLayer);
    connect(m_up, &QToolButton::clicked, this, [this] { moveLayer(1); });
    connect(m_down, &QToolButton::clicked, this, [this] { moveLayer(-1); });
    connectList();
    connectProperties();

    m_thumbnails.setSingleShot(true);
    m_thumbnails.setInterval(kThumbnailMs);
    connect(&m_thumbnails, &QTimer::timeout, this, &LayersPanel::refreshThumbnails);
    connect(&state.target(), &EditTarget::changed, this, &LayersPanel::rebuild);
    connect(&state.options(), &ViewOptions::changed, &m_thumbnails, qOverload<>(&QTimer::start));
    connect(&state.document(), &model::Document::changed, this, &LayersPanel::onChanged);
    rebuild();
}

void LayersPanel::connectList()
{
    connect(m_list, &LayerList::currentRowChanged, this, [this](int row) {
        if (!m_filling && row >= 0)
            m_state.target().setLayer(m_list->idAt(row));
    });
    connect(m_list, &LayerList::visibleWanted, this, [this](int layer, bool visible) {
        change(layer, visible ? tr("Show layer") : tr("Hide layer"),
               [visible](LayerProperties& properties) { properties.visible = visible; });
    });
    connect(m_list, &LayerList::lockWanted, this, [this](int layer, bool locked) {
        change(layer, locked ? tr("Lock layer") : tr("Unlock layer"),
               [locked](LayerProperties& properties) { properties.locked = locked; });
    });
    // Queued: the list is still busy closing its editor or dropping.
    connect(
        m_list, &LayerList::renameWanted, this,
        [this](int layer, const QString& name) {
            change(layer, tr("Rename layer"), [&](LayerProperties& properties) { properties.name = name; });
        },
        Qt::QueuedConnection);
    connect(
        m_list, &LayerList::moveWanted, this,
        [this](int layer, int row) {
            m_state.document().endEdit();
            const model::MapStack* layers = stack();
            if (layers != nullptr)
                moveTo(layer, static_cast<int>(layers->layers.size()) - 1 - row);
        },
        Qt::QueuedConnection);
    connect(m_list, &LayerList::removeWanted, this, &LayersPanel::removeLayer);
    m_list->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(m_list, &QWidget::customContextMenuRequested, this, &LayersPanel::showMenu);
}

void LayersPanel::showMenu(QPoint position)
{
    if (QListWidgetItem* under = m_list->itemAt(position))
        m_list->setCurrentItem(under);
    const Layer* layer = activeLayer();
    auto* menu = new QMenu(this);
    menu->setObjectName(QStringLiteral("layerMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(tr("Add layer"), this, &LayersPanel::addLayer);
    if (layer != nullptr) {
        const model::Id id = layer->id;
        menu->addAction(tr("Duplicate layer"), this, &LayersPanel::duplicateLayer);
        menu->addAction(tr("Rename layer"), this, [this] { m_list->editItem(m_list->currentItem()); });
        menu->addSeparator();
        menu->addAction(layer->visible ? tr("Hide layer") : tr("Show layer"), this,
                        [this, id, visible = !layer->visible] { Q_EMIT m_list->visibleWanted(id, visible); });
        menu->addAction(layer->locked ? tr("Unlock layer") : tr("Lock layer"), this,
                        [this, id, locked = !layer->locked] { Q_EMIT m_list->lockWanted(id, locked); });
        menu->addSeparator();
        menu->addAction(tr("Move layer up"), this, [this] { moveLayer(1); })->setEnabled(m_up->isEnabled());
        menu->addAction(tr("Move layer down"), this, [this] { moveLayer(-1); })->setEnabled(m_down->isEnabled());
        menu->addSeparator();
        menu->addAction(tr("Remove layer"), this, &LayersPanel::removeLayer);
    }
    menu->popup(m_list->viewport()->mapToGlobal(position));
}

void LayersPanel::connectProperties()
{
    const auto show = [this](double percent) {
        if (!m_opacityEdit.active())
            m_state.document().endEdit(); // What somebody only looks at may have another layer.
        const model::LayerAddress target = m_opacityTarget;
        m_state.document().show(m_opacityEdit, {.text = tr("Layer opacity")},
                                {.aspect = Change::Aspect::LayerList, .group = target.group, .map = target.map},
                                [target, percent](model::Project& project) {
                                    if (Layer* layer = project.layer(target.group, target.map, target.layer))
                                        layer->opacity = static_cast<float>(percent / 100.0);
                                });
    };
    connect(m_opacity, &BarSlider::editingBegan, this, [this] { m_opacityTarget = m_state.target().address(); });
    connect(m_opacity, &BarSlider::valueChanged, this, show);
    connect(m_opacity, &BarSlider::editingFinished, this, [this] { m_opacityEdit.commit(); });
    connect(m_opacity, &BarSlider::editingCancelled, this, [this] { m_opacityEdit.drop(); });
    connect(m_blend, &QComboBox::activated, this, [this](int index) {
        const auto mode = static_cast<model::BlendMode>(m_blend->itemData(index).toInt());
        m_state.document().endEdit(); // Ends what is only looked at, with its layers.
        change(m_state.target().layer(), tr("Layer blend mode"),
               [mode](LayerProperties& properties) { properties.blend = mode; });
    });
}

const model::MapStack* LayersPanel::stack() const
{
    const model::HairGroup* group = m_state.document().project().group(m_state.target().group());
    return group != nullptr ? &group->map(m_state.target().map()) : nullptr;
}

const Layer* LayersPanel::activeLayer() const
{
    const model::LayerAddress target = m_state.target().address();
    return m_state.document().project().layer(target.group, target.map, target.layer);
}

void LayersPanel::onChanged(const Change& change)
{
    switch (change.aspect) {
    case Change::Aspect::Texels:
        if (change.group == m_state.target().group() && change.map == m_state.target().map() &&
            !m_thumbnails.isActive())
            m_thumbnails.start();
        break;
    case Change::Aspect::LayerList:
    case Change::Aspect::GroupList:
    case Change::Aspect::Everything:
        rebuild();
        break;
    default:
        break;
    }
}

void LayersPanel::rebuild()
{
    m_filling = true;
    const model::MapStack* layers = stack();
    const int count = layers != nullptr ? static_cast<int>(layers->layers.size()) : 0;
    while (m_list->count() > count)
        delete m_list->takeItem(m_list->count() - 1);
    for (int row = 0; row < count; ++row) {
        const Layer& layer = layers->layers[static_cast<std::size_t>(count - 1 - row)];
        QListWidgetItem* item = m_list->item(row);
        if (item == nullptr) {
            item = new QListWidgetItem(m_list);
            item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable | Qt::ItemIsDragEnabled);
        }
        if (item->data(LayerList::IdRole).toInt() != layer.id)
            item->setData(LayerList::ThumbnailRole, QImage());
        item->setText(model::shownName(layer.name));
        item->setData(LayerList::IdRole, layer.id);
        item->setData(LayerList::VisibleRole, layer.visible);
        item->setData(LayerList::LockedRole, layer.locked);
        item->setData(Qt::AccessibleTextRole, item->text() + (layer.visible ? QString() : tr(", hidden")) +
                                                  (layer.locked ? tr(", locked") : QString()));
        if (layer.id == m_state.target().layer())
            m_list->setCurrentRow(row);
    }
    followActive();
    m_filling = false;
    refreshThumbnails();
}

void LayersPanel::followActive()
{
    const model::LayerAddress target = m_state.target().address();
    if (std::exchange(m_shownTarget, target) != target)
        m_opacity->release(); // It stands for another layer's from here on.
    const Layer* layer = activeLayer();
    const model::MapStack* layers = stack();
    m_list->setEnabled(layers != nullptr);
    for (QWidget* widget : std::initializer_list<QWidget*>{m_opacity, m_blend, m_remove, m_duplicate, m_up, m_down})
        widget->setEnabled(layer != nullptr);
    m_blend->clear();
    for (const model::BlendMode mode : model::mapSpec(m_state.target().map()).blendModes)
        m_blend->addItem(model::blendRule(mode).titleText(), static_cast<int>(mode));
    if (layer == nullptr)
        return;
    m_blend->setCurrentIndex(std::max(m_blend->findData(static_cast<int>(layer->blend)), 0));
    m_blend->setEnabled(m_blend->count() > 1);
    m_opacity->setValue(static_cast<double>(layer->opacity) * 100.0);
    m_up->setEnabled(layers->layers.back().id != layer->id);
    m_down->setEnabled(layers->layers.front().id != layer->id);
}

void LayersPanel::refreshThumbnails()
{
    m_thumbnails.stop();
    const model::MapSpec& spec = model::mapSpec(m_state.target().map());
    const int side = qRound(LayerList::kThumbnailSide * devicePixelRatioF());
    const bool night = m_state.options().nightPaper();
    std::map<model::Id, Thumbnail> before = std::exchange(m_thumbnailOf, {});
    for (int row = 0; row < m_list->count(); ++row) {
        const model::Id id = m_list->idAt(row);
        const Layer* layer = m_state.document().project().layer(m_state.target().group(), spec.kind, id);
        if (layer == nullptr)
            continue;
        const auto known = before.find(id);
        const bool holds = known != before.end() && known->second.map == spec.kind &&
                           known->second.nightPaper == night && known->second.side == side &&
                           known->second.raster == layer->raster;
        QImage image = holds ? known->second.image : layerThumbnail(*layer, spec, night, side);
        m_drawnThumbnails += holds ? 0 : 1;
        m_list->item(row)->setData(LayerList::ThumbnailRole, image);
        m_thumbnailOf.insert_or_assign(id, Thumbnail{.raster = layer->raster,
                                                     .map = spec.kind,
                                                     .nightPaper = night,
                                                     .side = side,
                                                     .image = std::move(image)});
    }
}

void LayersPanel::change(model::Id layer, const QString& text, const std::function<void(LayerProperties&)>& edit)
{
    const model::LayerAddress address{.group = m_state.target().group(), .map = m_state.target().map(), .layer = layer};
    m_state.document().endEdit();
    const Layer* found = m_state.document().committed().layer(address.group, address.map, address.layer);
    if (found == nullptr)
        return;
    LayerProperties properties = model::propertiesOf(*found);
    edit(properties);
    m_state.document().push(setLayerPropertiesCommand(m_state.document(), address, properties, text));
}

// Each of the following ends what runs before it looks: a hovered style shows layers that are gone with it.

void LayersPanel::addLayer()
{
    m_state.document().endEdit();
    const model::MapStack* layers = stack();
    if (layers == nullptr)
        return;
    m_state.document().push(addLayerCommand(m_state.document(), m_state.target().group(), m_state.target().map(),
                                            model::layerName(static_cast<qsizetype>(layers->layers.size()) + 1)));
    if (const model::MapStack* after = stack(); after != nullptr && !after->layers.empty())
        m_state.target().setLayer(after->layers.back().id);
}

void LayersPanel::removeLayer()
{
    m_state.document().endEdit();
    if (activeLayer() != nullptr)
        m_state.document().push(removeLayerCommand(m_state.document(), m_state.target().address()));
}

void LayersPanel::duplicateLayer()
{
    m_state.document().endEdit();
    const Layer* layer = activeLayer();
    const model::MapStack* layers = stack();
    if (layer == nullptr || layers == nullptr)
        return;
    const auto position = static_cast<int>(layer - layers->layers.data()) + 1;
    const std::size_t before = layers->layers.size();
    Layer copy = *layer;
    copy.name = tr("%1 copy").arg(model::shownName(layer->name));
    m_state.document().push(insertLayerCommand(m_state.document(), m_state.target().group(), m_state.target().map(),
                                               std::move(copy), position,
                                               tr("Duplicate layer \"%1\"").arg(model::shownName(layer->name))));
    // A document that is full takes no more.
    if (const model::MapStack* after = stack(); after != nullptr && after->layers.size() > before)
        m_state.target().setLayer(after->layers[static_cast<std::size_t>(position)].id);
}

void LayersPanel::moveLayer(int steps)
{
    m_state.document().endEdit();
    const Layer* layer = activeLayer();
    if (layer != nullptr)
        moveTo(layer->id, static_cast<int>(layer - stack()->layers.data()) + steps);
}

void LayersPanel::moveTo(model::Id layer, int position)
{
    const model::MapStack* layers = stack();
    if (layers == nullptr || position < 0 || position >= static_cast<int>(layers->layers.size()))
        return;
    if (layers->layers[static_cast<std::size_t>(position)].id == layer)
        return;
    m_state.document().push(
        moveLayerCommand(m_state.document(),
                         {.group = m_state.target().group(), .map = m_state.target().map(), .layer = layer}, position));
    m_state.target().setLayer(layer);
}

} // namespace hairpaint::view
