// The reader itself says what it takes: each part is put, alone, into a project that is known to be good.
#include "model/repair/mended_json.h"

#include "model/files/group_json.h"
#include "model/files/json_structure.h"
#include "model/files/migrations.h"
#include "model/files/project_json.h"

#include <QJsonArray>
#include <QJsonDocument>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

namespace hairpaint::model {

namespace {

constexpr auto kMendedFormat = "hairpaint project";
struct RootKey
{
    const char* key;
    int since = 1; ///< The first format version that has the key.
};
/// Keys of the root of project.json, in the order in which they are written; without the head, the groups and what is
/// found anew.
constexpr std::array<RootKey, 8> kRootKeys = {
    {{"background"}, {"ellipsoids"}, {"light"}, {"max_hairs"}, {"seed"}, {"skin"}, {"wind"}, {"worn", 3}}};

/// `value`, and where it is a list of what is worn, the things in it without the ids that `keeps` refuses.
template<typename Keeps>
QJsonValue withIds(const QJsonValue& value, const Keeps& keeps)
{
    if (!value.isArray())
        return value;
    QJsonArray array = value.toArray();
    for (QJsonValueRef item : array) {
        QJsonObject object = item.toObject();
        const QLatin1StringView id("id");
        if (!object.contains(id) || keeps(object.value(id).toInt(0)))
            continue;
        object.remove(id);
        item = object;
    }
    return array;
}

/// A position in the text before which all is whole, and the brackets that are open there.
struct CutPoint
{
    qsizetype at = 0;
    QByteArray closing; ///< The last one first.
};

/// The last such positions before `end`, the latest first.
std::vector<CutPoint> cutPoints(const QByteArray& json, qsizetype end)
{
    constexpr std::size_t kMost = 64;
    std::vector<CutPoint> points;
    QByteArray open;
    const auto note = [&](qsizetype at) {
        QByteArray closing = open;
        std::ranges::reverse(closing);
        if (points.size() == 2 * kMost)
            points.erase(points.begin(), points.begin() + kMost);
        points.push_back({.at = at, .closing = std::move(closing)});
    };
    visitJsonStructure(QByteArrayView(json).first(std::min(end, json.size())), [&](qsizetype at, char c) {
        if (c == '{' || c == '[')
            open.append(c == '{' ? '}' : ']');
        else if (c != ',' && !open.isEmpty())
            open.chop(1);
        note(c == ',' ? at : at + 1);
        return true;
    });
    std::ranges::reverse(points);
    return points;
}

QJsonValue valueAt(const QJsonObject& object, const char* key)
{
    return object.value(QLatin1StringView(key));
}

class Mender
{
public:
    Mender(const CutJson& json, const SizeOfLayer& sizeOfLayer, Losses& losses)
        : m_json(json), m_sizeOfLayer(sizeOfLayer), m_losses(losses)
    {
        const int version = valueAt(json.root, "format_version").toInt(0);
        m_good = {
            {QStringLiteral("format"), QLatin1StringView(kMendedFormat)},
            {QStringLiteral("format_version"), version >= 1 && version <= kFormatVersion ? version : kFormatVersion},
            {QStringLiteral("next_id"), kGreatestNextId},
            {QStringLiteral("head"), QJsonObject{{QStringLiteral("name"), QStringLiteral("bust-1")}}},
            {QStringLiteral("groups"), QJsonArray{QJsonObject{{QStringLiteral("id"), 1}}}}};
    }

