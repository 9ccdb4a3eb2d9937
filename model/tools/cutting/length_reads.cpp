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
constexpr float kOffM = 1e-3F; ///< Error that uncut hairs may have freely; a greater one only where nothing else helps.
/// Least sum of squared weights of a read's texels that may change; below it, the read is left alone.
constexpr float kLeastSquares = 1e-3F;

/// Shortens what is too long; returns the greatest excess before.
float shorten(std::span<LengthRead> reads, float perM)
{
    float worst = 0.0F;
    for (LengthRead& read : reads) {
        const float excess = read.value() - read.wanted;
        worst = std::max(worst, excess);
        if (excess > kReleasedM * perM)
            for (std::uint16_t* mask : read.masks)
                *mask = 65535;
        if (excess > kTooLongM * perM)
            read.move(-excess);
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
    return shorten(reads, perM) > kTooLongM * perM;
}

void shortenTooLong(std::span<LengthRead> reads, std::span<LengthRead> beside, float perM)
{
    float worst = std::numeric_limits<float>::max();
    for (int sweep = 0; sweep < kSparingSweeps && !beside.empty(); ++sweep) {
        for (LengthRead& read : beside)
            if (const float off = read.wanted - read.value(); std::abs(off) > kOffM * perM)
                read.move(off);
        worst = shorten(reads, perM);
    }
    for (int sweep = 0; sweep < kSweeps && worst > kTooLongM * perM; ++sweep)
        worst = shorten(reads, perM);
}

} // namespace hairpaint::model
