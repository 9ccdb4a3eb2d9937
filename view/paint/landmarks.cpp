// The built-in head's named points as places of the flat map.
#include "view/paint/landmarks.h"

#include "model/heads/bust_landmarks.h"

#include <QCoreApplication>

namespace hairpaint::view {

std::vector<Landmark> landmarksOf(const model::Head& head)
{
    if (!head.builtIn || !head.skin)
        return {};
    const heads::BustLandmarks bust = heads::bustLandmarks();
    const std::pair<const char*, glm::vec3> places[] = {
        {QT_TRANSLATE_NOOP("Landmarks", "crown"), bust.crown},
        {QT_TRANSLATE_NOOP("Landmarks", "hairline"), bust.forehead},
        {QT_TRANSLATE_NOOP("Landmarks", "nape"), bust.nape},
        {QT_TRANSLATE_NOOP("Landmarks", "ear"), bust.earLeft},
        {QT_TRANSLATE_NOOP("Landmarks", "ear"), bust.earRight},
        {QT_TRANSLATE_NOOP("Landmarks", "nose"), bust.noseTip},
        {QT_TRANSLATE_NOOP("Landmarks", "chin"), bust.chin},
    };
    std::vector<Landmark> landmarks;
    for (const auto& [name, positionHd] : places)
        landmarks.push_back({QCoreApplication::translate("Landmarks", name), head.skin->nearest(positionHd).uv});
    return landmarks;
}

} // namespace hairpaint::view
