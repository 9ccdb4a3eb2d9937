// Dabs of direction, mixed as they come.
#include "model/tools/lying/comb_field.h"

#include "sim/groom/direction_texel.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::model {

namespace {

constexpr float kYield = 0.5F; ///< How much of an earlier direction a dab replaces under its middle.
constexpr glm::vec3 kUntouched{0.0F, 0.0F, -1.0F};

} // namespace

CombField::CombField(int size) : m_size(size), m_tilesAcross(size / kTile)
{
    m_tiles.resize(static_cast<std::size_t>(m_tilesAcross) * static_cast<std::size_t>(m_tilesAcross));
}

void CombField::add(const Dab& dab, const Direction& direction)
{
    const float determinant = std::max(dab.a * dab.c - dab.b * dab.b, 1e-12F);
    const auto edge = [this](float tx) { return static_cast<int>(std::clamp(tx, 0.0F, static_cast<float>(m_size))); };
    const float halfWidth = std::sqrt(dab.c / determinant);
    const float halfHeight = std::sqrt(dab.a / determinant);
    const int right = edge(std::ceil(dab.xTx + halfWidth));
    const int bottom = edge(std::ceil(dab.yTx + halfHeight));
    for (int y = edge(std::floor(dab.yTx - halfHeight)); y < bottom; ++y)
        for (int x = edge(std::floor(dab.xTx - halfWidth)); x < right; ++x) {
            const float dx = static_cast<float>(x) + 0.5F - dab.xTx;
            const float dy = static_cast<float>(y) + 0.5F - dab.yTx;
            const float q = dab.a * dx * dx + 2.0F * dab.b * dx * dy + dab.c * dy * dy;
            if (q >= 1.0F)
                continue;
            const std::optional<glm::vec2> laid = direction(x, y);
            if (!laid)
                continue;
            std::vector<glm::vec3>& tile =
                m_tiles[static_cast<std::size_t>(y / kTile) * static_cast<std::size_t>(m_tilesAcross) +
                        static_cast<std::size_t>(x / kTile)];
            if (tile.empty())
                tile.assign(sim::kTileTexels, kUntouched);
            glm::vec3& texel = tile[static_cast<std::size_t>(y % kTile) * kTile + static_cast<std::size_t>(x % kTile)];
            const float length = glm::length(*laid);
            const glm::vec2 direction = length > 0.0F ? *laid / length : glm::vec2(0.0F);
            if (texel.z < 0.0F) {
                texel = {direction, length};
                continue;
            }
            const float part = kYield * (1.0F - q) * dab.strength;
            const glm::vec2 mixed = glm::vec2(texel) + (direction - glm::vec2(texel)) * part;
            const float mixedLength = glm::length(mixed);
            texel = {mixedLength > 1e-3F ? mixed / mixedLength : direction, texel.z + (length - texel.z) * part};
        }
}

std::vector<std::uint16_t> CombField::values(int tileIndex) const
{
    const std::vector<glm::vec3>& tile = m_tiles[static_cast<std::size_t>(tileIndex)];
    std::vector<std::uint16_t> values(sim::kTileTexels * 2);
    for (std::size_t i = 0; i < sim::kTileTexels; ++i) {
        const glm::vec3 texel = tile.empty() ? kUntouched : tile[i];
        const sim::Texel stored = sim::texelOfDirection(glm::vec2(texel) * std::max(texel.z, 0.0F));
        std::copy_n(stored.begin(), 2, values.begin() + static_cast<std::ptrdiff_t>(2 * i));
    }
    return values;
}

} // namespace hairpaint::model
