// What the roots of hair make of the skin's colour: a shaved side is darker than the face, a parting is no white
// stripe, and skin is clean where a hairline thins out.
#pragma once

#include "sim/groom/tile_index.h"
#include "sim/motion/strand_frame.h"
#include "sim/skin/head_mesh.h"

#include <glm/glm.hpp>
#include <glm/gtc/type_precision.hpp>

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace hairpaint::rendering {

/// A group's part in the tint.
struct ScalpTintSource
{
    sim::MapRaster density;
    sim::MapRaster colour;
    float strength = 0.0F;                                                            ///< StrandMaterial::scalpTint
    float densityPerM2 = 0.0F;                                                        ///< Where the density map is 1.
    float softenM = 0.0F;                                                             ///< HairlineSettings::softenM
    friend bool operator==(const ScalpTintSource&, const ScalpTintSource&) = default; ///< Compares rasters by pointer.
};
using ScalpTintSources = std::vector<ScalpTintSource>;

/// The sources of the groups that are visible and tint the skin.
[[nodiscard]] ScalpTintSources scalpTintSources(const sim::StrandFrame* hair);

/// What of its layout a mesh covers, to 1/256 of its side. Immutable.
class LayoutCover
{
public:
    LayoutCover() = default; ///< Covers nothing.
    explicit LayoutCover(const sim::HeadMesh& mesh);
    [[nodiscard]] bool covers(glm::vec2 uv) const;

private:
    static constexpr std::size_t kSide = 256;
    [[nodiscard]] static bool isInside(glm::vec2 uv)
    {
        return uv.x >= 0.0F && uv.y >= 0.0F && uv.x < 1.0F && uv.y < 1.0F;
    }
    [[nodiscard]] static std::size_t texelAt(glm::vec2 uv)
    {
        const glm::u64vec2 texel(uv * static_cast<float>(kSide));
        return texel.y * kSide + texel.x;
    }
    std::vector<bool> m_isCovered; ///< [kSide][kSide]
};

/// The tint at each vertex of a mesh. Only vertices whose texels may differ are looked at again. One thread; uses
/// parallelFor.
class ScalpTint
{
public:
    /// Linear colour times cover, and cover: the skin's colour c becomes c (1 - w) + xyz. 65535 is 1.
    using Texel = glm::u16vec4;

    /// Returns whether any vertex's tint may differ from before.
    bool update(const std::shared_ptr<const sim::HeadMesh>& mesh, const ScalpTintSources& sources);
    /// [vertices]; empty where nothing tints the mesh.
    [[nodiscard]] std::span<const Texel> texels() const { return m_texels; }

private:
    void evaluate(std::span<const std::uint32_t> vertices);
    /// Adds the vertices that read texels that differ, for a source that reads so far around; false where all are to be
    /// evaluated.
    bool findChanged(const sim::MapRaster& before, const sim::MapRaster& after, float softenM,
                     std::vector<std::uint32_t>& vertices);

    std::shared_ptr<const sim::HeadMesh> m_mesh;
    ScalpTintSources m_sources;
    std::vector<Texel> m_texels;
    float m_uvPerM = 0.0F; ///< Of the layout, as a mean.
    std::optional<LayoutCover> m_cover;
    /// By the raster's size and how far around a vertex reads it: which vertices read which tiles.
    std::map<std::pair<int, float>, sim::TileIndex> m_indices;
};

} // namespace hairpaint::rendering
