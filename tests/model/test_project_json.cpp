// project.json is refused or mended by the rules of hairpaint_format.md, whatever it holds.
#include "model/files/json_fields.h"
#include "model/files/project_file.h"
#include "model/files/project_json.h"
#include "tests/model/sample_project.h"
#include "tests/support/test_program.h"

#include <QJsonDocument>
#include <QTest>

#include <cmath>
#include <functional>
#include <limits>

using namespace hairpaint;
using namespace hairpaint::model;

namespace {

/// A good file's object.
QJsonObject goodRoot()
{
    Project project = newProject();
    project.groups = {makeGroup(project, QStringLiteral("Scalp"), 256)};
    return QJsonDocument::fromJson(projectToJson(project).value_or(QByteArray())).object();
}

/// Sets the value at a path of keys and array indices, "groups/0/id"; an undefined value takes the key away.
QJsonValue withValue(const QJsonValue& where, QStringList path, const QJsonValue& value)
{
    if (path.isEmpty())
        return value;
    const QString key = path.takeFirst();
    if (where.isArray()) {
        QJsonArray array = where.toArray();
        array.replace(key.toInt(), withValue(array.at(key.toInt()), path, value));
        return array;
    }
    QJsonObject object = where.toObject();
    const QJsonValue inner = withValue(object.value(key), path, value);
    if (inner.isUndefined())
        object.remove(key);
    else
        object.insert(key, inner);
    return object;
}

QByteArray changed(const char* path, const QJsonValue& value)
{
    const QStringList keys = QString::fromLatin1(path).split(QLatin1Char('/'));
    return QJsonDocument(withValue(goodRoot(), keys, value).toObject()).toJson();
}

} // namespace

