// Reading and writing what is worn.
#include "model/files/worn_json.h"

#include "model/files/group_json.h"
#include "model/files/json_fields.h"
#include "model/project/worn_on_ties.h"

#include <algorithm>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <utility>

namespace hairpaint::model {

namespace {

constexpr const char* kWornKey = "worn";
constexpr const char* kKindKey = "kind";
constexpr const char* kIdKey = "id";
constexpr const char* kAnchorKey = "anchor";
constexpr const char* kGroupKey = "group";
constexpr const char* kSheenKey = "sheen";
constexpr const char* kMakeKey = "make";
constexpr const char* kTightnessKey = "tightness";
constexpr const char* kCoilKey = "coil_radius_m";
constexpr const char* kTieKey = "tie";
constexpr const char* kPatchKey = "patch";
constexpr const char* kMeshKey = "mesh";
constexpr const char* kMeshNameKey = "mesh_name";
constexpr int kGreatestPatch = 65535;

template<typename Fields>
void visitAnchor(Fields& fields, WornAnchor& anchor)
{
    auto face = static_cast<int>(anchor.face);
    fields.integer("face", face, 0, std::numeric_limits<int>::max());
    anchor.face = static_cast<std::uint32_t>(face);
    fields.numbers("barycentric", components(anchor.barycentric), 0.0F, 1.0F);
}

template<typename Fields>
void visitPatch(Fields& fields, WornPatch& patch)
{
    auto number = static_cast<int>(patch.number);
    fields.integer("number", number, 1, kGreatestPatch);
    patch.number = static_cast<std::uint16_t>(number);
    fields.boolean("placed_by_hand", patch.placedByHand);
    visitAnchor(fields, patch.at);
}

void visitMake(FieldReader& fields, Worn& worn)
{
    const std::span<const WornMake> makes = wornSpec(worn.kind).makes;
    QString id;
    fields.text(kMakeKey, id);
    const auto found =
        std::ranges::find_if(makes, [&id](const WornMake& make) { return id == QLatin1StringView(make.id); });
    if (found != makes.end())
        worn.make = static_cast<std::uint8_t>(found - makes.begin());
    else if (fields.contains(kMakeKey))
        fields.complain(kMakeKey);
}
void visitMake(FieldWriter& fields, Worn& worn)
{
    fields.text(kMakeKey, QString::fromLatin1(wornSpec(worn.kind).makes[worn.make].id));
}

/// Reads or writes what a thing is made of, where its kind has a choice, and the values of ties.
template<typename Fields>
void visitMaking(Fields& fields, Worn& worn)
{
    const WornSpec& spec = wornSpec(worn.kind);
    if (!spec.makes.empty())
        visitMake(fields, worn);
    if (spec.tie)
        fields.number(kTightnessKey, worn.tightness, 0.0F, 1.0F);
    if (spec.coilRadiusM > 0.0F)
        fields.number(kCoilKey, worn.coilRadiusM, 0.005F, 0.2F);
}

/// What goes with an own mesh, but for its number.
template<typename Fields>
void visitOwn(Fields& fields, Worn& worn)
{
    if (!wornSpec(worn.kind).ownMesh)
        return;
    fields.boolean("mirrored", worn.mirrored);
    fields.boolean("passable", worn.passable);
}

/// Keys that a writer leaves out where they say nothing.
void visitOthers(FieldReader& fields, Worn& worn)
{
    visitMaking(fields, worn);
    visitOwn(fields, worn);
    if (fields.contains(kPatchKey))
        fields.object(kPatchKey, [&worn](FieldReader& inner) { visitPatch(inner, worn.patch.emplace()); });
    fields.number(kSheenKey, worn.sheen, 0.0F, 1.0F);
    fields.integer(kGroupKey, worn.group, 0, kGreatestNextId);
    fields.integer(kTieKey, worn.tie, 0, kGreatestNextId);
    if (fields.contains(kAnchorKey))
        fields.object(kAnchorKey, [&worn](FieldReader& inner) { visitAnchor(inner, worn.anchor.emplace()); });
}
void visitOthers(FieldWriter& fields, Worn& worn)
{
    visitMaking(fields, worn);
    visitOwn(fields, worn);
    if (worn.patch)
        fields.object(kPatchKey, [&worn](FieldWriter& inner) { visitPatch(inner, *worn.patch); });
    if (worn.sheen != wornSpec(worn.kind).sheen)
        fields.number(kSheenKey, worn.sheen, 0.0F, 1.0F);
    if (worn.group != 0)
        fields.integer(kGroupKey, worn.group, 0, kGreatestNextId);
    if (worn.tie != 0)
        fields.integer(kTieKey, worn.tie, 0, kGreatestNextId);
    if (worn.anchor)
        fields.object(kAnchorKey, [&worn](FieldWriter& inner) { visitAnchor(inner, *worn.anchor); });
}

template<typename Fields>
void visitWorn(Fields& fields, Worn& worn)
{
    const WornSpec& spec = wornSpec(worn.kind);
    fields.integer(kIdKey, worn.id, -1, kGreatestNextId);
    fields.numbers("centre_m", components(worn.shape.centreHd), -100.0F, 100.0F);
    fields.numbers("semi_axes_m", components(worn.shape.semiAxesM), 1e-4F, 100.0F);
    glm::quat& rotation = worn.shape.rotation;
    std::array<float, 4> turn = {rotation.x, rotation.y, rotation.z, rotation.w};
    fields.numbers("rotation", std::span<float>(turn), -1.0F, 1.0F);
    rotation = glm::quat(turn[3], turn[0], turn[1], turn[2]);
    if (spec.drawn())
        fields.colour("colour", worn.colour);
    if (spec.ownArray == nullptr)
        visitOthers(fields, worn);
}

class WornParser
{
public:
    WornParser(const std::vector<HairGroup>& groups, Id nextId) : m_nextId(nextId)
    {
        for (const HairGroup& group : groups) {
            m_ids.insert(group.id);
            m_groups.insert(group.id);
            for (const MapStack& stack : group.maps)
                for (const Layer& layer : stack.layers)
                    m_ids.insert(layer.id);
        }
    }

