// The hair of a group as one picture of the 3D area shows it, and which of its strands a brush or a line meets.
#pragma once

#include "model/tools/strokes/seen_hair.h"
#include "view/picking/picture_hair.h"

#include <QSize>

#include <memory>
#include <optional>
#include <vector>

namespace hairpaint::view {

/// What a picture is of.
struct PictureSource
{
    std::shared_ptr<const sim::StrandFrame> frame;
    int group = 0; ///< groupId of the groom.
    rendering::Camera camera;
    QSize size;
    std::shared_ptr<const sim::Skin> skin; ///< The head's skin, posed as in the frame; null: no skin hides anything.
    friend bool operator==(const PictureSource&, const PictureSource&) = default;
};

/// Immutable. Strands are met where their skeleton is near, curled ones where their drawn curve is; what is measured
/// along them is measured along the skeleton by under() and passed(), along the curve by the others. Answers come by
/// slot, and are the same for any number of threads.
class HairPicture : public model::SeenHair, public std::enable_shared_from_this<HairPicture>
{
public:
    explicit HairPicture(PictureSource source);

    [[nodiscard]] std::vector<model::SeenStrand> under(QPointF centre, double radiusPx) const override
    {
        return passed(centre, centre, radiusPx);
    }
    [[nodiscard]] std::vector<model::SeenStrand> passed(QPointF from, QPointF to, double radiusPx) const override;
    [[nodiscard]] std::vector<model::SeenStrand> crossing(std::span<const QPointF> line,
                                                          bool throughSkin) const override;
    [[nodiscard]] std::vector<model::SeenStrand> inside(const QPolygonF& lasso, bool throughSkin) const override;
    [[nodiscard]] std::shared_ptr<const SeenHair> held() const override { return shared_from_this(); }
    [[nodiscard]] const sim::GroupFrame* hair() const override { return m_hair ? m_hair->hair : nullptr; }

    /// A positioned strand as it is drawn, px of the view: its first part that the skin does not hide.
    [[nodiscard]] QPolygonF curve(std::uint32_t slot) const;
    [[nodiscard]] const PictureSource& source() const { return m_source; }

private:
    PictureSource m_source;
    std::optional<PictureHair> m_hair; ///< None where the group has no hair in the frame.
};

} // namespace hairpaint::view
