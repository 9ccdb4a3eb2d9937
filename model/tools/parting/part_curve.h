// The curve along which hair is parted.
#pragma once

#include "sim/base/tiled_raster.h"
#include "sim/skin/skin.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace hairpaint::model {

/// A smooth curve over the skin through points of it. Immutable; any thread. Hd, m.
class PartCurve
{
public:
    struct Sample
    {
        glm::vec3 positionHd{0.0F};
        glm::vec3 normalHd{0.0F};
        glm::vec3 tangentHd{0.0F}; ///< Unit, toward the curve's end.
        float alongM = 0.0F;
        glm::vec2 uv{0.0F};
        float mPerUv = 0.0F;   ///< How large a step of one in uv is on the skin there.
        std::size_t point = 0; ///< The last of the curve's points before it.

        /// Unit, along the skin, to the right of who walks along the curve on the skin.
        [[nodiscard]] glm::vec3 rightHd() const;
    };
    struct Near
    {
        std::size_t point = 0; ///< The last of the curve's points before it.
        float distanceM = 0.0F;
    };

    PartCurve() = default;
    /// Each piece between two points leaves and reaches them along the skin; what lies between is brought to the skin.
    PartCurve(const sim::Skin& skin, std::span<const sim::SurfacePoint> points);

    /// A few mm apart; none where there are fewer than two points.
    [[nodiscard]] const std::vector<Sample>& samples() const { return m_samples; }
    [[nodiscard]] bool empty() const { return m_samples.empty(); }
    [[nodiscard]] float lengthM() const { return m_samples.empty() ? 0.0F : m_samples.back().alongM; }
    [[nodiscard]] float mPerUv() const; ///< On average.
    [[nodiscard]] std::optional<Near> nearest(glm::vec3 positionHd) const;

private:
    std::vector<Sample> m_samples;
};

/// The points straight on from a curve's end (or its beginning), a few mm apart, up to the first that has no hair; none
/// where the curve does not lead toward the face, or hair goes on for more than some cm. `density`: of one channel.
[[nodiscard]] std::vector<sim::SurfacePoint> pointsToHairline(const sim::Skin& skin, const PartCurve& curve, bool atEnd,
                                                              const sim::TiledRaster& density);

/// A soft zigzag about a curve, straight at both ends.
class Zigzag
{
public:
    static constexpr float kWaveM = 0.012F; ///< About so long is one zig with its zag.

    struct Offset
    {
        float lateralM = 0.0F; ///< Signed distance to the right.
        float slope = 0.0F;    ///< Derivative of lateralM along the curve.
    };
    Zigzag(float amplitudeM, float lengthM);
    [[nodiscard]] Offset at(float alongM) const;

private:
    float m_amplitudeM;
    float m_perM;
};

} // namespace hairpaint::model
