// Bounds the memory of the undo history.
#pragma once

#include "model/project.h"

#include <QUndoStack>

#include <cstddef>
#include <functional>

namespace hairpaint::model {

/// A command that keeps tiles for undo and redo.
class TileHolder
{
public:
    using Visit = std::function<void(const sim::RasterTilePtr&)>;

    TileHolder() = default;
    TileHolder(const TileHolder&) = delete;
    TileHolder& operator=(const TileHolder&) = delete;
    virtual ~TileHolder() = default;
    virtual void visitTiles(const Visit& visit) const = 0;
    /// Lets go of everything; the command will neither be undone nor redone again.
    virtual void release() = 0;
};

/// QUndoStack can neither count bytes nor forget its oldest commands, so those stay as empty shells below a floor that
/// nobody undoes past.
class UndoBudget
{
public:
    static constexpr std::size_t kUsualBytes = std::size_t{1} << 30U;

    void setLimit(std::size_t bytes) { m_limit = bytes; }
    /// Frees the oldest steps until the tiles that only the history holds fit; never the newest step.
    void enforce(QUndoStack& stack, const Project& content);
    /// Steps below this index can't be undone any more.
    [[nodiscard]] int floor() const { return m_floor; }
    void reset() { m_floor = 0; }

private:
    std::size_t m_limit = kUsualBytes;
    int m_floor = 0;
};

} // namespace hairpaint::model
