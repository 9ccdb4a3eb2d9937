// A length map's texels, moved until it reads as wanted at many roots.
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace hairpaint::model {

/// A texel that is read at one root or more. Values are 0..65535.
struct LengthTexel
{
    float value = 0.0F;
    float before = 0.0F;             ///< Its value before the cut.
    float least = 0.0F, most = 0.0F; ///< Range of its value.
    bool mayChange = false;
    bool isReadBeside = false; ///< Whether a root that is not cut reads it, too.
};

/// The four texels that the map is interpolated from at a root.
struct LengthRead
{
    std::array<LengthTexel*, 4> texels{};
    std::array<float, 4> weights{};
    float wanted = 0.0F; ///< 0..65535

    [[nodiscard]] float value() const;
    [[nodiscard]] bool isReadBeside() const;
    /// Changes value() by `by`, with the least change of the texels, as far as they may change; tells whether one did.
    bool move(float by);
};

/// S. Kaczmarz, Angenaeherte Aufloesung von Systemen linearer Gleichungen, 1937: each root in turn moves the texels
/// that it is read from by the least that gives what it should read. `perM`: a texel's value per metre of length.
void bringToWanted(std::span<LengthRead> reads, float perM);
/// Tells whether something is longer than wanted; all texels of what is longer by 5 mm may change from here on.
[[nodiscard]] bool releaseTooLong(std::span<LengthRead> reads, float perM);
/// Shortens what is longer than wanted, as far as `beside`, reads that should stay as they are, change by no more than
/// a millimetre. Every texel of `beside` says that it is read beside.
void shortenTooLong(std::span<LengthRead> reads, std::span<LengthRead> beside, float perM);

} // namespace hairpaint::model
