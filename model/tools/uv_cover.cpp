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

void coverFace(std::vector<std::uint8_t>& texels, int size, glm::vec2 a, glm::vec2 b, glm::vec2 c)
{
    if (side(a, b, c) < 0.0F)
        std::swap(b, c);
    const auto low = [size](float x) { return std::clamp(static_cast<int>(std::floor(x - 0.5F)), 0, size); };
    const auto high = [size](float x) { return std::clamp(static_cast<int>(std::ceil(x + 0.5F)), 0, size); };
    for (int y = low(std::min({a.y, b.y, c.y})); y < high(std::max({a.y, b.y, c.y})); ++y) {
        for (int x = low(std::min({a.x, b.x, c.x})); x < high(std::max({a.x, b.x, c.x})); ++x) {
            const glm::vec2 centre(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
            if (side(a, b, centre) >= 0.0F && side(b, c, centre) >= 0.0F && side(c, a, centre) >= 0.0F)
                texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(size) + static_cast<std::size_t>(x)] = 1;
        }
    }
}

} // namespace

std::vector<std::uint8_t> uvCover(const sim::HeadMesh& mesh, int size)
{
    std::vector<std::uint8_t> texels(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    const auto corner = [&](std::uint32_t vertex) {
        const glm::vec2 uv = mesh.uvs[vertex];
        return glm::vec2(uv.x, 1.0F - uv.y) * static_cast<float>(size);
    };
    for (const glm::uvec3& face : mesh.triangles)
        coverFace(texels, size, corner(face.x), corner(face.y), corner(face.z));
    return texels;
}

void bleed(std::vector<std::uint8_t>& texels, int size, int rings)
{
    const auto at = [size](int x, int y) {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(size) + static_cast<std::size_t>(x);
    };
    std::vector<std::pair<int, int>> rim, next;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            if (texels[at(x, y)] != 0)
                rim.emplace_back(x, y);
    for (int ring = 0; ring < rings; ++ring) {
        next.clear();
        for (const auto& [x, y] : rim) {
            for (int dy = -1; dy <= 1; ++dy) {
                for (int dx = -1; dx <= 1; ++dx) {
                    const int nearX = x + dx;
                    const int nearY = y + dy;
                    if (nearX < 0 || nearY < 0 || nearX >= size || nearY >= size || texels[at(nearX, nearY)] != 0)
                        continue;
                    texels[at(nearX, nearY)] = 2;
                    next.emplace_back(nearX, nearY);
                }
            }
        }
        std::swap(rim, next);
    }
}

} // namespace hairpaint::model
