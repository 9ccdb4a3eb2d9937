// Where on a head its handles act, and by how much they change the lengths of hair there.
#pragma once

#include "model/project/project.h"
#include "model/tools/strokes/skin_frames.h"

#include <optional>
#include <vector>

namespace hairpaint::model {

/// Regions of a head by its landmarks; distances scale with the head. Hd, m. Immutable.
class HandleRegions
{
public:
    explicit HandleRegions(const sim::HeadLandmarks& landmarks);

    /// 0..1: how much a root belongs to the fringe: from the middle of the hairline some 5 cm back and to both sides.
    [[nodiscard]] float fringe(glm::vec3 rootHd) const;
    /// 0..1: how much a root's height counts in a fade: 1 at the sides and the back, 0 at the forehead and on top.
    [[nodiscard]] float faded(glm::vec3 rootHd) const;
    /// The angle of a root around the head's axis: 0 in front, pi / 2 at either side, pi at the back.
    [[nodiscard]] float angle(glm::vec3 rootHd) const;
    /// A ray outward from the axis around which angles are measured.
    [[nodiscard]] sim::RayHd rayAt(float angle, float heightM) const;
    /// Points of the skin over which a parting goes, from the face back; `side`: -1 at the head's right .. 1 at its
    /// left.
    [[nodiscard]] std::vector<sim::SurfacePoint> partLine(const sim::Skin& skin, float side) const;

    [[nodiscard]] float topM() const { return m_landmarks[sim::HeadLandmark::Crown].y; }
    [[nodiscard]] float napeM() const { return m_landmarks[sim::HeadLandmark::Nape].y; }
    [[nodiscard]] glm::vec3 hairlineHd() const { return m_landmarks[sim::HeadLandmark::Hairline]; }
    /// 1 for a head as wide as bust-1.
    [[nodiscard]] float scale() const { return m_scale; }

private:
    sim::HeadLandmarks m_landmarks;
    float m_scale;
    glm::vec3 m_axisHd; ///< A point of the axis around which angles are measured, at the height of the ears.
};

/// The lengths of hair around the head, by angle and height. Immutable.
class FadeColumns
{
public:
    /// `length`: the resolved length map, one channel.
    FadeColumns(const sim::Skin& skin, const HandleRegions& regions, const sim::TiledRaster& length);
    /// The length at that angle and height, 0..1 of the map's range.
    [[nodiscard]] float at(float angle, float heightM) const;

private:
    float m_lowestM, m_stepM;
    int m_rows;
    std::vector<float> m_values; ///< [kColumns][rows], each column from its lowest row; 0..1 of the map's range.
};

/// By what factor hair is longer, at samples of the layout.
class LengthFactors
{
public:
    LengthFactors() : m_factors(std::size_t{SkinFrames::kSize} * SkinFrames::kSize, 1.0F) {}

    /// Multiplies by `factorAt(positionHd)` wherever there is skin, and a little past its edges. One thread.
    template<typename FactorAt>
    void multiply(SkinFrames& frames, const FactorAt& factorAt)
    {
        for (int y = 0; y < SkinFrames::kSize; ++y)
            for (int x = 0; x < SkinFrames::kSize; ++x)
                if (const std::optional<FramedPoint>& point = frames.point(x, y))
                    at(x, y) *= factorAt(point->positionHd);
    }
    void spread(SkinFrames& frames); ///< Past the edges of the skin, so that texels between samples are sound.

    /// A length map with these lengths, every layer of it; where it had unpainted skin its lowest layer covers that.
    /// Where hair grows longer than the group's greatest length, `settings` gets a greater one, up to what files hold.
    [[nodiscard]] SharedStack applied(const HairGroup& group, sim::GroupSettings& settings) const;

private:
    [[nodiscard]] float& at(int x, int y) { return m_factors[indexOf(x, y)]; }
    [[nodiscard]] static std::size_t indexOf(int x, int y)
    {
        return static_cast<std::size_t>(y) * SkinFrames::kSize + static_cast<std::size_t>(x);
    }
    /// The factor at texel (x, y) of a map with `size` texels a side.
    [[nodiscard]] float texelFactor(int x, int y, int size) const;

    std::vector<float> m_factors;
};

} // namespace hairpaint::model
