// How a layer's value and the one below it make one: a row a mode.
#pragma once

#include <QString>

#include <cstddef>
#include <cstdint>
#include <span>

namespace hairpaint::model {

enum class BlendMode : std::uint8_t
{
    Normal,
    Multiply,
    Screen,
    Darken,
    Lighten,
    Add,
    Subtract,
    Difference,
    Overlay,
    SoftLight,
    HardLight
};
inline constexpr std::size_t kBlendModeCount = 11;

struct BlendRule
{
    BlendMode mode;
    const char* id;    ///< In files.
    const char* title; ///< To be translated in context "BlendMode".
    /// One channel, of 65535.
    std::uint16_t (*formula)(std::uint16_t below, std::uint16_t value);
    /// Over runs of texels of one value channel, and of three: map = lerp16(map, formula(map, layer), coverage *
    /// opacity). The first texel of the layer is used for all where `layerStep` is 0.
    using Run = void (*)(const std::uint16_t* layer, std::size_t layerStep, std::uint16_t opacity, std::uint16_t* map,
                         std::size_t count);
    Run ofOne;
    Run ofThree;

    [[nodiscard]] QString titleText() const; ///< Translated.
};

[[nodiscard]] std::span<const BlendRule> blendRules(); ///< In the order of BlendMode.
[[nodiscard]] const BlendRule& blendRule(BlendMode mode);

} // namespace hairpaint::model
