// Keeps the last picture, and what was last asked of it.
#include "view/picking/strand_pick.h"

namespace hairpaint::view {

const HairPicture& StrandPick::picture() const
{
    PictureSource source = m_source();
    if (!m_picture || m_picture->source() != source) {
        m_picture = std::make_shared<const HairPicture>(std::move(source));
        m_disc.reset();
    }
    return *m_picture;
}

std::vector<model::SeenStrand> StrandPick::under(QPointF centre, double radiusPx) const
{
    const HairPicture& now = picture();
    if (!m_disc || m_disc->centre != centre || m_disc->radiusPx != radiusPx)
        m_disc = Disc{.centre = centre, .radiusPx = radiusPx, .strands = now.under(centre, radiusPx)};
    return m_disc->strands;
}

} // namespace hairpaint::view
