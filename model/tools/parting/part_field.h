// What a parting makes of the skin around it.
#pragma once

#include "model/tools/parting/part_curve.h"
#include "model/tools/strokes/skin_frames.h"
#include "model/tools/strokes/stroke_buffer.h"

#include <optional>
#include <vector>

namespace hairpaint::model {

struct PartLook
{
    float reachM = 0.1F;   ///< Reach to either side; further out nothing changes.
    float flatness = 0.9F; ///< 0..1
    float gapM = 0.001F;   ///< Width without hair; 0 for none.
    float zigzagM = 0.0F;  ///< How far the parting leaves its curve.
    /// Length at the curve's beginning where hair falls to both sides, straight and without a gap.
    float leadInM = 0.0F;
    float leadOutM = 0.0F; ///< The same at the curve's end.
};

/// The curve through these points, extended over the hair in front of its ends; sets the lead lengths of `look`. A
/// part that begins behind the hairline would let the hair in front of it fall over the face. `density`: one channel.
[[nodiscard]] PartCurve ledToHairline(const sim::Skin& skin, const std::vector<sim::SurfacePoint>& points,
                                      const sim::TiledRaster& density, PartLook& look);

/// Where texels of the layout lie from a curve, and what a map's tiles become there. Computed between the samples of
/// SkinFrames near the curve, with work in proportion to them. One thread makes it; any number read it.
class PartField
{
public:
    PartField(SkinFrames& frames, PartCurve curve, const PartLook& look);

    /// The tiles of a map of `size` in which hair may be laid, or a gap may lie, in ascending order.
    [[nodiscard]] std::vector<int> laidTiles(int size) const { return tilesWithin(m_look.reachM, size); }
    [[nodiscard]] std::vector<int> gapTiles(int size) const;

    struct LaidTile
    {
        StrokeBuffer::MaskTile mask{};
        std::vector<std::uint16_t> values; ///< [64][64][2], as a direction layer holds them.
    };
    /// Hair laid to both sides, strongest near the curve.
    [[nodiscard]] LaidTile laid(int tileIndex, int size) const;
    /// Where hair is taken away: a soft line of at least about a texel.
    [[nodiscard]] StrokeBuffer::MaskTile gap(int tileIndex, int size) const;

private:
    struct Sample
    {
        glm::vec3 positionHd{0.0F};
        glm::vec2 right{0.0F}; ///< Unit, in the frame of that point of the skin: away from the curve on its right side.
        glm::vec2 shared{0.0F}; ///< Direction that hair of both sides goes in besides, in the same frame.
        sim::SkinFrame frame;
        float lateralM = 0.0F; ///< Distance from the curve, positive to its right.
        float alongM = 0.0F;
        float beyondM = 0.0F; ///< Distance past either end; 0 beside the curve.
    };
    static constexpr int kStride = 2; ///< Every other sample of SkinFrames is enough.
    static constexpr int kTileSide = SkinFrames::kTileSide / kStride;
    static constexpr int kSize = SkinFrames::kSize / kStride;
    static constexpr int kTilesAcross = SkinFrames::kTilesAcross;
    struct Tile
    {
        std::vector<std::optional<Sample>> samples; ///< [kTileSide][kTileSide]; none where nothing is in reach.
        float nearestM = 0.0F;                      ///< Least distance of its samples from the curve.
    };

    [[nodiscard]] std::vector<int> tilesNear(const sim::HeadMesh& mesh) const;
    [[nodiscard]] std::optional<Sample> sampleOf(const FramedPoint& skin) const;
    void fill(Tile& tile, int index, SkinFrames& frames) const;
    [[nodiscard]] std::vector<int> tilesWithin(float distanceM, int size) const;
    [[nodiscard]] float halfGapM(int size) const;
    [[nodiscard]] Zigzag::Offset zigzagAt(float alongM) const;
    [[nodiscard]] float partedM() const { return m_curve.lengthM() - m_look.leadInM - m_look.leadOutM; }
    [[nodiscard]] float endFadeM() const; ///< Distance past its ends over which the parting fades.
    [[nodiscard]] const Sample* entry(int x, int y) const;
    [[nodiscard]] std::optional<Sample> at(glm::vec2 uv) const;
    /// Calls `visit(texel, sample)` for a tile's texels that lie near the curve.
    template<typename Visit>
    void forTexels(int tileIndex, int size, const Visit& visit) const;

    PartLook m_look;
    PartCurve m_curve;
    Zigzag m_zigzag;
    glm::vec3 m_lowHd{0.0F}, m_highHd{0.0F}; ///< Corners of a box around all that is in reach.
    std::vector<Tile> m_tiles;               ///< [kTilesAcross][kTilesAcross], or none.
};

} // namespace hairpaint::model
