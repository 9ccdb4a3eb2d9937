// Reads the subset of binary glTF 2.0 in which the built-in heads are stored, independently of the product's own
// reader.
//
// Lengths in metres. Anything unexpected is an error text; the mesh is then incomplete.
#pragma once

#include <QByteArray>
#include <QString>
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace hairpaint::tests {

struct GlbMesh
{
    QString error; // empty if all went well
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec2> texCoords; // v down
    std::vector<glm::vec2> uvs;       // v up
    glm::vec3 declaredLow{0.0F};
    glm::vec3 declaredHigh{0.0F};
};

GlbMesh readGlb(const QByteArray& file);

} // namespace hairpaint::tests
