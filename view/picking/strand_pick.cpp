// Keeps the last picture.
#include "view/picking/strand_pick.h"

namespace hairpaint::view {

const HairPicture& StrandPick::picture() const
{
    PictureSource source = m_source();
    if (!m_picture || m_picture->source() != source)
        m_picture = std::make_shared<const HairPicture>(std::move(source));
    return *m_picture;
}

} // namespace hairpaint::view
