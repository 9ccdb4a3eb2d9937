// A head's landmarks as points of the flat map.
#include "view/paint_area/landmarks.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

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

/// In the order of HeadLandmark.
constexpr std::array<const char*, sim::kHeadLandmarkCount> kLandmarkNames = {
    QT_TRANSLATE_NOOP("Landmarks", "crown"),     QT_TRANSLATE_NOOP("Landmarks", "hairline"),
    QT_TRANSLATE_NOOP("Landmarks", "nape"),      QT_TRANSLATE_NOOP("Landmarks", "left ear"),
    QT_TRANSLATE_NOOP("Landmarks", "right ear"), QT_TRANSLATE_NOOP("Landmarks", "nose"),
    QT_TRANSLATE_NOOP("Landmarks", "chin"),
};

} // namespace

QString landmarkName(sim::HeadLandmark landmark)
{
    return QCoreApplication::translate("Landmarks", kLandmarkNames[static_cast<std::size_t>(landmark)]);
}

std::vector<Landmark> landmarksOf(const model::Head& head)
{
    if (!head.skin)
        return {};
    if (!head.landmarks)
        return sidesOf(*head.skin);
    std::vector<Landmark> landmarks;
    for (std::size_t i = 0; i < sim::kHeadLandmarkCount; ++i)
        landmarks.push_back(
            {landmarkName(static_cast<sim::HeadLandmark>(i)), head.skin->nearest(head.landmarks->positionsHd[i]).uv});
    return landmarks;
}

} // namespace hairpaint::view
