// The hair that the 3D area shows, as tools ask for it.
#pragma once

#include "sim/motion/strand_frame.h"

#include <QPointF>
#include <QPolygonF>

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace hairpaint::model {

/// A strand of the picture that a question met.
struct SeenStrand
{
    glm::vec2 rootUv{0.0F};
    glm::vec3 rootHd{0.0F};
    glm::vec3 positionHd{0.0F}; ///< Point of the strand that was met.
    float alongM = 0.0F;        ///< Distance of that point from the root along the drawn hair.
    float lengthM = 0.0F;       ///< Length of the drawn hair.
    float fraction = 0.0F;      ///< Fraction of the skeleton, 0..1, at that point.
    float firstFraction = 0.0F; ///< The fraction where the brush meets it nearest to its root; for brushes alone.
    float apart = 0.0F;         ///< Distance from the brush's middle, in units of its radius, 0..1.
    std::uint32_t slot = 0;     ///< Slot in the target's group.
};

/// What tools ask of the picture in the 3D area: strands that are seen, not hidden by skin (nor, for under() and
/// passed(), by other hair). Positions in px of the view. GUI thread.
class SeenHair
{
public:
    virtual ~SeenHair() = default;
    [[nodiscard]] virtual std::vector<SeenStrand> under(QPointF centre, double radiusPx) const = 0;
    /// The same for a disc that goes along a line.
    [[nodiscard]] virtual std::vector<SeenStrand> passed(QPointF from, QPointF to, double radiusPx) const = 0;
    /// The first point from its root where each strand crosses `line`. `throughSkin`: also strands that skin hides.
    [[nodiscard]] virtual std::vector<SeenStrand> crossing(std::span<const QPointF> line, bool throughSkin) const = 0;
    /// The first point from its root where each strand is inside `lasso`.
    [[nodiscard]] virtual std::vector<SeenStrand> inside(const QPolygonF& lasso, bool throughSkin) const = 0;
    /// The picture as it is now, whatever the hair does from here on.
    [[nodiscard]] virtual std::shared_ptr<const SeenHair> held() const = 0;
    /// The hair of the picture; null where there is none.
    [[nodiscard]] virtual const sim::GroupFrame* hair() const = 0;
};

} // namespace hairpaint::model
