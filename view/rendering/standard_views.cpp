// Cameras of the standard views.
#include "view/rendering/standard_views.h"

#include <array>
#include <cmath>
#include <numbers>

namespace hairpaint::rendering {

namespace {

struct NamedView
{
    std::string_view name;
    StandardView view;
    float azimuthRad;
    float elevationRad;
};

constexpr float kPi = std::numbers::pi_v<float>;
constexpr std::array<NamedView, 6> kViews = {{
    {"front", StandardView::Front, 0.0F, 0.04F},
    {"back", StandardView::Back, kPi, 0.08F},
    {"left", StandardView::Left, kPi / 2.0F, 0.04F},
    {"right", StandardView::Right, -kPi / 2.0F, 0.04F},
    {"top", StandardView::Top, 0.0F, 1.4F},
    {"three-quarter", StandardView::ThreeQuarter, 0.62F, 0.12F},
}};

} // namespace

std::optional<StandardView> standardViewNamed(std::string_view name)
{
    for (const NamedView& entry : kViews)
        if (entry.name == name)
            return entry.view;
    return std::nullopt;
}

Camera standardCamera(StandardView view, const sim::HeadMesh& head)
{
    glm::vec3 low(1e9F);
    glm::vec3 high(-1e9F);
    for (const glm::vec3& position : head.positionsHd) {
        low = glm::min(low, position);
        high = glm::max(high, position);
    }
    if (head.positionsHd.empty())
        low = high = glm::vec3(0.0F);
    const NamedView& entry = kViews[static_cast<std::size_t>(view)];
    Camera camera;
    const glm::vec3 size = high - low;
    // Hair stands above the crown, so the mesh sits a little low in the picture.
    camera.targetWo = (low + high) * 0.5F + glm::vec3(0.0F, size.y * 0.09F, 0.0F);
    const float shownHeightM = std::max(size.y * 1.42F, std::max(size.x, size.z) * 1.1F);
    camera.distanceM = std::max(0.05F, shownHeightM * 0.5F / std::tan(camera.fieldOfViewRad * 0.5F) + size.z * 0.25F);
    camera.azimuthRad = entry.azimuthRad;
    camera.elevationRad = entry.elevationRad;
    return camera;
}

} // namespace hairpaint::rendering
