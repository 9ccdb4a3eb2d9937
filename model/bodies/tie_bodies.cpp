// Rings of tubes and bands.
#include "model/bodies/tie_bodies.h"

#include "model/bodies/ribbon_bow.h"
#include "model/bodies/swept_body.h"
#include "sim/base/deterministic.h"

#include <array>
#include <numbers>
#include <vector>

namespace hairpaint::model {

namespace {

constexpr float kTieTurn = 2.0F * std::numbers::pi_v<float>;

/// About the z axis, where `section` tells the centre's radius, z, and the semi-axes along the radius and along z.
template<typename Section>
void addRing(sim::HeadMesh& mesh, int steps, int corners, const Section& section)
{
    std::vector<SweptSection> sections;
    for (int i = 0; i < steps; ++i) {
        const float angle = kTieTurn * static_cast<float>(i) / static_cast<float>(steps);
        const glm::vec3 out(sim::cosDet(angle), sim::sinDet(angle), 0.0F);
        const std::array<float, 4> of = section(angle);
        sections.push_back({.centre = out * of[0] + glm::vec3(0.0F, 0.0F, of[1]),
                            .side = out,
                            .up = {0.0F, 0.0F, 1.0F},
                            .halfSide = of[2],
                            .halfUp = of[3]});
    }
    addSwept(mesh, sections, true, corners);
}

} // namespace

/// A tube with the ribs of its thread.
std::shared_ptr<const sim::HeadMesh> elasticBody()
{
    static const std::shared_ptr<const sim::HeadMesh> body = [] {
        auto mesh = std::make_shared<sim::HeadMesh>();
        addRing(*mesh, 120, 12, [](float angle) {
            const float tube = 0.175F + 0.012F * sim::cosDet(24.0F * angle);
            return std::array{0.81F, 0.0F, tube, tube};
        });
        return mesh;
    }();
    return body;
}

namespace {

const BodyWithTails& ribbonTie()
{
    static const BodyWithTails made = [] {
        auto mesh = std::make_shared<sim::HeadMesh>();
        addRing(*mesh, 64, 14, [](float angle) {
            return std::array{0.8F + 0.03F * sim::cosDet(5.0F * angle), 0.0F, 0.1F, 0.42F};
        });
        // The bow lies on the ring, its face up and its tails along the hair that leaves.
        sim::HeadMesh bow;
        std::array<HangingPart, 2> tails = addRibbonBow(bow, glm::vec3(0.0F), 1.9F);
        const auto turned = [](glm::vec3 v) { return glm::vec3(v.x, v.z, -v.y); };
        const auto first = static_cast<unsigned>(mesh->positionsHd.size());
        for (std::size_t i = 0; i < bow.positionsHd.size(); ++i) {
            mesh->positionsHd.push_back(turned(bow.positionsHd[i]) + glm::vec3(0.0F, 0.78F, 0.0F));
            mesh->normalsHd.push_back(turned(bow.normalsHd[i]));
            mesh->uvs.push_back(bow.uvs[i]);
        }
        for (const glm::uvec3& triangle : bow.triangles)
            mesh->triangles.push_back(triangle + first);
        for (HangingPart& tail : tails)
            tail.first += first;
        return BodyWithTails{.mesh = std::move(mesh), .tails = tails};
    }();
    return made;
}

} // namespace

std::shared_ptr<const sim::HeadMesh> ribbonTieBody()
{
    return ribbonTie().mesh;
}

std::span<const HangingPart> ribbonTieTails()
{
    return ribbonTie().tails;
}

/// Two strands laid about each other.
std::shared_ptr<const sim::HeadMesh> cordBody()
{
    static const std::shared_ptr<const sim::HeadMesh> body = [] {
        constexpr float kLays = 9.0F;
        constexpr float kStrand = 0.1F;
        auto mesh = std::make_shared<sim::HeadMesh>();
        for (const float phase : {0.0F, 0.5F * kTieTurn})
            addRing(*mesh, 144, 10, [phase](float angle) {
                const float lay = kLays * angle + phase;
                return std::array{0.8F + 0.078F * sim::cosDet(lay), 0.1F * sim::sinDet(lay), kStrand, kStrand};
            });
        return mesh;
    }();
    return body;
}

/// A cuff.
std::shared_ptr<const sim::HeadMesh> metalRingBody()
{
    static const std::shared_ptr<const sim::HeadMesh> body = [] {
        auto mesh = std::make_shared<sim::HeadMesh>();
        addRing(*mesh, 72, 18, [](float /*angle*/) { return std::array{0.8F, 0.0F, 0.11F, 0.5F}; });
        return mesh;
    }();
    return body;
}

} // namespace hairpaint::model
