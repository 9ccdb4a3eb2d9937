// Finds the group's hair, and hands questions on.
#include "view/picking/hair_picture.h"

#include "view/picking/brushed_strands.h"
#include "view/picking/struck_strands.h"

#include <algorithm>
#include <utility>

namespace hairpaint::view {

using model::SeenStrand;

namespace {

const sim::GroupFrame* hairOf(const PictureSource& source)
{
    if (!source.frame)
        return nullptr;
    const auto found = std::ranges::find_if(source.frame->groups, [&source](const sim::GroupFrame& one) {
        return one.groom != nullptr && one.groom->groupId == source.group;
    });
    const bool isDrawn =
        found != source.frame->groups.end() && !found->positions.empty() && found->groom->roots->count() > 0;
    return isDrawn ? &*found : nullptr;
}

} // namespace

HairPicture::HairPicture(PictureSource source) : m_source(std::move(source))
{
    const sim::GroupFrame* hair = hairOf(m_source);
    if (hair == nullptr)
        return;
    const Lens lens(m_source.camera, QSizeF(m_source.size));
    const sim::HeadPose& pose = m_source.frame->pose;
    m_hair.emplace(PictureHair{.hair = hair,
                               .pose = pose,
                               .lens = lens,
                               .boxes = HairBoxes(*hair, lens),
                               .skin = SkinDepths(m_source.skin.get(), pose, lens, m_source.size)});
}

std::vector<SeenStrand> HairPicture::passed(QPointF from, QPointF to, double radiusPx) const
{
    if (!m_hair)
        return {};
    return brushedStrands(*m_hair, {pictureVec(from), pictureVec(to), static_cast<float>(radiusPx)});
}

std::vector<SeenStrand> HairPicture::crossing(std::span<const QPointF> line, bool throughSkin) const
{
    if (!m_hair)
        return {};
    return struckStrands(*m_hair, LineRows(line, false), false, throughSkin);
}

std::vector<SeenStrand> HairPicture::inside(const QPolygonF& lasso, bool throughSkin) const
{
    if (!m_hair)
        return {};
    const std::span corners(lasso.constData(), static_cast<std::size_t>(lasso.size()));
    return struckStrands(*m_hair, LineRows(corners, true), true, throughSkin);
}

QPolygonF HairPicture::curve(std::uint32_t slot) const
{
    QPolygonF line;
    if (!m_hair)
        return line;
    std::vector<glm::vec3> points;
    m_hair->drawnCurve(slot, points);
    for (const glm::vec3& positionWo : points) {
        const glm::vec3 seen = m_hair->lens.seen(positionWo);
        const bool isSeen = seen.z > 0.0F && !m_hair->skin.hides(seen);
        if (!isSeen && !line.isEmpty())
            break;
        if (isSeen)
            line.append(QPointF(static_cast<double>(seen.x), static_cast<double>(seen.y)));
    }
    return line;
}

} // namespace hairpaint::view
