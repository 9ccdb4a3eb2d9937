// A flood fill through cells that hold positions.
#include "model/importing/touching_sets.h"

#include <map>
#include <tuple>

namespace hairpaint::model {

std::vector<std::vector<std::uint32_t>> touchingSets(std::span<const glm::vec3> positions, float cellM)
{
    using Cell = std::tuple<int, int, int>;
    std::map<Cell, std::vector<std::uint32_t>> cells;
    for (std::uint32_t i = 0; i < positions.size(); ++i) {
        const glm::ivec3 cell(glm::floor(glm::clamp(positions[i] / cellM, -1e6F, 1e6F)));
        cells[{cell.x, cell.y, cell.z}].push_back(i);
    }
    std::vector<std::vector<std::uint32_t>> sets;
    std::vector<Cell> open;
    while (!cells.empty()) {
        std::vector<std::uint32_t>& set = sets.emplace_back();
        const auto take = [&](const Cell& cell) {
            const auto found = cells.find(cell);
            if (found == cells.end())
                return;
            set.insert(set.end(), found->second.begin(), found->second.end());
            open.push_back(cell);
            cells.erase(found);
        };
        take(cells.begin()->first);
        while (!open.empty()) {
            const auto [x, y, z] = open.back();
            open.pop_back();
            for (int dz = -1; dz <= 1; ++dz)
                for (int dy = -1; dy <= 1; ++dy)
                    for (int dx = -1; dx <= 1; ++dx)
                        take({x + dx, y + dy, z + dz});
        }
    }
    return sets;
}

} // namespace hairpaint::model