    /// `only`: the kind of all of them; null: each tells its own.
    [[nodiscard]] Checked<void> parse(const QJsonObject& root, const char* key, const WornSpec* only)
    {
        constexpr qsizetype kMost = 4096; // More than all limits together.
        const QJsonValue value = root.value(QLatin1StringView(key));
        if (value.isUndefined())
            return {};
        QString problem;
        FieldReader owner(root, problem);
        const QJsonArray array = value.toArray();
        if (!value.isArray() || array.size() > kMost)
            owner.complain(key);
        for (const QJsonValueConstRef item : array) {
            if (!problem.isEmpty())
                break;
            const QJsonValue kind = item.toObject().value(QLatin1StringView(kKindKey));
            const WornSpec* spec = only != nullptr ? only : findWornSpec(kind.toString());
            if (spec == nullptr && kind.isString())
                return refuse(
                    say(QT_TRANSLATE_NOOP("Files", "something worn in it is of a kind that is not known to this one")),
                    Clause::Cure::NewerProgram);
            if (spec == nullptr || !item.isObject() || countOf(m_all, spec->kind) >= spec->limit ||
                !parseOne(item.toObject(), *spec, problem))
                owner.complain(key);
        }
        if (!problem.isEmpty())
            return refuse(problem);
        return {};
    }
    [[nodiscard]] std::vector<Worn> take()
    {
        std::map<Id, Id> ties;
        for (const Worn& one : m_all)
            if (one.id != 0 && wornSpec(one.kind).tie)
                ties.emplace(one.id, one.id);
        renameTies(m_all, ties);
        return std::move(m_all);
    }

private:
    bool parseOne(const QJsonObject& object, const WornSpec& spec, QString& problem)
    {
        Worn worn{.kind = spec.kind,
                  .colour = spec.colour,
                  .sheen = spec.sheen,
                  .tightness = spec.tie ? 1.0F : 0.0F,
                  .coilRadiusM = spec.coilRadiusM};
        FieldReader fields(object, problem);
        visitWorn(fields, worn);
        if (spec.ownMesh && fields.contains(kMeshKey))
            worn.ownMesh = meshOf(fields);
        const glm::quat& q = worn.shape.rotation;
        const bool hasId = fields.contains(kIdKey);
        if (glm::dot(q, q) < 1e-6F || (hasId && (worn.id < 1 || worn.id >= m_nextId || !m_ids.insert(worn.id).second)))
            return false;
        if (!m_groups.contains(worn.group))
            worn.group = 0;
        if (worn.patch && (worn.group == 0 || worn.patch->number == 0 || !m_patches.insert(worn.patch->number).second))
            worn.patch.reset();
        insertWorn(m_all, worn);
        return true;
    }

