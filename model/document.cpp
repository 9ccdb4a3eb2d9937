// Committed content, at most one preview over it, and the maps resolved from whichever of the two is shown.
#include "model/document.h"

#include "model/commands/undo_budget.h"
#include "model/compositor.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

namespace hairpaint::model {

namespace {

using MapKey = std::pair<Id, MapKind>;

bool touchesMaps(Change::Aspect aspect)
{
    return aspect != Change::Aspect::Settings && aspect != Change::Aspect::Environment;
}

bool namesOneMap(Change::Aspect aspect)
{
    return aspect == Change::Aspect::Texels || aspect == Change::Aspect::LayerList;
}

/// Whether telling of `b` tells all that `a` says. Tiles are sorted.
bool covers(const Change& b, const Change& a)
{
    if (b.aspect == Change::Aspect::Everything)
        return true;
    return a.aspect == b.aspect && a.group == b.group && a.map == b.map && a.layer == b.layer &&
           (b.tiles.empty() || std::ranges::includes(b.tiles, a.tiles));
}

} // namespace

struct Document::State
{
    Project committed;
    std::optional<Project> preview;
    std::uint64_t revision = 1;
    Change previewChange; ///< Of the running preview; for a stroke, with every tile touched so far.
    bool stroke = false;  ///< The preview came through previewTiles.
    QUndoStack undoStack;
    UndoBudget undoBudget;
    std::map<MapKey, ResolvedMap> resolved; ///< Of what is shown.

    explicit State(Project project) : committed(std::move(project)) { resolveAll(); }

    const Project& shown() const { return preview ? *preview : committed; }
    /// The user changes something that is not committed yet. A preset shown on hover is no change.
    bool changing() const { return preview && (stroke || previewChange.aspect == Change::Aspect::Environment); }

