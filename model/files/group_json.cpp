// The one list of a group's keys, and the structure of groups, maps and layers around it.
#include "model/files/group_json.h"

#include "model/files/json_fields.h"
#include "model/project/group_schema.h"
#include "model/values/names.h"

#include <QCoreApplication>

#include <algorithm>
#include <bit>
#include <optional>
#include <set>
#include <type_traits>

namespace hairpaint::model {

namespace {

std::array<Choice<BlendMode>, kBlendModeCount> blendChoices()
{
    std::array<Choice<BlendMode>, kBlendModeCount> choices{};
    std::ranges::transform(blendRules(), choices.begin(), [](const BlendRule& rule) {
        return Choice<BlendMode>{rule.id, rule.mode};
    });
    return choices;
}

/// One row of the schema. Constant settings are only written.
template<typename Fields, typename Settings>
void visitSetting(Fields& fields, const GroupSetting& row, const char* key, Settings& settings)
{
    double value = row.read(settings);
    if (!row.choices.empty()) {
        QString id = QLatin1String(row.choices[static_cast<std::size_t>(value)].id);
        fields.text(key, id);
        const auto found = std::ranges::find_if(
            row.choices, [&](const SettingChoice& choice) { return id == QLatin1String(choice.id); });
        if constexpr (!std::is_const_v<Settings>)
            if (found == row.choices.end())
                return fields.complain(key);
        value = static_cast<double>(found - row.choices.begin());
    } else if (row.isSwitch()) {
        bool on = value != 0.0;
        fields.boolean(key, on);
        value = on ? 1.0 : 0.0;
    } else if (row.isInteger()) {
        int number = static_cast<int>(value);
        fields.integer(key, number, static_cast<int>(row.least), static_cast<int>(row.greatest));
        value = number;
    } else {
        auto number = static_cast<float>(value);
        fields.number(key, number, static_cast<float>(row.least), static_cast<float>(row.greatest));
        value = static_cast<double>(number);
    }
    if constexpr (!std::is_const_v<Settings>)
        row.write(settings, value);
}

/// The rows whose keys begin with `prefix` and have no further dot.
template<typename Fields, typename Settings>
void visitPart(Fields& fields, QLatin1StringView prefix, Settings& settings)
{
    for (const GroupSetting& row : groupSchema()) {
        const QLatin1StringView key(row.key);
        if (key.startsWith(prefix) && !key.mid(prefix.size()).contains(QLatin1Char('.')))
            visitSetting(fields, row, row.key + prefix.size(), settings);
    }
}

template<typename Fields, typename Settings>
void visitSettings(Fields& fields, Settings& settings)
{
    visitPart(fields, {}, settings);
    fields.object("curl", [&](Fields& inner) { visitPart(inner, QLatin1StringView("curl."), settings); });
    fields.object("locks", [&](Fields& inner) { visitPart(inner, QLatin1StringView("locks."), settings); });
    fields.object("variation", [&](Fields& inner) { visitPart(inner, QLatin1StringView("variation."), settings); });
    fields.object("hairline", [&](Fields& inner) { visitPart(inner, QLatin1StringView("hairline."), settings); });
    fields.object("physics", [&](Fields& inner) { visitPart(inner, QLatin1StringView("physics."), settings); });
    fields.object("material", [&](Fields& inner) { visitPart(inner, QLatin1StringView("material."), settings); });
}

template<typename Fields, typename AnyLayer>
void visitLayer(Fields& fields, AnyLayer& layer)
{
    fields.integer("id", layer.id, 0, kGreatestNextId);
    fields.text("name", layer.name);
    fields.boolean("visible", layer.visible);
    fields.number("opacity", layer.opacity, 0.0F, 1.0F);
    fields.choice("blend", layer.blend, blendChoices());
    fields.boolean("locked", layer.locked);
}

template<typename Fields, typename AnyGroup>
void visitGroup(Fields& fields, AnyGroup& group)
{
    fields.integer("id", group.id, 0, kGreatestNextId);
    fields.text("name", group.name);
    fields.boolean("visible", group.visible);
    fields.object("settings", [&group](Fields& inner) { visitSettings(inner, group.settings); });
}

class GroupsParser
{
public:
    explicit GroupsParser(Id nextId) : m_nextId(nextId) {}

    Checked<std::vector<HairGroup>> parse(const QJsonArray& array)
    {
        std::vector<HairGroup> groups;
        if (array.isEmpty() || array.size() > kMostGroups)
            return refuse(say(QT_TRANSLATE_NOOP("Files", "it holds no hair group, or too many")));
        for (const QJsonValueConstRef value : array) {
            if (!value.isObject())
                complain();
            groups.push_back(parseGroup(value.toObject()));
            if (!m_problem.isEmpty())
                return refuse(m_problem);
            if (!m_unknownMap.isEmpty())
                return refuse(
                    say(QT_TRANSLATE_NOOP("Files", "its map '%1' is not known to this one")).arg(m_unknownMap),
                    Clause::Cure::NewerProgram);
        }
        return groups;
    }

private:
    void complain()
    {
        if (m_problem.isEmpty())
            m_problem = say(QT_TRANSLATE_NOOP("Files", "its list of groups, maps and layers is broken"));
    }

    void takeId(Id id)
    {
        if (id < 1 || id >= m_nextId || !m_ids.insert(id).second)
            complain();
    }