    /// Named, to be read later; one object a number.
    [[nodiscard]] SharedOwnMesh meshOf(FieldReader& fields)
    {
        OwnMesh named;
        fields.integer(kMeshKey, named.entry, 1, kMostOwnMeshes);
        fields.text(kMeshNameKey, named.name);
        named.name.truncate(kLongestName);
        std::shared_ptr<const OwnMesh>& known = m_meshes[named.entry];
        if (known == nullptr)
            known = std::make_shared<const OwnMesh>(std::move(named));
        return {.own = known};
    }

    Id m_nextId;
    std::map<int, std::shared_ptr<const OwnMesh>> m_meshes;
    std::set<std::uint16_t> m_patches;
    std::set<Id> m_ids, m_groups; // A QSet ends the program where memory runs out.
    std::vector<Worn> m_all;
};

} // namespace

namespace {

QJsonObject written(Worn worn, const char* kind)
{
    FieldWriter fields;
    if (kind != nullptr)
        fields.text(kKindKey, QString::fromLatin1(kind));
    visitWorn(fields, worn);
    return fields.take();
}

/// From 1 on; 0 where it is none of them.
int numberIn(const std::vector<std::shared_ptr<const OwnMesh>>& meshes, const SharedOwnMesh& mesh)
{
    const auto at = std::ranges::find_if(
        meshes, [&mesh](const std::shared_ptr<const OwnMesh>& one) { return mesh == SharedOwnMesh{.own = one}; });
    return at != meshes.end() ? static_cast<int>(at - meshes.begin()) + 1 : 0;
}

/// Its number and name.
void writeMesh(const Worn& worn, const std::vector<std::shared_ptr<const OwnMesh>>& meshes, QJsonObject& object)
{
    if (worn.ownMesh.own == nullptr)
        return;
    object.insert(QLatin1StringView(kMeshKey), numberIn(meshes, worn.ownMesh));
    object.insert(QLatin1StringView(kMeshNameKey), worn.ownMesh.own->name);
}

} // namespace

std::vector<std::shared_ptr<const OwnMesh>> ownMeshesOf(const std::vector<Worn>& all)
{
    std::vector<std::shared_ptr<const OwnMesh>> meshes;
    for (const Worn& one : all)
        if (one.ownMesh.own != nullptr && numberIn(meshes, one.ownMesh) == 0)
            meshes.push_back(one.ownMesh.own);
    return meshes;
}

void wornToJson(const std::vector<Worn>& all, const std::vector<HairGroup>& groups, QJsonObject& root)
{
    for (const WornSpec& spec : wornSpecs()) {
        if (spec.ownArray == nullptr)
            continue;
        QJsonArray array;
        for (const Worn& one : all)
            if (one.kind == spec.kind && array.size() < static_cast<qsizetype>(spec.limit))
                array.append(written(one, nullptr));
        root.insert(QLatin1StringView(spec.ownArray), array);
    }
    wornToPreset(all, groups, root);
}

void wornToPreset(const std::vector<Worn>& all, const std::vector<HairGroup>& groups, QJsonObject& root)
{
    QJsonArray others;
    const std::vector<std::shared_ptr<const OwnMesh>> meshes = ownMeshesOf(all);
    for (Worn one : all) {
        if (std::ranges::find(groups, one.group, &HairGroup::id) == groups.end())
            one.group = 0;
        if (wornSpec(one.kind).ownArray != nullptr)
            continue;
        QJsonObject object = written(one, wornSpec(one.kind).id);
        writeMesh(one, meshes, object);
        others.append(object);
    }
    if (!others.isEmpty())
        root.insert(QLatin1StringView(kWornKey), others);
}

bool needsWornArray(const std::vector<Worn>& all)
{
    return std::ranges::any_of(all, [](const Worn& one) { return wornSpec(one.kind).ownArray == nullptr; });
}

Checked<std::vector<Worn>> wornFromJson(const QJsonObject& root, const std::vector<HairGroup>& groups, Id nextId)
{
    WornParser parser(groups, nextId);
    for (const WornSpec& spec : wornSpecs())
        if (spec.ownArray != nullptr)
            if (Checked<void> parsed = parser.parse(root, spec.ownArray, &spec); !parsed)
                return tl::unexpected(parsed.error());
    if (Checked<void> parsed = parser.parse(root, kWornKey, nullptr); !parsed)
        return tl::unexpected(parsed.error());
    return parser.take();
}

Checked<std::vector<Worn>> wornOfPreset(const QJsonObject& root, const std::vector<HairGroup>& groups, Id nextId)
{
    WornParser parser(groups, nextId);
    if (Checked<void> parsed = parser.parse(root, kWornKey, nullptr); !parsed)
        return tl::unexpected(parsed.error());
    return parser.take();
}

} // namespace hairpaint::model
