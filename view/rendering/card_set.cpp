// Smaller levels of a texture.
#include "view/rendering/card_set.h"

#include <utility>

namespace hairpaint::rendering {

std::vector<CardTexture> withSmallerLevels(CardTexture texture)
{
    std::vector<CardTexture> levels;
    levels.push_back(std::move(texture));
    while (levels.back().side > 1) {
        const CardTexture& fine = levels.back();
        const auto across = static_cast<std::size_t>(fine.side);
        CardTexture half{.side = fine.side / 2, .texels = {}};
        half.texels.reserve(fine.texels.size() / 4);
        for (std::size_t y = 0; y < across; y += 2)
            for (std::size_t x = 0; x < across; x += 2) {
                glm::uvec4 sum(2); // Rounds.
                for (const std::size_t i :
                     {y * across + x, y * across + x + 1, (y + 1) * across + x, (y + 1) * across + x + 1})
                    sum += glm::uvec4(fine.texels[i]);
                half.texels.emplace_back(sum / 4U);
            }
        levels.push_back(std::move(half));
    }
    return levels;
}

} // namespace hairpaint::rendering
