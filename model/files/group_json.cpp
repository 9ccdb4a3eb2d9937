// The one list of a group's keys, and the structure of groups, maps and layers around it.
#include "model/files/group_json.h"

#include "model/files/json_fields.h"
#include "model/names.h"

#include <QCoreApplication>

#include <algorithm>
#include <bit>
#include <optional>

namespace hairpaint::model {

namespace {

constexpr std::array<Choice<sim::TurnsMode>, 2> kTurnsModes = {
    {{"per_hair", sim::TurnsMode::PerHair}, {"per_length", sim::TurnsMode::PerLength}}};
constexpr std::array<Choice<BlendMode>, 2> kBlendModes = {
    {{"normal", BlendMode::Normal}, {"multiply", BlendMode::Multiply}}};

template<typename Fields, typename Settings>
void visitSettings(Fields& fields, Settings& s)
{
    fields.number("greatest_density_per_m2", s.greatestDensityPerM2, 1e4F, 4e6F);
    fields.number("greatest_length_m", s.greatestLengthM, 0.001F, 2.0F);
    fields.number("shortest_length_m", s.shortestLengthM, 0.0F, 2.0F);
    fields.number("hair_width_m", s.hairWidthM, 1e-5F, 1e-3F);
    fields.integer("nodes_per_hair", s.nodesPerHair, sim::kLeastNodes, sim::kMostNodes);
    fields.integer("basis_hairs", s.basisHairs, 256, 1'000'000);
    fields.choice("turns_mode", s.turnsMode, kTurnsModes);
    fields.boolean("stepped_turns", s.steppedTurns);
    fields.number("turns_per_length_m", s.turnsPerLengthM, 0.001F, 10.0F);
    fields.number("greatest_curl_radius_m", s.greatestCurlRadiusM, 0.0F, 0.2F);
    fields.number("braid_spacing_m", s.braidSpacingM, 0.005F, 2.0F);
    fields.number("braid_radius_m", s.braidRadiusM, 0.0005F, 0.2F);
    fields.object("physics", [&p = s.physics](Fields& inner) {
        inner.number("damping_per_s", p.damping, 0.0F, 20.0F);
        inner.number("gravity_scale", p.gravityScale, 0.0F, 2.0F);
        inner.number("wind_scale", p.windScale, 0.0F, 4.0F);
        inner.number("body", p.body, 0.0F, 1.0F);
        inner.number("friction", p.friction, 0.0F, 1.0F);
        inner.number("volume_m", p.volumeM, 0.0F, 0.05F);
        inner.number("parting", p.parting, 0.0F, 1.0F);
        inner.number("sweep_back", p.sweepBack, 0.0F, 1.0F);
    });
    fields.object("material", [&m = s.material](Fields& inner) {
        inner.number("shine", m.shine, 0.0F, 1.0F);
        inner.number("roughness", m.roughness, 0.05F, 1.0F);
        inner.number("root_alpha", m.rootAlpha, 0.0F, 1.0F);
        inner.number("tip_alpha", m.tipAlpha, 0.0F, 1.0F);
        inner.number("colour_variation", m.colourVariation, 0.0F, 1.0F);
    });
}

template<typename Fields, typename AnyLayer>
void visitLayer(Fields& fields, AnyLayer& layer)
{
    fields.integer("id", layer.id, 0, kGreatestNextId);
    fields.text("name", layer.name);
    fields.boolean("visible", layer.visible);
    fields.number("opacity", layer.opacity, 0.0F, 1.0F);
    fields.choice("blend", layer.blend, kBlendModes);
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

/// A raster of one tile that holds a layer's place until its image is read.
sim::TiledRaster emptyRaster(const MapSpec& spec, int size)
{
    sim::Texel empty = spec.defaultValue;
    empty[static_cast<std::size_t>(spec.valueChannels)] = 0;
    return {size, spec.layerChannels(), empty};
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
        if (id < 1 || id >= m_nextId || m_ids.contains(id))
            complain();
        m_ids.insert(id);
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
            group.maps.push_back(parseStack(mapObjects.value(QLatin1String(spec.id)), spec));
        return group;
    }

    MapStack parseStack(const QJsonValue& value, const MapSpec& spec)
    {
        MapStack stack{.kind = spec.kind, .size = 1024, .layers = {}};
        if (value.isUndefined()) {
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
        Layer layer{.name = {}, .raster = emptyRaster(spec, sim::TiledRaster::kTileSize)};
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
    QSet<Id> m_ids;
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
        for (MapStack& stack : group.maps)
            for (Layer& layer : stack.layers)
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
    std::size_t layers = 0;
    bool fits = !groups.empty() && groups.size() <= kMostGroups;
    for (const HairGroup& group : groups)
        for (const MapStack& stack : group.maps) {
            layers += stack.layers.size();
            fits = fits && stack.layers.size() <= kMostLayersInMap;
        }
    if (!fits || layers > kMostLayers)
        return refuse(say(QT_TRANSLATE_NOOP("Files", "it has too many groups or layers; remove some")));
    return {};
}

QString layerEntryName(const HairGroup& group, const MapStack& stack, const Layer& layer)
{
    return QStringLiteral("groups/%1/%2/%3.png").arg(group.id).arg(QLatin1String(mapSpec(stack.kind).id)).arg(layer.id);
}

} // namespace hairpaint::model
