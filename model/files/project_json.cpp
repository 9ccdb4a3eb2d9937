// project.json of projects and presets.
#include "model/files/project_json.h"

#include "model/files/group_json.h"
#include "model/files/json_fields.h"
#include "model/files/json_structure.h"
#include "model/files/migrations.h"
#include "model/files/worn_json.h"
#include "sim/groom/roots.h"

#include <QJsonDocument>

#include <algorithm>
#include <type_traits>

namespace hairpaint::model {

namespace {

constexpr int kDeepestJson = 32;
constexpr qsizetype kMostTags = 32;
constexpr float kFarthestLandmarkM = 1000.0F;

constexpr const char* kProjectFormat = "hairpaint project";
constexpr const char* kPresetFormat = "hairpaint preset";
constexpr std::array<Choice<UpAxis>, 2> kAxes = {{{"y", UpAxis::Y}, {"z", UpAxis::Z}}};

tl::unexpected<Clause> brokenKey(const char* key)
{
    return refuse(
        say(QT_TRANSLATE_NOOP("Files", "'%1' in project.json is not what it should be")).arg(QLatin1String(key)));
}

template<typename Fields, typename AnyWind>
void visitWind(Fields& fields, AnyWind& wind)
{
    fields.boolean("enabled", wind.enabled);
    fields.numbers("velocity_m_per_s", components(wind.velocity), -100.0F, 100.0F);
    fields.number("gustiness", wind.gustiness, 0.0F, 1.0F);
    fields.number("turbulence", wind.turbulence, 0.0F, 1.0F);
}

std::array<Choice<SkinTone>, kSkinToneCount> skinChoices()
{
    std::array<Choice<SkinTone>, kSkinToneCount> choices{};
    std::ranges::transform(skinLooks(), choices.begin(), [](const SkinLook& look) {
        return Choice<SkinTone>{look.id, look.tone};
    });
    return choices;
}

template<typename Enum, std::size_t N>
std::array<Choice<Enum>, N> choicesOf(std::span<const NamedValue, N> names)
{
    std::array<Choice<Enum>, N> choices{};
    for (std::size_t i = 0; i < N; ++i)
        choices.at(i) = {names[i].id, static_cast<Enum>(i)};
    return choices;
}

template<typename Fields>
void visitLight(Fields& fields, LightSettings& light)
{
    fields.number("azimuth_rad", light.azimuthRad, -1000.0F, 1000.0F);
    fields.number("elevation_rad", light.elevationRad, -1.5708F, 1.5708F);
    fields.number("intensity", light.intensity, 0.0F, 4.0F);
    fields.number("ambient", light.ambient, 0.0F, 1.0F);
    std::array<float, 3> colour = {light.red, light.green, light.blue};
    fields.numbers("colour", std::span<float>(colour), 0.0F, 1.0F);
    light.red = colour[0];
    light.green = colour[1];
    light.blue = colour[2];
    fields.number("temperature_k", light.temperatureK, kLeastTemperatureK, kGreatestTemperatureK);
    fields.number("fill", light.fill, 0.0F, 2.0F);
    fields.number("rim", light.rim, 0.0F, 4.0F);
    fields.choice("surroundings", light.surroundings, choicesOf<Surroundings>(surroundingsNames()));
    fields.choice("scattering", light.scattering, choicesOf<Scattering>(scatteringNames()));
}

template<typename Fields, typename AnyHead>
void visitHead(Fields& fields, AnyHead& head)
{
    fields.text("name", head.name);
    fields.boolean("built_in", head.builtIn);
    fields.number("unit_scale_m", head.unitScale, 1e-6F, 1e6F);
    fields.choice("up_axis", head.upAxis, kAxes);
}

template<typename Fields>
void visitLandmarks(Fields& fields, sim::HeadLandmarks& landmarks)
{
    constexpr std::array<const char*, sim::kHeadLandmarkCount> kKeys = {"crown",     "hairline", "nape", "ear_left",
                                                                        "ear_right", "nose_tip", "chin"};
    for (std::size_t i = 0; i < kKeys.size(); ++i) {
        fields.numbers(kKeys[i], components(landmarks.positionsHd[i]), -kFarthestLandmarkM, kFarthestLandmarkM);
        if constexpr (std::is_same_v<Fields, FieldReader>)
            if (!fields.contains(kKeys[i]))
                fields.complain(kKeys[i]);
    }
}

void writeReference(FieldWriter& fields, const Head& head)
{
    visitHead(fields, head);
    if (!head.builtIn && head.landmarks)
        fields.object("landmarks_m", [landmarks = *head.landmarks](FieldWriter& inner) {
            sim::HeadLandmarks copy = landmarks;
            visitLandmarks(inner, copy);
        });
}

void readReference(FieldReader& fields, HeadReference& head)
{
    visitHead(fields, head);
    if (!head.builtIn && fields.contains("landmarks_m"))
        fields.object("landmarks_m", [&head](FieldReader& inner) { visitLandmarks(inner, head.landmarks.emplace()); });
}

/// Qt's parser stops at 1024 levels; so deep a value would still be taken.
bool nestsTooDeep(const QByteArray& json)
{
    int depth = 0;
    visitJsonStructure(json, [&depth](qsizetype /*at*/, char c) {
        depth += c == '{' || c == '[' ? 1 : c == ',' ? 0 : -1;
        return depth <= kDeepestJson;
    });
    return depth > kDeepestJson;
}

/// As it was written.
Checked<QJsonObject> parseRoot(const QByteArray& json, const char* format)
{
    if (json.size() > kMostJsonBytes || nestsTooDeep(json))
        return refuse(say(QT_TRANSLATE_NOOP("Files", "its project.json is too large or nested too deep")));
    QJsonParseError problem;
    const QJsonDocument document = QJsonDocument::fromJson(json, &problem);
    if (problem.error != QJsonParseError::NoError || !document.isObject())
        return refuse(say(QT_TRANSLATE_NOOP("Files", "its project.json can't be understood")));
    if (document.object().value(QLatin1String("format")).toString() != QLatin1String(format))
        return brokenKey("format");
    return document.object();
}

/// What groups of the first version say in settings that are gone.
Checked<std::vector<std::optional<FormerCombing>>> parseFormerCombing(const QJsonObject& root)
{
    std::vector<std::optional<FormerCombing>> all;
    QString problem;
    const QJsonArray groups = root.value(QLatin1String("groups")).toArray();
    for (const QJsonValueConstRef value : groups) {
        const QJsonObject group = value.toObject();
        if (group.value(QLatin1String("maps")).toObject().contains(QLatin1String(mapSpec(MapKind::Direction).id))) {
            all.emplace_back();
            continue;
        }
        FormerCombing& combing = all.emplace_back().emplace();
        FieldReader fields(group, problem);
        fields.object("settings", [&combing](FieldReader& settings) {
            settings.object("physics", [&combing](FieldReader& physics) {
                physics.number("parting", combing.parting, 0.0F, 1.0F);
                physics.number("sweep_back", combing.sweepBack, 0.0F, 1.0F);
                physics.number("body", combing.body, 0.0F, 1.0F);
            });
        });
    }
    if (!problem.isEmpty())
        return refuse(problem);
    return all;
}

Checked<Id> parseNextId(const QJsonObject& root)
{
    const QJsonValue value = root.value(QLatin1String("next_id"));
    const Id id = value.toInt(0);
    if (id < 1 || id > kGreatestNextId)
        return brokenKey("next_id");
    return id;
}

/// Gives ids to the layers that stand for absent maps.
void fillIds(std::vector<HairGroup>& groups, Id& nextId)
{
    for (HairGroup& group : groups)
        for (SharedStack& map : group.maps)
            for (Layer& layer : map.write().layers)
                if (layer.id == 0)
                    layer.id = nextId++;
}

Checked<std::vector<HairGroup>> parseGroups(const QJsonObject& root, Id& nextId)
{
    const QJsonValue groups = root.value(QLatin1String("groups"));
    if (!groups.isArray())
        return brokenKey("groups");
    Checked<std::vector<HairGroup>> parsed = groupsFromJson(groups.toArray(), nextId);
    if (parsed)
        fillIds(*parsed, nextId);
    return parsed;
}

Checked<void> parseSeed(const QJsonObject& root, std::uint64_t& seed)
{
    const QJsonValue value = root.value(QLatin1String("seed"));
    if (value.isUndefined())
        return {};
    const QString digits = value.toString();
    const auto isDigit = [](QChar c) { return c >= QLatin1Char('0') && c <= QLatin1Char('9'); };
    bool ok = false;
    seed = digits.toULongLong(&ok);
    if (!value.isString() || !ok || !std::ranges::all_of(digits, isDigit))
        return brokenKey("seed");
    return {};
}

Checked<void> parseRoots(const QJsonObject& root)
{
    const QJsonValue roots = root.value(QLatin1String("roots"));
    if (roots.isUndefined())
        return {};
    if (!roots.isObject() || roots.toObject().value(QLatin1String("algorithm")).toInt(0) != sim::kRootsAlgorithm)
        return refuse(say(QT_TRANSLATE_NOOP("Files", "its way of drawing roots is not known to this one")),
                      Clause::Cure::NewerProgram);
    return {};
}

int leastVersion(const Head* head, bool hasWorn)
{
    if (head != nullptr && (!head->parts.empty() || head->texture))
        return kFormatVersion;
    return hasWorn ? kWornFormatVersion : kPlainFormatVersion;
}

QByteArray toBytes(QJsonObject root, const char* format, int version)
{
    root.insert(QStringLiteral("format"), QLatin1String(format));
    root.insert(QStringLiteral("format_version"), version);
    return QJsonDocument(root).toJson(QJsonDocument::Indented);
}

template<typename Fields, typename Step>
void visitStep(Fields& fields, Step& step)
{
    fields.text("tool", step.tool);
    fields.text("on", step.on);
    fields.integer("count", step.count, 1, kMostStepUses);
}

QJsonArray stepsToJson(const std::vector<StyleStep>& steps)
{
    QJsonArray array;
    for (std::size_t i = 0; i < std::min(steps.size(), kMostSteps); ++i) {
        FieldWriter fields;
        visitStep(fields, steps[i]);
        array.append(fields.take());
    }
    return array;
}

Checked<std::vector<StyleStep>> stepsFromJson(const QJsonObject& root)
{
    const QJsonValue given = root.value(QLatin1String("steps"));
    const QJsonArray array = given.toArray();
    if (!(given.isUndefined() || given.isArray()) || static_cast<std::size_t>(array.size()) > kMostSteps)
        return brokenKey("steps");
    std::vector<StyleStep> steps;
    for (const QJsonValueConstRef one : array) {
        if (!one.isObject())
            return brokenKey("steps");
        QString problem;
        FieldReader fields(one.toObject(), problem);
        visitStep(fields, steps.emplace_back());
        if (!problem.isEmpty())
            return refuse(problem);
    }
    return steps;
}

} // namespace

int formatVersionOf(const Project& project)
{
    return leastVersion(project.head.get(), needsWornArray(project.worn));
}

Checked<QByteArray> projectToJson(const Project& project)
{
    if (Checked<void> counts = checkGroupCounts(project.groups); !counts)
        return tl::unexpected(counts.error());
    FieldWriter fields;
    Id nextId = std::max(project.nextId, nextIdOf(project.groups));
    for (const Worn& one : project.worn)
        nextId = std::max(nextId, one.id + 1);
    fields.integer("next_id", nextId, 1, kGreatestNextId);
    fields.text("seed", QString::number(project.seed));
    fields.integer("max_hairs", project.maxHairs, 1, kMostHairs);
    fields.object("roots", [](FieldWriter& inner) { inner.integer("algorithm", sim::kRootsAlgorithm, 1, 1 << 20); });
    fields.colour("background", project.background);
    fields.choice("skin", project.skin, skinChoices());
    if (project.head)
        fields.object("head", [&project](FieldWriter& inner) { writeReference(inner, *project.head); });
    fields.object("wind", [&project](FieldWriter& inner) { visitWind(inner, project.wind); });
    fields.object("light", [light = project.light](FieldWriter& inner) {
        LightSettings copy = light;
        visitLight(inner, copy);
    });
    QJsonObject root = fields.take();
    wornToJson(project.worn, project.groups, root);
    root.insert(QStringLiteral("groups"), groupsToJson(project.groups));
    return toBytes(std::move(root), kProjectFormat, formatVersionOf(project));
}

Checked<ProjectManifest> projectFromJson(const QByteArray& json)
{
    const Checked<QJsonObject> written = parseRoot(json, kProjectFormat);
    if (!written)
        return tl::unexpected(written.error());
    const Checked<QJsonObject> root = migrated(*written);
    if (!root)
        return tl::unexpected(root.error());
    ProjectManifest manifest;
    Project& project = manifest.project;
    const Checked<Id> nextId = parseNextId(*root);
    if (!nextId)
        return tl::unexpected(nextId.error());
    project.nextId = *nextId;
    for (const Checked<void>& part : {parseSeed(*root, project.seed), parseRoots(*root)})
        if (!part)
            return tl::unexpected(part.error());

    QString problem;
    FieldReader fields(*root, problem);
    fields.integer("max_hairs", project.maxHairs, 1, kMostHairs);
    fields.colour("background", project.background);
    fields.choice("skin", project.skin, skinChoices());
    fields.object("wind", [&project](FieldReader& inner) { visitWind(inner, project.wind); });
    fields.object("light", [&project](FieldReader& inner) { visitLight(inner, project.light); });
    fields.object("head", [&manifest](FieldReader& inner) { readReference(inner, manifest.head); });
    if (manifest.head.name.isEmpty())
        fields.complain("head");
    if (!problem.isEmpty())
        return refuse(problem);

    Checked<std::vector<HairGroup>> groups = parseGroups(*root, project.nextId);
    if (!groups)
        return tl::unexpected(groups.error());
    project.groups = std::move(*groups);
    Checked<std::vector<Worn>> worn = wornFromJson(*root, project.groups, *nextId);
    if (!worn)
        return tl::unexpected(worn.error());
    project.worn = std::move(*worn);
    for (Worn& one : project.worn)
        if (one.id == 0)
            one.id = project.takeId();
    constexpr int kFirstWithDirections = 2;
    if (written->value(QLatin1String("format_version")).toInt() < kFirstWithDirections) {
        Checked<std::vector<std::optional<FormerCombing>>> combing = parseFormerCombing(*written);
        if (!combing)
            return tl::unexpected(combing.error());
        manifest.formerCombing = std::move(*combing);
    }
    return manifest;
}

Checked<QByteArray> presetToJson(const Preset& preset)
{
    if (Checked<void> counts = checkGroupCounts(preset.groups); !counts)
        return tl::unexpected(counts.error());
    FieldWriter fields;
    fields.text("name", preset.name);
    if (preset.head)
        fields.object("head", [&preset](FieldWriter& inner) { writeReference(inner, *preset.head); });
    Id nextId = nextIdOf(preset.groups);
    for (const Worn& one : preset.worn)
        nextId = std::max(nextId, one.id + 1);
    fields.integer("next_id", nextId, 1, kGreatestNextId);
    QJsonObject root = fields.take();
    wornToPreset(preset.worn, preset.groups, root);
    QJsonArray tags;
    for (const QString& tag : preset.tags)
        if (tags.size() < kMostTags)
            tags.append(tag.left(kLongestName));
    root.insert(QStringLiteral("tags"), tags);
    if (!preset.steps.empty())
        root.insert(QStringLiteral("steps"), stepsToJson(preset.steps));
    root.insert(QStringLiteral("groups"), groupsToJson(preset.groups));
    return toBytes(std::move(root), kPresetFormat, leastVersion(preset.head.get(), !preset.worn.empty()));
}

Checked<PresetManifest> presetFromJson(const QByteArray& json)
{
    const Checked<QJsonObject> written = parseRoot(json, kPresetFormat);
    if (!written)
        return tl::unexpected(written.error());
    const Checked<QJsonObject> root = migrated(*written);
    if (!root)
        return tl::unexpected(root.error());
    // Files of the first version do not say; there was one head.
    PresetManifest manifest{.preset = {}, .head = {.name = QStringLiteral("bust-1")}};
    Preset& preset = manifest.preset;
    Checked<Id> nextId = parseNextId(*root);
    if (!nextId)
        return tl::unexpected(nextId.error());
    QString problem;
    FieldReader fields(*root, problem);
    fields.text("name", preset.name);
    if (fields.contains("head")) {
        manifest.head.name.clear();
        fields.object("head", [&manifest](FieldReader& inner) { readReference(inner, manifest.head); });
        if (manifest.head.name.isEmpty())
            fields.complain("head");
    }
    if (!problem.isEmpty())
        return refuse(problem);
    const QJsonValue tags = root->value(QLatin1String("tags"));
    if (!(tags.isUndefined() || tags.isArray()) || tags.toArray().size() > kMostTags)
        return brokenKey("tags");
    const QJsonArray tagArray = tags.toArray();
    for (const QJsonValueConstRef tag : tagArray) {
        if (!tag.isString() || tag.toString().size() > kLongestName)
            return brokenKey("tags");
        preset.tags.append(tag.toString());
    }
    Checked<std::vector<StyleStep>> steps = stepsFromJson(*root);
    if (!steps)
        return tl::unexpected(steps.error());
    preset.steps = std::move(*steps);
    Checked<std::vector<HairGroup>> groups = parseGroups(*root, *nextId);
    if (!groups)
        return tl::unexpected(groups.error());
    preset.groups = std::move(*groups);
    Checked<std::vector<Worn>> worn = wornOfPreset(*root, preset.groups, *nextId);
    if (!worn)
        return tl::unexpected(worn.error());
    preset.worn = std::move(*worn);
    return manifest;
}

} // namespace hairpaint::model
