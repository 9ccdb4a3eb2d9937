// The frames of a head's skin, by the uv of its layout.
#pragma once

#include "sim/skin/skin_frame.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace hairpaint::model {

/// A point of the skin and the frame of directions there.
struct FramedPoint
{
    sim::SkinFrame frame;
    glm::vec3 positionHd{0.0F};
};

/// A table of 512 x 512 samples, filled a tile at a time as they are asked for, so that the first stroke on a head
/// waits for nothing. One thread at a time.
class SkinFrames
{
public:
    static constexpr int kSize = 512;
    static constexpr int kTileSide = 32;
    static constexpr int kTilesAcross = kSize / kTileSide;
    static constexpr float kAlike = 0.8F; ///< Cosine between frames of neighbours of one island.

    explicit SkinFrames(std::shared_ptr<const sim::Skin> skin);

    /// Between the table's samples; none where there is no skin near.
    [[nodiscard]] std::optional<sim::SkinFrame> at(glm::vec2 uv);
    /// The table's own samples, row 0 at v = 1; none off the skin.
    [[nodiscard]] const std::optional<FramedPoint>& point(int x, int y);
    [[nodiscard]] const sim::Skin& skin() const { return *m_skin; }
    [[nodiscard]] bool isOf(const std::shared_ptr<const sim::Skin>& skin) const { return m_skin == skin; }

private:
    using Tile = std::vector<std::optional<FramedPoint>>; ///< [kTileSide][kTileSide]

    std::shared_ptr<const sim::Skin> m_skin;
    std::array<Tile, std::size_t{kTilesAcross} * kTilesAcross> m_tiles; ///< Tiles of the table; empty until asked for.
};

} // namespace hairpaint::model
