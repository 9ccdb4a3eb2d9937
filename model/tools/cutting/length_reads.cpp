// Sweeps over all roots, a few times.
#include "model/tools/cutting/length_reads.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

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

bool isTooLong(const LengthRead& read, float perM)
{
    return read.value() - read.wanted > kTooLongM * perM;
}

/// Shortens what is too long; returns whether anything was. What is short enough leaves the list, unless hair beside it
/// can make it longer again.
bool shorten(std::vector<LengthRead*>& longer, float perM)
{
    bool any = false;
    std::erase_if(longer, [&](LengthRead* read) {
        if (!isTooLong(*read, perM))
            return !read->isReadBeside();
        any = true;
        read->move(read->wanted - read->value());
        return false;
    });
    return any;
}

/// Brings back what is off by more than uncut hair may be; returns whether a texel changed.
bool restore(std::span<LengthRead> beside, float perM)
{
    bool changed = false;
    for (LengthRead& read : beside) {
        const float off = read.wanted - read.value();
        if (std::abs(off) > kOffM * perM)
            changed = read.move(off) || changed;
    }
    return changed;
}

} // namespace

float LengthRead::value() const
{
    float sum = 0.0F;
    for (std::size_t k = 0; k < 4; ++k)
        sum += weights[k] * texels[k]->value;
    return sum;
}

bool LengthRead::isReadBeside() const
{
    return std::ranges::any_of(texels, &LengthTexel::isReadBeside);
}

bool LengthRead::move(float by)
{
    float squares = 0.0F;
    for (std::size_t k = 0; k < 4; ++k)
        squares += texels[k]->mayChange ? weights[k] * weights[k] : 0.0F;
    if (squares < kLeastSquares)
        return false;
    bool changed = false;
    for (std::size_t k = 0; k < 4; ++k)
        if (LengthTexel& texel = *texels[k]; texel.mayChange) {
            const float value = std::clamp(texel.value + by * weights[k] / squares, texel.least, texel.most);
            changed = changed || value != texel.value;
            texel.value = value;
        }
    return changed;
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
            for (LengthTexel* texel : read.texels)
                texel->mayChange = true;
    }
    return worst > kTooLongM * perM;
}

void shortenTooLong(std::span<LengthRead> reads, std::span<LengthRead> beside, float perM)
{
    std::vector<LengthRead*> longer; // Texels that no hair beside reads never become more.
    for (LengthRead& read : reads)
        if (read.isReadBeside() || isTooLong(read, perM))
            longer.push_back(&read);
    for (int sweep = 0; sweep < kSparingSweeps; ++sweep) {
        restore(beside, perM);
        if (!shorten(longer, perM))
            break;
    }
    for (int sweep = 0; sweep < kLastSweeps && restore(beside, perM); ++sweep)
        ;
}

} // namespace hairpaint::model
