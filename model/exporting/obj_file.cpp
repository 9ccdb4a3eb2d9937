// Wavefront OBJ: `v x y z r g b` and `l a b`.
#include "model/exporting/obj_file.h"

#include "model/exporting/piece_writer.h"

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

} // namespace

Result<void> writeObjFile(const CurveSet& curves, const ExportSettings& settings, const QString& path,
                          const Progress& progress)
{
    return writeInPieces(
        path, curves.pointCount() * kObjPointBytes, progress, [&](AtomicFile&, PieceWriter& writer) -> Checked<void> {
            writer.write(std::string("# Hair Paint: ") +
                         (settings.space.unitsPerMetre == 1.0F ? "metres" : "centimetres") +
                         ", y up, face toward +z\n");
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
            return {};
        });
}

} // namespace hairpaint::model
