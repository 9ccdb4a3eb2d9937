// USD text (openusd.org, "UsdGeomBasisCurves") and USDZ (openusd.org, "Usdz File Format Specification"). Unreal's groom
// attributes are those of Epic's "Alembic for Grooms Specification"; in USD they are primvars of the curves.
#include "model/exporting/usd_file.h"

#include "model/exporting/piece_writer.h"
#include "model/exporting/side_files.h"
#include "model/exporting/stored_archive.h"
#include "model/exporting/usd_mesh.h"
#include "model/exporting/usd_text.h"
#include "model/exporting/worn_images.h"

#include <QFileInfo>
#include <QSet>

#include <algorithm>
#include <span>

namespace hairpaint::model {

namespace {

constexpr std::size_t kUsdPointBytes = 60;     ///< About, as text.
constexpr float kCentimetresPerMetre = 100.0F; ///< groom_width is in Unreal's unit, whatever the stage's is.

/// Writes the prims of a set of curves.
class UsdText
{
public:
    /// `images`: of the bodies, beside the text.
    UsdText(const CurveSet& set, const ExportSettings& settings, std::span<const WornBody> bodies,
            const WornImages& images, PieceWriter& writer)
        : m_set(set), m_settings(settings), m_bodies(bodies), m_images(images), m_writer(writer)
    {
        for (const CurveGroup& group : set.groups())
            m_allPoints += pointsOf(group.curves) + pointsOf(group.guides);
    }

    void write()
    {
        const ExportSpace& space = m_settings.space;
        std::string head = "#usda 1.0\n(\n    defaultPrim = \"Hair\"\n    doc = \"Hair Paint\"\n    metersPerUnit = ";
        appendNumber(head, 1.0F / space.unitsPerMetre);
        head += std::string("\n    upAxis = ") + (space.zUp ? "\"Z\"" : "\"Y\"") + "\n)\n\n";
        head += "def Xform \"Hair\" (\n    prepend apiSchemas = [\"GroomAPI\"]\n    kind = \"component\"\n)\n{\n"
                "    custom int groom_version_major = 1\n    custom int groom_version_minor = 5\n"
                "    custom string groom_tool = \"Hair Paint\"\n";
        m_writer.write(head);
        QSet<QString> taken;
        std::uint64_t number = 0;
        for (const CurveGroup& group : m_set.groups()) {
            m_writer.write("\n    def Xform " + usdQuoted(usdName(group.name, taken)) + "\n    {\n");
            writeCurves(group, number, "Strands", group.curves, false);
            writeCurves(group, number, "Guides", group.guides, true);
            m_writer.write("    }\n");
            ++number;
        }
        for (const WornBody& body : m_bodies)
            m_writer.write(usdMesh(body, usdName(body.name, taken), m_images.nameOf(body), m_settings.space));
        m_writer.write("}\n");
    }

private:
    [[nodiscard]] static std::uint64_t pointsOf(std::span<const Curve> curves)
    {
        return curves.empty() ? 0 : curves.back().endPoint() - curves.front().firstPoint;
    }
    [[nodiscard]] float fractionOf(const Curve& curve, std::uint32_t i, bool guide) const
    {
        return guide ? static_cast<float>(i) / static_cast<float>(curve.segments) : m_set.fraction(curve, i);
    }
    /// Fraction of the whole file that is written, 0..1, once `weight` (0..1) of this group is.
    [[nodiscard]] double progressAt(double weight, std::span<const Curve> curves) const
    {
        const double perPoint = m_allPoints > 0 ? 1.0 / static_cast<double>(m_allPoints) : 0.0;
        return perPoint * (static_cast<double>(m_donePoints) + weight * static_cast<double>(pointsOf(curves)));
    }

