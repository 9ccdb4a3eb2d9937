// Wavefront OBJ: `v x y z r g b` and `l a b`.
#include "model/exporting/obj_file.h"

#include "model/exporting/piece_writer.h"
#include "model/exporting/side_files.h"
#include "model/exporting/worn_images.h"

#include <QDir>
#include <QFileInfo>

#include <initializer_list>
#include <span>
#include <string>
#include <vector>

namespace hairpaint::model {

namespace {

constexpr std::size_t kObjPointBytes = 60; ///< About: a vertex and its line, as text.
constexpr int kObjColourDecimals = 4;

/// A name on one line, without the spaces that end it for some readers.
std::string objectName(const QString& name)
{
    std::string out = name.simplified().toStdString();
    for (char& c : out)
        if (c == ' ')
            c = '_';
    return out;
}

void writeVertices(const CurveSet& set, const CurveGroup& group, const ExportSpace& space, double until,
                   PieceWriter& writer)
{
    writer.write(group.curves, until, [&](std::span<const Curve> curves, CurveScratch& scratch, std::string& out) {
        for (const Curve& curve : curves) {
            std::uint32_t i = 0;
            for (const glm::vec3& point : set.points(curve, scratch)) {
                const glm::vec3 position = space.position(point);
                const glm::vec3 colour = set.encodedColour(curve, set.fraction(curve, i));
                out.push_back('v');
                for (int axis = 0; axis < 3; ++axis) {
                    out.push_back(' ');
                    appendNumber(out, position[axis]);
                }
                for (int channel = 0; channel < 3; ++channel) {
                    out.push_back(' ');
                    appendFraction(out, colour[channel], kObjColourDecimals);
                }
                out.push_back('\n');
                ++i;
            }
        }
    });
}

/// Vertices are counted from 1, through all objects.
void writeLines(const CurveGroup& group, double until, PieceWriter& writer)
{
    writer.write(group.curves, until, [](std::span<const Curve> curves, CurveScratch&, std::string& out) {
        for (const Curve& curve : curves)
            for (std::uint64_t vertex = curve.firstPoint + 1; vertex < curve.endPoint(); ++vertex) {
                out += "l ";
                appendNumber(out, vertex);
                out.push_back(' ');
                appendNumber(out, vertex + 1);
                out.push_back('\n');
            }
    });
}

/// A thing that is worn, behind `before` vertices: triangles with normals and uv, whose vertices bring its colour, as
/// the hair's do; of a texture its mean.
std::string wornObject(const WornBody& body, const ExportSpace& space, std::uint64_t before, std::uint64_t ownBefore)
{
    const auto numbers = [](std::string& out, const char* keyword, std::initializer_list<float> values) {
        out += keyword;
        for (const float value : values) {
            out.push_back(' ');
            appendNumber(out, value);
        }
    };
    std::string out = "o " + objectName(body.name);
    out += "\nusemtl ";
    out += objectName(body.name);
    out.push_back('\n');
    std::string colour;
    const QRgb mean = meanColour(body);
    for (const int channel : {qRed(mean), qGreen(mean), qBlue(mean)}) {
        colour.push_back(' ');
        appendFraction(colour, static_cast<float>(channel) / 255.0F, kObjColourDecimals);
    }
    for (const HeadVertexOut& vertex : body.mesh.vertices) {
        const glm::vec3 position = space.position(vertex.position);
        const glm::vec3 normal = space.direction(vertex.normal);
        numbers(out, "v", {position.x, position.y, position.z});
        out += colour;
        numbers(out, "\nvt", {vertex.uv.x, 1.0F - vertex.uv.y});
        numbers(out, "\nvn", {normal.x, normal.y, normal.z});
        out.push_back('\n');
    }
    for (std::size_t i = 0; i + 2 < body.mesh.indices.size(); i += 3) {
        out.push_back('f');
        for (std::size_t corner = i; corner < i + 3; ++corner) {
            const std::uint64_t own = ownBefore + body.mesh.indices[corner] + 1;
            out.push_back(' ');
            appendNumber(out, before + body.mesh.indices[corner] + 1);
            for (int times = 0; times < 2; ++times) {
                out.push_back('/');
                appendNumber(out, own);
            }
        }
        out.push_back('\n');
    }
    return out;
}

/// Colours in sRGB; roughness as an exponent for old readers and by itself for new ones.
void addMaterial(const WornBody& body, const WornImages& images, std::string& out)
{
    constexpr float kGlint = 0.04F; // What is no metal reflects.
    constexpr float kSharpest = 1000.0F;
    const auto roughness = static_cast<float>(body.roughness);
    const auto line = [&out](const char* keyword, std::initializer_list<float> values) {
        out += keyword;
        for (const float value : values) {
            out.push_back(' ');
            appendFraction(out, value, kObjColourDecimals);
        }
        out.push_back('\n');
    };
    const auto channel = [](int value) { return static_cast<float>(value) / 255.0F; };
    out += "\nnewmtl ";
    out += objectName(body.name);
    out.push_back('\n');
    line("Kd", {channel(qRed(body.colour)), channel(qGreen(body.colour)), channel(qBlue(body.colour))});
    line("Ks", {kGlint, kGlint, kGlint});
    out += "Ns ";
    appendNumber(out, kSharpest * (1.0F - roughness) * (1.0F - roughness));
    out.push_back('\n');
    line("Pr", {roughness});
    line("Pm", {0.0F});
    out += "illum 2\n";
    if (body.texture)
        out += "map_Kd " + images.nameOf(body).toStdString() + "\n";
    if (body.alpha != sim::TextureAlpha::Opaque)
        out += "map_d " + images.nameOf(body).toStdString() + "\n";
}

std::string materialsText(std::span<const WornBody> bodies, const WornImages& images)
{
    std::string text = "# Hair Paint: colours in sRGB\n";
    for (const WornBody& body : bodies)
        addMaterial(body, images, text);
    return text;
}

Result<void> writeObj(const CurveSet& curves, const ExportSettings& settings, std::span<const WornBody> bodies,
                      const QString& path, const QString& materials, const Progress& progress)
{
    return writeInPieces(
        path, curves.pointCount() * kObjPointBytes, progress, [&](AtomicFile&, PieceWriter& writer) -> Checked<void> {
            writer.write(std::string("# Hair Paint: ") +
                         (settings.space.unitsPerMetre == 1.0F ? "metres" : "centimetres") +
                         ", y up, face toward +z\n");
            if (!materials.isEmpty())
                writer.write(QStringLiteral("mtllib %1\n").arg(QFileInfo(materials).fileName()).toStdString());
            constexpr double kVertexWork = 0.8;
            double before = 0.0;
            for (const CurveGroup& group : curves.groups()) {
                if (group.curves.empty())
                    continue;
                const double fraction =
                    static_cast<double>(group.curves.back().endPoint()) / static_cast<double>(curves.pointCount());
                writer.write("o " + objectName(group.name) + "\n");
                writeVertices(curves, group, settings.space, before + kVertexWork * (fraction - before), writer);
                writeLines(group, fraction, writer);
                before = fraction;
            }
            std::uint64_t vertices = curves.pointCount();
            for (const WornBody& body : bodies) {
                writer.write(wornObject(body, settings.space, vertices, vertices - curves.pointCount()));
                vertices += body.mesh.vertices.size();
            }
            return {};
        });
}

} // namespace

QString objMaterialsPath(const QString& path)
{
    const QFileInfo file(path);
    return file.dir().filePath(file.completeBaseName() + QLatin1String(".mtl"));
}

Result<void> writeObjFile(const CurveSet& curves, const ExportSettings& settings, const QString& path,
                          const Progress& progress)
{
    const std::vector<WornBody> bodies = wornBodies(curves, settings.worn);
    if (bodies.empty())
        return writeObj(curves, settings, bodies, path, {}, progress);
    const QString materials = objMaterialsPath(path);
    const WornImages images(bodies, QFileInfo(path).completeBaseName());
    std::vector<SideFile> sides = images.filesBeside(path);
    sides.insert(sides.begin(), {.path = materials, .bytes = QByteArray::fromStdString(materialsText(bodies, images))});
    return writeWithSideFiles(path, sides, [&](const QString& staged) {
        return writeObj(curves, settings, bodies, staged, materials, progress);
    });
}

} // namespace hairpaint::model
