// Views and accessors of a glTF file.
#include "model/exporting/glb_buffer.h"

namespace hairpaint::model {

int GlbBuffer::addView(const void* data, std::size_t bytes, int target, int stride)
{
    QJsonObject view{{QStringLiteral("buffer"), 0},
                     {QStringLiteral("byteOffset"), m_bin.size()},
                     {QStringLiteral("byteLength"), static_cast<qsizetype>(bytes)}};
    if (target != kOther)
        view.insert(QStringLiteral("target"), target);
    if (stride > 0)
        view.insert(QStringLiteral("byteStride"), stride);
    m_bin.append(static_cast<const char*>(data), static_cast<qsizetype>(bytes));
    while (m_bin.size() % 4 != 0)
        m_bin.append('\0');
    m_views.append(view);
    return static_cast<int>(m_views.size()) - 1;
}

QJsonObject GlbBuffer::accessor(int view, std::size_t offset, int componentType, std::size_t count, const char* type)
{
    return {{QStringLiteral("bufferView"), view},
            {QStringLiteral("byteOffset"), static_cast<int>(offset)},
            {QStringLiteral("componentType"), componentType},
            {QStringLiteral("count"), static_cast<qsizetype>(count)},
            {QStringLiteral("type"), QLatin1String(type)}};
}

int GlbBuffer::addAccessor(const QJsonObject& accessor)
{
    m_accessors.append(accessor);
    return static_cast<int>(m_accessors.size()) - 1;
}

int GlbBuffer::addIndices(const std::vector<std::uint32_t>& indices)
{
    const int view = addView(indices.data(), indices.size() * sizeof(std::uint32_t), kIndices);
    return addAccessor(accessor(view, 0, kInts, indices.size(), "SCALAR"));
}

const QByteArray& GlbBuffer::describedIn(QJsonObject& root) const
{
    root.insert(QStringLiteral("accessors"), m_accessors);
    root.insert(QStringLiteral("bufferViews"), m_views);
    root.insert(QStringLiteral("buffers"), QJsonArray{QJsonObject{{QStringLiteral("byteLength"), m_bin.size()}}});
    return m_bin;
}

QJsonArray jsonNumbers(const glm::vec3& v)
{
    return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

void insertAlpha(sim::TextureAlpha alpha, QJsonObject& material)
{
    if (alpha != sim::TextureAlpha::Opaque)
        material.insert(QStringLiteral("alphaMode"),
                        alpha == sim::TextureAlpha::Mask ? QStringLiteral("MASK") : QStringLiteral("BLEND"));
}

} // namespace hairpaint::model
