// Rasterising the uv layout.
#include "model/tools/uv_cover.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hairpaint::model {

namespace {

/// Twice the signed area of the triangle a b p.
float side(glm::vec2 a, glm::vec2 b, glm::vec2 p)
{
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

void coverFace(TexelMask& texels, glm::vec2 a, glm::vec2 b, glm::vec2 c)
{
    const int size = texels.size();
    if (side(a, b, c) < 0.0F)
        std::swap(b, c);
    const auto low = [size](float x) { return std::clamp(static_cast<int>(std::floor(x - 0.5F)), 0, size); };
    const auto high = [size](float x) { return std::clamp(static_cast<int>(std::ceil(x + 0.5F)), 0, size); };
    for (int y = low(std::min({a.y, b.y, c.y})); y < high(std::max({a.y, b.y, c.y})); ++y) {
        for (int x = low(std::min({a.x, b.x, c.x})); x < high(std::max({a.x, b.x, c.x})); ++x) {
            const glm::vec2 centre(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
            if (side(a, b, centre) >= 0.0F && side(b, c, centre) >= 0.0F && side(c, a, centre) >= 0.0F)
                texels.set(x, y);
        }
    }
}

} // namespace

TexelMask uvCover(const sim::HeadMesh& mesh, int size)
{
    TexelMask texels(size);
    const auto corner = [&](std::uint32_t vertex) {
        const glm::vec2 uv = mesh.uvs[vertex];
        return glm::vec2(uv.x, 1.0F - uv.y) * static_cast<float>(size);
    };
    for (const glm::uvec3& face : mesh.triangles)
        coverFace(texels, corner(face.x), corner(face.y), corner(face.z));
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
