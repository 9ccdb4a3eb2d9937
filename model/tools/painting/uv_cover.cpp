// Rasterising the uv layout.
#include "model/tools/painting/uv_cover.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace hairpaint::model {

namespace {

/// Twice the signed area of the triangle a b p.
float side(glm::vec2 a, glm::vec2 b, glm::vec2 p)
{
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

/// Texels whose side is asked: so many times the map, and so many a face besides. Only a mesh of which many faces cover
/// the same large part of the map comes to the end of it.
constexpr std::int64_t kMostLayers = 16;
constexpr std::int64_t kTexelsPerFace = 32;

/// Columns of a row between which a face's texels lie, wide enough that the rounding of side() loses none.
struct Span
{
    double low;
    double high;

    /// Leaves out what lies on the wrong side of the edge a b in the row of texels' centres at `y`.
    void cut(glm::vec2 a, glm::vec2 b, double y)
    {
        const double rise = static_cast<double>(b.y) - static_cast<double>(a.y);
        if (rise == 0.0)
            return;
        const double shift =
            (static_cast<double>(b.x) - static_cast<double>(a.x)) * (y - static_cast<double>(a.y)) / rise;
        const double crossing = static_cast<double>(a.x) + shift;
        const double slack = 1.0 + 2e-6 * (std::abs(shift) + std::abs(static_cast<double>(a.x)) + std::abs(high));
        if (rise > 0.0)
            high = std::min(high, crossing + slack);
        else
            low = std::max(low, crossing - slack);
    }
};

/// Sets the texels whose centre lies in the face; returns how many were looked at.
std::int64_t coverFace(TexelMask& texels, glm::vec2 a, glm::vec2 b, glm::vec2 c)
{
    const int size = texels.size();
    if (side(a, b, c) < 0.0F)
        std::swap(b, c);
    const auto low = [size](float x) { return std::clamp(static_cast<int>(std::floor(x - 0.5F)), 0, size); };
    const auto high = [size](float x) { return std::clamp(static_cast<int>(std::ceil(x + 0.5F)), 0, size); };
    const int x0 = low(std::min({a.x, b.x, c.x}));
    const int x1 = high(std::max({a.x, b.x, c.x}));
    std::int64_t visited = 0;
    for (int y = low(std::min({a.y, b.y, c.y})); y < high(std::max({a.y, b.y, c.y})); ++y) {
        const float middle = static_cast<float>(y) + 0.5F;
        Span span{static_cast<double>(x0), static_cast<double>(x1)};
        span.cut(a, b, static_cast<double>(middle));
        span.cut(b, c, static_cast<double>(middle));
        span.cut(c, a, static_cast<double>(middle));
        const int first = std::max(x0, static_cast<int>(std::min(std::floor(span.low), static_cast<double>(x1))));
        const int end = std::min(x1, static_cast<int>(std::max(std::ceil(span.high), static_cast<double>(x0))));
        for (int x = first; x < end; ++x) {
            const glm::vec2 centre(static_cast<float>(x) + 0.5F, middle);
            if (side(a, b, centre) >= 0.0F && side(b, c, centre) >= 0.0F && side(c, a, centre) >= 0.0F)
                texels.set(x, y);
        }
        visited += 1 + std::max(end - first, 0);
    }
    return visited;
}

} // namespace

TexelMask uvCover(const sim::HeadMesh& mesh, int size)
{
    TexelMask texels(size);
    const auto corner = [&](std::uint32_t vertex) {
        const glm::vec2 uv = mesh.uvs[vertex];
        return glm::vec2(uv.x, 1.0F - uv.y) * static_cast<float>(size);
    };
    std::int64_t left = kMostLayers * size * size + kTexelsPerFace * static_cast<std::int64_t>(mesh.triangles.size());
    for (const glm::uvec3& face : mesh.triangles) {
        left -= coverFace(texels, corner(face.x), corner(face.y), corner(face.z));
        if (left < 0)
            return TexelMask(size, true);
    }
    return texels;
}

const TexelMask& UvCover::of(const std::shared_ptr<const sim::Skin>& skin, int size)
{
    if (m_cover == nullptr || m_cover->size() != size || m_skin.lock() != skin) {
        m_cover = std::make_unique<const TexelMask>(uvCover(skin->mesh(), size));
        m_skin = skin;
    }
    return *m_cover;
}

} // namespace hairpaint::model
