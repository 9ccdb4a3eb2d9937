// From map values to a style.
#include "sim/groom/strand_style.h"

#include "sim/base/deterministic.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace hairpaint::sim {

namespace {

constexpr std::uint64_t kChanceKey = 0x6368616E6365U; ///< Apart from the keys of other uses of the seed.

std::uint32_t byteOf(float value)
{
    // Not negative, so that the cast rounds down. NOLINTNEXTLINE(bugprone-incorrect-roundings)
    return static_cast<std::uint32_t>(std::clamp(value, 0.0F, 1.0F) * 255.0F + 0.5F);
}

/// 0xAABBGGRR.
std::uint32_t packColour(glm::vec3 encoded)
{
    return 0xFF000000U | (byteOf(encoded.z) << 16U) | (byteOf(encoded.y) << 8U) | byteOf(encoded.x);
}

std::uint16_t sixteenBits(float value)
{
    // Not negative, so that the cast rounds down. NOLINTNEXTLINE(bugprone-incorrect-roundings)
    return static_cast<std::uint16_t>(std::clamp(value, 0.0F, 1.0F) * 65535.0F + 0.5F);
}

/// Uniform over the unit disc, by rejection from the square.
glm::vec2 pointInDisc(std::uint64_t hash)
{
    constexpr int kTries = 8; // All fail once in 226,000.
    glm::vec2 point(0.0F);
    for (int i = 0; i < kTries; ++i) {
        point = glm::vec2(unitFloat(hash), unitFloat(hash << 32U)) * 2.0F - 1.0F;
        if (glm::dot(point, point) <= 1.0F)
            return point;
        hash = hash64(hash, 1);
    }
    return point * 0.5F;
}

} // namespace

float turnsOfCurl(float value, bool stepped)
{
    // Table 1: 1024, 512, 256, 64 and 32 samples are 16, 8, 4, 1 and 1/2 turns; 0 is straight.
    constexpr std::array<float, 6> kTurns{0.0F, 0.5F, 1.0F, 4.0F, 8.0F, 16.0F};
    const float level = std::clamp(value, 0.0F, 1.0F) * 5.0F;
    if (stepped)
        return kTurns[static_cast<std::size_t>(std::floor(level + 0.5F))];
    const auto below = static_cast<std::size_t>(std::min(level, 4.0F));
    return kTurns[below] + (level - static_cast<float>(below)) * (kTurns[below + 1] - kTurns[below]);
}

RootChance chanceOf(std::uint64_t seed, std::uint32_t rank)
{
    const std::uint64_t first = hash64(seed ^ kChanceKey, std::uint64_t{rank} * 2);
    constexpr float kPerSixteenBits = 1.0F / 65536.0F;
    RootChance chance;
    chance.phase = unitFloat(first) * glm::two_pi<float>();
    chance.variation = static_cast<float>(first & 0xFFFFU) * (2.0F * kPerSixteenBits) - 1.0F;
    chance.coatHeight = static_cast<float>((first >> 16U) & 0xFFFFU) * kPerSixteenBits;
    return chance;
}

WispChance wispChanceOf(std::uint64_t seed, std::uint32_t rank)
{
    const std::uint64_t hash = hash64(seed ^ kChanceKey, std::uint64_t{rank} * 2 + 1);
    return {.wisp = static_cast<std::uint32_t>(hash & 0xFFFFU) % 720, .wispOffset = pointInDisc(hash)};
}

LayRoot layRootOf(const GroupSettings& settings, const RootSet& roots, std::uint32_t slot, const RootChance& chance,
                  float liftM)
{
    const glm::vec3 positionHd = roots.positionHd[slot];
    const SkinFrame frame = roots.frame(slot);
    return {.positionHd = positionHd,
            .frame = frame,
            .uv = roots.uv[slot],
            .chance = chance.coatHeight,
            .strayHd = settings.variation.parting > 0.0F
                           ? strayOf(settings.variation, roots.seed, roots.rankOfSlot[slot], positionHd, frame)
                           : glm::vec3(0.0F),
            .liftM = liftM};
}

