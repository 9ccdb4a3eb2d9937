// Hair cards drawn into the head's picture.
#pragma once

#include "view/rendering/card_set.h"
#include "view/rendering/frame_constants.h"
#include "view/rendering/software/tile_kernel.h"

#include <vector>

namespace hairpaint::rendering {

/// Rows of the head's picture. A sample shows the nearest texel that is hair; none is half covered.
struct CardBand
{
    int width = 0;
    int firstRow = 0;
    int endRow = 0;
    HeadSample* samples = nullptr; ///< The picture's; rows are `width` long.
    float* distancesM = nullptr;   ///< Along the view.
};

class CardPicture
{
public:
    /// Projects and lights the corners. `cards` must outlive what is drawn of it.
    void transform(const CardSet& cards, const FrameConstants& constants);
    /// False where none of it lies in the band. Several threads may draw bands.
    bool drawBand(const CardBand& band) const;

private:
    struct ProjectedVertex
    {
        float x = 0.0F, y = 0.0F; ///< Samples.
        float perDistance = 0.0F; ///< 1/m; 0 where it lies behind the eye.
        glm::vec2 uv{0.0F};
        glm::vec3 light{0.0F}; ///< That a white card throws back.
    };
    void drawTriangle(const CardBand& band, const ProjectedVertex& a, const ProjectedVertex& b,
                      const ProjectedVertex& c, float area) const;

    const CardSet* m_cards = nullptr;
    std::vector<ProjectedVertex> m_corners;
};

} // namespace hairpaint::rendering