    HairGroup parseGroup(const QJsonObject& object)
    {
        HairGroup group;
        FieldReader fields(object, m_problem);
        visitGroup(fields, group);
        takeId(group.id);
        const QJsonValue maps = object.value(QLatin1String("maps"));
        if (!maps.isUndefined() && !maps.isObject())
            complain();
        const QJsonObject mapObjects = maps.toObject();
        for (const QString& id : mapObjects.keys())
            if (findMapSpec(id) == nullptr)
                m_unknownMap = id.left(40);
        for (const MapSpec& spec : mapSpecs())
            group.maps.emplace_back(
                parseStack(mapObjects.value(QLatin1String(spec.id)), spec, sizeOfAbsent(spec, group.maps)));
        return group;
    }

    /// That of the map it follows, so that it shows the very same; else of the group's first.
    static int sizeOfAbsent(const MapSpec& spec, const std::vector<SharedStack>& before)
    {
        if (before.empty())
            return MapStack().size;
        return spec.follows ? before[sim::indexOf(*spec.follows)]->size : before.front()->size;
    }

    MapStack parseStack(const QJsonValue& value, const MapSpec& spec, int sizeIfAbsent)
    {
        MapStack stack{.kind = spec.kind, .size = sizeIfAbsent, .layers = {}};
        if (value.isUndefined()) {
            if (++m_layers > kMostLayers)
                complain();
            stack.layers.push_back(Layer{.name = layerName(1), .raster = emptyRaster(spec, stack.size)});
            return stack;
        }
        const QJsonObject object = value.toObject();
        const QJsonArray layers = object.value(QLatin1String("layers")).toArray();
        stack.size = object.value(QLatin1String("size")).toInt(0);
        const bool sizeFits = stack.size >= sim::TiledRaster::kSmallestSize &&
                              stack.size <= sim::TiledRaster::kLargestSize &&
                              std::has_single_bit(static_cast<unsigned>(stack.size));
        m_layers += static_cast<int>(layers.size());
        if (!value.isObject() || !object.value(QLatin1String("layers")).isArray() || !sizeFits ||
            layers.size() > kMostLayersInMap || m_layers > kMostLayers) {
            complain();
            return stack;
        }
        for (const QJsonValueConstRef layer : layers)
            stack.layers.push_back(parseLayer(layer, spec));
        return stack;
    }

    Layer parseLayer(const QJsonValue& value, const MapSpec& spec)
    {
        Layer layer{.name = {},
                    .raster = emptyRaster(
                        spec, sim::TiledRaster::kTileSize)}; // Keeps its position in the order until it is read.
        if (!value.isObject())
            complain();
        FieldReader fields(value.toObject(), m_problem);
        visitLayer(fields, layer);
        takeId(layer.id);
        if (std::ranges::find(spec.blendModes, layer.blend) == spec.blendModes.end())
            fields.complain("blend");
        return layer;
    }

    Id m_nextId;
    int m_layers = 0;
    std::set<Id> m_ids; // A QSet ends the program where memory runs out.
    QString m_problem;
    QString m_unknownMap;
};

QJsonObject stackToJson(const MapStack& stack)
{
    QJsonArray layers;
    for (const Layer& layer : stack.layers) {
        FieldWriter fields;
        visitLayer(fields, layer);
        layers.append(fields.take());
    }
    return {{QStringLiteral("size"), stack.size}, {QStringLiteral("layers"), layers}};
}

} // namespace

Id nextIdOf(const std::vector<HairGroup>& groups)
{
    Id next = 1;
    for (const HairGroup& group : groups) {
        next = std::max(next, group.id + 1);
        for (const MapStack& stack : group.maps)
            for (const Layer& layer : stack.layers)
                next = std::max(next, layer.id + 1);
    }
    return next;
}

bool idsFit(const std::vector<HairGroup>& groups, Id nextId)
{
    return std::max(nextId, nextIdOf(groups)) <= kGreatestNextId;
}

void renumber(std::vector<HairGroup>& groups, Id& nextId)
{
    nextId = 1;
    for (HairGroup& group : groups) {
        group.id = nextId++;
        for (SharedStack& stack : group.maps)
            for (Layer& layer : stack.write().layers)
                layer.id = nextId++;
    }
}

QJsonArray groupsToJson(const std::vector<HairGroup>& groups)
{
    QJsonArray array;
    for (const HairGroup& group : groups) {
        FieldWriter fields;
        visitGroup(fields, group);
        QJsonObject object = fields.take();
        QJsonObject maps;
        for (const MapStack& stack : group.maps)
            maps.insert(QLatin1String(mapSpec(stack.kind).id), stackToJson(stack));
        object.insert(QStringLiteral("maps"), maps);
        array.append(object);
    }
    return array;
}

Checked<std::vector<HairGroup>> groupsFromJson(const QJsonArray& array, Id nextId)
{
    return GroupsParser(nextId).parse(array);
}

Checked<void> checkGroupCounts(const std::vector<HairGroup>& groups)
{
    if (groups.empty() || countsExceed(groups))
        return refuse(say(QT_TRANSLATE_NOOP("Files", "it has too many groups or layers; remove some")));
    return {};
}

QString layerEntryName(const HairGroup& group, const MapStack& stack, const Layer& layer)
{
    return QStringLiteral("groups/%1/%2/%3.png").arg(group.id).arg(QLatin1String(mapSpec(stack.kind).id)).arg(layer.id);
}

} // namespace hairpaint::model
