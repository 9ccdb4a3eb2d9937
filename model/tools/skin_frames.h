// The frames of a head's skin, by the places of its layout.
#pragma once

#include "sim/skin/skin_frame.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace hairpaint::model {

/// A table of 512 places a side, filled a tile at a time as they are asked for, so that the first stroke on a head
/// waits for nothing. One thread at a time.
class SkinFrames
{
public:
    explicit SkinFrames(std::shared_ptr<const sim::Skin> skin);

    /// Between the table's places; none where there is no skin near.
    [[nodiscard]] std::optional<sim::SkinFrame> at(glm::vec2 uv);
    [[nodiscard]] bool isOf(const std::shared_ptr<const sim::Skin>& skin) const { return m_skin == skin; }

private:
    static constexpr int kSize = 512;
    static constexpr int kTileSide = 32;
    static constexpr int kTilesAcross = kSize / kTileSide;
    using Frames = std::vector<std::optional<sim::SkinFrame>>; ///< [kTileSide][kTileSide], row 0 at v = 1.

    [[nodiscard]] const std::optional<sim::SkinFrame>& entry(int x, int y);

    std::shared_ptr<const sim::Skin> m_skin;
    std::array<Frames, std::size_t{kTilesAcross} * kTilesAcross> m_tiles; ///< Empty: not asked for yet.
};

} // namespace hairpaint::model
