// Every texel asks for its point on the skin.
#include "sim/groom/stream_raster.h"

#include "sim/groom/direction_texel.h"
#include "sim/skin/skin_frame.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hairpaint::sim {

namespace {

/// Texels that a triangle covers, by their centres.
template<typename Visit>
void visitTexels(const std::array<glm::vec2, 3>& uv, int size, const Visit& visit)
{
    const auto n = static_cast<float>(size);
    std::array<glm::vec2, 3> p;
    for (std::size_t i = 0; i < 3; ++i)
        p[i] = glm::vec2(uv[i].x * n - 0.5F, (1.0F - uv[i].y) * n - 0.5F);
    const float area = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (p[1].y - p[0].y);
    if (!(std::abs(area) > 1e-12F))
        return;
    const auto low = glm::max(glm::min(p[0], glm::min(p[1], p[2])), glm::vec2(0.0F));
    const auto high = glm::min(glm::max(p[0], glm::max(p[1], p[2])), glm::vec2(n - 1.0F));
    for (int y = static_cast<int>(std::ceil(low.y)); static_cast<float>(y) <= high.y; ++y)
        for (int x = static_cast<int>(std::ceil(low.x)); static_cast<float>(x) <= high.x; ++x) {
            const glm::vec2 at(static_cast<float>(x), static_cast<float>(y));
            glm::vec3 weights;
            for (int i = 0; i < 3; ++i) {
                const glm::vec2 a = p[static_cast<std::size_t>((i + 1) % 3)] - at;
                const glm::vec2 b = p[static_cast<std::size_t>((i + 2) % 3)] - at;
                weights[i] = (a.x * b.y - b.x * a.y) / area;
            }
            if (std::min({weights.x, weights.y, weights.z}) >= -1e-5F)
                visit(x, y, weights);
        }
}

} // namespace

std::shared_ptr<const TiledRaster> streamRaster(const Skin& skin, const std::vector<glm::vec3>& directionsHd)
{
    constexpr int kSize = kStreamRasterSize;
    constexpr int kBleedTexels = 6;
    constexpr auto kTexels = static_cast<std::size_t>(kSize) * kSize;
    const HeadMesh& mesh = skin.mesh();
    std::vector<glm::vec2> vectors(kTexels, glm::vec2(0.0F));
    std::vector<std::uint8_t> covered(kTexels, 0);
    for (std::uint32_t face = 0; face < mesh.triangles.size(); ++face) {
        const glm::uvec3 t = mesh.triangles[face];
        visitTexels({mesh.uvs[t.x], mesh.uvs[t.y], mesh.uvs[t.z]}, kSize, [&](int x, int y, glm::vec3 weights) {
            const std::size_t at = static_cast<std::size_t>(y) * kSize + static_cast<std::size_t>(x);
            if (covered[at] != 0)
                return;
            const glm::vec3 direction =
                directionsHd[t.x] * weights.x + directionsHd[t.y] * weights.y + directionsHd[t.z] * weights.z;
            vectors[at] = SkinFrame::at(skin.at(face, weights)).fromHd(direction);
            covered[at] = 1;
        });
    }
    for (int pass = 0; pass < kBleedTexels; ++pass) {
        const std::vector<std::uint8_t> before = covered;
        for (int y = 0; y < kSize; ++y)
            for (int x = 0; x < kSize; ++x) {
                const std::size_t at = static_cast<std::size_t>(y) * kSize + static_cast<std::size_t>(x);
                if (before[at] != 0)
                    continue;
                glm::vec2 sum(0.0F);
                float count = 0.0F;
                for (int v = std::max(y - 1, 0); v <= std::min(y + 1, kSize - 1); ++v)
                    for (int u = std::max(x - 1, 0); u <= std::min(x + 1, kSize - 1); ++u) {
                        const std::size_t from = static_cast<std::size_t>(v) * kSize + static_cast<std::size_t>(u);
                        if (before[from] != 0) {
                            sum += vectors[from];
                            count += 1.0F;
                        }
                    }
                if (count > 0.0F) {
                    vectors[at] = sum / count;
                    covered[at] = 1;
                }
            }
    }
    auto raster = std::make_shared<TiledRaster>(kSize, 2, Texel{32768, 32768});
    for (int tile = 0; tile < raster->tileCount(); ++tile) {
        const TexelRect rect = raster->tileRect(tile);
        const std::span<std::uint16_t> pixels = raster->writableTile(tile);
        std::size_t out = 0;
        for (int y = rect.y0; y < rect.y1; ++y)
            for (int x = rect.x0; x < rect.x1; ++x) {
                const glm::vec2 v = vectors[static_cast<std::size_t>(y) * kSize + static_cast<std::size_t>(x)];
                const Texel texel = texelOfDirection(v);
                pixels[out++] = texel[0];
                pixels[out++] = texel[1];
            }
        raster->compact(tile);
    }
    return raster;
}

} // namespace hairpaint::sim