    void resolveAll()
    {
        const Project& project = shown();
        std::erase_if(resolved, [&](const auto& entry) { return project.group(entry.first.first) == nullptr; });
        for (const HairGroup& group : project.groups)
            for (const MapStack& stack : group.maps)
                resolveOne(group.id, stack);
    }
    sim::MapRaster resolvedMap(Id group, MapKind map) const
    {
        const auto found = resolved.find({group, map});
        return found == resolved.end() ? nullptr : found->second.result();
    }
    void resolveOne(Id group, const MapStack& stack)
    {
        const sim::MapRaster start =
            startOf(mapSpec(stack.kind), shown().head.get(), [&](MapKind kind) { return resolvedMap(group, kind); });
        const auto found = resolved.find({group, stack.kind});
        if (found == resolved.end())
            resolved.emplace(MapKey{group, stack.kind}, ResolvedMap(stack, start));
        else
            found->second.update(stack, start);
    }
    void resolveFollowers(const HairGroup& group, MapKind map)
    {
        for (const MapStack& stack : group.maps)
            if (mapSpec(stack.kind).follows == map)
                resolveOne(group.id, stack);
    }
    void resolveFor(const Change& change)
    {
        const HairGroup* group = shown().group(change.group);
        if (namesOneMap(change.aspect) && group != nullptr) {
            resolveOne(change.group, group->map(change.map));
            resolveFollowers(*group, change.map);
        } else if (touchesMaps(change.aspect)) {
            resolveAll();
        }
    }
};

Document::Document(Project project, QObject* parent)
    : QObject(parent), m_state(std::make_unique<State>(std::move(project)))
{
    connect(&m_state->undoStack, &QUndoStack::cleanChanged, this,
            [this](bool clean) { Q_EMIT modifiedChanged(!clean); });
}

Document::~Document()
{
    m_state->undoStack.disconnect(this);
}

const Project& Document::project() const
{
    return m_state->shown();
}

const Project& Document::committed() const
{
    return m_state->committed;
}

QUndoStack& Document::undoStack()
{
    return m_state->undoStack;
}

bool Document::canUndo() const
{
    return m_state->changing() || m_state->undoStack.index() > m_state->undoBudget.floor();
}

void Document::setUndoBudget(std::size_t bytes)
{
    m_state->undoBudget.setLimit(bytes);
    m_state->undoBudget.enforce(m_state->undoStack, m_state->committed);
}

bool Document::modified() const
{
    return !m_state->undoStack.isClean();
}

void Document::markSaved()
{
    m_state->undoStack.setClean();
}

void Document::replace(Project project)
{
    Q_EMIT strokeMustEnd(true);
    m_state->preview.reset();
    m_state->stroke = false;
    m_state->committed = std::move(project);
    m_state->resolved.clear();
    m_state->resolveAll();
    m_state->undoStack.clear();
    m_state->undoBudget.reset();
    tell(Change{}, false);
}

std::shared_ptr<const sim::TiledRaster> Document::resolved(Id group, MapKind map) const
{
    return m_state->resolvedMap(group, map);
}

std::uint64_t Document::revision() const
{
    return m_state->revision;
}

sim::GroomInput Document::groomInput() const
{
    const Project& shown = project();
    sim::GroomInput input;
    if (shown.head != nullptr)
        input.skin = shown.head->skin;
    input.colliders = shown.ellipsoids;
    input.seed = shown.seed;
    input.maxHairs = shown.maxHairs;
    input.revision = m_state->revision;
    input.preview = previewing();
    for (const HairGroup& group : shown.groups) {
        sim::GroupInput& one = input.groups.emplace_back();
        one.id = group.id;
        one.visible = group.visible;
        one.settings = group.settings;
        for (const MapSpec& spec : mapSpecs())
            one.maps[spec.kind] = resolved(group.id, spec.kind);
    }
    return input;
}

void Document::apply(const Change& change, const std::function<void(Project&)>& edit)
{
    State& state = *m_state;
    const bool hadPreview = state.preview.has_value();
    state.preview.reset();
    state.stroke = false;
    edit(state.committed);
    // Resolving compares tile pointers, so what a preview already showed costs nothing here.
    if (hadPreview)
        state.resolveAll();
    else
        state.resolveFor(change);
    if (hadPreview && !covers(change, state.previewChange))
        tell(state.previewChange, true);
    tell(change, false);
}

void Document::setPreview(const Change& change, const std::function<void(Project&)>& edit)
{
    State& state = *m_state;
    Q_EMIT strokeMustEnd(false);
    const bool hadPreview = state.preview.has_value();
    const Change before = std::exchange(state.previewChange, change);
    state.preview = state.committed;
    state.stroke = false;
    edit(*state.preview);
    if (hadPreview && !covers(change, before)) {
        state.resolveAll();
        tell(before, true);
    } else {
        state.resolveFor(change);
    }
    tell(change, true);
}

void Document::previewTiles(const LayerAddress& address, const std::vector<std::pair<int, sim::RasterTilePtr>>& tiles)
{
    State& state = *m_state;
    Change change{.aspect = Change::Aspect::Texels, .group = address.group, .map = address.map, .layer = address.layer};
    const Change& running = state.previewChange;
    if (state.preview && !(state.stroke && running.group == address.group && running.map == address.map &&
                           running.layer == address.layer))
        dropPreview();
    if (!state.preview) {
        state.preview = state.committed;
        state.stroke = true;
        state.previewChange = change;
    }
    Layer* layer = state.preview->layer(address.group, address.map, address.layer);
    if (layer == nullptr)
        return;
    change.tiles.reserve(tiles.size());
    for (const auto& [index, tile] : tiles) {
        layer->raster.setTile(index, tile);
        change.tiles.push_back(index);
    }
    const auto map = state.resolved.find({address.group, address.map});
    const HairGroup& group = *state.preview->group(address.group);
    map->second.updateTiles(group.map(address.map), address.layer, change.tiles);
    state.resolveFollowers(group, address.map);
    std::ranges::sort(change.tiles);
    std::vector<int> all;
    std::ranges::set_union(state.previewChange.tiles, change.tiles, std::back_inserter(all));
    state.previewChange.tiles = std::move(all);
    tell(std::move(change), true);
}

void Document::clearPreview()
{
    if (m_state->preview)
        dropPreview();
}

void Document::dropPreview()
{
    State& state = *m_state;
    state.preview.reset();
    state.stroke = false;
    state.resolveFor(state.previewChange);
    tell(state.previewChange, true);
}

bool Document::previewing() const
{
    return m_state->preview.has_value();
}

void Document::tell(Change change, bool preview)
{
    change.preview = preview;
    ++m_state->revision;
    Q_EMIT changed(change);
}

void Document::undo()
{
    const bool changing = m_state->changing();
    Q_EMIT strokeMustEnd(true);
    clearPreview();
    if (changing || !canUndo())
        return;
    const QString name = m_state->undoStack.undoText();
    m_state->undoStack.undo();
    Q_EMIT undone(name);
}

void Document::redo()
{
    Q_EMIT strokeMustEnd(false);
    clearPreview();
    if (!m_state->undoStack.canRedo())
        return;
    const QString name = m_state->undoStack.redoText();
    m_state->undoStack.redo();
    Q_EMIT redone(name);
}

void Document::push(std::unique_ptr<QUndoCommand> command)
{
    if (command == nullptr)
        return;
    Q_EMIT strokeMustEnd(false);
    m_state->undoStack.push(command.release());
    m_state->undoBudget.enforce(m_state->undoStack, m_state->committed);
}

} // namespace hairpaint::model
