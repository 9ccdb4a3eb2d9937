// Sweeps over all roots, a few times.
#include "model/tools/cutting/length_reads.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hairpaint::model {

namespace {

constexpr int kSweeps = 16;
constexpr int kSparingSweeps = 24;
constexpr float kErrorM = 1e-4F;    ///< Sweeps end once the greatest error of a hair's length is below this.
constexpr float kTooLongM = 1e-3F;  ///< Excess below which a hair counts as short enough.
constexpr float kReleasedM = 5e-3F; ///< Excess above which uncut hairs beside a hair may become shorter, too.
constexpr float kOffM = 1e-3F;      ///< Error that uncut hairs may have.
constexpr int kLastSweeps = 200;    ///< Uncut hairs have the last word; a few sweeps are enough.
/// Least sum of squared weights of a read's texels that may change; below it, the read is left alone.
constexpr float kLeastSquares = 1e-3F;

/// Shortens what is too long; returns the greatest excess before.
float shorten(std::span<LengthRead> reads, float perM)
{
    float worst = 0.0F;
    for (LengthRead& read : reads) {
        const float excess = read.value() - read.wanted;
        worst = std::max(worst, excess);
        if (excess > kTooLongM * perM)
            read.move(-excess);
    }
    return worst;
}

/// Brings back what is off by more than uncut hair may be; returns the greatest error before.
float restore(std::span<LengthRead> beside, float perM)
{
    float worst = 0.0F;
    for (LengthRead& read : beside) {
        const float off = read.wanted - read.value();
        worst = std::max(worst, std::abs(off));
        if (std::abs(off) > kOffM * perM)
            read.move(off);
    }
    return worst;
}

} // namespace

float LengthRead::value() const
{
    float sum = 0.0F;
    for (std::size_t k = 0; k < 4; ++k)
        sum += weights[k] * *texels[k];
    return sum;
}

void LengthRead::move(float by)
{
    float squares = 0.0F;
    for (std::size_t k = 0; k < 4; ++k)
        squares += *masks[k] != 0 ? weights[k] * weights[k] : 0.0F;
    if (squares < kLeastSquares)
        return;
    for (std::size_t k = 0; k < 4; ++k)
        if (*masks[k] != 0)
            *texels[k] = std::clamp(*texels[k] + by * weights[k] / squares, least[k], most[k]);
}

void bringToWanted(std::span<LengthRead> reads, float perM)
{
    float worst = std::numeric_limits<float>::max();
    for (int sweep = 0; sweep < kSweeps && worst > kErrorM * perM; ++sweep) {
        worst = 0.0F;
        for (LengthRead& read : reads) {
            const float error = read.wanted - read.value();
            worst = std::max(worst, std::abs(error));
            read.move(error);
        }
    }
}

bool releaseTooLong(std::span<LengthRead> reads, float perM)
{
    float worst = 0.0F;
    for (const LengthRead& read : reads) {
        const float excess = read.value() - read.wanted;
        worst = std::max(worst, excess);
        if (excess > kReleasedM * perM)
            for (std::uint16_t* mask : read.masks)
                *mask = 65535;
    }
    return worst > kTooLongM * perM;
}

void shortenTooLong(std::span<LengthRead> reads, std::span<LengthRead> beside, float perM)
{
    for (int sweep = 0; sweep < kSparingSweeps; ++sweep) {
        restore(beside, perM);
        if (shorten(reads, perM) <= kTooLongM * perM)
            break;
    }
    for (int sweep = 0; sweep < kLastSweeps && restore(beside, perM) > kOffM * perM; ++sweep)
        ;
}

} // namespace hairpaint::model