    /// "        TYPE[] NAME = [A, B] (\n interpolation ... )".
    void writeArray(const char* typedName, const char* interpolation, std::span<const Curve> curves, double until,
                    const PieceWriter::Make& make)
    {
        m_writer.write(std::string("            ") + typedName + " = [");
        const Curve* const first = curves.data();
        m_writer.write(curves, progressAt(until, curves),
                       [&make, first](std::span<const Curve> some, CurveScratch& scratch, std::string& out) {
                           const std::size_t before = out.size();
                           make(some, scratch, out);
                           // Each value ends with a comma, and the very first stands behind none.
                           if (some.data() == first && out.size() > before)
                               out.erase(before, 1);
                       });
        m_writer.write(interpolation == nullptr ? std::string("]\n")
                                                : std::string("] (\n                interpolation = \"") +
                                                      interpolation + "\"\n            )\n");
    }
    void writeConstant(const char* typedName, const std::string& value)
    {
        m_writer.write(std::string("            ") + typedName + " = [" + value +
                       "] (\n                interpolation = \"constant\"\n            )\n");
    }

    void writeCurves(const CurveGroup& group, std::uint64_t number, const char* name, std::span<const Curve> curves,
                     bool guide)
    {
        if (curves.empty())
            return;
        m_writer.write(std::string("        def BasisCurves \"") + name +
                       "\"\n        {\n            uniform token type = \"linear\"\n"
                       "            uniform token wrap = \"nonperiodic\"\n");
        writeExtent(group);
        writeShape(curves, guide);
        writeLook(curves, guide);
        writeGroomAttributes(group, number, curves, guide);
        m_writer.write("        }\n");
        m_donePoints += pointsOf(curves);
    }

    void writeExtent(const CurveGroup& group)
    {
        // Axes may swap and turn round, and ribbons stand half their width beyond.
        const ExportSpace& space = m_settings.space;
        constexpr float kWidestM = 1.7e-3F;
        const glm::vec3 a = space.position(group.leastWo);
        const glm::vec3 b = space.position(group.greatestWo);
        std::string extent = "            float3[] extent = [";
        appendUsdPoint(extent, glm::min(a, b) - space.length(kWidestM));
        extent += ", ";
        appendUsdPoint(extent, glm::max(a, b) + space.length(kWidestM));
        m_writer.write(extent + "]\n");
    }

    void writeShape(std::span<const Curve> curves, bool guide)
    {
        writeArray("int[] curveVertexCounts", nullptr, curves, 0.02,
                   [](std::span<const Curve> some, CurveScratch&, std::string& out) {
                       for (const Curve& curve : some) {
                           out.push_back(',');
                           appendNumber(out, std::uint64_t{curve.points});
                       }
                   });
        writeArray("point3f[] points", nullptr, curves, 0.5,
                   [this, guide](std::span<const Curve> some, CurveScratch& scratch, std::string& out) {
                       for (const Curve& curve : some)
                           for (const glm::vec3& point :
                                guide ? m_set.guidePoints(curve, scratch) : m_set.points(curve, scratch)) {
                               out.push_back(',');
                               appendUsdPoint(out, m_settings.space.position(point));
                           }
                   });
    }

    void writeLook(std::span<const Curve> curves, bool guide)
    {
        writeArray("float[] widths", "vertex", curves, 0.65,
                   [this, guide](std::span<const Curve> some, CurveScratch&, std::string& out) {
                       for (const Curve& curve : some)
                           for (std::uint32_t i = 0; i < curve.points; ++i) {
                               out.push_back(',');
                               const float width = m_set.width(curve, fractionOf(curve, i, guide));
                               appendNumber(out, m_settings.space.length(width));
                           }
                   });
        const auto colours = [this, guide](std::span<const Curve> some, CurveScratch&, std::string& out) {
            for (const Curve& curve : some)
                for (std::uint32_t i = 0; i < curve.points; ++i) {
                    out.push_back(',');
                    appendUsdColour(out, m_set.linearColour(curve, fractionOf(curve, i, guide)));
                }
        };
        writeArray("color3f[] primvars:displayColor", "vertex", curves, m_settings.groomColours ? 0.8 : 0.9, colours);
        if (m_settings.groomColours)
            writeArray("float3[] primvars:groom_color", "vertex", curves, 0.9, colours);
    }

