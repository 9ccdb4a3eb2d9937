// Parts of bodies that hang from the rest.
#pragma once

#include <cstdint>

namespace hairpaint::model {

/// A part of a mesh that hangs from where it is held, and may swing: sections across its line, the first of them where
/// it is held, and behind these the vertices of its two ends.
struct HangingPart
{
    std::uint32_t first = 0; ///< Index of its first vertex.
    std::uint32_t sections = 0;
    std::uint32_t corners = 0; ///< Vertices of a section, around its line.

    [[nodiscard]] std::uint32_t vertices() const { return sections * corners + 2 * (corners + 1); }
};

} // namespace hairpaint::model