class TestProjectJson : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aWrongValueIsRefused_data()
    {
        QTest::addColumn<QByteArray>("path");
        QTest::addColumn<QJsonValue>("value");
        const auto row = [](const char* name, const char* path, const QJsonValue& value) {
            QTest::newRow(name) << QByteArray(path) << value;
        };
        const QJsonValue absent(QJsonValue::Undefined);
        const QString longText(5000, QLatin1Char('x'));
        row("no format", "format", absent);
        row("a preset's format", "format", QStringLiteral("hairpaint preset"));
        row("no version", "format_version", absent);
        row("version 0", "format_version", 0);
        row("a version to come", "format_version", 5);
        row("no next id", "next_id", absent);
        row("a next id of 0", "next_id", 0);
        row("a next id above the limit", "next_id", 2'100'000'000);
        row("a next id below the ids", "next_id", 5);
        row("a seed that is a number", "seed", 1);
        row("a negative seed", "seed", QStringLiteral("-1"));
        row("a seed of 65 bits", "seed", QStringLiteral("18446744073709551616"));
        row("a seed of letters", "seed", QStringLiteral("abc"));
        row("an empty seed", "seed", QString());
        row("other roots", "roots/algorithm", 99);
        row("roots of another type", "roots", 1);
        row("a background without #", "background", QStringLiteral("red"));
        row("a short background", "background", QStringLiteral("#fff"));
        row("a skin that is not known", "skin", QStringLiteral("green"));
        row("a skin that is a number", "skin", 3);
        row("no head", "head", absent);
        row("a head of another type", "head", QJsonArray());
        row("a head without a name", "head/name", absent);
        row("an unknown axis", "head/up_axis", QStringLiteral("x"));
        row("ellipsoids of another type", "ellipsoids", 1);
        row("an ellipsoid with two axes", "ellipsoids/0/semi_axes_m", QJsonArray{1, 2});
        row("an ellipsoid with a text", "ellipsoids/0/centre_m", QJsonArray{1, 2, QStringLiteral("3")});
        row("an ellipsoid turned by nothing", "ellipsoids/0/rotation", QJsonArray{0, 0, 0, 0});
        row("an ellipsoid that is none", "ellipsoids/0", 1);
        row("an ellipsoid with the id of a group", "ellipsoids/0/id", 20);
        row("an ellipsoid with id 0", "ellipsoids/0/id", 0);
        row("an ellipsoid with the next id", "ellipsoids/0/id", goodRoot().value(QLatin1String("next_id")));
        row("33 ellipsoids", "ellipsoids", QJsonArray::fromVariantList(QVariantList(33, QVariantMap())));
        row("worn things of another type", "worn", 1);
        row("a worn thing without a kind", "worn", QJsonArray{QJsonObject()});
        row("a worn thing of a kind to come", "worn",
            QJsonArray{QJsonObject{{QStringLiteral("kind"), QStringLiteral("tiara")}}});
        row("wind of another type", "wind", 1);
        row("wind in two dimensions", "wind/velocity_m_per_s", QJsonArray{1, 2});
        row("light that is a text", "light/intensity", QStringLiteral("bright"));
        row("no groups", "groups", absent);
        row("an empty list of groups", "groups", QJsonArray());
        row("a group that is none", "groups/0", 1);
        row("a group without id", "groups/0/id", absent);
        row("a group with id 0", "groups/0/id", 0);
        row("a negative id", "groups/0/id", -3);
        row("an id with a fraction", "groups/0/id", 1.5);
        row("an id that a layer has", "groups/0/id", 21);
        row("an id that is a text", "groups/0/id", QStringLiteral("1"));
        row("a name that is a number", "groups/0/name", 1);
        row("a name too long", "groups/0/name", longText);
        row("visible as a number", "groups/0/visible", 1);
        row("settings of another type", "groups/0/settings", 1);
        row("a setting that is a text", "groups/0/settings/greatest_length_m", QStringLiteral("1"));
        row("an unknown turns mode", "groups/0/settings/turns_mode", QStringLiteral("per_week"));
        row("physics of another type", "groups/0/settings/physics", QJsonArray());
        row("maps of another type", "groups/0/maps", QJsonArray());
        row("an unknown map", "groups/0/maps/horns", QJsonObject());
        row("a map that is none", "groups/0/maps/gel", 1);
        row("a map without size", "groups/0/maps/gel/size", absent);
        row("a size of no power", "groups/0/maps/gel/size", 300);
        row("a small size", "groups/0/maps/gel/size", 128);
        row("a large size", "groups/0/maps/gel/size", 16384);
        row("a negative size", "groups/0/maps/gel/size", -256);
        row("a size that wraps round", "groups/0/maps/gel/size", 4294967552.0);
        row("layers of another type", "groups/0/maps/gel/layers", 1);
        row("a layer that is none", "groups/0/maps/gel/layers/0", 1);
        row("a layer without id", "groups/0/maps/gel/layers/0/id", absent);
        row("an unknown blend mode", "groups/0/maps/gel/layers/0/blend", QStringLiteral("dodge"));
        row("a blend mode that the map lacks", "groups/0/maps/braid/layers/0/blend", QStringLiteral("multiply"));
        row("opacity of another type", "groups/0/maps/gel/layers/0/opacity", true);
    }
    void aWrongValueIsRefused()
    {
        QFETCH(QByteArray, path);
        QFETCH(QJsonValue, value);
        const Checked<ProjectManifest> manifest = projectFromJson(changed(path.constData(), value));
        QVERIFY(!manifest);
        QVERIFY(!manifest.error().text.isEmpty() && !manifest.error().text.contains(QLatin1Char('\n')));
    }

    void aNumberOutsideItsRangeMovesToTheNearestEnd_data()
    {
        QTest::addColumn<QByteArray>("path");
        QTest::addColumn<double>("value");
        QTest::addColumn<std::function<float(const Project&)>>("read");
        QTest::addColumn<float>("expected");
        using Read = std::function<float(const Project&)>;
        const auto row = [](const char* name, const char* path, double value, const Read& read, float expected) {
            QTest::newRow(name) << QByteArray(path) << value << read << expected;
        };
        const Read length = [](const Project& p) { return p.groups.front().settings.greatestLengthM; };
        const Read nodes = [](const Project& p) { return static_cast<float>(p.groups.front().settings.nodesPerHair); };
        const Read opacity = [](const Project& p) { return p.groups.front().map(MapKind::Gel).layers.front().opacity; };
        const Read hairs = [](const Project& p) { return static_cast<float>(p.maxHairs); };
        row("a length of 1e300", "groups/0/settings/greatest_length_m", 1e300, length, 2.0F);
        row("a negative length", "groups/0/settings/greatest_length_m", -1.0, length, 0.001F);
        row("a million nodes", "groups/0/settings/nodes_per_hair", 1e6, nodes, 32.0F);
        row("minus 1e300 nodes", "groups/0/settings/nodes_per_hair", -1e300, nodes, 4.0F);
        row("a negative opacity", "groups/0/maps/gel/layers/0/opacity", -0.5, opacity, 0.0F);
        row("an opacity of 7", "groups/0/maps/gel/layers/0/opacity", 7.0, opacity, 1.0F);
        row("1e18 hairs", "max_hairs", 1e18, hairs, 4e6F);
        row("no hairs", "max_hairs", 0.0, hairs, 1.0F);
    }
    void aNumberOutsideItsRangeMovesToTheNearestEnd()
    {
        QFETCH(QByteArray, path);
        QFETCH(double, value);
        QFETCH(std::function<float(const Project&)>, read);
        QFETCH(float, expected);
        const Checked<ProjectManifest> manifest = projectFromJson(changed(path.constData(), value));
        QVERIFY2(manifest, manifest ? "" : qPrintable(manifest.error().text));
        QCOMPARE(read(manifest->project), expected);
    }

    void whatIsAbsentHasItsDefault()
    {
        const QByteArray json = R"({"format": "hairpaint project", "format_version": 1, "next_id": 5,
            "head": {"name": "bust-1"}, "groups": [{"id": 1}], "unknown": {"a": [1]}})";
        const Checked<ProjectManifest> manifest = projectFromJson(json);
        QVERIFY2(manifest, manifest ? "" : qPrintable(manifest.error().text));
        const Project& project = manifest->project;
        QCOMPARE(project.seed, std::uint64_t{1});
        QCOMPARE(project.maxHairs, 1'000'000);
        QVERIFY(project.groups.front().settings == sim::GroupSettings{});
        QVERIFY(project.wind == sim::Wind{} && project.light == LightSettings{});
        QCOMPARE(project.groups.front().maps.size(), std::size_t{kMapKindCount});
        QCOMPARE(project.nextId, 5 + kMapKindCount);
    }

    void textThatIsNoJsonIsRefused_data()
    {
        QTest::addColumn<QByteArray>("json");
        QTest::newRow("nothing") << QByteArray();
        QTest::newRow("a word") << QByteArray("hello");
        QTest::newRow("an array") << QByteArray("[]");
        QTest::newRow("cut short") << QByteArray(R"({"format": "hairpaint project")");
        QTest::newRow("nested deep") << QByteArray(R"({"a":)") + QByteArray(100'000, '[') + QByteArray(100'000, ']') +
                                            "}";
        QTest::newRow("nested 40 deep") << QByteArray(R"({"a":)") + QByteArray(40, '[') + QByteArray(40, ']') + "}";
        QTest::newRow("a number too large") << QByteArray(R"({"format": 1e99999})");
        QTest::newRow("NaN") << QByteArray(R"({"format": NaN})");
        QTest::newRow("bytes that are no UTF-8") << QByteArray("{\"format\": \"\xFF\xFE\"}");
        QTest::newRow("five million blanks") << QByteArray(5'000'000, ' ') + "{}";
    }
    void textThatIsNoJsonIsRefused()
    {
        QFETCH(QByteArray, json);
        QVERIFY(!projectFromJson(json));
        QVERIFY(!presetFromJson(json));
    }

    void everyFloatIsWrittenSoThatItReadsBackExactly()
    {
        std::uint32_t bits = 12345;
        for (int i = 0; i < 200'000; ++i) {
            bits = bits * 1'664'525U + 1'013'904'223U;
            const auto value = std::bit_cast<float>(bits);
            if (!std::isfinite(value))
                continue;
            const QByteArray json = QJsonDocument(QJsonArray{shortestDouble(value)}).toJson();
            const auto back = static_cast<float>(QJsonDocument::fromJson(json).array().at(0).toDouble());
            QCOMPARE(std::bit_cast<std::uint32_t>(back), value == 0.0F ? 0U : bits);
        }
    }

    void aFloatIsWrittenInItsShortForm()
    {
        QCOMPARE(QJsonDocument(QJsonArray{shortestDouble(0.3F)}).toJson(QJsonDocument::Compact), QByteArray("[0.3]"));
        QCOMPARE(QJsonDocument(QJsonArray{shortestDouble(80e-6F)}).toJson(QJsonDocument::Compact),
                 QByteArray("[8e-05]"));
    }
};

HAIRPAINT_TEST(TestProjectJson, Core)
#include "test_project_json.moc"
