// Writes the first inputs of the fuzz targets: hairpaint_fuzz_seeds tests/data/fuzz
#include "model/files/glb_writing.h"
#include "model/files/image_map.h"
#include "model/files/png_codec.h"
#include "model/files/project_file.h"
#include "model/files/project_json.h"
#include "model/files/wire_format.h"
#include "model/journal/journal_format.h"
#include "model/journal/journal_writer.h"
#include "model/project/group_schema.h"
#include "model/tools/tool_list.h"
#include "tests/fuzz/made_archive.h"
#include "tests/model/exported_hair.h"
#include "tests/model/sample_project.h"

#include <QDir>
#include <QJsonDocument>

#include <array>
#include <cstdio>

using namespace hairpaint;

namespace {

class Seeds
{
public:
    explicit Seeds(QString folder) : m_folder(std::move(folder)) {}

    void write(const char* target, const char* name, const QByteArray& bytes) const
    {
        const QDir folder(m_folder + QLatin1Char('/') + QString::fromLatin1(target));
        if (!folder.mkpath(QStringLiteral(".")))
            std::abort();
        test::writeBytes(folder.filePath(QString::fromLatin1(name)), bytes);
    }

private:
    QString m_folder;
};

/// One group of which only the first layer of density is there.
model::Project smallProject()
{
    model::Project project = model::newProject();
    model::HairGroup& group = project.groups.front();
    for (model::SharedStack& stack : group.maps) {
        stack.write().size = 256;
        stack.write().layers.clear();
    }
    model::Layer layer = model::makeLayer(project, model::mapSpec(model::MapKind::Density), 256, QStringLiteral("One"));
    layer.raster.setUniform(3, {20'000, 65'535, 0, 0});
    group.map(model::MapKind::Density).layers.push_back(layer);
    return project;
}

constexpr std::array kFullMaps{model::MapKind::Density, model::MapKind::Frizz, model::MapKind::Width,
                               model::MapKind::Gloss};

/// The same with a value of its own for every setting of the group, some maps more, and all that a worn thing can tell.
model::Project fullProject()
{
    model::Project project = smallProject();
    model::HairGroup& group = project.groups.front();
    for (const model::GroupSetting& row : model::groupSchema()) {
        const double last = row.isSwitch() ? 1.0 : static_cast<double>(row.choices.size()) - 1.0;
        const bool isOneOfFew = row.isSwitch() || !row.choices.empty();
        row.write(group.settings, isOneOfFew ? last : row.least + (row.greatest - row.least) / 3.0);
    }
    project.nextId = group.id + 1; // An input has room for ids up to 31.
    for (const model::MapKind kind : kFullMaps) {
        model::Layer layer = model::makeLayer(project, model::mapSpec(kind), 256, QString());
        layer.raster.setUniform(2, {1, 65'535, 65'535, 65'535});
        group.map(kind).layers = {layer};
    }
    const model::WornSpec& ball = model::wornSpec(model::WornKind::Ball);
    for (const model::Id worn : {group.id, model::Id(0)}) {
        model::Worn bead =
            model::makeWorn(ball, {.positionHd = {0.0F, 0.1F, 0.0F}, .normalHd = {0.0F, 1.0F, 0.0F}}, worn);
        bead.id = project.takeId();
        bead.colour = 0xFF102030;
        bead.sheen = 0.25F;
        bead.anchor = {.face = 7, .barycentric = {0.25F, 0.25F, 0.5F}};
        model::insertWorn(project.worn, bead);
    }
    return project;
}

QByteArray imageOf(const model::Project& project, model::MapKind kind = model::MapKind::Density)
{
    return model::encodeLayer(project.groups.front().map(kind).layers.front().raster).bytes;
}

QByteArray fileOf(const model::Project& project)
{
    const QString path = fuzz::scratchPath(QStringLiteral("seed.hairpaint"));
    if (!model::saveProject(project, path, {}))
        std::abort();
    return test::readBytes(path);
}

/// Short, so that more of an input is worth changing.
QByteArray compact(const QByteArray& json)
{
    return QJsonDocument::fromJson(json).toJson(QJsonDocument::Compact);
}

/// As made_archive.h reads an image of group 1.
QByteArray layerOf(model::MapKind kind, int layer, const QByteArray& png)
{
    return QByteArray(1, '\x01') + QByteArray(1, static_cast<char>(kind)) + QByteArray(1, static_cast<char>(layer)) +
           fuzz::pieceOf(png);
}

/// As made_archive.h reads it; its one layer lies in group 1, density.
QByteArray madeOf(const QByteArray& json, const QByteArray& glb, int layer, const QByteArray& png)
{
    return QByteArray("\x01", 1) + fuzz::pieceOf(json) + fuzz::pieceOf(glb) +
           layerOf(model::MapKind::Density, layer, png);
}

QByteArray madeOf(const QByteArray& json, const model::Project& project)
{
    QByteArray bytes = QByteArray("\x01", 1) + fuzz::pieceOf(compact(json)) + fuzz::pieceOf({});
    for (const model::MapKind kind : kFullMaps)
        bytes += layerOf(kind, project.groups.front().map(kind).layers.front().id, imageOf(project, kind));
    return bytes;
}

QByteArray bytesOf(const wire::Bytes& message, char kind)
{
    const auto body = std::span(message).subspan(wire::kHeaderBytes);
    return QByteArray(1, kind) +
           QByteArray(reinterpret_cast<const char*>(body.data()), static_cast<qsizetype>(body.size()));
}

QByteArray stateBytes(const QByteArray& json, int layer)
{
    QByteArray bytes("\x04", 1); // RecordKind::State
    bytes += fuzz::pieceOf(json) + QByteArray("\xFF", 1) + QByteArray(8, '\0') + QByteArray("\x01", 1);
    return bytes + QByteArray(1, static_cast<char>(layer)) + QByteArray(2, '\0');
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 2) {
        std::puts("hairpaint_fuzz_seeds FOLDER");
        return 2;
    }
    const Seeds seeds(QString::fromLocal8Bit(argv[1]));
    const model::Project project = smallProject();
    const QByteArray json = model::projectToJson(project).value();
    const QByteArray png = imageOf(project);
    const QByteArray glb = model::glbFromMesh(test::makePatchHead(2));
    const int layer = project.groups.front().map(model::MapKind::Density).layers.front().id;

    seeds.write("project", "file", QByteArray(1, '\0') + fileOf(project));
    seeds.write("project", "made", madeOf(json, {}, layer, png));
    QByteArray imported = json;
    imported.replace(R"("built_in": true)", R"("built_in": false)");
    seeds.write("project", "imported_head", madeOf(imported, glb, layer, png));
    QByteArray first = json;
    first.replace(R"("format_version": 2)", R"("format_version": 1)");
    seeds.write("project", "version_1", madeOf(first, {}, layer, png));
    seeds.write("project", "json_cut", madeOf(json.first(json.size() / 2), {}, layer, png));

    QByteArray preset = json;
    preset.replace("hairpaint project", "hairpaint preset");
    seeds.write("preset", "made", madeOf(preset, {}, layer, png));

    const model::Project full = fullProject();
    const QByteArray fullJson = model::projectToJson(full).value();
    seeds.write("project", "full", madeOf(fullJson, full));
    seeds.write(
        "preset", "full",
        madeOf(model::presetToJson({.name = QStringLiteral("Full"), .groups = full.groups, .head = full.head}).value(),
               full));

    seeds.write("png", "layer", QByteArray("\x01\x00", 2) + png);
    seeds.write("png", "picture", QByteArray("\x01\x00", 2) + test::pngOf(4, 4, 8, 6, test::packedZeros(4 * 17)));
    seeds.write("png", "picture_rgb", QByteArray("\x01\x00", 2) + test::pngOf(4, 4, 8, 2, test::packedZeros(4 * 13)));

    seeds.write("glb", "patch", QByteArray("\x00", 1) + glb);
    model::RiggedMesh body(test::makePatchHead(2));
    body.skeleton.joints = {{.name = "a"}, {.name = "b", .parent = 0, .translation = {0.0F, 1.0F, 0.0F}}};
    body.skeleton.weights.assign(body.positionsHd.size(), {.joints = {1, 0, 0, 0}, .weights = {0.75F, 0.25F, 0, 0}});
    seeds.write("glb", "body", QByteArray("\x01", 1) + model::glbFromMesh(body));
    seeds.write("glb", "ball", QByteArray("\x01", 1) + model::glbFromMesh(test::makeBallHead(4)));

    const auto hair = test::frameOf({test::hairGroup(1, 500, 20'000, 20'000)});
    for (const char* ending : {"hair", "usda"}) {
        const QString path = fuzz::scratchPath(QStringLiteral("seed.") + QLatin1StringView(ending));
        if (!test::exported(hair, path))
            return 1;
        const QByteArray bytes = test::readBytes(path);
        if (QLatin1StringView(ending) == QLatin1String("hair"))
            seeds.write("hair", "exported", bytes);
        else
            seeds.write("usd", "exported", bytes.sliced(bytes.indexOf('\n') + 1)); // The target writes that line.
    }
    seeds.write("usd", "moved",
                "def Xform \"a\" {\nmatrix4d xformOp:transform = ((2,0,0,0),(0,1,0,0),(0,0,1,0),(1,2,3,1))\n"
                "float xformOp:rotateX = 90\nuniform token[] xformOpOrder = [\"xformOp:transform\", "
                "\"!invert!xformOp:rotateX\"]\ndef BasisCurves \"b\" {\nint[] curveVertexCounts = [4]\n"
                "point3f[] points.timeSamples = {0: [(0,0,0),(0,1,0),(0,2,0),(0,3,0)], 1: None}\n"
                "uniform token basis = \"bspline\"\nfloat[] widths = [0.1]\n}\n}\n");
    const char layers[] =
        "(\nsubLayers = [ @b@ ]\n)\nover \"a\" (\nreferences = @b@</c>\nvariants = { string v = \"x\" }\n)\n"
        "{\npoint3f[] points = [(0,0,0),(0,2,0)]\nvariantSet \"v\" = { \"x\" ( inherits = </d> ) {\n"
        "float[] widths = [0.2]\n} }\n}\nclass \"d\" {\nuniform token type = \"linear\"\n}\n\0"
        "def \"a\" {\n}\ndef BasisCurves \"c\" (\nprepend payload = @a@</d>\n) {\n"
        "int[] curveVertexCounts = [2]\ntoken visibility = \"inherited\"\n}\n";
    seeds.write("usd", "layers", QByteArray(layers, sizeof layers - 1));

    seeds.write("wire", "path", bytesOf(wire::encodeText(wire::Kind::ReadImage, "/a/b.png"), '\0'));
    const wire::Image image{.width = 2, .height = 2, .channels = 3, .samples = std::vector<std::uint16_t>(12, 7)};
    seeds.write("wire", "image", bytesOf(wire::encodeImage(image), '\x01'));
    seeds.write("wire", "request", bytesOf(wire::encodeRequest({.bits = 8, .ending = "png", .image = image}), '\x02'));
    seeds.write("wire", "mesh", bytesOf(wire::encodeMesh(test::makePatchHead(2)), '\x03'));
    seeds.write("wire", "body", bytesOf(wire::encodeMesh(body), '\x03'));
    seeds.write("wire", "refusal", bytesOf(wire::encodeRefusal(wire::Reason::NoUvs), '\x04'));
    seeds.write("wire", "sandbox",
                bytesOf(wire::encodeSandbox({.landlockVersion = 7, .filtersCalls = 1, .mostMegabytes = 1800}), '\x05'));

    seeds.write("import", "mesh",
                QByteArray(1, '\0') + QByteArray("\x01\x10\x20\x30\x00\x00\x10\x08\x08", 9).repeated(6));
    seeds.write("import", "image", QByteArray("\x01\x04\x04\x02\x00\x00", 6) + QByteArray(96, '\x33'));

    QByteArray options; // The options of every tool, each beyond its range.
    for (const auto& tool : model::makeTools())
        for (const model::ToolOption* option : tool->options())
            options += QByteArray(", \"tools/") + option->key + "\": 1e9";
    seeds.write(
        "settings", "whole",
        QByteArray(R"({"theme": "light", "language": "es", "presenter": 2, "whitePaper": true, "earlierVersions": true,
"geometry": "base64:AdnQywADAAA=", "recentFiles": ["/a/b.hairpaint", "/c.hairpaint"], "lastFolder": "/a",
"viewTurned": true, "avatarAuthor": "A", "keys/file.save": "Ctrl+Shift+S", "places/export": [100, 40],
"picture": {"asView": false, "width": 1920, "height": 1080, "keepsShape": true, "framing": 3, "background": 2,
"colour": "#102030", "samples": 16})") +
            options + '}');
    seeds.write("settings", "beyond",
                R"({"presenter": 1e300, "places/export": [2147483647, -1e300], "tools/size": 1e300,
"picture": {"width": -2147483649, "height": 1e300, "samples": 4294967297, "framing": -1, "colour": "#"}})");

    const QString journal = fuzz::scratchPath(QStringLiteral("journal"));
    {
        model::JournalWriter writer(journal);
        if (!writer.append({.project = project, .path = {}, .step = {}, .index = 0, .count = 0, .timeMs = 0}))
            return 1;
    }
    seeds.write("journal", "file", QByteArray(1, '\0') + test::readBytes(journal));
    const QByteArray tile = QByteArray("\x02\x02\x01", 3) + fuzz::pieceOf(QByteArray(8, '\x11'));
    seeds.write("journal", "made", QByteArray("\x01", 1) + tile + stateBytes(json, layer));
    seeds.write("journal", "full",
                QByteArray("\x01", 1) + tile +
                    stateBytes(compact(fullJson), full.groups.front().map(model::MapKind::Density).layers.front().id));
    return 0;
}
