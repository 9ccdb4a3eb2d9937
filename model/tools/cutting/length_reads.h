// A length map's texels, moved until it reads as wanted at many roots.
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace hairpaint::model {

/// What the map is read from at a root. Values are a texel's, 0..65535, as floats.
struct LengthRead
{
    std::array<float*, 4> texels{};
    std::array<std::uint16_t*, 4> masks{}; ///< 0: the texel may not change.
    std::array<float, 4> weights{};
    std::array<float, 4> least{}, most{}; ///< Of a texel's value.
    float wanted = 0.0F;

    [[nodiscard]] float value() const;
    /// By the least that takes the value there, as far as the texels may change.
    void move(float by);
};

/// S. Kaczmarz, Angenaeherte Aufloesung von Systemen linearer Gleichungen, 1937: each root in turn moves the texels
/// that it is read from by the least that gives what it should read. `perM`: of a texel's value.
void bringToWanted(std::span<LengthRead> reads, float perM);
/// Shortens what is longer than wanted once, and tells whether there is such; all texels of what is longer by 5 mm may
/// change from here on.
[[nodiscard]] bool releaseTooLong(std::span<LengthRead> reads, float perM);
/// Shortens what is longer than wanted. `beside`: reads that should stay as they are; they change only as far as
/// nothing else helps.
void shortenTooLong(std::span<LengthRead> reads, std::span<LengthRead> beside, float perM);

} // namespace hairpaint::model
