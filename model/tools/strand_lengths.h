// How long a group's hairs are by its maps as they are now; the hair that is drawn may still be of before.
#pragma once

#include "model/document/document.h"
#include "sim/groom/groom.h"
#include "sim/groom/map_sampler.h"

namespace hairpaint::model {

/// Immutable; any thread.
class StrandLengths
{
public:
    StrandLengths(Document& document, Id group);
    /// m, of the skeleton of a hair that is not in a braid.
    [[nodiscard]] float at(const sim::RootSet& roots, std::uint32_t slot) const;

private:
    sim::GroupSettings m_settings;
    sim::MapRaster m_length, m_curl, m_curlSize;
    sim::MapSampler m_lengths, m_curls, m_curlSizes;
};

} // namespace hairpaint::model