RootValues valuesAt(const MapSamplers& maps, glm::vec2 uv)
{
    const float curl = maps[MapSlot::Curl].scalar(uv);
    return {.length = maps[MapSlot::Length].scalar(uv),
            .curl = curl,
            .curlSize = curl > 0.0F ? maps[MapSlot::CurlSize].scalar(uv) : 0.0F};
}

float widthOf(float value)
{
    constexpr float kDiffers = 0.7F;
    constexpr float kHalfTexel = static_cast<float>(ruleOf(MapSlot::Width).defaultValue[0]) / 65535.0F;
    return 1.0F +
           kDiffers * (value <= kHalfTexel ? value / kHalfTexel - 1.0F : (value - kHalfTexel) / (1.0F - kHalfTexel));
}

HairLook::HairLook(const GroupSettings& settings, const MapSamplers& maps)
    : m_settings(settings), m_maps(maps),
      m_hasColours(maps[MapSlot::Colour].isUniform() && maps[MapSlot::TipColour].isUniform() &&
                   maps[MapSlot::TipStart].isUniform()),
      m_hasSurface(maps[MapSlot::Frizz].isUniform() && maps[MapSlot::Width].isUniform() &&
                   maps[MapSlot::Gloss].isUniform())
{
    constexpr glm::vec2 kAnywhere(0.5F);
    if (m_hasColours)
        setColours(coloursAt(kAnywhere), {}, m_common);
    if (m_hasSurface)
        setSurface(kAnywhere, m_common);
}

void HairLook::give(glm::vec2 uv, const HairVariation& own, StrandStyle& style) const
{
    if (m_hasSurface) {
        style.frizzM = m_common.frizzM;
        style.width = m_common.width;
        style.gloss = m_common.gloss;
    } else {
        setSurface(uv, style);
    }
    style.width *= own.width;
    if (m_hasColours && !own.isGrey) {
        style.rootColour = m_common.rootColour;
        style.tipColour = m_common.tipColour;
        style.tipStart = m_common.tipStart;
    } else {
        setColours(coloursAt(uv), own, style);
    }
}

HairLook::Colours HairLook::coloursAt(glm::vec2 uv) const
{
    const MapSampler& colour = m_maps[MapSlot::Colour];
    const MapSampler& tip = m_maps[MapSlot::TipColour];
    const glm::vec3 root(colour.channels(uv));
    return {.root = root,
            .tip = tip.sameAs(colour) ? root : glm::vec3(tip.channels(uv)),
            .tipStart = m_maps[MapSlot::TipStart].scalar(uv)};
}

void HairLook::setSurface(glm::vec2 uv, StrandStyle& style) const
{
    style.frizzM = m_settings.greatestFrizzM * m_maps[MapSlot::Frizz].scalar(uv);
    style.width = widthOf(m_maps[MapSlot::Width].scalar(uv));
    style.gloss = sixteenBits(m_maps[MapSlot::Gloss].scalar(uv));
}

void HairLook::setColours(const Colours& colours, const HairVariation& own, StrandStyle& style) const
{
    const auto shown = [&](glm::vec3 colour) { return own.isGrey ? greyed(colour, style.variation) : colour; };
    style.rootColour = packColour(shown(colours.root));
    style.tipColour = colours.tip == colours.root ? style.rootColour : packColour(shown(colours.tip));
    style.tipStart = style.tipColour == style.rootColour ? 0.0F : colours.tipStart;
}

void varyCurl(const HairVariation& variation, StrandStyle& style)
{
    style.turns *= variation.turns;
    style.curlRadiusM *= variation.radius;
}

float lengthOf(const GroupSettings& settings, float value)
{
    return settings.shortestLengthM + (settings.greatestLengthM - settings.shortestLengthM) * value;
}

float curlRadiusOf(const GroupSettings& settings, float value)
{
    // The default is the texel next above one half. It means one half, not a little more.
    constexpr float kHalfTexel = static_cast<float>(ruleOf(MapSlot::CurlSize).defaultValue[0]) / 65535.0F;
    const float fraction =
        value <= kHalfTexel ? 0.5F * (value / kHalfTexel) : 0.5F + 0.5F * ((value - kHalfTexel) / (1.0F - kHalfTexel));
    return (settings.turnsMode == TurnsMode::Coils ? settings.curl.diameterM : settings.greatestCurlRadiusM) * fraction;
}

