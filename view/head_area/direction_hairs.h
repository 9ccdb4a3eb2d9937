// Which short hairs show a direction map on the head, as a camera sees them.
#pragma once

#include "sim/base/tiled_raster.h"
#include "sim/motion/strand_frame.h"
#include "sim/skin/skin_frame.h"
#include "view/look/tapered_hair.h"
#include "view/rendering/scene.h"

#include <QSizeF>

#include <memory>
#include <vector>

namespace hairpaint::view {

/// What they show: a group's resolved maps. None where `direction` is null.
struct DirectionField
{
    std::shared_ptr<const sim::TiledRaster> direction;
    std::shared_ptr<const sim::TiledRaster> density; ///< Hairs stand where it is above 0; everywhere where all is bald.
};

/// Their roots stay where they are on the skin, so that they go with the head; of those that would stand too close in
/// the picture the same ones stay away whichever side the camera comes from. GUI thread.
class DirectionHairs
{
public:
    /// Spaced evenly in the picture of `size`, at most about 2,000, in about 3 ms; the first time on a head in 30 ms.
    [[nodiscard]] std::vector<HairSpine> seen(const std::shared_ptr<const sim::Skin>& skin, const DirectionField& field,
                                              const rendering::Camera& camera, const sim::HeadPose& pose, QSizeF size);

private:
    struct Root
    {
        sim::SurfacePoint point;
        sim::SkinFrame frame;
        glm::mat2 uvPerM{0.0F}; ///< From a vector in the frame to one in uv.
    };
    void takeSkin(const std::shared_ptr<const sim::Skin>& skin);

    std::shared_ptr<const sim::Skin> m_skin;
    std::vector<Root> m_roots; ///< Every first part of them covers the skin evenly.
};

} // namespace hairpaint::view
