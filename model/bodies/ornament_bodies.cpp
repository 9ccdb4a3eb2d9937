// Ornaments out of tubes and ribbons.
#include "model/bodies/ornament_bodies.h"

#include "model/bodies/ribbon_bow.h"
#include "model/bodies/swept_body.h"
#include "sim/base/deterministic.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace hairpaint::model {

namespace {

constexpr float kHalfTurn = std::numbers::pi_v<float>;

/// A leaf from the middle outward, cupped.
void addPetal(sim::HeadMesh& mesh, float angle, float reach, float width, float rise)
{
    constexpr int kSteps = 12;
    const glm::vec3 out(sim::cosDet(angle), sim::sinDet(angle), 0.0F);
    const glm::vec3 across(-out.y, out.x, 0.0F);
    std::vector<RibbonPoint> points;
    for (int i = 0; i <= kSteps; ++i) {
        const float t = static_cast<float>(i) / kSteps;
        const float along = 0.1F + 0.9F * t;
        points.push_back({.centre = out * (reach * along) + glm::vec3(0.0F, 0.0F, 0.06F + rise * t * (1.6F - t)),
                          .across = across,
                          .halfWidth = width * (0.16F + sim::sinDet(kHalfTurn * std::min(0.22F + 0.7F * t, 0.93F)))});
    }
    addRibbon(mesh, points, 0.028F, 10);
}

/// Rounded off at both ends.
void addBead(sim::HeadMesh& mesh, glm::vec3 at, float radius)
{
    constexpr int kSteps = 10;
    std::vector<SweptSection> sections;
    for (int i = 0; i <= kSteps; ++i) {
        const float t = 0.96F * (2.0F * static_cast<float>(i) / kSteps - 1.0F);
        const float round = radius * std::sqrt(1.0F - t * t);
        sections.push_back({.centre = at + glm::vec3(0.0F, 0.0F, radius * t), .halfSide = round, .halfUp = round});
    }
    addSwept(mesh, sections, false, 20);
}

/// A band's sections over a surface: `radiusAt` tells how far it lies from the centre at an angle from z toward x.
template<typename Radius>
std::shared_ptr<const sim::HeadMesh> bandOver(float halfWidth, float halfThickness, const Radius& radiusAt)
{
    constexpr int kSteps = 72;
    constexpr float kEnd = 1.85F; // rad; to behind the ears.
    std::vector<RibbonPoint> points;
    for (int i = 0; i <= kSteps; ++i) {
        const float t = 2.0F * static_cast<float>(i) / kSteps - 1.0F;
        const float angle = kEnd * t;
        const float square = t * t;
        const float nearEnd = square * square * square * square * square;
        const float round = std::sqrt(1.0F - 0.97F * nearEnd * nearEnd);
        points.push_back({.centre = glm::vec3(sim::sinDet(angle), 0.0F, sim::cosDet(angle)) * radiusAt(angle),
                          .across = {0.0F, 1.0F, 0.0F},
                          .halfWidth = halfWidth * round * (1.0F - 0.6F * square)});
    }
    auto mesh = std::make_shared<sim::HeadMesh>();
    addRibbon(*mesh, points, halfThickness, 16);
    return mesh;
}

} // namespace

namespace {

const BodyWithTails& bow()
{
    static const BodyWithTails made = [] {
        auto mesh = std::make_shared<sim::HeadMesh>();
        const std::array<HangingPart, 2> tails = addRibbonBow(*mesh, glm::vec3(0.0F), 1.0F);
        fitInBall(*mesh, kBowProportions, 1.0F);
        return BodyWithTails{.mesh = std::move(mesh), .tails = tails};
    }();
    return made;
}

} // namespace

std::shared_ptr<const sim::HeadMesh> bowBody()
{
    return bow().mesh;
}

std::span<const HangingPart> bowTails()
{
    return bow().tails;
}

/// A bent wire: one leg straight, the other in waves.
std::shared_ptr<const sim::HeadMesh> hairpinBody()
{
    static const std::shared_ptr<const sim::HeadMesh> body = [] {
        constexpr int kSteps = 40;
        constexpr float kApart = 0.05F;
        std::vector<RibbonPoint> wire;
        const auto bend = [&wire](float x, float z) {
            wire.push_back({.centre = {x, 0.0F, z}, .across = {0.0F, 1.0F, 0.0F}, .halfWidth = 0.045F});
        };
        for (int i = 0; i <= kSteps; ++i) {
            const float t = static_cast<float>(i) / kSteps;
            bend(-1.0F + 1.9F * t, kApart + 0.025F * sim::sinDet(8.0F * kHalfTurn * t) * (1.0F - t));
        }
        for (int i = 1; i < 10; ++i) {
            const float angle = 0.5F * kHalfTurn - kHalfTurn * static_cast<float>(i) / 10.0F;
            bend(0.9F + kApart * sim::cosDet(angle), kApart * sim::sinDet(angle));
        }
        for (int i = 0; i <= kSteps; ++i)
            bend(0.9F - 1.8F * static_cast<float>(i) / kSteps, -kApart);
        auto mesh = std::make_shared<sim::HeadMesh>();
        addRibbon(*mesh, wire, 0.018F, 10);
        fitInBall(*mesh, kHairpinProportions, 1.0F);
        return mesh;
    }();
    return body;
}

