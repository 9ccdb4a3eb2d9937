// Keeps what is active in step with the document.
#include "view/editing/edit_target.h"

#include "model/project/map_spec.h"
#include "model/values/names.h"

#include <algorithm>
#include <utility>

namespace hairpaint::view {

using model::Change;
using model::MapKind;

EditTarget::EditTarget(model::Document& document, QObject* parent) : QObject(parent), m_document(document)
{
    if (!document.project().groups.empty())
        m_group = document.project().groups.front().id;
    connect(&document, &model::Document::changed, this, &EditTarget::onDocumentChanged);
    connect(&document, &model::Document::undone, this, &EditTarget::followStep);
    connect(&document, &model::Document::redone, this, &EditTarget::followStep);
}

bool EditTarget::setGroup(model::Id group)
{
    if (group == m_group || m_document.project().group(group) == nullptr)
        return false;
    Q_EMIT aboutToChange();
    m_group = group;
    Q_EMIT rangesChanged(false);
    Q_EMIT changed();
    return true;
}

bool EditTarget::setMap(MapKind map)
{
    Q_EMIT mapChosen();
    if (map == m_map)
        return false;
    Q_EMIT aboutToChange();
    m_map = map;
    Q_EMIT changed();
    return true;
}

model::Id EditTarget::layer(MapKind map) const
{
    const model::HairGroup* group = m_document.project().group(m_group);
    if (group == nullptr || group->map(map).layers.empty())
        return 0;
    for (const model::LayerAddress& address : m_layers) {
        if (address.group == m_group && address.map == map &&
            m_document.project().layer(address.group, address.map, address.layer) != nullptr)
            return address.layer;
    }
    return group->map(map).layers.back().id;
}

bool EditTarget::setLayer(model::Id layerId)
{
    if (layerId == layer() || m_document.project().layer(m_group, m_map, layerId) == nullptr)
        return false;
    Q_EMIT aboutToChange();
    std::erase_if(m_layers,
                  [this](const model::LayerAddress& known) { return known.group == m_group && known.map == m_map; });
    m_layers.push_back({.group = m_group, .map = m_map, .layer = layerId});
    Q_EMIT changed();
    return true;
}

model::LayerAddress EditTarget::address() const
{
    return {.group = m_group, .map = m_map, .layer = layer()};
}

const sim::GroupSettings* EditTarget::knownSettings() const
{
    const model::HairGroup* group = m_document.project().group(m_group);
    return group != nullptr ? &group->settings : nullptr;
}

const sim::GroupSettings& EditTarget::settings() const
{
    static const sim::GroupSettings none;
    const sim::GroupSettings* known = knownSettings();
    return known != nullptr ? *known : none;
}

QString EditTarget::refusal() const
{
    return refusal(m_map);
}

QString EditTarget::refusal(MapKind map) const
{
    const model::HairGroup* group = m_document.project().group(m_group);
    if (group == nullptr)
        return tr("There is no hair group to paint on; add one in the Hair panel.");
    const model::Layer* painted = m_document.project().layer(m_group, map, layer(map));
    if (painted == nullptr)
        return tr("This map has no layer to paint on; add one in the Layers panel.");
    if (!group->visible)
        return tr("“%1” is hidden; show the group to paint on it.").arg(model::shownName(group->name));
    if (!painted->visible)
        return tr("“%1” is hidden; show the layer to paint on it.").arg(model::shownName(painted->name));
    if (painted->locked)
        return tr("“%1” is locked; unlock the layer to paint on it.").arg(model::shownName(painted->name));
    return {};
}

QString EditTarget::refusalOfOther(MapKind map) const
{
    if (m_document.project().group(m_group) == nullptr)
        return refusal(map);
    const QString reason = refusal(map);
    //: %1: a map's name; %2: a sentence that says why nothing can be painted on it.
    return reason.isEmpty() ? QString() : tr("%1: %2").arg(model::mapSpec(map).titleText(), reason);
}

bool EditTarget::hold(bool held)
{
    return std::exchange(m_held, held);
}

void EditTarget::followStep()
{
    const std::vector<Change> changes = std::exchange(m_stepped, {});
    const bool isShown = std::ranges::any_of(
        changes, [this](const Change& change) { return change.group == m_group && change.map == m_map; });
    if (changes.empty() || isShown || m_document.project().group(changes.back().group) == nullptr)
        return;
    m_group = changes.back().group;
    m_map = changes.back().map;
    Q_EMIT mapChosen();
    Q_EMIT rangesChanged(false);
    Q_EMIT changed();
}

void EditTarget::onDocumentChanged(const Change& change)
{
    if (change.aspect == Change::Aspect::Texels) {
        if (change.preview || m_held)
            return;
        m_stepped.push_back(change);
        if (!m_document.stepping())
            followStep(); // Nobody paints there, so this is an import.
        return;
    }
    if (change.aspect == Change::Aspect::Settings && change.group == m_group)
        Q_EMIT rangesChanged(!change.preview);
    const bool listsChanged = change.aspect == Change::Aspect::LayerList ||
                              change.aspect == Change::Aspect::GroupList || change.aspect == Change::Aspect::Everything;
    if (!listsChanged)
        return;
    const model::Project& project = m_document.project();
    if (project.group(m_group) == nullptr)
        m_group = project.groups.empty() ? 0 : project.groups.front().id;
    if (change.aspect == Change::Aspect::Everything)
        m_layers.clear();
    if (change.aspect != Change::Aspect::LayerList)
        Q_EMIT rangesChanged(!change.preview);
    Q_EMIT changed();
}

} // namespace hairpaint::view
