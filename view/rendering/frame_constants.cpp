// Derives matrices, grids and depth keys from the scene.
#include "view/rendering/frame_constants.h"

#include "sim/motion/head_motion.h"
#include "view/rendering/eye_grid.h"

#include <glm/gtc/matrix_access.hpp>
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

/// Bounds along one direction, lane by lane.
struct Extent
{
    using Row = std::array<float, sim::kLanes>;
    Row low;
    Row high;
    Extent()
    {
        low.fill(std::numeric_limits<float>::max());
        high.fill(std::numeric_limits<float>::lowest());
    }
    /// Sixteen positions; what is not a number is none.
    void add(const Row& x, const float* y, const float* z, glm::vec3 direction)
    {
        for (std::size_t i = 0; i < sim::kLanes; ++i) {
            const float along = direction.x * x[i] + direction.y * y[i] + direction.z * z[i];
            low[i] = along < low[i] ? along : low[i];
            high[i] = along > high[i] ? along : high[i];
        }
    }
};

/// The x of sixteen strands' node. A slot of nothing but zeros is no hair's, and gets no number.
Extent::Row positionedX(const float* x, const float* y, const float* z)
{
    Extent::Row positioned;
    for (std::size_t i = 0; i < sim::kLanes; ++i)
        positioned[i] =
            std::abs(x[i]) + std::abs(y[i]) + std::abs(z[i]) > 0.0F ? x[i] : std::numeric_limits<float>::quiet_NaN();
    return positioned;
}

constexpr std::size_t kBlocksLookedAt = 128;

/// Bounds of the hair in two frames, from some of its blocks: grids and depth keys only need to be near.
std::array<Box, 2> hairBounds(const sim::StrandFrame& frame, const std::array<glm::mat3, 2>& gridAxesFromWo)
{
    std::array<std::array<Extent, 3>, 2> extents;
    for (const sim::GroupFrame& group : frame.groups) {
        if (!group.groom || !group.groom->visible)
            continue;
        const auto nodes = static_cast<std::size_t>(group.groom->nodes);
        const sim::StrandBlocks layout = group.groom->blocks();
        std::size_t blocks = 0;
        group.forEachPositionedBlock([&](std::size_t) { ++blocks; });
        const std::size_t step = std::max<std::size_t>(1, blocks / kBlocksLookedAt);
        std::size_t number = 0;
        group.forEachPositionedBlock([&](std::size_t block) {
            if (number++ % step != 0)
                return;
            for (std::size_t node = 0; node < nodes; ++node) {
                const float* x = group.positions.data() + layout.index(block * sim::kLanes, node);
                const float* y = x + sim::StrandBlocks::kAxisStride;
                const float* z = y + sim::StrandBlocks::kAxisStride;
                const Extent::Row positioned = positionedX(x, y, z);
                for (std::size_t grid = 0; grid < extents.size(); ++grid)
                    for (int axis = 0; axis < 3; ++axis)
                        extents[grid][static_cast<std::size_t>(axis)].add(positioned, y, z,
                                                                          glm::row(gridAxesFromWo[grid], axis));
            }
        });
    }
    std::array<Box, 2> boxes;
    for (std::size_t grid = 0; grid < boxes.size(); ++grid)
        for (int axis = 0; axis < 3; ++axis) {
            const Extent& extent = extents[grid][static_cast<std::size_t>(axis)];
            boxes[grid].low[axis] = *std::ranges::min_element(extent.low);
            boxes[grid].high[axis] = *std::ranges::max_element(extent.high);
        }
    return boxes;
}

/// Fraction of its light that skin keeps under dense hair: light hair passes light on, dark hair takes it. By the mean
/// of the encoded colours of a hair a chunk; as of black hair where none is drawn.
float keptUnderHair(const sim::StrandFrame& hair)
{
    constexpr float kOfBlack = 0.08F;
    constexpr float kPerLightness = 0.65F;
    constexpr float kMost = 0.45F;
    std::uint32_t sum = 0;
    std::uint32_t hairs = 0;
    for (const sim::GroupFrame& group : hair.groups) {
        if (!group.groom || !group.groom->visible)
            continue;
        for (const auto& chunk : group.groom->chunks) {
            if (!chunk || chunk->drawn.none())
                continue;
            std::size_t first = 0;
            while (!chunk->drawn[first])
                ++first;
            const std::uint32_t colour = chunk->styles[first].rootColour;
            sum += (colour & 0xFFU) + (colour >> 8U & 0xFFU) + (colour >> 16U & 0xFFU);
            ++hairs;
        }
    }
    const float lightness = hairs > 0 ? static_cast<float>(sum) / (765.0F * static_cast<float>(hairs)) : 0.0F;
    return std::min(kOfBlack + kPerLightness * lightness, kMost);
}

