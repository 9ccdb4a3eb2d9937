// The picture and depth of the head, of what is worn on it and of cards that stand for its hair, drawn anew only when
// something about it differs.
#pragma once

#include "view/rendering/frame_constants.h"
#include "view/rendering/scalp_tint.h"
#include "view/rendering/software/card_picture.h"
#include "view/rendering/software/head_kernel.h"
#include "view/rendering/software/head_occlusion.h"
#include "view/rendering/software/tile_kernel.h"

#include <memory>
#include <span>
#include <vector>

namespace hairpaint::rendering {

/// Rows of samples from the lowest on.
class HeadPicture
{
public:
    /// Draws the scene's head, solids and cards. `coarse`: where the view differs from the call before, headInMotion is
    /// drawn instead of the head, unless null, and the head in the first call that does not differ.
    void update(const Scene& scene, bool coarse, const FrameConstants& constants);
    [[nodiscard]] const std::vector<HeadSample>& samples() const { return m_samples; }
    /// Distances along the view, m; huge where there is no head.
    [[nodiscard]] const std::vector<float>& distancesM() const { return m_distancesM; }
    /// 1 where a solid is seen; null where there are no solids.
    [[nodiscard]] const std::uint8_t* worn() const { return m_worn.empty() ? nullptr : m_worn.data(); }
    /// [rows of samples] 0 where the row shows no head.
    [[nodiscard]] const std::vector<std::uint8_t>& rowHasHead() const { return m_rowHasHead; }
    [[nodiscard]] const HeadOcclusion& occlusion() const { return m_occlusion; }
    [[nodiscard]] int width() const { return m_width; }
    [[nodiscard]] int height() const { return m_height; }
    /// Whether any of the samples in a rectangle shows the head.
    [[nodiscard]] bool isIn(int x0, int y0, int across, int up) const;

private:
    struct Mesh
    {
        std::shared_ptr<const sim::HeadMesh> source;
        bool closed = false; ///< The inside is never seen.
        ScalpTint tint;
    };
    /// A mesh in the picture's projection, with its light.
    struct Part
    {
        std::vector<HeadVertex> vertices;
        std::span<const glm::uvec3> triangles;
        SkinLighting lighting;
        bool isSolid = false;
        bool isTinted = false;
        const sim::MeshTexture* texture = nullptr; ///< Kept alive by m_solids or m_skinTexture; null: none.
        glm::vec3 colour{1.0F};
        bool isMasked = false;
        std::vector<std::uint32_t> bandBegin;     ///< [bands + 1] where each band of rows begins in bandTriangles.
        std::vector<std::uint32_t> bandTriangles; ///< Indices of triangles, band by band.
        void sortIntoBands(bool closed, int height);
    };
    void transformParts(const Mesh& head, const FrameConstants& constants, int height);
    /// Whether there is anything of head and solids in the band.
    bool drawParts(HeadBand band, std::size_t number) const;

    Mesh m_fine;
    Mesh m_coarse;
    CardPicture m_cardPicture;
    std::shared_ptr<const sim::HeadMesh> m_head;
    std::shared_ptr<const CardSet> m_cards;
    std::vector<Solid> m_solids;
    std::shared_ptr<const sim::MeshTexture> m_skinTexture;
    ScalpTintSources m_tintSources;
    FrameConstants m_drawnWith{};
    bool m_isCoarse = false; ///< The picture shows the coarse head.
    int m_width = 0;
    int m_height = 0;
    std::vector<HeadSample> m_samples;
    std::vector<float> m_distancesM;
    std::vector<std::uint8_t> m_worn;
    std::vector<std::uint8_t> m_rowHasHead;
    HeadOcclusion m_occlusion;
    std::vector<Part> m_parts; ///< The head, then the solids.
};

} // namespace hairpaint::rendering
