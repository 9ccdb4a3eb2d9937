// Rings of vertices joined by triangles that face away from the line.
#include "model/bodies/swept_body.h"

#include "sim/base/deterministic.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hairpaint::model {

namespace {

constexpr float kTurn = 2.0F * std::numbers::pi_v<float>;

void addFacing(sim::HeadMesh& mesh, unsigned a, unsigned b, unsigned c)
{
    const glm::vec3& from = mesh.positionsHd[a];
    const glm::vec3 across = glm::cross(mesh.positionsHd[b] - from, mesh.positionsHd[c] - from);
    const glm::vec3 normal = mesh.normalsHd[a] + mesh.normalsHd[b] + mesh.normalsHd[c];
    if (glm::dot(across, normal) < 0.0F)
        std::swap(b, c);
    mesh.triangles.emplace_back(a, b, c);
}

void addCap(sim::HeadMesh& mesh, const SweptSection& section, unsigned firstOfRing, int corners, glm::vec3 outward)
{
    const auto middle = static_cast<unsigned>(mesh.positionsHd.size());
    const auto add = [&](glm::vec3 position) {
        mesh.positionsHd.push_back(position);
        mesh.normalsHd.push_back(outward);
        mesh.uvs.emplace_back(0.5F, 0.5F);
    };
    add(section.centre);
    for (int i = 0; i < corners; ++i)
        add(glm::vec3(mesh.positionsHd[firstOfRing + static_cast<unsigned>(i)]));
    for (int i = 0; i < corners; ++i)
        addFacing(mesh, middle, middle + 1U + static_cast<unsigned>(i),
                  middle + 1U + static_cast<unsigned>((i + 1) % corners));
}

glm::vec3 tangentAt(std::span<const glm::vec3> line, std::size_t at, bool closed)
{
    const std::size_t count = line.size();
    const glm::vec3 before = line[at > 0 ? at - 1 : closed ? count - 1 : 0];
    const glm::vec3 after = line[at + 1 < count ? at + 1 : closed ? 0 : count - 1];
    return glm::normalize(after - before);
}

} // namespace

void addSwept(sim::HeadMesh& mesh, std::span<const SweptSection> sections, bool closed, int corners)
{
    const auto first = static_cast<unsigned>(mesh.positionsHd.size());
    const auto count = static_cast<int>(sections.size());
    for (int row = 0; row < count; ++row) {
        const SweptSection& section = sections[static_cast<std::size_t>(row)];
        for (int i = 0; i < corners; ++i) {
            const float angle = kTurn * static_cast<float>(i) / static_cast<float>(corners);
            const float cosine = sim::cosDet(angle);
            const float sine = sim::sinDet(angle);
            mesh.positionsHd.push_back(section.centre + section.side * (section.halfSide * cosine) +
                                       section.up * (section.halfUp * sine));
            mesh.normalsHd.push_back(
                glm::normalize(section.side * (cosine / section.halfSide) + section.up * (sine / section.halfUp)));
            mesh.uvs.emplace_back(static_cast<float>(i) / static_cast<float>(corners),
                                  static_cast<float>(row) / static_cast<float>(count));
        }
    }
    const auto at = [&](int row, int corner) {
        return first + static_cast<unsigned>((row % count) * corners + corner % corners);
    };
    for (int row = 0; row + (closed ? 0 : 1) < count; ++row)
        for (int i = 0; i < corners; ++i) {
            addFacing(mesh, at(row, i), at(row, i + 1), at(row + 1, i));
            addFacing(mesh, at(row + 1, i), at(row, i + 1), at(row + 1, i + 1));
        }
    if (closed || count < 2)
        return;
    addCap(mesh, sections.front(), first, corners, glm::normalize(sections[0].centre - sections[1].centre));
    addCap(mesh, sections.back(), at(count - 1, 0), corners,
           glm::normalize(sections.back().centre - sections[sections.size() - 2].centre));
}

std::vector<SweptSection> tubeAlong(std::span<const glm::vec3> line, std::span<const float> radii, bool closed)
{
    // The frame is carried from point to point, so that the tube does not twist.
    std::vector<SweptSection> sections;
    glm::vec3 side(0.0F);
    for (std::size_t i = 0; i < line.size(); ++i) {
        const glm::vec3 tangent = tangentAt(line, i, closed);
        if (i == 0)
            side = std::abs(tangent.z) < 0.9F ? glm::vec3(0, 0, 1) : glm::vec3(1, 0, 0);
        side = glm::normalize(side - glm::dot(side, tangent) * tangent);
        sections.push_back({.centre = line[i],
                            .side = side,
                            .up = glm::cross(tangent, side),
                            .halfSide = radii[i],
                            .halfUp = radii[i]});
    }
    return sections;
}

void addRibbon(sim::HeadMesh& mesh, std::span<const RibbonPoint> points, float halfThickness, int corners)
{
    std::vector<glm::vec3> line;
    for (const RibbonPoint& point : points)
        line.push_back(point.centre);
    std::vector<SweptSection> sections;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::vec3 across = points[i].across;
        const glm::vec3 tangent = tangentAt(line, i, false);
        const glm::vec3 side = glm::normalize(across - glm::dot(across, tangent) * tangent);
        sections.push_back({.centre = line[i],
                            .side = side,
                            .up = glm::cross(tangent, side),
                            .halfSide = points[i].halfWidth,
                            .halfUp = halfThickness});
    }
    addSwept(mesh, sections, false, corners);
}

void fitInBall(sim::HeadMesh& mesh, glm::vec3 proportions, float reach)
{
    float furthest = 0.0F;
    for (glm::vec3& position : mesh.positionsHd) {
        position /= proportions;
        furthest = std::max(furthest, glm::length(position));
    }
    if (furthest > 0.0F)
        for (glm::vec3& position : mesh.positionsHd)
            position *= reach / furthest;
    for (glm::vec3& normal : mesh.normalsHd)
        normal = glm::normalize(normal * proportions);
}

} // namespace hairpaint::model