/// Rounds a box outward to whole steps, so that it rests while the hair moves.
void settle(Box& box, float stepM)
{
    box.low = glm::floor(box.low / stepM - 0.2F) * stepM;
    box.high = glm::ceil(box.high / stepM + 0.2F) * stepM;
}

/// Axes with z along `away`, as rows.
glm::mat3 axesAlong(glm::vec3 away)
{
    const glm::vec3 z = glm::normalize(away);
    const glm::vec3 x = glm::normalize(glm::cross(std::abs(z.y) < 0.9F ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0), z));
    return glm::transpose(glm::mat3(x, glm::cross(z, x), z));
}

/// `axesWo`: the eye's right, up and backward.
void setLights(const Light& light, glm::vec3 keyWo, const glm::mat3& axesWo, FrameConstants& c)
{
    // Above the eye, as a photographer's soft light is, and above and behind the head.
    constexpr glm::vec3 kFillEye{-0.35F, 0.5F, 0.8F};
    constexpr glm::vec3 kRimEye{0.3F, 0.6F, -0.75F};
    constexpr glm::vec3 kRimColour{1.0F, 1.0F, 1.0F};
    c.keyWo = glm::vec4(keyWo, static_cast<float>(light.scattering));
    c.keyColour = glm::vec4(light.colour, 0.0F);
    c.fillWo = glm::vec4(glm::normalize(axesWo * kFillEye), 0.0F);
    c.fillColour = glm::vec4(glm::vec3(light.fill), 0.0F);
    c.rimWo = glm::vec4(glm::normalize(axesWo * kRimEye), 0.0F);
    c.rimColour = glm::vec4(kRimColour * light.rim, 0.0F);
    const Irradiance& around = irradianceOf(light.surroundings);
    for (std::size_t i = 0; i < around.size(); ++i)
        c.around.at(i) = glm::vec4(around.at(i) * light.ambient, 0.0F);
}

/// x^(1/2.4) for x in 0..1, the same on every machine: the fifth power of the cube root of the fourth root.
float rootOf2Point4(float x)
{
    const double fourth = std::sqrt(std::sqrt(static_cast<double>(x)));
    double cube = 0.5 + 0.5 * fourth;
    constexpr int kNewtonSteps = 12;
    for (int i = 0; i < kNewtonSteps; ++i)
        cube = (2.0 * cube + fourth / (cube * cube)) / 3.0;
    return static_cast<float>(cube * cube * cube * cube * cube);
}

glm::vec3 srgbFromLinear(glm::vec3 linear)
{
    glm::vec3 srgb(0.0F);
    for (int i = 0; i < 3; ++i) {
        const float c = std::clamp(linear[i], 0.0F, 1.0F);
        srgb[i] = c <= 0.0031308F ? 12.92F * c : 1.055F * rootOf2Point4(c) - 0.055F;
    }
    return srgb;
}

} // namespace

