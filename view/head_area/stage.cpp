// The stage's camera.
#include "view/head_area/stage.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace hairpaint::view {

namespace {

constexpr float kBustShownM = 0.52F;
constexpr glm::vec3 kBustMiddleWo{0.0F, -0.063F, 0.0F};
constexpr float kMarginM = 0.015F; ///< Margin above the highest hair: curls and volume reach beyond the nodes.

/// Visits the nodes of all hairs in positioned blocks. A slot of zeros is no hair's.
template<class Visit>
void forEachNode(const sim::GroupFrame& group, const Visit& visit)
{
    const sim::StrandBlocks layout = group.groom->blocks();
    group.forEachPositionedBlock([&](std::size_t block) {
        for (std::size_t row = 0; row < layout.blockFloats(); row += sim::StrandBlocks::kNodeStride)
            for (std::size_t lane = 0; lane < sim::kLanes; ++lane) {
                const glm::vec3 node =
                    sim::StrandBlocks::load(group.positions.data() + layout.floatsFor(block) + row + lane);
                if (node != glm::vec3(0.0F))
                    visit(node);
            }
    });
}

/// Greatest height above the target at which hair is seen, m at the target's distance.
float highestSeen(const rendering::Camera& camera, const sim::StrandFrame& hair)
{
    const glm::mat4 view = camera.view();
    const glm::vec3 up(view[0][1], view[1][1], view[2][1]);
    const glm::vec3 towardEye(view[0][2], view[1][2], view[2][2]);
    float highest = 0.0F;
    for (const sim::GroupFrame& group : hair.groups) {
        if (!group.groom->visible)
            continue;
        forEachNode(group, [&](const glm::vec3& node) {
            const glm::vec3 offset = node - camera.targetWo;
            const float nearness = std::max(0.1F, 1.0F - glm::dot(offset, towardEye) / camera.distanceM);
            highest = std::max(highest, glm::dot(offset, up) / nearness);
        });
    }
    return highest;
}

void makeRoomForHair(rendering::Camera& camera, const sim::StrandFrame& hair)
{
    const float half = camera.distanceM * std::tan(camera.fieldOfViewRad / 2.0F);
    const float beyond = highestSeen(camera, hair) + kMarginM - half;
    if (beyond <= 0.0F)
        return;
    const glm::mat4 view = camera.view();
    camera.targetWo += glm::vec3(view[0][1], view[1][1], view[2][1]) * (beyond / 2.0F);
    camera.distanceM *= 1.0F + beyond / 2.0F / half;
}

rendering::Camera stageOf(rendering::Camera camera, const model::Head& head, const sim::StrandFrame* hair)
{
    if (head.builtIn) {
        camera.targetWo = kBustMiddleWo;
        camera.distanceM = 0.5F * kBustShownM / std::tan(camera.fieldOfViewRad / 2.0F);
    }
    if (hair != nullptr)
        makeRoomForHair(camera, *hair);
    return camera;
}

/// Adds the points of a bust's head alone, and of other heads all.
void addHead(std::vector<glm::vec3>& pointsWo, const model::Head& head)
{
    constexpr float kBelowChinM = 0.01F;
    const float lowest =
        head.builtIn && head.landmarks ? (*head.landmarks)[sim::HeadLandmark::Chin].y - kBelowChinM : -1e9F;
    std::ranges::copy_if(head.skin->mesh().positionsHd, std::back_inserter(pointsWo),
                         [lowest](const glm::vec3& position) { return position.y >= lowest; });
}

void addHair(std::vector<glm::vec3>& pointsWo, const sim::StrandFrame& hair)
{
    for (const sim::GroupFrame& group : hair.groups) {
        if (!group.groom || !group.groom->visible)
            continue;
        forEachNode(group, [&](const glm::vec3& node) { pointsWo.push_back(node); });
    }
}

} // namespace

rendering::Camera pictureCamera(rendering::StandardView view, rendering::Fit fit, const model::Head& head,
                                const sim::StrandFrame* hair, float aspect)
{
    return pictureCamera(rendering::standardCamera(view, head.skin->mesh()), fit, head, hair, aspect);
}

rendering::Camera pictureCamera(const rendering::Camera& from, rendering::Fit fit, const model::Head& head,
                                const sim::StrandFrame* hair, float aspect)
{
    std::vector<glm::vec3> pointsWo;
    if (fit != rendering::Fit::Bust)
        addHead(pointsWo, head);
    if (fit == rendering::Fit::Hair && hair != nullptr)
        addHair(pointsWo, *hair);
    if (!pointsWo.empty())
        return rendering::fittedCamera(from, pointsWo, aspect);
    rendering::Camera camera = rendering::standardCamera(rendering::StandardView::Front, head.skin->mesh());
    camera.azimuthRad = from.azimuthRad;
    camera.elevationRad = from.elevationRad;
    return camera;
}

rendering::Camera stageCamera(rendering::StandardView view, const model::Head& head, const sim::HeadMesh& mesh,
                              const sim::StrandFrame* hair)
{
    return stageOf(rendering::standardCamera(view, mesh), head, hair);
}

rendering::Camera stageCamera(const rendering::Camera& from, const model::Head& head, const sim::HeadMesh& mesh,
                              const sim::StrandFrame* hair)
{
    rendering::Camera camera = rendering::standardCamera(rendering::StandardView::Front, mesh);
    camera.azimuthRad = from.azimuthRad;
    camera.elevationRad = from.elevationRad;
    return stageOf(camera, head, hair);
}

} // namespace hairpaint::view
