// Rasterizes the head into its uv square.
#include "view/paint_area/uv_shading.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::view {

namespace {

constexpr int kOversampling = 2;
constexpr float kHollowPerM = 0.0045F; ///< Shade for a curvature of 1/m.

/// Mean of the normals' divergence along each vertex's edges, 1/m: above 0 on ridges, below in hollows.
std::vector<float> curvatures(const sim::HeadMesh& mesh)
{
    std::vector<float> sums(mesh.positionsHd.size(), 0.0F);
    std::vector<float> counts(mesh.positionsHd.size(), 0.0F);
    for (const glm::uvec3& triangle : mesh.triangles) {
        for (int corner = 0; corner < 3; ++corner) {
            const unsigned a = triangle[corner];
            const unsigned b = triangle[(corner + 1) % 3];
            const glm::vec3 edge = mesh.positionsHd[b] - mesh.positionsHd[a];
            const float bend =
                glm::dot(mesh.normalsHd[b] - mesh.normalsHd[a], edge) / std::max(glm::dot(edge, edge), 1e-10F);
            for (const unsigned vertex : {a, b}) {
                sums[vertex] += bend;
                counts[vertex] += 1.0F;
            }
        }
    }
    for (std::size_t i = 0; i < sums.size(); ++i)
        sums[i] /= std::max(counts[i], 1.0F);
    return sums;
}

float shadeOf(glm::vec3 normalHd, float curvature)
{
    const glm::vec3 key = glm::normalize(glm::vec3(0.25F, 0.55F, 0.8F));
    const glm::vec3 back = glm::normalize(glm::vec3(-0.3F, 0.35F, -0.9F));
    const float diffuse =
        0.75F * std::max(0.0F, glm::dot(normalHd, key)) + 0.45F * std::max(0.0F, glm::dot(normalHd, back));
    const float hollow = std::clamp(curvature * kHollowPerM, -0.45F, 0.25F);
    return std::clamp(0.15F + diffuse + hollow, 0.0F, 1.0F);
}

std::vector<float> vertexShades(const sim::HeadMesh& mesh)
{
    std::vector<float> shades = curvatures(mesh);
    for (std::size_t i = 0; i < shades.size(); ++i)
        shades[i] = shadeOf(mesh.normalsHd[i], shades[i]);
    return shades;
}

struct ShadedCorner
{
    glm::vec2 at; ///< Samples, y down.
    float shade;
};

float cross(glm::vec2 a, glm::vec2 b)
{
    return a.x * b.y - a.y * b.x;
}

void fillTriangle(const std::array<ShadedCorner, 3>& corners, int side, std::vector<float>& shades,
                  std::vector<std::uint8_t>& covered)
{
    const float area = cross(corners[1].at - corners[0].at, corners[2].at - corners[0].at);
    if (std::abs(area) < 1e-9F)
        return;
    const glm::vec2 low = glm::min(corners[0].at, glm::min(corners[1].at, corners[2].at));
    const glm::vec2 high = glm::max(corners[0].at, glm::max(corners[1].at, corners[2].at));
    const auto limited = [side](float x) { return std::clamp(static_cast<int>(std::floor(x)), 0, side - 1); };
    for (int y = limited(low.y); y <= limited(high.y); ++y) {
        for (int x = limited(low.x); x <= limited(high.x); ++x) {
            const glm::vec2 p(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
            const float b = cross(p - corners[0].at, corners[2].at - corners[0].at) / area;
            const float c = cross(corners[1].at - corners[0].at, p - corners[0].at) / area;
            if (b < 0.0F || c < 0.0F || b + c > 1.0F)
                continue;
            const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(side) + static_cast<std::size_t>(x);
            shades[at] = (1.0F - b - c) * corners[0].shade + b * corners[1].shade + c * corners[2].shade;
            covered[at] = 1;
        }
    }
}

} // namespace

QImage bakeUvShading(const sim::HeadMesh& mesh, int side)
{
    const int fine = side * kOversampling;
    const auto count = static_cast<std::size_t>(fine) * static_cast<std::size_t>(fine);
    std::vector<float> shades(count, 0.0F);
    std::vector<std::uint8_t> covered(count, 0);
    const std::vector<float> shadeOfVertex = vertexShades(mesh);
    for (const glm::uvec3& triangle : mesh.triangles) {
        std::array<ShadedCorner, 3> corners{};
        for (std::size_t i = 0; i < 3; ++i) {
            const unsigned vertex = triangle[static_cast<int>(i)];
            const glm::vec2 uv = mesh.uvs[vertex];
            corners[i] = {glm::vec2(uv.x, 1.0F - uv.y) * static_cast<float>(fine), shadeOfVertex[vertex]};
        }
        fillTriangle(corners, fine, shades, covered);
    }
    QImage image(side, side, QImage::Format_RGBA8888);
    for (int y = 0; y < side; ++y) {
        std::uint8_t* line = image.scanLine(y);
        for (int x = 0; x < side; ++x) {
            float sum = 0.0F;
            int hits = 0;
            for (int i = 0; i < kOversampling * kOversampling; ++i) {
                const auto at =
                    static_cast<std::size_t>(y * kOversampling + i / kOversampling) * static_cast<std::size_t>(fine) +
                    static_cast<std::size_t>(x * kOversampling + i % kOversampling);
                sum += covered[at] != 0 ? shades[at] : 0.0F;
                hits += covered[at];
            }
            const auto shade = static_cast<std::uint8_t>(hits > 0 ? 255.0F * sum / static_cast<float>(hits) : 0.0F);
            std::fill_n(line + 4 * x, 3, shade);
            line[4 * x + 3] = static_cast<std::uint8_t>(255 * hits / (kOversampling * kOversampling));
        }
    }
    return image;
}

QImage shadingVeil(const QImage& shading, bool nightPaper, const QColor& outside)
{
    constexpr float kBrightening = 0.34F;
    constexpr float kDarkening = 0.34F;
    constexpr float kOutside = 0.85F;
    QImage veil(shading.size(), QImage::Format_ARGB32_Premultiplied);
    for (int y = 0; y < shading.height(); ++y) {
        const std::uint8_t* source = shading.constScanLine(y);
        auto* line = reinterpret_cast<QRgb*>(veil.scanLine(y));
        for (int x = 0; x < shading.width(); ++x) {
            const float shade = static_cast<float>(source[4 * x]) / 255.0F;
            const float inside = static_cast<float>(source[4 * x + 3]) / 255.0F;
            // Light over the dark paper or shadow over the white one, with the contrast in the middle tones.
            const float strength = nightPaper ? kBrightening * shade * shade : kDarkening * (1.0F - shade);
            const float alphaInside = strength * inside;
            const float alphaOutside = kOutside * (1.0F - inside);
            const float tone = nightPaper ? 255.0F : 30.0F;
            const auto mixed = [&](int channel) {
                return static_cast<int>(std::lround(alphaInside * tone + alphaOutside * static_cast<float>(channel)));
            };
            line[x] = qRgba(mixed(outside.red()), mixed(outside.green()), mixed(outside.blue()),
                            static_cast<int>(std::lround(255.0F * (alphaInside + alphaOutside))));
        }
    }
    return veil;
}

} // namespace hairpaint::view
