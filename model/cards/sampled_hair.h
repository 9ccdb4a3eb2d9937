// Hair with equally many samples a strand, to be compared and put together.
#pragma once

#include "model/exporting/curve_set.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace hairpaint::model {

/// The hairs of a set, or an evenly spread subset where there are very many.
struct SampledHair
{
    static constexpr std::size_t kSamples = 40; ///< A hair, root and tip included, equally far along it.
    static constexpr std::size_t kMostHairs = 120'000;

    std::vector<std::uint32_t> curve; ///< By hair: index into CurveSet::curves().
    std::vector<float> lengthM;       ///< By hair.
    std::vector<float> widthM;        ///< By hair: diameter at the root; wider where it stands for others too.
    /// [hairs][kSamples], Wo, m. The root, then means over a stretch around each sample, so that narrow curls become
    /// the axis that they run round.
    std::vector<glm::vec3> samplesWo;

    [[nodiscard]] std::size_t count() const { return curve.size(); }
    [[nodiscard]] std::span<const glm::vec3> samples(std::size_t hair) const
    {
        return std::span(samplesWo).subspan(hair * kSamples, kSamples);
    }
};

/// None where `progress` cancels. Any thread; runs on several.
[[nodiscard]] std::optional<SampledHair> sampledHair(const CurveSet& set, const Progress& progress);

} // namespace hairpaint::model
