// A small z-buffer rasteriser.
#include "preview.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <string>

#include "parallel_for.h"

namespace hairpaint::heads {

namespace {

struct View
{
    const char* name;
    float yaw;   // degrees, 0 is the face, 90 its left side
    float pitch; // degrees, positive looks down
    glm::vec3 target;
    float height; // m, what the picture shows
};

constexpr std::array<View, 9> views = {{{"front", 0.0F, 3.0F, {0.0F, -0.115F, 0.0F}, 0.54F},
                                        {"three_quarter", 38.0F, 5.0F, {0.0F, -0.115F, 0.0F}, 0.54F},
                                        {"profile", 90.0F, 0.0F, {0.0F, -0.115F, 0.0F}, 0.54F},
                                        {"back", 180.0F, 5.0F, {0.0F, -0.115F, 0.0F}, 0.54F},
                                        {"below", 25.0F, -35.0F, {0.0F, -0.115F, 0.0F}, 0.54F},
                                        {"face", 0.0F, 0.0F, {0.0F, -0.015F, 0.0F}, 0.23F},
                                        {"face_three_quarter", 40.0F, 4.0F, {0.0F, -0.015F, 0.02F}, 0.23F},
                                        {"face_profile", 90.0F, 0.0F, {0.0F, -0.015F, 0.02F}, 0.25F},
                                        {"ear", 75.0F, 0.0F, {0.07F, -0.014F, -0.01F}, 0.11F}}};

class Picture
{
public:
    Picture(int width, int height)
        : m_width(width), m_height(height), m_colours(pixels(), glm::vec3(0.13F, 0.14F, 0.16F)),
          m_depths(pixels(), -std::numeric_limits<float>::max()), m_hits(pixels(), 0)
    {}

    int width() const { return m_width; }
    int height() const { return m_height; }

    // Corners in pixels with depth toward the viewer; `shade` gets barycentric weights.
    template<typename Shade>
    void fill(const std::array<glm::vec3, 3>& corners, const Shade& shade)
    {
        const auto [a, b, c] = corners;
        const float area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        if (area == 0.0F)
            return;
        const int x0 = std::max(0, static_cast<int>(std::floor(std::min({a.x, b.x, c.x}))));
        const int x1 = std::min(m_width - 1, static_cast<int>(std::ceil(std::max({a.x, b.x, c.x}))));
        const int y0 = std::max(0, static_cast<int>(std::floor(std::min({a.y, b.y, c.y}))));
        const int y1 = std::min(m_height - 1, static_cast<int>(std::ceil(std::max({a.y, b.y, c.y}))));
        for (int y = y0; y <= y1; ++y) {
            for (int x = x0; x <= x1; ++x) {
                const glm::vec2 p(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
                const float wb = ((p.x - a.x) * (c.y - a.y) - (p.y - a.y) * (c.x - a.x)) / area;
                const float wc = ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) / area;
                const float wa = 1.0F - wb - wc;
                if (wa < 0.0F || wb < 0.0F || wc < 0.0F)
                    continue;
                const std::size_t k =
                    static_cast<std::size_t>(y) * static_cast<std::size_t>(m_width) + static_cast<std::size_t>(x);
                ++m_hits[k];
                const float depth = wa * a.z + wb * b.z + wc * c.z;
                if (depth <= m_depths[k])
                    continue;
                m_depths[k] = depth;
                m_colours[k] = shade(glm::vec3(wa, wb, wc));
            }
        }
    }

    void markOverlaps()
    {
        for (std::size_t k = 0; k < pixels(); ++k)
            if (m_hits[k] > 1)
                m_colours[k] = {1.0F, 0.0F, 0.0F};
    }

    // Four samples to a pixel.
    void write(const std::filesystem::path& path) const
    {
        std::ofstream file(path, std::ios::binary);
        file << "P6\n" << m_width / 2 << ' ' << m_height / 2 << "\n255\n";
        for (int y = 0; y + 1 < m_height; y += 2) {
            for (int x = 0; x + 1 < m_width; x += 2) {
                const std::size_t k =
                    static_cast<std::size_t>(y) * static_cast<std::size_t>(m_width) + static_cast<std::size_t>(x);
                const auto below = k + static_cast<std::size_t>(m_width);
                const glm::vec3 mean =
                    0.25F * (m_colours[k] + m_colours[k + 1] + m_colours[below] + m_colours[below + 1]);
                for (int c = 0; c < 3; ++c)
                    file.put(static_cast<char>(
                        std::lround(255.0F * std::pow(std::clamp(mean[c], 0.0F, 1.0F), 1.0F / 2.2F))));
            }
        }
    }

private:
    std::size_t pixels() const { return static_cast<std::size_t>(m_width) * static_cast<std::size_t>(m_height); }

