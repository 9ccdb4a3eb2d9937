// From the names of entries to groups, maps and layers.
#include "model/repair/orphaned_layers.h"

#include "model/files/group_json.h"
#include "model/values/names.h"

#include <QJsonArray>
#include <QRegularExpression>

#include <algorithm>
#include <optional>
#include <set>
#include <span>
#include <vector>

namespace hairpaint::model {

namespace {

const QString kIdKey = QStringLiteral("id");
const QString kNameKey = QStringLiteral("name");
const QString kMapsKey = QStringLiteral("maps");
const QString kSizeKey = QStringLiteral("size");
const QString kLayersKey = QStringLiteral("layers");
const QString kGroupsKey = QStringLiteral("groups");
const QString kNextIdKey = QStringLiteral("next_id");

/// A layer that has an image; where the JSON does not name it, it is an orphan.
struct Orphan
{
    Id group = 0;
    const MapSpec* spec = nullptr;
    Id layer = 0;
};

/// By their numbers: layers are made one after the other.
std::vector<Orphan> layersIn(const QStringList& names)
{
    static const QRegularExpression entry(QStringLiteral("^groups/(\\d{1,10})/(\\w+)/(\\d{1,10})\\.png$"));
    std::vector<Orphan> layers;
    for (const QString& name : names) {
        const QRegularExpressionMatch match = entry.match(name);
        const MapSpec* spec = match.hasMatch() ? findMapSpec(match.captured(2)) : nullptr;
        const Orphan layer{.group = match.captured(1).toInt(), .spec = spec, .layer = match.captured(3).toInt()};
        if (spec != nullptr && layer.group >= 1 && layer.layer >= 1 && layer.group < kGreatestNextId &&
            layer.layer < kGreatestNextId)
            layers.push_back(layer);
    }
    std::ranges::stable_sort(layers, {}, &Orphan::layer);
    return layers;
}

class Adoption
{
public:
    /// `there`: all layers that have an image.
    Adoption(const QJsonArray& groups, std::span<const Orphan> there, const SizeOfLayer& sizeOfLayer, Losses& losses)
        : m_there(there), m_sizeOfLayer(sizeOfLayer), m_losses(losses)
    {
        for (const QJsonValueConstRef value : groups) {
            QJsonObject group = value.toObject();
            m_ids.insert(group.value(kIdKey).toInt());
            QJsonObject maps = group.value(kMapsKey).toObject();
            for (const QString& map : maps.keys()) {
                QJsonObject stack = maps.value(map).toObject();
                stack.insert(kLayersKey,
                             withoutMislaid(group.value(kIdKey).toInt(), map, stack.value(kLayersKey).toArray()));
                maps.insert(map, stack);
            }
            group.insert(kMapsKey, maps);
            m_groups.push_back(group);
        }
    }

    void adopt(const Orphan& orphan)
    {
        const QString map = QLatin1StringView(orphan.spec->id);
        const int size = m_sizeOfLayer(orphan.group, map, orphan.layer);
        if (m_ids.contains(orphan.layer))
            return; // It is no orphan, or another stands for it.
        QJsonObject* group = groupOf(orphan.group);
        if (group == nullptr)
            return;
        QJsonObject maps = group->value(kMapsKey).toObject();
        QJsonObject stack = maps.value(map).toObject({{kSizeKey, size}});
        const QString name = layerName(stack.value(kLayersKey).toArray().size() + 1);
        const QString groupTitle = group->value(kNameKey).toString(QString::number(orphan.group));
        if (size == 0 || stack.value(kSizeKey).toInt() != size) {
            m_losses.layer(groupTitle, *orphan.spec, name);
            return;
        }
        QJsonArray layers = stack.value(kLayersKey).toArray();
        layers.append(QJsonObject{{kIdKey, orphan.layer}, {kNameKey, name}});
        m_ids.insert(orphan.layer);
        stack.insert(kLayersKey, layers);
        maps.insert(map, stack);
        group->insert(kMapsKey, maps);
        m_losses.layerProperties(groupTitle, *orphan.spec, name);
    }

    [[nodiscard]] QJsonArray groups() const
    {
        QJsonArray array;
        for (const QJsonObject& group : m_groups)
            array.append(group);
        return array;
    }
    [[nodiscard]] Id greatestId() const { return m_ids.empty() ? 0 : *m_ids.rbegin(); }

private:
    /// Without those that have an image elsewhere: a number of theirs is wrong. The others' ids are taken.
    [[nodiscard]] QJsonArray withoutMislaid(Id group, const QString& map, const QJsonArray& layers)
    {
        QJsonArray kept;
        for (const QJsonValueConstRef layer : layers) {
            const Id id = layer.toObject().value(kIdKey).toInt();
            const auto isHere = [&](const Orphan& one) {
                return one.layer == id && one.group == group && map == QLatin1StringView(one.spec->id);
            };
            if (std::ranges::none_of(m_there, isHere) &&
                std::ranges::find(m_there, id, &Orphan::layer) != m_there.end())
                continue;
            m_ids.insert(id);
            kept.append(layer);
        }
        return kept;
    }

    /// Null where there is none and none can be made.
    [[nodiscard]] QJsonObject* groupOf(Id id)
    {
        const auto found = std::ranges::find_if(
            m_groups, [id](const QJsonObject& group) { return group.value(kIdKey).toInt() == id; });
        if (found != m_groups.end())
            return &*found;
        if (m_groups.size() >= kMostGroups || !m_ids.insert(id).second)
            return nullptr;
        const QString name = groupName(static_cast<qsizetype>(m_groups.size()) + 1);
        m_losses.groupSettings(name);
        m_groups.push_back({{kIdKey, id}, {kNameKey, name}});
        return &m_groups.back();
    }

    std::span<const Orphan> m_there;
    const SizeOfLayer& m_sizeOfLayer;
    Losses& m_losses;
    std::vector<QJsonObject> m_groups;
    std::set<Id> m_ids;
};

} // namespace

void adoptOrphans(QJsonObject& root, const QStringList& names, const SizeOfLayer& sizeOfLayer, Losses& losses)
{
    const std::vector<Orphan> there = layersIn(names);
    Adoption adoption(root.value(kGroupsKey).toArray(), there, sizeOfLayer, losses);
    for (const Orphan& orphan : there)
        adoption.adopt(orphan);
    root.insert(kGroupsKey, adoption.groups());
    root.insert(kNextIdKey, std::clamp(root.value(kNextIdKey).toInt(), adoption.greatestId() + 1, kGreatestNextId));
}

} // namespace hairpaint::model
