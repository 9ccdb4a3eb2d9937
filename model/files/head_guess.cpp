// Plausible heads, busts and bodies.
#include "model/files/head_guess.h"

#include "model/heads/humanoid_bones.h"
#include "sim/skin/mesh_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hairpaint::model {

namespace {

/// Where the surface of an open mesh looks as a whole: away from its opening. Of unit length where all of it looks in
/// one direction; short where the mesh is closed.
glm::vec3 opennessOf(const sim::HeadMesh& mesh)
{
    glm::dvec3 sum(0.0);
    double area = 0.0;
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::dvec3 a(mesh.positionsHd[t.x]);
        const glm::dvec3 across =
            glm::cross(glm::dvec3(mesh.positionsHd[t.y]) - a, glm::dvec3(mesh.positionsHd[t.z]) - a);
        sum += across;
        area += glm::length(across);
    }
    return area > 0.0 ? glm::vec3(sum / area) : glm::vec3(0.0F);
}

/// A scalp is deeper than it is high, and open below.
bool opensBelowY(const sim::HeadMesh& mesh)
{
    constexpr float kOpen = 0.1F;
    const glm::vec3 openness = opennessOf(mesh);
    return openness.y > kOpen && openness.y > 2.0F * std::max(std::abs(openness.x), std::abs(openness.z));
}

float likelyUnit(const RiggedMesh& source, UpAxis upAxis)
{
    // From the chin to the crown 0.23 m, a bust with shoulders up to 0.9 m.
    constexpr float kTypicalHeadM = 0.3F;
    constexpr float kTypicalBodyM = 1.5F;
    constexpr float kSlender = 3.5F; // Heads and busts are less than that times as tall as they are deep.
    const glm::vec3 size = sim::boundsOf(source).size();
    const float height = upAxis == UpAxis::Y ? size.y : size.z;
    const float depth = upAxis == UpAxis::Y ? size.z : size.y;
    if (!(height > 0.0F))
        return 1.0F;
    const bool isBody = height > kSlender * depth || humanoidBones(source.skeleton.joints);
    const float typicalM = isBody ? kTypicalBodyM : kTypicalHeadM;
    constexpr std::array kMetresPerUnit = {1.0F, 0.01F, 0.001F, 0.0254F};
    const auto distance = [height, typicalM](float scale) { return std::abs(std::log(height * scale / typicalM)); };
    return *std::ranges::min_element(kMetresPerUnit, {}, distance);
}

} // namespace

HeadGuess guessHead(const RiggedMesh& source)
{
    const glm::vec3 size = sim::boundsOf(source).size();
    HeadGuess guess;
    if (source.told.up != ToldAxis::None)
        guess.upAxis = source.told.up == ToldAxis::Z ? UpAxis::Z : UpAxis::Y;
    else
        guess.upAxis = size.z > size.y && !opensBelowY(source) ? UpAxis::Z : UpAxis::Y;
    // A unit under which it would be no head is told wrongly.
    constexpr float kSmallestM = 0.001F;
    constexpr float kLargestM = 100.0F;
    const float toldM = source.told.metresPerUnit * std::max({size.x, size.y, size.z});
    guess.unitScale =
        toldM >= kSmallestM && toldM <= kLargestM ? source.told.metresPerUnit : likelyUnit(source, guess.upAxis);
    return guess;
}

HeadGuess chosen(HeadGuess guess, const HeadChoice& choice)
{
    return {.unitScale = choice.metresPerUnit.value_or(guess.unitScale),
            .upAxis = choice.upAxis.value_or(guess.upAxis)};
}

bool turnToFront(RiggedMesh& source, UpAxis upAxis, const glm::ivec3& facing)
{
    const glm::vec3 up = upAxis == UpAxis::Y ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, 1);
    const glm::vec3 front = upAxis == UpAxis::Y ? glm::vec3(0, 0, 1) : glm::vec3(0, -1, 0);
    const glm::vec3 face(facing);
    if (glm::dot(up, face) != 0.0F)
        return false;
    const glm::mat3 now(face, up, glm::cross(face, up));
    const glm::mat3 then(front, up, glm::cross(front, up));
    const glm::mat3 turn = then * glm::transpose(now); // All entries are 0, 1 or -1, so the rotation is exact.
    for (glm::vec3& position : source.positionsHd)
        position = turn * position;
    for (glm::vec3& normal : source.normalsHd)
        normal = turn * normal;
    if (!source.skeleton.empty()) {
        HeadJoint& root = source.skeleton.joints.front();
        root.translation = turn * root.translation;
        root.rotation = glm::normalize(glm::quat_cast(turn) * root.rotation);
    }
    return true;
}

bool hasLayout(const sim::HeadMesh& mesh)
{
    return mesh.uvs.size() == mesh.positionsHd.size() &&
           std::ranges::any_of(mesh.uvs, [&mesh](const glm::vec2& uv) { return uv != mesh.uvs.front(); });
}

} // namespace hairpaint::model
