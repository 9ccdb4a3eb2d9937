// The strands that a brush meets in the 3D area's picture, as small dabs at their roots.
#pragma once

#include "model/tools/strokes/seen_hair.h"
#include "model/tools/strokes/stroke_buffer.h"
#include "model/tools/tool.h"

#include <optional>
#include <vector>

namespace hairpaint::model {

/// A strand's root, and its twin on the other side of the head where the stroke is mirrored; on built-in heads the
/// twin's root only where it is asked for.
struct RootDab
{
    Dab dab;
    sim::SurfacePoint root;
    glm::vec3 seenHd{0.0F}; ///< Where the brush met the strand.
    float fraction = 0.0F; ///< Fraction of its length, 0..1, nearest to its root at which the stroke has met it so far.
    std::optional<Dab> twin = {};
    std::optional<sim::SurfacePoint> twinRoot = {};
};

/// Follows a stroke from event to event. A dab is about as wide as the roots stand apart there, so that nothing is left
/// out between the roots of neighbours that are met, and little is painted of neighbours that are not; its strength
/// falls off as the brush's does, by how far from the pointer the strand is seen.
class RootDabs
{
public:
    RootDabs(const ToolContext& context, int mapSize);

    struct Shape
    {
        float sizeM = 0.03F; ///< The brush's diameter at the hair's distance from the camera.
        float hardness = 1.0F;
        float strength = 1.0F;
        bool twinRoots = false;
        bool fractions = false; ///< Whether strands are given again when they are met nearer to their root.
    };
    /// Dabs of the strands that the brush met since the last event; `onlyStronger`: without those that it met as
    /// strongly before.
    [[nodiscard]] std::vector<RootDab> moveTo(const OverHair& hair, const ToolContext& context, const Shape& shape,
                                              bool onlyStronger);
    /// Stands at the event without giving dabs.
    void standAt(const OverHair& hair) { m_last = hair.position; }
    /// The next event starts anew.
    void lift() { m_last.reset(); }

private:
    [[nodiscard]] float spacingM(glm::vec2 uv, float detail) const;

    int m_mapSize;
    float m_spacingM = 0.001F; ///< Mean spacing of the group's candidates.
    std::shared_ptr<const sim::TiledRaster> m_density;
    std::optional<QPointF> m_last;
    std::vector<float> m_strengths; ///< By slot: the greatest strength so far.
    std::vector<float> m_fractions; ///< By slot: the least fraction so far; empty until Shape::fractions asks for it.
};

} // namespace hairpaint::model
