// Bounds the memory of the undo history.
#pragma once

#include "sim/base/tiled_raster.h"

#include <QUndoStack>

#include <cstddef>
#include <vector>

namespace hairpaint::model {

[[nodiscard]] inline std::size_t bytesOf(const sim::RasterTilePtr& tile)
{
    return tile->pixels.size() * sizeof(std::uint16_t);
}

/// A command that keeps tiles for undo and redo.
class TileHolder
{
public:
    TileHolder() = default;
    TileHolder(const TileHolder&) = delete;
    TileHolder& operator=(const TileHolder&) = delete;
    virtual ~TileHolder() = default;
    /// After redo(): bytes of the tiles that it took out of the content. Tiles that another layer has too count as
    /// well, so the sum over the history is an upper bound.
    [[nodiscard]] virtual std::size_t keptBytes() const = 0;
    /// Frees its tiles; the command will never be undone or redone again.
    virtual void release() = 0;
};

/// QUndoStack can neither count bytes nor forget its oldest commands, so those stay as empty shells below a floor that
/// nobody undoes past. A push costs what its own command holds, however long the history is.
class UndoBudget
{
public:
    static constexpr std::size_t kUsualBytes = std::size_t{1} << 30U;

    void setLimit(QUndoStack& stack, std::size_t bytes);
    /// After a push: counts the newest command, and frees the oldest ones until the rest fits; never the newest.
    void pushed(QUndoStack& stack);
    /// Steps below this index can't be undone any more.
    [[nodiscard]] int floor() const { return m_floor; }
    void reset();

private:
    void enforce(QUndoStack& stack);

    std::size_t m_limit = kUsualBytes;
    std::vector<std::size_t> m_bytes; ///< Bytes that each command of the stack keeps, by its index.
    std::size_t m_sum = 0;            ///< Bytes kept by the commands above the floor.
    int m_floor = 0;
};

} // namespace hairpaint::model
