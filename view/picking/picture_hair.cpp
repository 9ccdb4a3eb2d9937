// Curves of a picture's hair.
#include "view/picking/picture_hair.h"

#include "sim/groom/strand_curve.h"

namespace hairpaint::view {

void PictureHair::drawnCurve(std::uint32_t slot, std::vector<glm::vec3>& points) const
{
    const sim::Groom& groom = *hair->groom;
    std::vector<glm::vec3> nodes(static_cast<std::size_t>(groom.nodes));
    groom.blocks().read(hair->positions, groom.frameStrand(slot), nodes);
    const sim::CurlSettings* coils = sim::coilsOf(groom.settings);
    const sim::StrandStyle& style = groom.style(slot);
    sim::evaluateStrand(nodes, pose.rotation * sim::frameTangentHd(groom, slot), style,
                        sim::segmentsOf(style, groom.nodes, coils), points, coils);
}

} // namespace hairpaint::view
