// What fingers change in hair: the direction map and, by kind, the clump, gel, length and curl maps, in one step.
#pragma once

#include "model/tools/live_edit.h"
#include "model/tools/lying/comb_field.h"
#include "model/tools/lying/fallen_hair.h"
#include "model/tools/strokes/skin_frames.h"

#include <memory>
#include <optional>
#include <vector>

namespace hairpaint::model {

/// A dab of the fingers: a disc of the skin, or the root of a strand that they meet elsewhere.
struct FingerDab
{
    Dab dab; ///< The dab on the direction map.
    sim::SurfacePoint centre;
    float reachM = 0.015F;     ///< Radius of the fingers.
    glm::vec3 headingHd{0.0F}; ///< Unit direction of the stroke; zero while it does not move.
    /// Vector from the strand to the middle of the fingers, in units of their radius; none where each texel has its
    /// own.
    std::optional<glm::vec3> gatherHd = {};
};

/// Each texel's value is the one before the stroke, changed by the greatest mask of all dabs, so that neither the order
/// of the dabs nor their overlap shows.
class FingerMaps
{
public:
    /// False where the direction layer can't be painted on; another layer that can't be stays as it is.
    [[nodiscard]] bool begin(const ToolContext& context, const QString& text, SkinFrames& frames);
    void add(const FingerDab& dab);
    void show(); ///< Shows what the dabs since the last call have changed.
    void commit();
    void cancel();
    [[nodiscard]] bool active() const { return m_edit.active(); }
    [[nodiscard]] int size() const { return m_edit.size(); } ///< Side of the direction map, texels.

private:
    /// A scalar map that changes along with the direction map.
    struct Scalar
    {
        MapKind map = MapKind::Clump;
        std::size_t layer = 0; ///< Index of its layer in m_edit.
        StrokeBuffer masks;
        std::shared_ptr<const sim::TiledRaster> before; ///< The resolved map before the stroke.
        std::optional<std::uint16_t> target; ///< The value that texels move to; none: the mean of their neighbours.
        std::vector<std::vector<std::uint16_t>> means = {}; ///< By tile: the neighbours' mean of each texel.
    };

    void also(const ToolContext& context, MapKind map, std::optional<std::uint16_t> target);
    void addTo(Scalar& scalar, const Dab& dab, const Dab& brush);
    [[nodiscard]] glm::vec2 directionAt(glm::vec2 uv, const FingerDab& dab, const Dab& brush);
    [[nodiscard]] sim::RasterTilePtr direction(int tile, const sim::RasterTilePtr& before);
    [[nodiscard]] sim::RasterTilePtr scalarTile(const Scalar& scalar, int tile, const sim::RasterTilePtr& before) const;
    void drop();

    LiveEdit m_edit; ///< Edits the direction layer, then those of m_scalars.
    FingerKind m_kind = FingerKind::Puff;
    std::uint16_t m_strength = 65535;
    SkinFrames* m_frames = nullptr;
    std::optional<FallenHair> m_before; ///< How hair lay when the stroke began.
    std::optional<StrokeBuffer> m_masks;
    std::optional<CombField> m_field;
    std::shared_ptr<const sim::TiledRaster> m_density;
    std::vector<Scalar> m_scalars;
};

} // namespace hairpaint::model
