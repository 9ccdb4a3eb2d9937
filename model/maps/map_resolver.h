// Keeps the resolved maps of what a document shows up to date, without holding up its thread.
#pragma once

#include "model/maps/resolved_maps.h"

#include <functional>
#include <memory>
#include <span>

namespace hairpaint::model {

/// Little work is done at once. Much, such as a tick of a layer's opacity over a large map, is done in the background
/// where there is one: until it is done maps() are those from before (none of a new group), and requests made meanwhile
/// wait for it, as one.
/// Lives on one thread, as do the calls to it. Errors: std::bad_alloc, after which maps() may lack the newest change.
class MapResolver
{
public:
    /// Runs `work` on another thread, then `done` on this one, unless the resolver is gone; false where memory ran out.
    using Background = std::function<void(std::function<void()> work, std::function<void(bool whole)> done)>;

    explicit MapResolver(const Project& project) : m_maps(project) {}

    /// `arrived`: what was resolved in the background is in maps(); these are the maps that differ.
    void setBackground(Background background, std::function<void(const ResolvedMaps::Addresses& differing)> arrived);
    [[nodiscard]] const ResolvedMaps& maps() const { return m_maps; }
    /// Whether maps() are older than what was asked for.
    [[nodiscard]] bool underway() const { return m_underway != nullptr; }

    /// All maps of `project`, of which any may differ.
    void update(const Project& project);
    /// One map, and those that follow it.
    void update(const Project& project, const HairGroup& group, MapKind map);
    /// The same, where only these tiles of one layer can differ.
    void updateTiles(const Project& project, const LayerAddress& address, std::span<const int> tiles);
    /// Ends at once what is unfinished. Returns the maps that differ.
    ResolvedMaps::Addresses finish();
    /// Replaces the maps; what is unfinished is dropped.
    void replace(ResolvedMaps maps);

private:
    struct Underway;
    /// Whether it will be done in the background; `tiles` counts those of layers that are to be blended.
    template<typename Tiles>
    bool postpone(const Project& project, const Tiles& tiles);
    void start(const Project& project);
    void take(const std::shared_ptr<Underway>& done, bool whole);

    ResolvedMaps m_maps;
    Background m_background;
    std::function<void(const ResolvedMaps::Addresses&)> m_arrived;
    std::shared_ptr<Underway> m_underway; ///< Null where nothing is being resolved.
};

} // namespace hairpaint::model