    int m_width;
    int m_height;
    std::vector<glm::vec3> m_colours; // linear
    std::vector<float> m_depths;
    std::vector<int> m_hits;
};

// A warm key light from the upper left of the viewer and a cool, weaker one from the right; normals in view space.
glm::vec3 lit(const glm::vec3& normal, const glm::vec3& albedo)
{
    const glm::vec3 key = glm::normalize(glm::vec3(-0.55F, 0.60F, 0.60F));
    const glm::vec3 fill = glm::normalize(glm::vec3(0.85F, 0.15F, 0.35F));
    const auto gloss = [&](const glm::vec3& light) {
        const glm::vec3 half = glm::normalize(light + glm::vec3(0.0F, 0.0F, 1.0F));
        return 0.10F * std::pow(std::max(glm::dot(normal, half), 0.0F), 40.0F);
    };
    const glm::vec3 diffuse = glm::vec3(0.85F, 0.80F, 0.74F) * std::max(glm::dot(normal, key), 0.0F) +
                              glm::vec3(0.20F, 0.23F, 0.28F) * std::max(glm::dot(normal, fill), 0.0F) +
                              glm::vec3(0.07F) * (1.0F + 0.5F * normal.y);
    return albedo * diffuse + glm::vec3(gloss(key) + 0.5F * gloss(fill));
}

Picture shaded(const sim::HeadMesh& mesh, const View& view, const std::function<glm::vec3(std::size_t)>& albedo,
               bool isChecked)
{
    constexpr int width = 1000;
    constexpr int height = 1200;
    constexpr float distance = 1.6F;
    const float yaw = glm::radians(view.yaw);
    const float pitch = glm::radians(view.pitch);
    const glm::vec3 toward(std::sin(yaw) * std::cos(pitch), std::sin(pitch), std::cos(yaw) * std::cos(pitch));
    const glm::vec3 right(std::cos(yaw), 0.0F, -std::sin(yaw));
    const glm::vec3 up = glm::cross(toward, right);
    Picture picture(width, height);
    const float scale = static_cast<float>(height) / view.height;
    std::vector<glm::vec3> projected;
    std::vector<glm::vec3> normals;
    for (std::size_t v = 0; v < mesh.positionsHd.size(); ++v) {
        const glm::vec3 q = mesh.positionsHd[v] - view.target;
        const float depth = glm::dot(q, toward);
        const float zoom = scale * distance / (distance - depth);
        projected.emplace_back(0.5F * static_cast<float>(width) + glm::dot(q, right) * zoom,
                               0.5F * static_cast<float>(height) - glm::dot(q, up) * zoom, depth);
        const glm::vec3& n = mesh.normalsHd[v];
        normals.emplace_back(glm::dot(n, right), glm::dot(n, up), glm::dot(n, toward));
    }
    for (const glm::uvec3& t : mesh.triangles) {
        picture.fill({projected[t[0]], projected[t[1]], projected[t[2]]}, [&](const glm::vec3& w) {
            const glm::vec3 normal = glm::normalize(w.x * normals[t[0]] + w.y * normals[t[1]] + w.z * normals[t[2]]);
            glm::vec3 colour = w.x * albedo(t[0]) + w.y * albedo(t[1]) + w.z * albedo(t[2]);
            const glm::vec2 uv = w.x * mesh.uvs[t[0]] + w.y * mesh.uvs[t[1]] + w.z * mesh.uvs[t[2]];
            const glm::ivec2 cell(glm::floor(uv * 64.0F));
            if (isChecked && (cell.x + cell.y) % 2 == 0)
                colour *= glm::vec3(0.15F, 0.25F, 0.5F);
            return normal.z < 0.0F ? glm::vec3(0.3F, 0.1F, 0.1F) : lit(normal, colour);
        });
    }
    return picture;
}

Picture layout(const sim::HeadMesh& mesh, const std::function<glm::vec3(std::size_t)>& albedo)
{
    constexpr int size = 1600;
    Picture picture(size, size);
    const auto project = [&](std::uint32_t v) {
        return glm::vec3(mesh.uvs[v].x, 1.0F - mesh.uvs[v].y, 0.0F) * static_cast<float>(size);
    };
    for (const glm::uvec3& t : mesh.triangles) {
        picture.fill({project(t[0]), project(t[1]), project(t[2])}, [&](const glm::vec3& w) {
            const glm::vec3 normal =
                glm::normalize(w.x * mesh.normalsHd[t[0]] + w.y * mesh.normalsHd[t[1]] + w.z * mesh.normalsHd[t[2]]);
            return (w.x * albedo(t[0]) + w.y * albedo(t[1]) + w.z * albedo(t[2])) *
                   (0.55F + 0.35F * normal.y + 0.3F * normal.x);
        });
    }
    picture.markOverlaps();
    return picture;
}

} // namespace

void writePreviews(const sim::HeadMesh& fine, const sim::HeadMesh& carrying,
                   const std::function<glm::vec3(const glm::vec3&)>& tint, const std::filesystem::path& folder)
{
    std::filesystem::create_directories(folder);
    const glm::vec3 skin(0.72F, 0.62F, 0.55F);
    parallelFor(static_cast<int>(views.size()) * 2, [&](int i) {
        const View& view = views[static_cast<std::size_t>(i / 2)];
        const std::string name = view.name;
        if (i % 2 == 0)
            shaded(
                fine, view, [&](std::size_t) { return skin; }, false)
                .write(folder / (name + ".ppm"));
        else
            shaded(
                carrying, view, [&](std::size_t v) { return tint(carrying.positionsHd[v]); }, true)
                .write(folder / (name + "_checker.ppm"));
    });
    layout(carrying, [&](std::size_t v) { return tint(carrying.positionsHd[v]); }).write(folder / "uv_layout.ppm");
}

} // namespace hairpaint::heads
