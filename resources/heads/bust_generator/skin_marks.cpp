// Rays spread over the hemisphere by the golden angle, as dense as their cosine.
#include "skin_marks.h"

#include <array>
#include <cmath>
#include <fstream>
#include <numbers>

#include "bust_shape.h"
#include "parallel_for.h"
#include "sdf_primitives.h"
#include "sim/skin/skin.h"

namespace hairpaint::heads {

namespace {

std::uint8_t byteOf(float fraction)
{
    return static_cast<std::uint8_t>(std::lround(255.0F * std::clamp(fraction, 0.0F, 1.0F)));
}

float skyFraction(const sim::Skin& skin, const glm::vec3& position, const glm::vec3& normal)
{
    constexpr int rays = 256;
    constexpr float clearance = 0.0004F; // The faces around a vertex bulge a little over its tangent plane.
    const glm::vec3 across = glm::normalize(
        glm::cross(normal, std::abs(normal.y) < 0.9F ? glm::vec3(0.0F, 1.0F, 0.0F) : glm::vec3(0.0F, 0.0F, 1.0F)));
    const glm::vec3 along = glm::cross(normal, across);
    int open = 0;
    for (int i = 0; i < rays; ++i) {
        constexpr float goldenAngle = 2.3999632F;
        const float squared = (static_cast<float>(i) + 0.5F) / static_cast<float>(rays);
        const float radius = std::sqrt(squared);
        const float angle = goldenAngle * static_cast<float>(i);
        const glm::vec3 direction =
            radius * std::cos(angle) * across + radius * std::sin(angle) * along + std::sqrt(1.0F - squared) * normal;
        open += skin.pick({.originHd = position + clearance * normal, .directionHd = direction}) ? 0 : 1;
    }
    return static_cast<float>(open) / static_cast<float>(rays);
}

// Where blood shines through: cheeks, tip of the nose, ears, chin.
float blushFraction(const MirroredPoint& p)
{
    const float cheek = 0.8F * bell(p.folded, {0.0420F, -0.0300F, 0.0680F}, {0.0200F, 0.0170F, 0.0260F});
    const float nose = bell(p.folded, {0.0040F, -0.0380F, 0.1000F}, {0.0130F, 0.0110F, 0.0160F});
    const float ear = bell(p.folded, {0.0830F, -0.0120F, -0.0180F}, {0.0160F, 0.0330F, 0.0240F});
    const float chin = 0.5F * bell(p.folded, {0.0F, -0.0980F, 0.0850F}, {0.0140F, 0.0110F, 0.0140F});
    return std::max({cheek, nose, ear, chin});
}

} // namespace

std::vector<sim::SkinMarks> skinMarks(const sim::HeadMesh& mesh)
{
    const sim::Skin skin(mesh);
    std::vector<sim::SkinMarks> marks(mesh.positionsHd.size());
    parallelFor(static_cast<int>(marks.size()), [&](int i) {
        const auto k = static_cast<std::size_t>(i);
        glm::vec3 position = mesh.positionsHd[k];
        glm::vec3 normal = mesh.normalsHd[k];
        if (position.x < 0.0F) {
            position.x = -position.x;
            normal.x = -normal.x;
        }
        const MirroredPoint p = mirrored(position);
        marks[k] = {.sky = byteOf(skyFraction(skin, position, normal)),
                    .lips = byteOf(lipsFraction(p)),
                    .lids = byteOf(lidsFraction(p)),
                    .blush = byteOf(blushFraction(p))};
    });
    return marks;
}

bool writeMarks(const std::vector<sim::SkinMarks>& marks, const std::filesystem::path& path)
{
    static_assert(sizeof(sim::SkinMarks) == 4);
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(marks.data()),
               static_cast<std::streamsize>(marks.size() * sizeof(sim::SkinMarks)));
    return static_cast<bool>(file.flush());
}

} // namespace hairpaint::heads
