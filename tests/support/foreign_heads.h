// Heads of other shapes and layouts, of which it is known where each point of the built-in one lies.
#pragma once

#include "sim/base/rounded.h"
#include "sim/skin/head_mesh.h"

#include <cmath>
#include <functional>
#include <map>
#include <utility>

namespace hairpaint::test {

/// A head that was bent into another one, and the bending.
struct ForeignHead
{
    sim::HeadMesh mesh;
    std::function<glm::vec3(const glm::vec3&)> moved; ///< From a point of the built-in head to that of this one.
};

/// Its two halves as islands apart, smaller, one of them on its side: nothing lies where it did.
inline void layOutInHalves(sim::HeadMesh& mesh)
{
    std::map<std::pair<unsigned, bool>, unsigned> copies;
    sim::HeadMesh halves;
    const auto copyOf = [&](unsigned vertex, bool left) {
        const auto [found, isNew] = copies.try_emplace({vertex, left}, static_cast<unsigned>(halves.uvs.size()));
        if (isNew) {
            halves.positionsHd.push_back(mesh.positionsHd[vertex]);
            halves.normalsHd.push_back(mesh.normalsHd[vertex]);
            const glm::vec2 uv = mesh.uvs[vertex];
            halves.uvs.push_back(left ? glm::vec2(0.02F + 0.9F * (uv.x - 0.5F), 0.05F + 0.9F * uv.y)
                                      : glm::vec2(0.52F + 0.45F * uv.y, 0.02F + 0.9F * (0.5F - uv.x)));
        }
        return found->second;
    };
    for (const glm::uvec3& t : mesh.triangles) {
        const bool left = mesh.uvs[t.x].x + mesh.uvs[t.y].x + mesh.uvs[t.z].x > 1.5F;
        halves.triangles.emplace_back(copyOf(t.x, left), copyOf(t.y, left), copyOf(t.z, left));
    }
    mesh = std::move(halves);
}

inline ForeignHead bent(const sim::HeadMesh& known, std::function<glm::vec3(const glm::vec3&)> moved)
{
    ForeignHead head{.mesh = known, .moved = std::move(moved)};
    for (glm::vec3& p : head.mesh.positionsHd)
        p = head.moved(p);
    for (glm::vec3& n : head.mesh.normalsHd)
        n = glm::vec3(0.0F);
    for (const glm::uvec3& t : head.mesh.triangles) {
        const glm::vec3& a = head.mesh.positionsHd[t.x];
        const glm::vec3 normal = glm::cross(head.mesh.positionsHd[t.y] - a, head.mesh.positionsHd[t.z] - a);
        for (int corner = 0; corner < 3; ++corner)
            head.mesh.normalsHd[t[corner]] += normal;
    }
    for (glm::vec3& n : head.mesh.normalsHd)
        n = glm::normalize(n);
    layOutInHalves(head.mesh);
    return head;
}

/// Smaller, the skull larger against the face.
inline ForeignHead childOf(const sim::HeadMesh& known)
{
    return bent(known, [](const glm::vec3& p) {
        const float face = 0.84F + 0.10F * std::tanh((p.y + 0.01F) / 0.05F);
        return glm::vec3(0.86F * p.x * (0.95F + 0.05F * face), p.y * face, 0.84F * p.z);
    });
}

/// Broader and lower, the jaw as wide as the skull.
inline ForeignHead broadOf(const sim::HeadMesh& known)
{
    return bent(known, [](const glm::vec3& p) {
        const float wider = 1.10F - 0.04F * std::tanh((p.y + 0.02F) / 0.05F);
        return glm::vec3(wider * p.x, 0.95F * p.y, 1.05F * p.z);
    });
}

/// As a scanner gives it: turned and shifted, another face, rough, with holes, and cut off at the neck.
inline ForeignHead scanOf(const sim::HeadMesh& known)
{
    ForeignHead head = bent(known, [](const glm::vec3& p) {
        const float wider = 1.06F + 0.05F * std::tanh(p.y / 0.06F);
        const glm::vec3 own(wider * p.x, 0.97F * p.y, 1.04F * p.z + 0.06F * p.y * p.y / 0.1F);
        const float cosine = sim::cosRounded(0.2F);
        const float sine = sim::sinRounded(0.2F);
        const glm::vec3 rough = 0.0004F * glm::vec3(sim::sinRounded(1900.0F * p.y), sim::sinRounded(2300.0F * p.z),
                                                    sim::sinRounded(2100.0F * p.x));
        return glm::vec3(cosine * own.x + sine * own.z, own.y, -sine * own.x + cosine * own.z) + rough +
               glm::vec3(0.03F, 1.52F, -0.02F);
    });
    const float neck = head.moved({0.0F, -0.15F, 0.0F}).y;
    unsigned number = 0;
    std::erase_if(head.mesh.triangles,
                  [&](const glm::uvec3& t) { return head.mesh.positionsHd[t.x].y < neck || number++ % 97 == 0; });
    return head;
}

} // namespace hairpaint::test
