// Each texel's centre is looked up in the head's layout.
#include "model/importing/skin_texels.h"

#include "sim/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::model {

namespace {

constexpr float kTexelGridM = 0.002F;
constexpr int kTexelRows = 64;

struct FoundTexel
{
    glm::vec3 positionHd;
    sim::SkinFrame frame;
    float areaM2;
};

} // namespace

std::optional<SkinTexels> SkinTexels::of(const sim::Skin& skin, int size, const Progress& progress)
{
    SkinTexels texels;
    texels.size = size;
    const auto side = static_cast<float>(size);
    const auto across = static_cast<std::size_t>(size);
    std::vector<std::optional<FoundTexel>> found(across * kTexelRows);
    for (int first = 0; first < size; first += kTexelRows) {
        if (progress && !progress(static_cast<double>(first) / size))
            return std::nullopt;
        const int rows = std::min(kTexelRows, size - first);
        sim::parallelFor(static_cast<std::size_t>(rows), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t row = begin; row < end; ++row)
                for (std::size_t x = 0; x < across; ++x) {
                    const glm::vec2 at(static_cast<float>(x) + 0.5F,
                                       static_cast<float>(first) + static_cast<float>(row) + 0.5F);
                    const auto point = skin.atUv({at.x / side, 1.0F - at.y / side});
                    auto& texel = found[row * across + x];
                    texel.reset();
                    if (point)
                        texel = FoundTexel{point->positionHd, sim::SkinFrame::at(*point),
                                           glm::length(glm::cross(point->dPduHd, point->dPdvHd)) / (side * side)};
                }
        });
        for (std::size_t i = 0; i < static_cast<std::size_t>(rows) * across; ++i) {
            if (!found[i] || !(found[i]->areaM2 > 0.0F))
                continue;
            texels.texel.push_back(static_cast<std::uint32_t>(static_cast<std::size_t>(first) * across + i));
            texels.positionsHd.push_back(found[i]->positionHd);
            texels.frame.push_back(found[i]->frame);
            texels.areaM2.push_back(found[i]->areaM2);
        }
    }
    if (!texels.areaM2.empty()) {
        std::vector<float> areas = texels.areaM2;
        const auto middle = areas.begin() + static_cast<std::ptrdiff_t>(areas.size() / 2);
        std::ranges::nth_element(areas, middle);
        texels.sideM = std::sqrt(*middle);
    }
    texels.sortByPosition();
    return texels;
}

void SkinTexels::sortByPosition()
{
    const PositionGrid unsorted(positionsHd, kTexelGridM);
    const auto sort = [&unsorted](auto& values) {
        auto sorted = values;
        std::ranges::transform(unsorted.order(), sorted.begin(), [&values](std::uint32_t i) { return values[i]; });
        values = std::move(sorted);
    };
    sort(texel);
    sort(positionsHd);
    sort(frame);
    sort(areaM2);
    grid.emplace(positionsHd, kTexelGridM);
}

} // namespace hairpaint::model
