// The directions that a running comb stroke leaves.
#pragma once

#include "model/tools/strokes/stroke_buffer.h"

#include <glm/glm.hpp>

#include <functional>
#include <optional>
#include <vector>

namespace hairpaint::model {

/// For each texel that a dab reached, the direction in which the stroke laid its hair: later dabs, stronger ones and
/// those nearer to it count for more, so that neither a bend nor a turning back leaves an edge. The masks are a
/// StrokeBuffer's.
class CombField
{
public:
    explicit CombField(int size);

    /// The direction that a dab gives a texel, in the texel's frame; where none, the texel keeps its own.
    using Direction = std::function<std::optional<glm::vec2>(int x, int y)>;
    void add(const Dab& dab, const Direction& direction);
    /// [64][64][2] as a direction layer holds them; zero vectors where no dab was.
    [[nodiscard]] std::vector<std::uint16_t> values(int tileIndex) const;

private:
    int m_size;
    int m_tilesAcross;
    std::vector<std::vector<glm::vec3>> m_tiles; ///< Unit direction and length; a length below 0: no dab yet.
};

} // namespace hairpaint::model