    QJsonObject mend()
    {
        QJsonObject root = m_good;
        const QString lastKey = m_json.root.isEmpty() ? QString() : m_json.root.keys().constLast();
        for (const auto& [key, since] : kRootKeys) {
            const QJsonValue value = withIds(valueAt(m_json.root, key), [](int) { return false; });
            const bool isCutOff = !m_json.isWhole && value.isUndefined() && lastKey < QLatin1StringView(key) &&
                                  valueAt(m_good, "format_version").toInt() >= since;
            if (!value.isUndefined() && takes(QLatin1StringView(key), value))
                root.insert(QLatin1StringView(key), valueAt(m_json.root, key));
            else if (isCutOff || !value.isUndefined())
                m_losses.setting(QLatin1StringView(key));
        }
        if (const QJsonValue head = valueAt(m_json.root, "head"); takes(QStringLiteral("head"), head))
            root.insert(QStringLiteral("head"), head);
        root.insert(QStringLiteral("groups"), mendedGroups());
        for (const auto& [key, since] : kRootKeys)
            if (root.contains(QLatin1StringView(key)))
                root.insert(QLatin1StringView(key), withIds(valueAt(root, key), [this](int id) { return takeId(id); }));
        const int nextId = valueAt(m_json.root, "next_id").toInt(0);
        const Id least = m_ids.empty() ? 1 : *m_ids.rbegin() + 1;
        root.insert(QStringLiteral("next_id"), std::clamp(nextId, least, kGreatestNextId));
        return root;
    }

private:
    [[nodiscard]] bool takes(const QString& key, const QJsonValue& value) const
    {
        QJsonObject trial = m_good;
        trial.insert(key, value);
        return projectFromJson(QJsonDocument(trial).toJson(QJsonDocument::Compact)).has_value();
    }

    [[nodiscard]] bool takesGroup(const QJsonObject& group) const
    {
        return takes(QStringLiteral("groups"), QJsonArray{group});
    }

    [[nodiscard]] QJsonArray mendedGroups()
    {
        QJsonArray mended;
        const QJsonArray groups = valueAt(m_json.root, "groups").toArray();
        for (qsizetype i = 0; i < groups.size() && mended.size() < kMostGroups; ++i) {
            const QJsonObject group = groups[i].toObject();
            const int id = valueAt(group, "id").toInt(0);
            if (!takeId(id)) {
                m_losses.group(i + 1);
                continue;
            }
            mended.append(mendedGroup(group));
        }
        return mended;
    }

    [[nodiscard]] bool takeId(int id) { return id >= 1 && id < kGreatestNextId && m_ids.insert(id).second; }

    [[nodiscard]] QJsonObject mendedGroup(const QJsonObject& group)
    {
        QJsonObject mended{{QStringLiteral("id"), valueAt(group, "id")}};
        const QJsonValue name = valueAt(group, "name");
        m_group = name.toString().left(kLongestShownName);
        if (m_group.isEmpty())
            m_group = QString::number(valueAt(group, "id").toInt());
        for (const char* key : {"name", "visible"})
            if (const QJsonValue value = valueAt(group, key); !value.isUndefined())
                addTo(mended, QLatin1StringView(key), value);
        const QJsonValue settings = valueAt(group, "settings");
        if (!m_json.isWhole && !group.contains(QLatin1StringView("visible"))) // The last of its keys.
            m_losses.groupSettings(m_group);
        if (!settings.isUndefined())
            mended.insert(QStringLiteral("settings"), mendedSettings(mended, settings.toObject()));
        QJsonObject maps;
        const QJsonObject written = valueAt(group, "maps").toObject();
        for (const QString& id : written.keys()) {
            const QJsonObject map = mendedMap(valueAt(group, "id").toInt(), id, written.value(id).toObject());
            if (!map.isEmpty())
                maps.insert(id, map);
            else
                m_losses.map(m_group, id);
        }
        mended.insert(QStringLiteral("maps"), maps);
        return mended;
    }

    /// Only what the reader takes.
    void addTo(QJsonObject& group, const QString& key, const QJsonValue& value)
    {
        QJsonObject trial = group;
        trial.insert(key, value);
        if (takesGroup(trial))
            group = trial;
        else
            m_losses.groupSetting(m_group, key);
    }

    [[nodiscard]] QJsonObject mendedSettings(const QJsonObject& group, const QJsonObject& settings)
    {
        const auto takesSettings = [&](const QJsonObject& trial) {
            QJsonObject whole = group;
            whole.insert(QStringLiteral("settings"), trial);
            return takesGroup(whole);
        };
        if (takesSettings(settings))
            return settings;
        QJsonObject mended;
        for (const QString& key : settings.keys()) {
            QJsonObject trial = mended;
            trial.insert(key, settings.value(key));
            if (takesSettings(trial)) {
                mended = trial;
                continue;
            }
            if (!settings.value(key).isObject()) {
                m_losses.groupSetting(m_group, key);
                continue;
            }
            QJsonObject part;
            const QJsonObject inner = settings.value(key).toObject();
            for (const QString& innerKey : inner.keys()) {
                QJsonObject longer = part;
                longer.insert(innerKey, inner.value(innerKey));
                if (takesSettings({{key, longer}}))
                    part = longer;
                else
                    m_losses.groupSetting(m_group, key + QLatin1Char('.') + innerKey);
            }
            mended.insert(key, part);
        }
        return mended;
    }