std::shared_ptr<const sim::HeadMesh> flowerBody()
{
    static const std::shared_ptr<const sim::HeadMesh> body = [] {
        constexpr int kOuter = 6;
        constexpr int kInner = 5;
        auto mesh = std::make_shared<sim::HeadMesh>();
        for (int i = 0; i < kOuter; ++i)
            addPetal(*mesh, 2.0F * kHalfTurn * static_cast<float>(i) / kOuter, 1.0F, 0.34F, 0.16F);
        for (int i = 0; i < kInner; ++i)
            addPetal(*mesh, 2.0F * kHalfTurn * (static_cast<float>(i) + 0.4F) / kInner, 0.62F, 0.24F, 0.34F);
        addBead(*mesh, {0.0F, 0.0F, 0.2F}, 0.17F);
        fitInBall(*mesh, kFlowerProportions, 1.0F);
        return mesh;
    }();
    return body;
}

/// A bow of teeth under a rounded back.
std::shared_ptr<const sim::HeadMesh> combBody()
{
    static const std::shared_ptr<const sim::HeadMesh> body = [] {
        constexpr int kTeeth = 13;
        constexpr int kSteps = 32;
        const auto bent = [](float x) { return 0.2F - 0.2F * x * x; }; // Around the head.
        auto mesh = std::make_shared<sim::HeadMesh>();
        std::vector<RibbonPoint> back;
        for (int i = 0; i <= kSteps; ++i) {
            const float x = 2.0F * static_cast<float>(i) / kSteps - 1.0F;
            back.push_back({.centre = {x, 0.12F, bent(x)},
                            .across = {0.0F, 1.0F, 0.0F},
                            .halfWidth = 0.09F + 0.13F * (1.0F - x * x) + 0.02F * sim::cosDet(9.0F * kHalfTurn * x)});
        }
        addRibbon(*mesh, back, 0.05F, 14);
        for (int tooth = 0; tooth < kTeeth; ++tooth) {
            const float x = 0.92F * (2.0F * static_cast<float>(tooth) / (kTeeth - 1) - 1.0F);
            std::vector<glm::vec3> line;
            std::vector<float> radii;
            for (int i = 0; i <= 6; ++i) {
                const float t = static_cast<float>(i) / 6.0F;
                line.emplace_back(x, 0.1F - 0.75F * t, bent(x) - 0.06F * t);
                radii.push_back(0.036F - 0.02F * t * t);
            }
            addSwept(*mesh, tubeAlong(line, radii, false), false, 8);
        }
        fitInBall(*mesh, kCombProportions, 1.0F);
        return mesh;
    }();
    return body;
}

std::shared_ptr<const sim::HeadMesh> looseHeadbandBody()
{
    static const std::shared_ptr<const sim::HeadMesh> body =
        bandOver(0.95F, 0.02F, [](float /*angle*/) { return 0.97F; });
    return body;
}

std::shared_ptr<const sim::HeadMesh> headbandBody(const sim::Ellipsoid& shape, const sim::Skin& skin)
{
    constexpr float kFarM = 0.5F;
    constexpr float kOffSkinM = 0.006F; // Hair goes under it.
    constexpr float kHalfThickM = 0.0015F;
    constexpr int kAngles = 33;
    constexpr float kSpan = 1.9F; // rad, to each side.
    // Ears and the like are bridged: the band is stretched over its highest points.
    std::vector<float> radii(kAngles, shape.semiAxesM.z);
    const glm::quat rotation = glm::normalize(shape.rotation);
    for (int i = 0; i < kAngles; ++i) {
        const float angle = kSpan * (2.0F * static_cast<float>(i) / (kAngles - 1) - 1.0F);
        const glm::vec3 out = rotation * glm::vec3(sim::sinDet(angle), 0.0F, sim::cosDet(angle));
        if (const auto hit = skin.pick({.originHd = shape.centreHd + out * kFarM, .directionHd = -out}))
            radii[static_cast<std::size_t>(i)] = glm::dot(hit->positionHd - shape.centreHd, out) + kOffSkinM;
    }
    for (int round = 0; round < 3; ++round) {
        std::vector<float> smooth = radii;
        for (std::size_t i = 1; i + 1 < radii.size(); ++i)
            smooth[i] = std::max(radii[i], 0.5F * (radii[i - 1] + radii[i + 1]));
        radii = smooth;
    }
    const auto radiusAt = [&](float angle) {
        const float at = (angle / kSpan + 1.0F) * 0.5F * (kAngles - 1);
        const auto before = std::min(static_cast<std::size_t>(at), radii.size() - 2);
        const float t = at - static_cast<float>(before);
        return radii[before] * (1.0F - t) + radii[before + 1] * t;
    };
    auto mesh = std::make_shared<sim::HeadMesh>(*bandOver(shape.semiAxesM.y, kHalfThickM, radiusAt));
    for (glm::vec3& position : mesh->positionsHd)
        position /= shape.semiAxesM;
    for (glm::vec3& normal : mesh->normalsHd)
        normal = glm::normalize(normal * shape.semiAxesM);
    return mesh;
}

} // namespace hairpaint::model
