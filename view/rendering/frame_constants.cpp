#include "view/rendering/frame_constants.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hairpaint::rendering {
namespace {

struct Box
{
    glm::vec3 low{std::numeric_limits<float>::max()};
    glm::vec3 high{std::numeric_limits<float>::lowest()};
    void add(glm::vec3 p)
    {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    [[nodiscard]] bool empty() const { return low.x > high.x; }
};

/// Bounds of the hair in the light's frame, from some of its blocks: the grid and the depth keys only need to be near.
Box hairBounds(const sim::StrandFrame& frame, const glm::mat3& lightFromWo)
{
    Box box;
    for (const sim::GroupFrame& group : frame.groups) {
        if (!group.groom || !group.groom->visible)
            continue;
        const sim::Groom& groom = *group.groom;
        const auto nodes = static_cast<std::size_t>(groom.nodes);
        const std::size_t blockFloats = nodes * 3 * sim::kLanes;
        const std::size_t blocks = group.positions.size() / blockFloats;
        const std::size_t step = std::max<std::size_t>(1, blocks / 512);
        for (std::size_t block = 0; block < blocks; block += step)
            for (std::size_t node = 0; node < nodes; ++node)
                for (std::size_t lane = 0; lane < sim::kLanes; ++lane) {
                    const float* p = group.positions.data() + block * blockFloats + node * 3 * sim::kLanes + lane;
                    const glm::vec3 wo(p[0], p[sim::kLanes], p[2 * sim::kLanes]);
                    if (wo != glm::vec3(0.0F))
                        box.add(lightFromWo * wo);
                }
    }
    return box;
}

/// Rounds a box outward to whole steps, so that it rests while the hair moves.
void settle(Box& box, float stepM)
{
    box.low = glm::floor(box.low / stepM - 0.2F) * stepM;
    box.high = glm::ceil(box.high / stepM + 0.2F) * stepM;
}

glm::mat3 lightFrame(glm::vec3 towardLightWo)
{
    const glm::vec3 z = -glm::normalize(towardLightWo);
    const glm::vec3 x = glm::normalize(glm::cross(std::abs(z.y) < 0.9F ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0), z));
    return glm::transpose(glm::mat3(x, glm::cross(z, x), z));
}

glm::vec3 srgbFromLinear(glm::vec3 linear)
{
    glm::vec3 srgb(0.0F);
    for (int i = 0; i < 3; ++i) {
        const float c = std::clamp(linear[i], 0.0F, 1.0F);
        srgb[i] = c <= 0.0031308F ? 12.92F * c : 1.055F * std::pow(c, 1.0F / 2.4F) - 0.055F;
    }
    return srgb;
}

} // namespace

FrameConstants frameConstants(const Scene& scene, const Target& target)
{
    FrameConstants c{};
    const float aspect = static_cast<float>(target.width) / static_cast<float>(target.height);
    const glm::mat4 view = scene.camera.view();
    glm::mat4 projection = scene.camera.projection(aspect);
    const glm::vec2 size(target.width, target.height);
    projection = glm::translate(glm::mat4(1.0F), glm::vec3(2.0F * target.jitter / size, 0.0F)) * projection;
    c.projectionFromWo = projection * view;
    c.woFromProjection = glm::inverse(c.projectionFromWo);
    const sim::HeadPose pose = scene.hair ? scene.hair->pose : sim::HeadPose{};
    c.woFromHd = glm::translate(glm::mat4(1.0F), pose.positionWo) * glm::mat4_cast(pose.rotation);
    c.eyeWo = glm::vec4(scene.camera.eyeWo(), 1.0F);
    const glm::vec3 light = glm::length(scene.light.directionWo) > 0.0F ? glm::normalize(scene.light.directionWo)
                                                                        : glm::vec3(0.0F, 1.0F, 0.0F);
    c.lightWo = glm::vec4(light, scene.light.ambient);
    c.lightColour = glm::vec4(scene.light.colour, 0.0F);
    c.headWo = c.woFromHd * glm::vec4(0.0F, 0.0F, 0.0F, 1.0F);

    const glm::mat3 lightFromWo = lightFrame(light);
    Box box;
    if (scene.hair)
        box = hairBounds(*scene.hair, lightFromWo);
    if (box.empty())
        box.add(lightFromWo * glm::vec3(c.headWo));
    settle(box, 0.02F);
    const glm::vec3 extent = box.high - box.low;
    c.gridFromWo =
        glm::scale(glm::mat4(1.0F), 1.0F / extent) * glm::translate(glm::mat4(1.0F), -box.low) * glm::mat4(lightFromWo);
    const float side = static_cast<float>(kGridSide);
    const float projectionScale = scene.camera.projection(aspect)[1][1];
    c.gridSize = glm::vec4(extent.x, extent.y, extent.x * extent.y / (side * side),
                           0.5F * projectionScale * static_cast<float>(target.height * target.samples.y));

    // Depth keys reach over a ball around hair and head.
    const glm::vec3 middle = glm::transpose(lightFromWo) * (0.5F * (box.low + box.high));
    constexpr float headRadiusM = 0.22F;
    const float radius = std::max(0.5F * glm::length(extent), glm::distance(middle, glm::vec3(c.headWo)) + headRadiusM);
    const float middleDistance = -(view * glm::vec4(middle, 1.0F)).z;
    const float nearest = std::max(middleDistance - radius, 0.005F);
    const float keys = 8191.0F / std::max(middleDistance + radius - nearest, 0.01F);
    const float c0 = projection[3][2] / 1.0F;
    // ndc = (P22 * z + P32) / -z with z = -distance, so distance = -P32 / (-P22 - ndc) ... solved for common.glsl's
    // form.
    c.depthRange = glm::vec4(nearest, keys, -c0, -projection[2][2]);

    c.target = glm::vec4(target.width * target.samples.x, target.height * target.samples.y, target.samples);
    const glm::vec3 background = srgbFromLinear(scene.background);
    c.background = {glm::vec4(background, 1.0F), glm::vec4(background * 0.06F + 0.01F, 0.0F)};
    std::size_t ring = 0;
    for (const auto& wanted : {scene.ring, scene.mirroredRing}) {
        if (wanted)
            c.ringWo[ring] = glm::vec4(glm::vec3(c.woFromHd * glm::vec4(wanted->centreHd, 1.0F)), wanted->radiusM);
        ++ring;
    }
    return c;
}

} // namespace hairpaint::rendering
