// Curves and roots of a picture's hair.
#include "view/picking/picture_hair.h"

#include "sim/groom/strand_curve.h"

#include <cmath>

namespace hairpaint::view {

sim::SurfacePoint rootOf(const sim::RootSet& roots, std::uint32_t slot)
{
    const sim::Skin& skin = *roots.skin;
    const glm::uvec3 face = skin.mesh().triangles[roots.face[slot]];
    const glm::vec2 a = skin.mesh().uvs[face.x];
    const glm::vec2 ab = skin.mesh().uvs[face.y] - a;
    const glm::vec2 ac = skin.mesh().uvs[face.z] - a;
    const glm::vec2 at = roots.uv[slot] - a;
    const float area = ab.x * ac.y - ab.y * ac.x;
    glm::vec3 barycentric(1.0F, 0.0F, 0.0F);
    if (std::abs(area) > 0.0F) {
        barycentric.y = (at.x * ac.y - at.y * ac.x) / area;
        barycentric.z = (ab.x * at.y - ab.y * at.x) / area;
        barycentric.x = 1.0F - barycentric.y - barycentric.z;
    }
    return skin.at(roots.face[slot], barycentric);
}

sim::SurfacePoint PictureHair::rootOf(std::uint32_t slot) const
{
    return view::rootOf(*hair->groom->roots, slot);
}

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
