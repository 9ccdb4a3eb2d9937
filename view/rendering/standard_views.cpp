// Cameras of the standard views.
#include "view/rendering/standard_views.h"

#include "sim/base/deterministic.h"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

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
constexpr std::array<NamedView, 7> kViews = {{
    {"front", StandardView::Front, 0.0F, 0.04F},
    {"back", StandardView::Back, kPi, 0.08F},
    {"left", StandardView::Left, kPi / 2.0F, 0.04F},
    {"right", StandardView::Right, -kPi / 2.0F, 0.04F},
    {"top", StandardView::Top, 0.0F, 1.4F},
    {"bottom", StandardView::Bottom, 0.0F, -1.4F},
    {"three-quarter", StandardView::ThreeQuarter, 0.62F, 0.12F},
}};

/// The same on every machine.
float tangentOfHalf(float angleRad)
{
    return sim::sinDet(angleRad * 0.5F) / sim::cosDet(angleRad * 0.5F);
}

} // namespace

std::optional<StandardView> standardViewNamed(std::string_view name)
{
    for (const NamedView& entry : kViews)
        if (entry.name == name)
            return entry.view;
    return std::nullopt;
}

std::vector<std::string_view> standardViewNames()
{
    std::vector<std::string_view> names;
    names.reserve(kViews.size());
    for (const NamedView& entry : kViews)
        names.push_back(entry.name);
    return names;
}

std::optional<Fit> fitNamed(std::string_view name)
{
    constexpr std::array<std::pair<std::string_view, Fit>, 3> names = {
        {{"hair", Fit::Hair}, {"head", Fit::Head}, {"bust", Fit::Bust}}};
    for (const auto& [known, fit] : names)
        if (known == name)
            return fit;
    return std::nullopt;
}

/// Each point asks that the eye be far enough away: along an axis of the picture, with k the tangent of half the view,
/// eye - point along the view >= |point - eye across| / k. The two sides of each axis give the least distance and the
/// middle; the longer distance of the two axes holds for both.
Camera fittedCamera(const Camera& from, std::span<const glm::vec3> pointsWo, float aspect)
{
    constexpr float kMargin = 1.08F;
    Camera camera;
    camera.azimuthRad = from.azimuthRad;
    camera.elevationRad = from.elevationRad;
    const glm::mat4 matrix = camera.view();
    const std::array<glm::vec3, 2> across = {glm::vec3(matrix[0][0], matrix[1][0], matrix[2][0]),
                                             glm::vec3(matrix[0][1], matrix[1][1], matrix[2][1])};
    const glm::vec3 toward(matrix[0][2], matrix[1][2], matrix[2][2]);
    const float halfHeight = tangentOfHalf(camera.fieldOfViewRad) / kMargin;
    const std::array<float, 2> half = {halfHeight * aspect, halfHeight};
    std::array<float, 2> middle{};
    float eye = -1e9F;
    float depth = 0.0F;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        float above = -1e9F;
        float below = -1e9F;
        for (const glm::vec3& point : pointsWo) {
            const float aside = glm::dot(point, across.at(axis));
            const float nearer = glm::dot(point, toward) * half.at(axis);
            above = std::max(above, nearer + aside);
            below = std::max(below, nearer - aside);
        }
        middle.at(axis) = (above - below) * 0.5F;
        eye = std::max(eye, (above + below) * 0.5F / half.at(axis));
    }
    for (const glm::vec3& point : pointsWo)
        depth += glm::dot(point, toward) / static_cast<float>(pointsWo.size());
    camera.targetWo = across[0] * middle[0] + across[1] * middle[1] + toward * depth;
    camera.distanceM = std::max(0.05F, eye - depth);
    return camera;
}

Camera fittedCamera(StandardView view, std::span<const glm::vec3> pointsWo, float aspect)
{
    const NamedView& entry = kViews[static_cast<std::size_t>(view)];
    Camera from;
    from.azimuthRad = entry.azimuthRad;
    from.elevationRad = entry.elevationRad;
    return fittedCamera(from, pointsWo, aspect);
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
    camera.distanceM = std::max(0.05F, shownHeightM * 0.5F / tangentOfHalf(camera.fieldOfViewRad) + size.z * 0.25F);
    camera.azimuthRad = entry.azimuthRad;
    camera.elevationRad = entry.elevationRad;
    return camera;
}

} // namespace hairpaint::rendering
