// The picture and depth of the head, and of cards that stand for its hair, drawn anew only when something about it
// differs.
#pragma once

#include "view/rendering/frame_constants.h"
#include "view/rendering/software/card_picture.h"
#include "view/rendering/software/head_kernel.h"
#include "view/rendering/software/tile_kernel.h"

#include <memory>
#include <vector>

namespace hairpaint::rendering {

/// Rows of samples from the lowest on.
class HeadPicture
{
public:
    /// Draws `head` (may be null). Where the view differs from the call before, `inMotion` is drawn instead,
    /// unless null, and `head` in the first call that does not differ. `cards`: null where there are none.
    void update(const std::shared_ptr<const sim::HeadMesh>& head, const std::shared_ptr<const sim::HeadMesh>& inMotion,
                const std::shared_ptr<const CardSet>& cards, const FrameConstants& constants);
    [[nodiscard]] const std::vector<HeadSample>& samples() const { return m_samples; }
    /// Distances along the view, m; huge where there is no head.
    [[nodiscard]] const std::vector<float>& distancesM() const { return m_distancesM; }
    /// Of each row of samples: 0 where it shows none.
    [[nodiscard]] const std::vector<std::uint8_t>& rowHasHead() const { return m_rowHasHead; }
    [[nodiscard]] int width() const { return m_width; }
    [[nodiscard]] int height() const { return m_height; }
    /// Whether any of it is in some samples.
    [[nodiscard]] bool isIn(int x0, int y0, int across, int up) const;

private:
    struct Mesh
    {
        std::shared_ptr<const sim::HeadMesh> source;
        bool closed = false; ///< The inside is never seen.
    };
    void place(const sim::HeadMesh& mesh, const FrameConstants& constants);
    void sortIntoBands(const sim::HeadMesh& mesh, bool closed);

    Mesh m_fine;
    Mesh m_coarse;
    CardPicture m_cardPicture;
    std::shared_ptr<const sim::HeadMesh> m_head;
    std::shared_ptr<const CardSet> m_cards;
    FrameConstants m_drawnWith{};
    bool m_isCoarse = false; ///< What the picture shows.
    int m_width = 0;
    int m_height = 0;
    std::vector<HeadSample> m_samples;
    std::vector<float> m_distancesM;
    std::vector<std::uint8_t> m_rowHasHead;
    std::vector<HeadVertex> m_vertices;
    std::vector<std::uint32_t> m_bandBegin; ///< Into the triangles of each band of rows.
    std::vector<std::uint32_t> m_bandTriangles;
};

} // namespace hairpaint::rendering
