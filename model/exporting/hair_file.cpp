// Writing Cem Yuksel's `.hair` format (http://www.cemyuksel.com/research/hairmodels): header, then one array after
// another: segments, points, thickness, transparency, colours.
#include "model/exporting/hair_file.h"

#include "model/exporting/piece_writer.h"

#include <QtEndian>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace hairpaint::model {

namespace {

constexpr quint32 kSegmentsFlag = 1;
constexpr quint32 kPointsFlag = 2;
constexpr quint32 kThicknessFlag = 4;
constexpr quint32 kTransparencyFlag = 8;
constexpr quint32 kColoursFlag = 16;
constexpr std::size_t kHairHeaderBytes = 128;
constexpr std::size_t kHairTextBytes = 88;
constexpr std::size_t kHairPointBytes = 32; ///< Position, thickness, transparency, colour.
constexpr float kUsualWidthM = 80e-6F;
static_assert(std::endian::native == std::endian::little, "arrays are written as they lie in memory");

std::string hairText(const ExportSpace& space)
{
    const bool inMetres = space.unitsPerMetre == 1.0F;
    return std::string("Hair Paint: ") + (inMetres ? "metres, " : "centimetres, ") +
           (space.zUp ? "z up, face toward -y" : "y up, face toward +z") + "; root to tip; thickness is the diameter";
}

std::array<char, kHairHeaderBytes> makeHairHeader(const CurveSet& curves, const ExportSpace& space)
{
    std::array<char, kHairHeaderBytes> header{};
    std::memcpy(header.data(), "HAIR", 4);
    const std::array<quint32, 4> counts = {
        static_cast<quint32>(curves.curves().size()), static_cast<quint32>(curves.pointCount()),
        kSegmentsFlag | kPointsFlag | kThicknessFlag | kTransparencyFlag | kColoursFlag, 0};
    std::memcpy(header.data() + 4, counts.data(), sizeof(counts));
    const std::array<float, 5> defaults = {space.length(kUsualWidthM), 0.0F, 0.25F, 0.15F, 0.1F};
    std::memcpy(header.data() + 20, defaults.data(), sizeof(defaults));
    const std::string text = hairText(space);
    std::memcpy(header.data() + 40, text.data(), std::min(text.size(), kHairTextBytes));
    return header;
}

/// One value per point, computed from the curve and the fraction of the length to the tip.
template<typename Function>
PieceWriter::Make perPoint(const CurveSet& set, const Function& function)
{
    return [&set, function](std::span<const Curve> curves, CurveScratch&, std::string& out) {
        for (const Curve& curve : curves)
            for (std::uint32_t i = 0; i < curve.points; ++i)
                appendBytes(out, function(curve, set.fraction(curve, i)));
    };
}

} // namespace

Result<void> writeHairFile(const CurveSet& curves, const ExportSettings& settings, const QString& path,
                           const Progress& progress)
{
    const ExportSpace& space = settings.space;
    return writeInPieces(
        path, curves.pointCount() * kHairPointBytes, progress, [&](AtomicFile&, PieceWriter& writer) -> Checked<void> {
            const std::array<char, kHairHeaderBytes> header = makeHairHeader(curves, space);
            writer.write({header.data(), header.size()});
            const std::span<const Curve> all = curves.curves();
            writer.write(all, 0.1, [](std::span<const Curve> some, CurveScratch&, std::string& out) {
                for (const Curve& curve : some)
                    appendBytes(out, static_cast<quint16>(curve.points - 1));
            });
            writer.write(all, 0.5, [&](std::span<const Curve> some, CurveScratch& scratch, std::string& out) {
                for (const Curve& curve : some)
                    for (const glm::vec3& point : curves.points(curve, scratch))
                        appendBytes(out, space.position(point));
            });
            writer.write(all, 0.6, perPoint(curves, [&](const Curve& curve, float fraction) {
                             return space.length(curves.width(curve, fraction));
                         }));
            writer.write(all, 0.7, perPoint(curves, [&](const Curve& curve, float fraction) {
                             return 1.0F - curves.opacity(curve, fraction);
                         }));
            writer.write(all, 1.0, perPoint(curves, [&](const Curve& curve, float fraction) {
                             return curves.encodedColour(curve, fraction);
                         }));
            return {};
        });
}

} // namespace hairpaint::model
