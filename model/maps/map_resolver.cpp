// When maps are resolved: at once, or in the background and taken over when that is done.
#include "model/maps/map_resolver.h"

#include <algorithm>
#include <new>
#include <utility>

namespace hairpaint::model {

namespace {

/// Tiles of layers that are blended within a few milliseconds on any machine: less than waking another thread is worth.
constexpr std::size_t kTilesAtOnce = 512;

bool isMuch(std::size_t tiles)
{
    return tiles > kTilesAtOnce;
}

} // namespace

/// What is being resolved in the background. While that works, this thread touches only `wanted` and `stale`.
struct MapResolver::Underway
{
    ResolvedMaps maps;
    Project wanted;     ///< The newest project that was asked for.
    bool stale = false; ///< Whether `wanted` differs from the project that is being resolved.
};

void MapResolver::setBackground(Background background, std::function<void(const ResolvedMaps::Addresses&)> arrived)
{
    m_background = std::move(background);
    m_arrived = std::move(arrived);
}

void MapResolver::update(const Project& project)
{
    if (postpone(project, [&] { return m_maps.tilesToBlend(project); }))
        return;
    m_maps.update(project);
}

void MapResolver::update(const Project& project, const HairGroup& group, MapKind map)
{
    if (postpone(project, [&] { return m_maps.tilesToBlend(project, group, map); }))
        return;
    m_maps.update(project, group, map);
}

void MapResolver::updateTiles(const Project& project, const LayerAddress& address, std::span<const int> tiles)
{
    const MapStack& stack = project.group(address.group)->map(address.map);
    if (postpone(project, [&] { return tiles.size() * stack.layers.size(); }))
        return;
    m_maps.updateTiles(project, address, tiles);
}

template<typename Tiles>
bool MapResolver::postpone(const Project& project, const Tiles& tiles)
{
    if (m_underway) {
        m_underway->wanted = project;
        m_underway->stale = true;
        return true;
    }
    if (!m_background || !isMuch(tiles()))
        return false;
    start(project);
    return true;
}

void MapResolver::start(const Project& project)
{
    const auto underway = std::make_shared<Underway>(Underway{.maps = m_maps, .wanted = project});
    m_underway = underway;
    m_background([underway, project] { underway->maps.update(project); },
                 [this, weak = std::weak_ptr(underway)](bool whole) {
                     // What was dropped meanwhile is gone, or held by its work alone.
                     if (const std::shared_ptr<Underway> done = weak.lock(); done && done == m_underway)
                         take(done, whole);
                 });
}

void MapResolver::take(const std::shared_ptr<Underway>& done, bool whole)
{
    m_underway.reset();
    const ResolvedMaps before = whole ? std::exchange(m_maps, std::move(done->maps)) : m_maps;
    const auto tell = [&] { m_arrived(m_maps.differingFrom(before)); };
    try {
        // Where memory ran out on the other thread there may be enough by now; if not, it is this one's caller that
        // hears, after what has come all the same was told.
        if (!whole || done->stale)
            update(done->wanted);
    } catch (const std::bad_alloc&) {
        tell();
        throw;
    }
    tell();
}

ResolvedMaps::Addresses MapResolver::finish()
{
    if (!m_underway)
        return {};
    const std::shared_ptr<Underway> dropped = std::exchange(m_underway, nullptr);
    const ResolvedMaps before = m_maps;
    m_maps.update(dropped->wanted);
    return m_maps.differingFrom(before);
}

void MapResolver::replace(ResolvedMaps maps)
{
    m_underway.reset();
    m_maps = std::move(maps);
}

} // namespace hairpaint::model
