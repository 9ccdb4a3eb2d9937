// The formulas of the blend modes, and the loops made of them.
#include "model/project/blend_modes.h"

#include "model/values/texel_math.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>

namespace hairpaint::model {

namespace {

constexpr std::uint32_t kOne = 65535;

using Formula = std::uint16_t (*)(std::uint16_t, std::uint16_t);

constexpr std::uint16_t normal(std::uint16_t /*below*/, std::uint16_t value)
{
    return value;
}

constexpr std::uint16_t multiply(std::uint16_t below, std::uint16_t value)
{
    return mul16(below, value);
}

constexpr std::uint16_t screen(std::uint16_t below, std::uint16_t value)
{
    return static_cast<std::uint16_t>(kOne - mul16(kOne - below, kOne - value));
}

constexpr std::uint16_t darken(std::uint16_t below, std::uint16_t value)
{
    return std::min(below, value);
}

constexpr std::uint16_t lighten(std::uint16_t below, std::uint16_t value)
{
    return std::max(below, value);
}

constexpr std::uint16_t add(std::uint16_t below, std::uint16_t value)
{
    return static_cast<std::uint16_t>(std::min<std::uint32_t>(std::uint32_t{below} + value, kOne));
}

constexpr std::uint16_t subtract(std::uint16_t below, std::uint16_t value)
{
    return static_cast<std::uint16_t>(below - std::min(below, value));
}

constexpr std::uint16_t difference(std::uint16_t below, std::uint16_t value)
{
    return static_cast<std::uint16_t>(std::max(below, value) - std::min(below, value));
}

/// Multiply where the value is dark, screen where it is light.
constexpr std::uint16_t hardLight(std::uint16_t below, std::uint16_t value)
{
    if (value < kHalfCoverage)
        return mul16(below, 2U * value);
    return screen(below, static_cast<std::uint16_t>(2U * value - kOne));
}

constexpr std::uint16_t overlay(std::uint16_t below, std::uint16_t value)
{
    return hardLight(value, below);
}

/// W3C Compositing and Blending Level 1, 2015, "soft-light".
std::uint16_t softLight(std::uint16_t below, std::uint16_t value)
{
    const float b = static_cast<float>(below) / kOne;
    const float v = static_cast<float>(value) / kOne;
    if (v <= 0.5F)
        return unit16(b - (1.0F - 2.0F * v) * b * (1.0F - b));
    const float lit = b <= 0.25F ? ((16.0F * b - 12.0F) * b + 4.0F) * b : std::sqrt(b);
    return unit16(b + (2.0F * v - 1.0F) * (lit - b));
}

template<int channels, Formula formula>
void blendRun(const std::uint16_t* layer, std::size_t layerStep, std::uint16_t opacity, std::uint16_t* map,
              std::size_t count)
{
    for (std::size_t texel = 0; texel < count; ++texel) {
        const std::uint16_t* source = layer + texel * layerStep;
        std::uint16_t* target = map + texel * channels;
        const std::uint16_t fraction = mul16(source[channels], opacity);
        for (int i = 0; i < channels; ++i)
            target[i] = lerp16(target[i], formula(target[i], source[i]), fraction);
    }
}

/// Two loops: of neighbouring texels the compiler makes vector code, where it knows how far apart they lie.
template<int channels, Formula formula>
void blendEither(const std::uint16_t* layer, std::size_t layerStep, std::uint16_t opacity, std::uint16_t* map,
                 std::size_t count)
{
    if (layerStep == channels + 1)
        blendRun<channels, formula>(layer, channels + 1, opacity, map, count);
    else
        blendRun<channels, formula>(layer, layerStep, opacity, map, count);
}

template<Formula formula>
constexpr BlendRule rule(BlendMode mode, const char* id, const char* title)
{
    return {mode, id, title, formula, blendEither<1, formula>, blendEither<3, formula>};
}

constexpr std::array<BlendRule, kBlendModeCount> kRules{
    rule<normal>(BlendMode::Normal, "normal", QT_TRANSLATE_NOOP("BlendMode", "Normal")),
    rule<multiply>(BlendMode::Multiply, "multiply", QT_TRANSLATE_NOOP("BlendMode", "Multiply")),
    rule<screen>(BlendMode::Screen, "screen", QT_TRANSLATE_NOOP("BlendMode", "Screen")),
    rule<darken>(BlendMode::Darken, "darken", QT_TRANSLATE_NOOP("BlendMode", "Darken")),
    rule<lighten>(BlendMode::Lighten, "lighten", QT_TRANSLATE_NOOP("BlendMode", "Lighten")),
    rule<add>(BlendMode::Add, "add", QT_TRANSLATE_NOOP("BlendMode", "Add")),
    rule<subtract>(BlendMode::Subtract, "subtract", QT_TRANSLATE_NOOP("BlendMode", "Subtract")),
    rule<difference>(BlendMode::Difference, "difference", QT_TRANSLATE_NOOP("BlendMode", "Difference")),
    rule<overlay>(BlendMode::Overlay, "overlay", QT_TRANSLATE_NOOP("BlendMode", "Overlay")),
    rule<softLight>(BlendMode::SoftLight, "soft_light", QT_TRANSLATE_NOOP("BlendMode", "Soft light")),
    rule<hardLight>(BlendMode::HardLight, "hard_light", QT_TRANSLATE_NOOP("BlendMode", "Hard light")),
};

static_assert(
    [] {
        for (std::size_t i = 0; i < kRules.size(); ++i)
            if (static_cast<std::size_t>(kRules[i].mode) != i)
                return false;
        return true;
    }(),
    "rows stand in the order of BlendMode");

} // namespace

QString BlendRule::titleText() const
{
    return QCoreApplication::translate("BlendMode", title);
}

std::span<const BlendRule> blendRules()
{
    return kRules;
}

const BlendRule& blendRule(BlendMode mode)
{
    return kRules[static_cast<std::size_t>(mode)];
}

} // namespace hairpaint::model