FrameConstants frameConstants(const Scene& scene, const Target& target, float skullRadiusM)
{
    FrameConstants c{};
    const float aspect = static_cast<float>(target.width) / static_cast<float>(target.height);
    const glm::mat4 view = scene.camera.view();
    const glm::mat4 projection = scene.camera.projection(aspect);
    c.projectionFromWo = projection * view;
    c.woFromProjection = glm::inverse(c.projectionFromWo);
    const sim::HeadPose pose = scene.hair ? scene.hair->pose : sim::HeadPose{};
    c.woFromHd = glm::translate(glm::mat4(1.0F), pose.positionWo) * glm::mat4_cast(pose.rotation);
    const sim::NeckTurn neck = scene.hair ? sim::neckTurn(scene.hair->neck, pose) : sim::NeckTurn{};
    c.neckTurn = glm::vec4(neck.turn[0], neck.turn[1], neck.turn[2], neck.turn[3]);
    c.neckPivotHd = glm::vec4(neck.pivot[0], neck.pivot[1], neck.pivot[2], neck.headY);
    c.neckReach = glm::vec4(neck.perTwistM, 0.0F, 0.0F, 0.0F);
    c.eyeWo = glm::vec4(scene.camera.eyeWo(), 1.0F);
    const glm::vec3 light = glm::length(scene.light.directionWo) > 0.0F ? glm::normalize(scene.light.directionWo)
                                                                        : glm::vec3(0.0F, 1.0F, 0.0F);
    c.headWo = glm::vec4(glm::vec3(c.woFromHd[3]), skullRadiusM);
    setLights(scene.light, light, glm::transpose(glm::mat3(view)), c);

    const std::array<glm::mat3, 2> axes{axesAlong(-light), axesAlong(scene.camera.targetWo - glm::vec3(c.eyeWo))};
    std::array<Box, 2> boxes;
    if (scene.hair)
        boxes = hairBounds(*scene.hair, axes);
    for (std::size_t grid = 0; grid < boxes.size(); ++grid) {
        Box& box = boxes[grid];
        if (box.empty())
            box.add(axes[grid] * glm::vec3(c.headWo));
        settle(box, 0.02F);
        const glm::vec3 extent = box.high - box.low;
        c.gridFromWo[grid] = glm::scale(glm::mat4(1.0F), 1.0F / extent) * glm::translate(glm::mat4(1.0F), -box.low) *
                             glm::mat4(axes[grid]);
        c.gridSize[static_cast<int>(grid)] = extent.x * extent.y / static_cast<float>(kGridSide * kGridSide);
    }
    c.gridSize.w = scene.hair ? keptUnderHair(*scene.hair) : 1.0F;
    c.gridSize.z = 0.5F * projection[1][1] * static_cast<float>(target.height * target.samples.y);

    // Depth keys reach over a ball around hair and head.
    const glm::vec3 middle = glm::transpose(axes[0]) * (0.5F * (boxes[0].low + boxes[0].high));
    constexpr float headRadiusM = 0.22F;
    const float radius = std::max(0.5F * glm::length(boxes[0].high - boxes[0].low),
                                  glm::distance(middle, glm::vec3(c.headWo)) + headRadiusM);
    const float middleDistance = -(view * glm::vec4(middle, 1.0F)).z;
    const float nearest = std::max(middleDistance - radius, 0.005F);
    const float keys = 4095.0F / std::max(middleDistance + radius - nearest, 0.01F);
    c.depthRange = glm::vec4(nearest, keys, -projection[3][2], -projection[2][2]);

    c.target = glm::vec4(target.width * target.samples.x, target.height * target.samples.y, target.samples);
    const glm::vec3 background = srgbFromLinear(scene.background);
    c.background = {glm::vec4(background, 1.0F), glm::vec4(background * 0.06F + 0.01F, 0.0F)};
    c.skin = {glm::vec4(scene.skin.colour, scene.skin.scatter), glm::vec4(scene.skin.lips, scene.skin.grain),
              glm::vec4(scene.skin.lids, scene.skin.sheen)};
    std::size_t ring = 0;
    for (const auto& wanted : {scene.ring, scene.mirroredRing}) {
        if (wanted)
            c.ringWo[ring] = glm::vec4(glm::vec3(c.woFromHd * glm::vec4(wanted->centreHd, 1.0F)), wanted->radiusM);
        ++ring;
    }
    const EyeGrid eye = eyeGrid(c);
    c.eyeGrid = {glm::vec4(eye.low, eye.sectionM2), glm::vec4(eye.per, eye.middleM)};
    return c;
}

FrameConstants withoutHair(FrameConstants constants)
{
    constants.gridFromWo = {};
    constants.depthRange = glm::vec4(0.0F);
    constants.gridSize.x = constants.gridSize.y = constants.gridSize.w = 0.0F;
    constants.background = {};
    constants.ringWo = {};
    constants.eyeGrid = {};
    return constants;
}

} // namespace hairpaint::rendering