    void writeGroomAttributes(const CurveGroup& group, std::uint64_t number, std::span<const Curve> curves, bool guide)
    {
        const auto perCurve = [&](const char* typedName, double until, const auto& append) {
            writeArray(typedName, "uniform", curves, until,
                       [append](std::span<const Curve> some, CurveScratch&, std::string& out) {
                           for (const Curve& curve : some) {
                               out.push_back(',');
                               append(curve, out);
                           }
                       });
        };
        perCurve("int[] primvars:groom_id", 0.93,
                 [this](const Curve& curve, std::string& out) { appendNumber(out, std::uint64_t{m_set.id(curve)}); });
        perCurve("float2[] primvars:groom_root_uv", 0.97, [this](const Curve& curve, std::string& out) {
            const glm::vec2 uv = m_set.rootUv(curve);
            out.push_back('(');
            appendNumber(out, uv.x);
            out.push_back(',');
            appendNumber(out, uv.y);
            out.push_back(')');
        });
        perCurve("float[] primvars:groom_width", 1.0, [this](const Curve& curve, std::string& out) {
            appendNumber(out, kCentimetresPerMetre * m_set.width(curve, 0.0F));
        });
        writeConstant("int[] primvars:groom_guide", guide ? "1" : "0");
        writeConstant("int[] primvars:groom_group_id", std::to_string(number));
        writeConstant("string[] primvars:groom_group_name", usdQuoted(group.name));
        const auto differs = [&](const Curve& curve) {
            return m_set.roughness(curve) != m_set.roughness(curves.front());
        };
        if (std::ranges::any_of(curves, differs)) {
            perCurve("float[] primvars:groom_roughness", 1.0,
                     [this](const Curve& curve, std::string& out) { appendNumber(out, m_set.roughness(curve)); });
        } else {
            std::string roughness;
            appendNumber(roughness, m_set.roughness(curves.front()));
            writeConstant("float[] primvars:groom_roughness", roughness);
        }
    }

    const CurveSet& m_set;
    const ExportSettings& m_settings;
    std::span<const WornBody> m_bodies;
    const WornImages& m_images;
    PieceWriter& m_writer;
    std::uint64_t m_allPoints = 0;
    std::uint64_t m_donePoints = 0;
};

} // namespace

Result<void> writeUsdFile(const CurveSet& curves, const ExportSettings& settings, const QString& path,
                          const Progress& progress)
{
    const std::vector<WornBody> bodies = wornBodies(curves, settings.worn);
    const WornImages images(bodies, QFileInfo(path).completeBaseName());
    return writeWithSideFiles(path, images.filesBeside(path), [&](const QString& staged) {
        return writeInPieces(staged, curves.pointCount() * kUsdPointBytes, progress,
                             [&](AtomicFile&, PieceWriter& writer) -> Checked<void> {
                                 UsdText(curves, settings, bodies, images, writer).write();
                                 return {};
                             });
    });
}

Result<void> writeUsdArchive(const CurveSet& curves, const ExportSettings& settings, const QString& path,
                             const Progress& progress)
{
    const std::vector<WornBody> bodies = wornBodies(curves, settings.worn);
    const WornImages images(bodies, QStringLiteral("hair"));
    return writeInPieces(path, curves.pointCount() * kUsdPointBytes, progress,
                         [&](AtomicFile& file, PieceWriter& writer) {
                             StoredArchive archive(file);
                             archive.begin("hair.usda");
                             writer.divert([&archive](std::string_view bytes) { archive.write(bytes); });
                             UsdText(curves, settings, bodies, images, writer).write();
                             for (const SideFile& image : images.files()) {
                                 archive.begin(image.path.toLatin1());
                                 archive.write({image.bytes.constData(), static_cast<std::size_t>(image.bytes.size())});
                             }
                             return archive.finish();
                         });
}

} // namespace hairpaint::model
