// The binary chunk of a glTF file while it is put together, and the accessors that describe it.
#pragma once

#include "sim/skin/mesh_texture.h"

#include <QByteArray>
#include <QJsonArray>
#include <QJsonObject>

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hairpaint::model {

/// Numbers by the glTF 2.0 specification (Khronos).
class GlbBuffer
{
public:
    static constexpr int kFloats = 5126; ///< Types of components.
    static constexpr int kInts = 5125;
    static constexpr int kShorts = 5123;
    static constexpr int kVertices = 34962; ///< Targets of buffer views.
    static constexpr int kIndices = 34963;
    static constexpr int kOther = 0;

    /// A view of those bytes; its number. `stride`: 0 where elements lie close together.
    int addView(const void* data, std::size_t bytes, int target = kOther, int stride = 0);
    [[nodiscard]] static QJsonObject accessor(int view, std::size_t offset, int componentType, std::size_t count,
                                              const char* type);
    int addAccessor(const QJsonObject& accessor);              ///< Its number.
    int addIndices(const std::vector<std::uint32_t>& indices); ///< The number of their accessor.

    /// Sets "accessors", "bufferViews" and "buffers"; what follows is the chunk.
    [[nodiscard]] const QByteArray& describedIn(QJsonObject& root) const;

private:
    QJsonArray m_views;
    QJsonArray m_accessors;
    QByteArray m_bin;
};

[[nodiscard]] QJsonArray jsonNumbers(const glm::vec3& v);
/// Sets a material's "alphaMode" where it is not opaque.
void insertAlpha(sim::TextureAlpha alpha, QJsonObject& material);

} // namespace hairpaint::model
