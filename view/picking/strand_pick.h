// The hair that the 3D area shows now, for tools.
#pragma once

#include "view/picking/hair_picture.h"

#include <functional>
#include <optional>
#include <vector>

namespace hairpaint::view {

/// Makes a picture of what `source` tells when it is asked, and keeps it until that differs. GUI thread.
class StrandPick : public model::SeenHair
{
public:
    explicit StrandPick(std::function<PictureSource()> source) : m_source(std::move(source)) {}

    [[nodiscard]] std::vector<model::SeenStrand> under(QPointF centre, double radiusPx) const override;
    [[nodiscard]] std::vector<model::SeenStrand> passed(QPointF from, QPointF to, double radiusPx) const override
    {
        return picture().passed(from, to, radiusPx);
    }
    [[nodiscard]] std::vector<model::SeenStrand> crossing(std::span<const QPointF> line,
                                                          bool throughSkin) const override
    {
        return picture().crossing(line, throughSkin);
    }
    [[nodiscard]] std::vector<model::SeenStrand> inside(const QPolygonF& lasso, bool throughSkin) const override
    {
        return picture().inside(lasso, throughSkin);
    }
    [[nodiscard]] std::shared_ptr<const SeenHair> held() const override { return picture().held(); }
    [[nodiscard]] const sim::GroupFrame* hair() const override { return picture().hair(); }
    [[nodiscard]] const HairPicture& picture() const;

private:
    std::function<PictureSource()> m_source;
    mutable std::shared_ptr<const HairPicture> m_picture;
    struct Disc
    {
        QPointF centre;
        double radiusPx = 0.0;
        std::vector<model::SeenStrand> strands;
    };
    mutable std::optional<Disc> m_disc; ///< Last asked for of that picture: a move of the pointer asks twice.
};

} // namespace hairpaint::view
