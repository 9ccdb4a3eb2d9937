// Binary glTF (Khronos, glTF 2.0 specification): interleaved vertices and indices of each group, one after another.
#include "model/exporting/ribbon_file.h"

#include "model/exporting/piece_writer.h"
#include "model/exporting/ribbon.h"
#include "model/files/glb.h"

#include <QJsonArray>
#include <QJsonObject>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <mutex>

namespace hairpaint::model {

namespace {

constexpr std::size_t kRibbonPointBytes = 90; ///< About: two vertices and their triangles.
constexpr int kFloatType = 5126;
constexpr int kShortType = 5123;
constexpr int kIntType = 5125;
constexpr int kVertexTarget = 34962;
constexpr int kIndexTarget = 34963;
constexpr float kWidestRibbonM = 4e-3F;
constexpr float kShortMost = 65535.0F;

/// As it lies in the file.
struct RibbonVertex
{
    glm::vec3 position;
    glm::vec3 normal;
    std::array<quint16, 2> uv;
    std::array<quint16, 4> colour;
};
static_assert(sizeof(RibbonVertex) == 36);

struct RibbonGroup
{
    const CurveGroup* curves = nullptr;
    glm::vec3 least{std::numeric_limits<float>::max()};
    glm::vec3 greatest{std::numeric_limits<float>::lowest()};
    [[nodiscard]] quint64 points() const
    {
        return curves->curves.back().endPoint() - curves->curves.front().firstPoint;
    }
    [[nodiscard]] quint64 vertices() const { return 2 * points(); }
    [[nodiscard]] quint64 indices() const { return 6 * (points() - curves->curves.size()); }
    [[nodiscard]] quint64 vertexBytes() const { return vertices() * sizeof(RibbonVertex); }
    [[nodiscard]] quint64 indexBytes() const { return indices() * sizeof(quint32); }
};

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

QJsonArray exactly(const glm::vec3& v)
{
    return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

/// The description of what follows in the binary chunk.
class RibbonJson
{
public:
    void add(const CurveSet& set, const RibbonGroup& group)
    {
        const QString name = group.curves->name;
        const int vertices = addView(group.vertexBytes(), kVertexTarget, sizeof(RibbonVertex));
        QJsonObject position =
            accessor(vertices, offsetof(RibbonVertex, position), kFloatType, group.vertices(), "VEC3");
        position.insert(QStringLiteral("min"), exactly(group.least));
        position.insert(QStringLiteral("max"), exactly(group.greatest));
        const auto normalised = [](QJsonObject object) {
            object.insert(QStringLiteral("normalized"), true);
            return object;
        };
        const QJsonObject attributes{
            {QStringLiteral("POSITION"), addAccessor(position)},
            {QStringLiteral("NORMAL"),
             addAccessor(accessor(vertices, offsetof(RibbonVertex, normal), kFloatType, group.vertices(), "VEC3"))},
            {QStringLiteral("TEXCOORD_0"), addAccessor(normalised(accessor(vertices, offsetof(RibbonVertex, uv),
                                                                           kShortType, group.vertices(), "VEC2")))},
            {QStringLiteral("COLOR_0"), addAccessor(normalised(accessor(vertices, offsetof(RibbonVertex, colour),
                                                                        kShortType, group.vertices(), "VEC4")))}};
        const int indexView = addView(group.indexBytes(), kIndexTarget, 0);
        const int indices = addAccessor(accessor(indexView, 0, kIntType, group.indices(), "SCALAR"));
        const auto roughness = static_cast<double>(set.material(group.curves->curves.front()).roughness);
        m_materials.append(QJsonObject{
            {QStringLiteral("name"), name},
            {QStringLiteral("doubleSided"), true},
            {QStringLiteral("pbrMetallicRoughness"),
             QJsonObject{{QStringLiteral("metallicFactor"), 0.0}, {QStringLiteral("roughnessFactor"), roughness}}}});
        const QJsonObject primitive{{QStringLiteral("attributes"), attributes},
                                    {QStringLiteral("indices"), indices},
                                    {QStringLiteral("material"), static_cast<int>(m_materials.size()) - 1},
                                    {QStringLiteral("mode"), 4}};
        m_meshes.append(
            QJsonObject{{QStringLiteral("name"), name}, {QStringLiteral("primitives"), QJsonArray{primitive}}});
        m_nodes.append(QJsonObject{{QStringLiteral("name"), name},
                                   {QStringLiteral("mesh"), static_cast<int>(m_meshes.size()) - 1}});
    }

    [[nodiscard]] quint64 bytes() const { return m_bytes; }

    [[nodiscard]] QJsonObject finish() const
    {
        QJsonObject root{
            {QStringLiteral("asset"), QJsonObject{{QStringLiteral("version"), QStringLiteral("2.0")},
                                                  {QStringLiteral("generator"), QStringLiteral("Hair Paint")}}},
            {QStringLiteral("scene"), 0}};
        QJsonObject scene{{QStringLiteral("name"), QStringLiteral("Hair")}};
        if (!m_nodes.isEmpty()) { // Arrays of glTF are never empty.
            QJsonArray nodes;
            for (int i = 0; i < static_cast<int>(m_nodes.size()); ++i)
                nodes.append(i);
            scene.insert(QStringLiteral("nodes"), nodes);
            root.insert(QStringLiteral("nodes"), m_nodes);
            root.insert(QStringLiteral("meshes"), m_meshes);
            root.insert(QStringLiteral("materials"), m_materials);
            root.insert(QStringLiteral("accessors"), m_accessors);
            root.insert(QStringLiteral("bufferViews"), m_views);
            root.insert(QStringLiteral("buffers"),
                        QJsonArray{QJsonObject{{QStringLiteral("byteLength"), static_cast<qint64>(m_bytes)}}});
        }
        root.insert(QStringLiteral("scenes"), QJsonArray{scene});
        return root;
    }

private:
    int addView(quint64 bytes, int target, std::size_t stride)
    {
        QJsonObject view{{QStringLiteral("buffer"), 0},
                         {QStringLiteral("byteOffset"), static_cast<qint64>(m_bytes)},
                         {QStringLiteral("byteLength"), static_cast<qint64>(bytes)},
                         {QStringLiteral("target"), target}};
        if (stride > 0)
            view.insert(QStringLiteral("byteStride"), static_cast<int>(stride));
        m_views.append(view);
        m_bytes += bytes;
        return static_cast<int>(m_views.size()) - 1;
    }
    [[nodiscard]] static QJsonObject accessor(int view, std::size_t offset, int componentType, quint64 count,
                                              const char* type)
    {
        return {{QStringLiteral("bufferView"), view},
                {QStringLiteral("byteOffset"), static_cast<int>(offset)},
                {QStringLiteral("componentType"), componentType},
                {QStringLiteral("count"), static_cast<qint64>(count)},
                {QStringLiteral("type"), QLatin1String(type)}};
    }
    int addAccessor(const QJsonObject& accessor)
    {
        m_accessors.append(accessor);
        return static_cast<int>(m_accessors.size()) - 1;
    }

    QJsonArray m_nodes, m_meshes, m_materials, m_accessors, m_views;
    quint64 m_bytes = 0;
};

} // namespace

Result<void> writeRibbonFile(const CurveSet& curves, const ExportSettings& /*settings*/, const QString& path,
                             const Progress& progress)
{
    return writeInPieces(path, curves.pointCount() * kRibbonPointBytes, progress,
                         [&](AtomicFile&, PieceWriter& writer) -> Checked<void> {
                             constexpr double kMeasuredPart = 0.4;
                             constexpr double kVertexPart = 0.9; // Of the rest.
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
                             constexpr quint64 kMostJsonBytes = 1U << 20U;
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
                             return {};
                         });
}

} // namespace hairpaint::model
