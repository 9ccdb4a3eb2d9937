// What one hair looks like, from its rank and the maps' values at its root.
#pragma once

#include "sim/groom/groom.h"
#include "sim/groom/lay.h"
#include "sim/groom/map_sampler.h"
#include "sim/groom/variation.h"

namespace hairpaint::sim {

/// Values of the maps that tell a hair's shape, at one root.
struct RootValues
{
    float length = 0.0F;
    float curl = 0.0F;
    float curlSize = 0.0F; ///< 0..1; 0 where there is no curl.
};
[[nodiscard]] RootValues valuesAt(const MapSamplers& maps, glm::vec2 uv);

/// What a hair has from chance, always the same for a rank.
struct RootChance
{
    float phase = 0.0F;      ///< rad
    float variation = 0.0F;  ///< -1..1
    float coatHeight = 0.0F; ///< 0..1
};
[[nodiscard]] RootChance chanceOf(std::uint64_t seed, std::uint32_t rank);

/// The same of a braided hair: where in its braid it is.
struct WispChance
{
    std::uint32_t wisp = 0;     ///< 0..719: even over up to six wisps, and over nine
    glm::vec2 wispOffset{0.0F}; ///< In the unit disc, uniform.
};
[[nodiscard]] WispChance wispChanceOf(std::uint64_t seed, std::uint32_t rank);

[[nodiscard]] LayRoot layRootOf(const GroupSettings& settings, const RootSet& roots, std::uint32_t slot,
                                const RootChance& chance, float liftM = 0.0F);

/// Radius of a coil from the curl-size map's value, m: exactly half of the greatest where nothing is painted.
[[nodiscard]] float curlRadiusOf(const GroupSettings& settings, float value);

/// Seen length over cut length p / sqrt(p^2 + (pi D)^2) of a coil of pitch p and diameter D; 1 where lengths are as
/// seen.
[[nodiscard]] float seenOverCut(const GroupSettings& settings, float curl, float curlSize);

/// Turns by table 1 for a curl value of 0..1; `stepped` rounds to the table's levels.
[[nodiscard]] float turnsOfCurl(float value, bool stepped);

/// What equation 1 is given.
struct Coil
{
    float turns = 0.0F; ///< Over the whole hair.
    float radiusM = 0.0F;
};
/// The coil of a hair of `lengthM` from the curl and curl-size maps' values.
[[nodiscard]] Coil coilOf(const GroupSettings& settings, float curl, float curlSize, float lengthM);
/// How far above the coat a coil in real units is laid, so that it lies on the skin and not in it; 0 for others.
[[nodiscard]] float liftOf(const GroupSettings& settings, float radiusM, float lengthM);
/// By what fraction of its length a coil may stretch and shorten, so that its fibre stretches by no more than 1 %;
/// 0 where straight.
[[nodiscard]] float giveOf(const Coil& coil, float lengthM);

/// Length of a hair from the length map's value, m.
[[nodiscard]] float lengthOf(const GroupSettings& settings, float value);

/// Factor on a hair's diameter from the width map's value: exactly 1 where nothing is painted.
[[nodiscard]] float widthOf(float value);

/// What the maps say that changes how hairs look, not where they lie. What is the same for all is found once. Must not
/// outlive its arguments.
class HairLook
{
public:
    HairLook(const GroupSettings& settings, const MapSamplers& maps);
    /// The look of the hair at `uv`, whose style has its variation.
    void give(glm::vec2 uv, const HairVariation& own, StrandStyle& style) const;

private:
    /// Colours of one hair, sRGB as encoded.
    struct Colours
    {
        glm::vec3 root{0.0F};
        glm::vec3 tip{0.0F};
        float tipStart = 0.0F; ///< 0..1
    };
    [[nodiscard]] Colours coloursAt(glm::vec2 uv) const;
    void setColours(const Colours& colours, const HairVariation& own, StrandStyle& style) const;
    void setSurface(glm::vec2 uv, StrandStyle& style) const;

    const GroupSettings& m_settings;
    const MapSamplers& m_maps;
    bool m_hasColours = false; ///< m_common holds the colours of all hairs that are not grey,
    bool m_hasSurface = false; ///< m_common holds frizz, width and gloss of all hairs.
    StrandStyle m_common;
};
/// Scales a style's turns and curl radius by `variation`, which is that of the hair's lock where it curls in step.
void varyCurl(const HairVariation& variation, StrandStyle& style);
/// A hair that is not braided, its curl as the maps say, without its look; `detail` = threshold / density.
[[nodiscard]] StrandStyle styleOf(const GroupSettings& settings, const RootValues& values, const RootChance& chance,
                                  const HairVariation& own, float detail);

} // namespace hairpaint::sim
