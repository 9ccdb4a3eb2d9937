// The description of ribbons in a binary glTF file, made before the bytes that it describes.
#pragma once

#include "model/exporting/curve_set.h"
#include "model/exporting/worn_body.h"

#include <QByteArray>
#include <QJsonArray>
#include <QJsonObject>

#include <glm/glm.hpp>

#include <array>
#include <limits>
#include <memory>
#include <vector>

namespace hairpaint::model {

/// A vertex as the file's binary chunk holds it.
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

/// Whatever is added takes its bytes of the binary chunk behind what was added before: vertices, then indices.
class RibbonJson
{
public:
    void add(const CurveSet& set, const RibbonGroup& group);
    void add(const WornBody& body); ///< Its vertices are HeadVertexOut, as it has them.
    /// After all others: the images that bodies show, as the chunk has them.
    [[nodiscard]] std::vector<QByteArray> addImages();

    [[nodiscard]] quint64 bytes() const { return m_bytes; } ///< Size of the binary chunk.
    [[nodiscard]] QJsonObject finish() const;

private:
    void addNode(const QString& name, const QJsonObject& attributes, int indices, const QJsonObject& material);
    int addView(quint64 bytes, int target, std::size_t stride);
    int addAccessor(const QJsonObject& accessor);

    QJsonArray m_nodes, m_meshes, m_materials, m_accessors, m_views, m_images;
    std::vector<std::shared_ptr<const sim::MeshTexture>> m_textures;
    quint64 m_bytes = 0;
};

} // namespace hairpaint::model
