// A character of parts as other programs have them: head, eyes, body, clothes, glasses; made, with a skeleton.
#pragma once

#include "model/heads/rigged_mesh.h"
#include "tests/support/mannequin.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace hairpaint::test {

/// Two colours in squares of a quarter.
inline model::MeshTexture chequered(std::uint32_t side, std::array<std::uint8_t, 3> first,
                                    std::array<std::uint8_t, 3> second)
{
    model::MeshTexture texture{.width = side, .height = side, .rgba = {}};
    for (std::uint32_t y = 0; y < side; ++y)
        for (std::uint32_t x = 0; x < side; ++x) {
            const auto& colour = (x * 4 / side + y * 4 / side) % 2 == 0 ? first : second;
            texture.rgba.insert(texture.rgba.end(), {colour[0], colour[1], colour[2], 255});
        }
    return texture;
}

/// The mesh's vertices and triangles that no part has yet become one.
inline model::MeshPart& closePart(model::RiggedMesh& mesh, std::string name, std::string material)
{
    model::MeshPart part{.name = std::move(name), .material = std::move(material)};
    part.vertices = static_cast<std::uint32_t>(mesh.positionsHd.size());
    part.triangles = static_cast<std::uint32_t>(mesh.triangles.size());
    for (const model::MeshPart& other : mesh.parts) {
        part.vertices -= other.vertices;
        part.triangles -= other.triangles;
    }
    return mesh.parts.emplace_back(std::move(part));
}

inline void addBall(model::RiggedMesh& mesh, glm::vec3 centre, float radiusM, int segments, int joint = kMannequinHead)
{
    const sim::HeadMesh ball = makeBallHead(segments, radiusM);
    const auto first = static_cast<std::uint32_t>(mesh.positionsHd.size());
    for (std::size_t i = 0; i < ball.positionsHd.size(); ++i) {
        mesh.positionsHd.push_back(ball.positionsHd[i] + centre);
        mesh.normalsHd.push_back(ball.normalsHd[i]);
        mesh.uvs.push_back(ball.uvs[i]);
        mesh.skeleton.weights.push_back({.joints = {static_cast<std::uint16_t>(joint), 0, 0, 0}});
    }
    for (const glm::uvec3& triangle : ball.triangles)
        mesh.triangles.push_back(triangle + first);
}

inline constexpr glm::vec3 kCharacterHead(0.0F, 1.62F, 0.0F);

/// Six parts: "Body" with a texture, "Head", "Eye_L" and "Eye_R" with one together, "Bag" and "Glasses", which have no
/// layout. Metres, y up. The head alone has the scalp; all layouts cover the whole square.
inline model::RiggedMesh makeCharacter(int headSegments = 24)
{
    const model::RiggedMesh mannequin = makeMannequin(0.0F, 4);
    model::RiggedMesh made;
    made.skeleton.joints = mannequin.skeleton.joints;
    std::vector<model::JointPose> poses = posesOf(mannequin.skeleton);
    for (std::size_t i = 0; i < kMannequin.size(); ++i)
        if (const int parent = kMannequin[i].parent; parent >= 0 && parent != kMannequinHead)
            addLimb(made, parent, poses[static_cast<std::size_t>(parent)].position, poses[i].position);
    made.textures = {chequered(64, {200, 30, 30}, {30, 30, 200}), chequered(32, {250, 250, 250}, {20, 120, 40})};
    closePart(made, "Body", "Cotton").texture = 0;
    addBall(made, kCharacterHead, 0.12F, headSegments);
    closePart(made, "Head", "Skin").colour = glm::vec3(0.6F, 0.4F, 0.3F);
    for (const float side : {1.0F, -1.0F}) {
        addBall(made, kCharacterHead + glm::vec3(0.04F * side, 0.02F, 0.115F), 0.016F, 12);
        closePart(made, side > 0.0F ? "Eye_L" : "Eye_R", "Iris").texture = 1;
    }
    addBall(made, kCharacterHead + glm::vec3(0.0F, -0.5F, 0.1F), 0.05F, 12, 3);
    closePart(made, "Bag", "Leather").colour = glm::vec3(0.2F, 0.1F, 0.05F);
    const std::size_t first = made.uvs.size();
    addBall(made, kCharacterHead + glm::vec3(0.0F, 0.03F, 0.15F), 0.01F, 8);
    std::fill(made.uvs.begin() + static_cast<std::ptrdiff_t>(first), made.uvs.end(), glm::vec2(0.0F));
    closePart(made, "Glasses", "").hasLayout = false;
    return made;
}

} // namespace hairpaint::test