    [[nodiscard]] bool takesMap(const QString& id, const QJsonObject& map) const
    {
        // Ids are compared with those of the good group.
        return takesGroup(
            {{QStringLiteral("id"), kGreatestNextId - 1}, {QStringLiteral("maps"), QJsonObject{{id, map}}}});
    }

    /// Empty where nothing of it can be taken.
    [[nodiscard]] QJsonObject mendedMap(Id group, const QString& id, const QJsonObject& map)
    {
        const MapSpec* spec = findMapSpec(id);
        if (spec == nullptr)
            return {};
        const QJsonArray written = valueAt(map, "layers").toArray();
        QJsonObject mended{{QStringLiteral("size"), valueAt(map, "size")}, {QStringLiteral("layers"), QJsonArray{}}};
        for (qsizetype i = 0; i < written.size() && !takesMap(id, mended); ++i)
            mended.insert(QStringLiteral("size"),
                          m_sizeOfLayer(group, id, valueAt(written[i].toObject(), "id").toInt(0)));
        if (!takesMap(id, mended))
            return {};
        QJsonArray layers;
        for (const QJsonValueConstRef layer : written) {
            const QJsonObject taken = mendedLayer(*spec, mended, layer.toObject());
            if (taken.isEmpty())
                m_losses.layer(m_group, *spec, valueAt(layer.toObject(), "name").toString());
            else
                layers.append(taken);
        }
        mended.insert(QStringLiteral("layers"), layers);
        return mended;
    }

    /// `map`: what is good of it, without layers.
    [[nodiscard]] QJsonObject mendedLayer(const MapSpec& spec, const QJsonObject& map, const QJsonObject& layer)
    {
        const auto takesLayer = [&](const QJsonObject& trial) {
            QJsonObject whole = map;
            whole.insert(QStringLiteral("layers"), QJsonArray{trial});
            return takesMap(QLatin1StringView(spec.id), whole);
        };
        const QJsonValue id = valueAt(layer, "id");
        if (!takeId(id.toInt(0)))
            return {};
        bool isWhole = m_json.isWhole || layer.contains(QLatin1StringView("visible")); // The last of its keys.
        QJsonObject mended{{QStringLiteral("id"), id}};
        if (takesLayer(layer)) {
            mended = layer;
        } else {
            isWhole = false;
            for (const QString& key : layer.keys()) {
                QJsonObject trial = mended;
                trial.insert(key, layer.value(key));
                if (takesLayer(trial))
                    mended = trial;
            }
        }
        if (!isWhole)
            m_losses.layerProperties(m_group, spec,
                                     mended.value(QLatin1StringView("name")).toString(QString::number(id.toInt())));
        return mended;
    }

    static constexpr qsizetype kLongestShownName = 60;
    const CutJson& m_json;
    const SizeOfLayer& m_sizeOfLayer;
    Losses& m_losses;
    QJsonObject m_good; ///< That is known to be taken.
    std::set<Id> m_ids;
    QString m_group; ///< That is being mended.
};

} // namespace

CutJson jsonAsFarAsItGoes(const QByteArray& json)
{
    QJsonParseError problem;
    const QJsonDocument whole = QJsonDocument::fromJson(json, &problem);
    if (problem.error == QJsonParseError::NoError)
        return {.root = whole.object(), .isWhole = whole.isObject()};
    for (const CutPoint& point : cutPoints(json, problem.offset)) {
        const QJsonDocument cut = QJsonDocument::fromJson(json.first(point.at) + point.closing, &problem);
        if (problem.error == QJsonParseError::NoError && cut.isObject())
            return {.root = cut.object()};
    }
    return {};
}

QJsonObject mendedJson(const CutJson& json, const SizeOfLayer& sizeOfLayer, Losses& losses)
{
    return Mender(json, sizeOfLayer, losses).mend();
}

} // namespace hairpaint::model
