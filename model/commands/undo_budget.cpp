// Counting the history's own tiles, newest first, and freeing what does not fit.
#include "model/commands/undo_budget.h"

#include <unordered_set>

namespace hairpaint::model {

void UndoBudget::enforce(QUndoStack& stack, const Project& content)
{
    const auto holder = [&stack](int index) {
        // The stack hands out const commands; releasing one changes nothing it knows of.
        return dynamic_cast<TileHolder*>(const_cast<QUndoCommand*>(stack.command(index)));
    };
    if (stack.index() != stack.count())
        return; // Undone steps may be wanted again; the next push drops them.
    std::size_t upperBound = 0;
    for (int index = m_floor; index < stack.count(); ++index)
        if (const TileHolder* command = holder(index))
            command->visitTiles(
                [&](const sim::RasterTilePtr& tile) { upperBound += tile->pixels.size() * sizeof(std::uint16_t); });
    if (upperBound <= m_limit)
        return;

    // Tiles that the content or a newer step holds too cost nothing more.
    std::unordered_set<const sim::RasterTile*> counted;
    for (const HairGroup& group : content.groups)
        for (const MapStack& stackOfMap : group.maps)
            for (const Layer& layer : stackOfMap.layers)
                for (int index = 0; index < layer.raster.tileCount(); ++index)
                    counted.insert(layer.raster.tile(index).get());
    std::size_t bytes = 0;
    for (int index = stack.count() - 1; index >= m_floor; --index) {
        TileHolder* command = holder(index);
        if (command == nullptr)
            continue;
        command->visitTiles([&](const sim::RasterTilePtr& tile) {
            if (counted.insert(tile.get()).second)
                bytes += tile->pixels.size() * sizeof(std::uint16_t);
        });
        if (bytes <= m_limit || index == stack.count() - 1)
            continue;
        for (int old = index; old >= m_floor; --old)
            if (TileHolder* oldCommand = holder(old))
                oldCommand->release();
        m_floor = index + 1;
        return;
    }
}

} // namespace hairpaint::model
