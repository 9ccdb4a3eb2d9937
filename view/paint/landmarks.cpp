// The built-in head's named points as places of the flat map.
#include "view/paint/landmarks.h"

#include "model/heads/bust_landmarks.h"

#include <QCoreApplication>

#include <algorithm>

namespace hairpaint::view {

namespace {

/// "L" and "R" where the head is widest: its own left is at +x.
std::vector<Landmark> sidesOf(const sim::Skin& skin)
{
    const std::vector<glm::vec3>& positions = skin.mesh().positionsHd;
    if (positions.empty())
        return {};
    const auto [right, left] = std::ranges::minmax_element(positions, {}, &glm::vec3::x);
    if (left->x - right->x < 1e-4F)
        return {};
    return {{QCoreApplication::translate("Landmarks", "L"), skin.nearest(*left).uv},
            {QCoreApplication::translate("Landmarks", "R"), skin.nearest(*right).uv}};
}

} // namespace

std::vector<Landmark> landmarksOf(const model::Head& head)
{
    if (!head.skin)
        return {};
    if (!head.builtIn)
        return sidesOf(*head.skin);
    const heads::BustLandmarks bust = heads::bustLandmarks();
    const std::pair<const char*, glm::vec3> named[] = {
        {QT_TRANSLATE_NOOP("Landmarks", "crown"), bust.crown},
        {QT_TRANSLATE_NOOP("Landmarks", "hairline"), bust.forehead},
        {QT_TRANSLATE_NOOP("Landmarks", "nape"), bust.nape},
        {QT_TRANSLATE_NOOP("Landmarks", "left ear"), bust.earLeft},
        {QT_TRANSLATE_NOOP("Landmarks", "right ear"), bust.earRight},
        {QT_TRANSLATE_NOOP("Landmarks", "nose"), bust.noseTip},
        {QT_TRANSLATE_NOOP("Landmarks", "chin"), bust.chin},
    };
    std::vector<Landmark> landmarks;
    for (const auto& [name, positionHd] : named)
        landmarks.push_back({QCoreApplication::translate("Landmarks", name), head.skin->nearest(positionHd).uv});
    return landmarks;
}

} // namespace hairpaint::view
