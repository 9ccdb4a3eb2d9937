// A length map's texels, moved until it reads as wanted at many roots.
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace hairpaint::model {

/// The four texels that the map is interpolated from at a root. Values are 0..65535, as floats.
struct LengthRead
{
    std::array<float*, 4> texels{};
    std::array<std::uint16_t*, 4> masks{}; ///< 0: the texel may not change.
    std::array<float, 4> weights{};
    std::array<float, 4> least{}, most{}; ///< Range of each texel's value.
    float wanted = 0.0F;

    [[nodiscard]] float value() const;
    /// Changes value() by `by`, with the least change of the texels, as far as they may change.
    void move(float by);
};

/// S. Kaczmarz, Angenaeherte Aufloesung von Systemen linearer Gleichungen, 1937: each root in turn moves the texels
/// that it is read from by the least that gives what it should read. `perM`: a texel's value per metre of length.
void bringToWanted(std::span<LengthRead> reads, float perM);
/// Tells whether something is longer than wanted; all texels of what is longer by 5 mm may change from here on.
[[nodiscard]] bool releaseTooLong(std::span<LengthRead> reads, float perM);
/// Shortens what is longer than wanted, as far as `beside`, reads that should stay as they are, change by no more than
/// a millimetre.
void shortenTooLong(std::span<LengthRead> reads, std::span<LengthRead> beside, float perM);

} // namespace hairpaint::model
