// Binary glTF (Khronos, glTF 2.0 specification): interleaved vertices and indices of each group, one after another.
#include "model/exporting/ribbon_file.h"

#include "model/exporting/piece_writer.h"
#include "model/exporting/ribbon.h"
#include "model/exporting/ribbon_json.h"
#include "model/exporting/worn_body.h"
#include "model/files/glb_writing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

namespace hairpaint::model {

namespace {

constexpr std::size_t kRibbonPointBytes = 90; ///< About: two vertices and their triangles.
constexpr float kWidestRibbonM = 4e-3F;
constexpr float kShortMost = 65535.0F;

quint16 shortOf(float value)
{
    return static_cast<quint16>(std::lround(std::clamp(value, 0.0F, 1.0F) * kShortMost));
}

/// Calls visit with each vertex of a curve's ribbon, left and right of each point.
template<typename Visit>
void forEachVertex(const CurveSet& set, const Curve& curve, const glm::vec3& middle, CurveScratch& scratch,
                   std::vector<RibbonFrame>& frames, const Visit& visit)
{
    const std::span<const glm::vec3> points = set.points(curve, scratch);
    ribbonFrames(points, middle, frames);
    for (std::uint32_t i = 0; i < curve.points; ++i) {
        const float fraction = set.fraction(curve, i);
        const float width = std::min(set.width(curve, fraction) * set.thinning(), kWidestRibbonM);
        const glm::vec3 colour = set.linearColour(curve, fraction);
        const glm::vec3 across = 0.5F * width * frames[i].side;
        RibbonVertex vertex{.position = points[i] - across,
                            .normal = frames[i].normal,
                            .uv = {0, shortOf(fraction)},
                            .colour = {shortOf(colour.r), shortOf(colour.g), shortOf(colour.b), 65535}};
        visit(vertex);
        vertex.position = points[i] + across;
        vertex.uv[0] = 65535;
        visit(vertex);
    }
}

/// Bounds stand before the vertices that they are of, so these are made twice.
void measureRibbons(const CurveSet& set, RibbonGroup& group, double until, PieceWriter& writer)
{
    std::mutex mutex;
    writer.write(
        group.curves->curves, until, [&](std::span<const Curve> curves, CurveScratch& scratch, std::string& /*out*/) {
            std::vector<RibbonFrame> frames;
            glm::vec3 least(std::numeric_limits<float>::max());
            glm::vec3 greatest(std::numeric_limits<float>::lowest());
            for (const Curve& curve : curves)
                forEachVertex(set, curve, group.curves->middleWo, scratch, frames, [&](const RibbonVertex& vertex) {
                    least = glm::min(least, vertex.position);
                    greatest = glm::max(greatest, vertex.position);
                });
            const std::lock_guard lock(mutex);
            group.least = glm::min(group.least, least);
            group.greatest = glm::max(group.greatest, greatest);
        });
}

void writeRibbonVertices(const CurveSet& set, const RibbonGroup& group, double until, PieceWriter& writer)
{
    writer.write(group.curves->curves, until,
                 [&](std::span<const Curve> curves, CurveScratch& scratch, std::string& out) {
                     std::vector<RibbonFrame> frames;
                     for (const Curve& curve : curves)
                         forEachVertex(set, curve, group.curves->middleWo, scratch, frames,
                                       [&out](const RibbonVertex& vertex) { appendBytes(out, vertex); });
                 });
}

/// Two triangles a segment, front towards the normals.
void writeRibbonIndices(const RibbonGroup& group, double until, PieceWriter& writer)
{
    const std::uint64_t first = group.curves->curves.front().firstPoint;
    writer.write(group.curves->curves, until, [first](std::span<const Curve> curves, CurveScratch&, std::string& out) {
        for (const Curve& curve : curves)
            for (std::uint64_t point = curve.firstPoint; point + 1 < curve.endPoint(); ++point) {
                const auto at = static_cast<quint32>(2 * (point - first));
                for (const quint32 corner : {0U, 1U, 2U, 2U, 1U, 3U})
                    appendBytes(out, at + corner);
            }
    });
}

template<typename T>
std::string_view bytesOf(const std::vector<T>& values)
{
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

} // namespace

Result<void> writeRibbonFile(const CurveSet& curves, const ExportSettings& settings, const QString& path,
                             const Progress& progress)
{
    return writeInPieces(path, curves.pointCount() * kRibbonPointBytes, progress,
                         [&](AtomicFile&, PieceWriter& writer) -> Checked<void> {
                             constexpr double kMeasuredPart = 0.4;
                             // The fraction of writing that vertices take; indices take the rest.
                             constexpr double kVertexPart = 0.9;
                             const auto doneWith = [&curves](const RibbonGroup& group) {
                                 return static_cast<double>(group.curves->curves.back().endPoint()) /
                                        static_cast<double>(curves.pointCount());
                             };
                             std::vector<RibbonGroup> groups;
                             RibbonJson json;
                             for (const CurveGroup& group : curves.groups()) {
                                 if (group.curves.empty())
                                     continue;
                                 groups.push_back({.curves = &group});
                                 measureRibbons(curves, groups.back(), kMeasuredPart * doneWith(groups.back()), writer);
                                 json.add(curves, groups.back());
                             }
                             const std::vector<WornBody> bodies = wornBodies(curves, settings.worn);
                             for (const WornBody& body : bodies)
                                 json.add(body);
                             const std::vector<QByteArray> images = json.addImages();
                             constexpr quint64 kMostJsonBytes = 1U << 26U;
                             if (json.bytes() > std::numeric_limits<quint32>::max() - kMostJsonBytes)
                                 return tooManyPoints();
                             const QByteArray head = glbHead(json.finish(), static_cast<quint32>(json.bytes()));
                             writer.write({head.constData(), static_cast<std::size_t>(head.size())});
                             double before = kMeasuredPart;
                             for (const RibbonGroup& group : groups) {
                                 const double after = kMeasuredPart + (1.0 - kMeasuredPart) * doneWith(group);
                                 writeRibbonVertices(curves, group, before + kVertexPart * (after - before), writer);
                                 writeRibbonIndices(group, after, writer);
                                 before = after;
                             }
                             for (const WornBody& body : bodies) {
                                 writer.write(bytesOf(body.mesh.vertices));
                                 writer.write(bytesOf(body.mesh.indices));
                             }
                             for (const QByteArray& image : images)
                                 writer.write({image.constData(), static_cast<std::size_t>(image.size())});
                             return {};
                         });
}

} // namespace hairpaint::model