float seenOverCut(const GroupSettings& settings, float curl, float curlSize)
{
    if (settings.turnsMode != TurnsMode::Coils || !settings.lengthAsCut || !(curl > 0.0F))
        return 1.0F;
    // The mean of the squared slopes of the two axes: exact for a coil, near for an S.
    const float round = 1.0F - settings.curl.flatness;
    const float windingM =
        glm::two_pi<float>() * curlRadiusOf(settings, curlSize) * std::sqrt(0.5F + 0.5F * round * round);
    const float pitchM = settings.curl.pitchM / std::min(curl, 1.0F);
    return pitchM / std::sqrt(pitchM * pitchM + windingM * windingM);
}

Coil coilOf(const GroupSettings& settings, float curl, float curlSize, float lengthM)
{
    Coil coil;
    if (settings.turnsMode == TurnsMode::Coils) {
        coil.turns = std::clamp(curl, 0.0F, 1.0F) * lengthM / std::max(settings.curl.pitchM, 1e-4F);
        // The first half turn eases in.
        coil.radiusM = curlRadiusOf(settings, curlSize) * std::min(coil.turns * 2.0F, 1.0F);
        return coil;
    }
    coil.turns = turnsOfCurl(curl, settings.steppedTurns);
    if (settings.turnsMode == TurnsMode::PerLength)
        coil.turns *= lengthM / std::max(settings.turnsPerLengthM, 1e-3F);
    // A coil is no wider than its turns are apart, and where the first half turn is not complete it eases in.
    if (coil.turns > 0.0F)
        coil.radiusM =
            std::min(curlRadiusOf(settings, curlSize), lengthM / coil.turns) * std::min(coil.turns * 2.0F, 1.0F);
    return coil;
}

float liftOf(const GroupSettings& settings, float radiusM, float lengthM)
{
    constexpr float kMostOfLength = 0.25F;
    if (settings.turnsMode != TurnsMode::Coils)
        return 0.0F;
    return std::min(radiusM * (1.0F - settings.curl.flatness), lengthM * kMostOfLength);
}

float giveOf(const Coil& coil, float lengthM)
{
    // The fibre, sqrt(length^2 + winding^2), grows by a hundredth while the turns keep their radius; a straight hair's
    // hundredth is none that is seen.
    constexpr float kFibreGrowth = 0.02F; // of its square
    constexpr float kAmongOthers = 0.1F;  // tight coils hold on to each other
    const float slope = glm::two_pi<float>() * coil.turns * coil.radiusM / std::max(lengthM, 1e-4F);
    const float free = std::sqrt(1.0F + kFibreGrowth * (1.0F + slope * slope)) - std::sqrt(1.0F + kFibreGrowth);
    return std::min(free, kAmongOthers);
}

StrandStyle styleOf(const GroupSettings& settings, const RootValues& values, const RootChance& chance,
                    const HairVariation& own, float detail)
{
    StrandStyle style;
    // What is cut off takes its turns along, so that the hairs of a lock stay in step.
    const float uncutM = lengthOf(settings, values.length) * seenOverCut(settings, values.curl, values.curlSize);
    const Coil coil = coilOf(settings, values.curl, values.curlSize, uncutM);
    style.lengthM = uncutM * own.length;
    style.turns = coil.turns * own.length;
    style.curlRadiusM = coil.radiusM;
    if (own.babyM > 0.0F) {
        constexpr float kTurns = 0.9F;
        constexpr float kRadius = 0.07F; // As a fraction of its length.
        style.lengthM = std::min(style.lengthM, own.babyM);
        style.turns = kTurns * own.turns;
        style.curlRadiusM = kRadius * style.lengthM;
    }
    style.phase = chance.phase;
    style.variation = chance.variation;
    style.detail = detail;
    return style;
}

} // namespace hairpaint::sim
