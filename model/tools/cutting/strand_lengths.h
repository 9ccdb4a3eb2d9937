// How long a group's hairs are by its maps as they are now; the hair that is drawn may still be of before.
#pragma once

#include "model/document/document.h"
#include "sim/groom/groom.h"
#include "sim/groom/hairline.h"
#include "sim/groom/map_sampler.h"
#include "sim/groom/variation.h"

namespace hairpaint::model {

/// Immutable; any thread.
class StrandLengths
{
public:
    /// Where hair thins out at its edge some ms for 100,000 hairs.
    StrandLengths(Document& document, Id group, std::shared_ptr<const sim::RootSet> roots);
    /// m, of the skeleton of a hair that is not in a braid; a baby hair's as if it were none, for that is what the map
    /// can tell.
    [[nodiscard]] float at(std::uint32_t slot) const;
    /// Whether it is a baby hair, whose length is its own: it grows no longer, whatever its map tells.
    [[nodiscard]] bool isBaby(std::uint32_t slot) const;
    /// The fraction of the length that its map gives of which that hair has `lengthM`, >= 0; chance takes more of some
    /// lengths than of others.
    [[nodiscard]] float keptFor(std::uint32_t slot, float lengthM) const;

private:
    [[nodiscard]] sim::HairVariation thinnedAt(std::uint32_t slot) const; ///< What the hairline makes of it.
    /// Length, m, before chance and the hairline shorten it.
    [[nodiscard]] float uncutAt(std::uint32_t slot) const;

    std::shared_ptr<const sim::RootSet> m_roots;
    sim::Hairline m_hairline;
    sim::GroupSettings m_settings;
    sim::MapRaster m_length, m_curl, m_curlSize;
    sim::MapSampler m_lengths, m_curls, m_curlSizes;
};

} // namespace hairpaint::model
