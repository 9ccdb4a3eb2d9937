// Committed content, at most one running edit's preview over it, and the maps resolved from whichever of the two is
// shown.
#include "model/document/document.h"

#include "model/document/command_ptr.h"
#include "model/document/groom_input.h"
#include "model/document/restored_step.h"
#include "model/document/running_edit.h"
#include "model/document/undo_budget.h"
#include "model/project/content_budget.h"

#include <QScopedValueRollback>

#include <algorithm>
#include <iterator>
#include <utility>

namespace hairpaint::model {

namespace {

bool touchesMaps(Change::Aspect aspect)
{
    return aspect != Change::Aspect::Settings && aspect != Change::Aspect::Environment;
}

bool namesOneMap(Change::Aspect aspect)
{
    return aspect == Change::Aspect::Texels || aspect == Change::Aspect::LayerList;
}

} // namespace

struct Document::State
{
    Project committed;
    std::optional<RunningEdit> running;
    bool stepping = false;   ///< An undo or a redo runs.
    bool committing = false; ///< The running edit's command is being made and pushed.
    std::uint64_t sessions = 0;
    std::uint64_t revision = 1;
    QUndoStack undoStack;
    UndoBudget undoBudget;
    MapResolver resolver;   ///< Resolves the maps of the content that is shown.
    ProjectPatches patches; ///< The patches of the committed content.

    explicit State(Project project) : committed(std::move(project)), resolver(committed)
    {
        patches.follow(committed, nullptr); // Content from elsewhere: what is worn is made to agree with the maps.
    }

    [[nodiscard]] const ProjectPatches& shownPatches() const
    {
        return running && running->patches ? *running->patches : patches;
    }
    /// After the running edit shows something else in the part that `change` names. Whether what is worn differs.
    [[nodiscard]] bool followPatches(const Change& change)
    {
        return (needsPatches(change) || running->patches) && running->followPatches(patches);
    }

    const Project& shown() const { return running ? running->shown : committed; }
    /// The user changes something that is not committed yet. What is only looked at is no change.
    bool changing() const { return running && running->owner.policy == EditPolicy::Commit; }

    void resolveFor(const Change& change)
    {
        const HairGroup* group = shown().group(change.group);
        if (namesOneMap(change.aspect) && group != nullptr)
            resolver.update(shown(), *group, change.map);
        else if (touchesMaps(change.aspect))
            resolver.update(shown());
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

const ProjectPatches& Document::patches() const
{
    return m_state->patches;
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
    m_state->undoBudget.setLimit(m_state->undoStack, bytes);
}

bool Document::stepping() const
{
    return m_state->stepping;
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
    // First, for want of memory shows here, and then the old content must be whole.
    ResolvedMaps resolved(project);
    replace(std::move(project), std::move(resolved));
}

void Document::replace(Project project, ResolvedMaps resolved)
{
    ProjectPatches patches; // First, as above.
    patches.follow(project, nullptr);
    const bool ended = std::exchange(m_state->running, std::nullopt).has_value();
    m_state->committed = std::move(project);
    m_state->patches = std::move(patches);
    m_state->resolver.replace(std::move(resolved));
    m_state->undoStack.clear();
    m_state->undoBudget.reset();
    tell(Change{}, false);
    if (ended)
        Q_EMIT editEnded();
}

void Document::restore(const RecoveredWork& work, ResolvedMaps resolved)
{
    replace(work.steps.at(work.current).project, std::move(resolved));
    const auto dormant = std::make_shared<bool>(true);
    for (std::size_t i = 1; i < work.steps.size(); ++i)
        push(std::make_unique<RestoredStep>(*this, work.steps[i].step, work.steps[i - 1].project, work.steps[i].project,
                                            dormant));
    m_state->undoStack.setIndex(static_cast<int>(work.current));
    m_state->undoStack.resetClean();
    *dormant = false;
}

std::shared_ptr<const sim::TiledRaster> Document::resolved(Id group, MapKind map) const
{
    return m_state->resolver.maps().map(group, map);
}

void Document::resolveIn(MapResolver::Background background)
{
    m_state->resolver.setBackground(std::move(background),
                                    [this](const ResolvedMaps::Addresses& maps) { tellResolved(maps); });
}

bool Document::resolving() const
{
    return m_state->resolver.underway();
}

std::shared_ptr<const sim::TiledRaster> Document::resolvedNow(Id group, MapKind map)
{
    tellResolved(m_state->resolver.finish());
    return resolved(group, map);
}

std::uint64_t Document::revision() const
{
    return m_state->revision;
}

sim::GroomInput Document::groomInput() const
{
    sim::GroomInput input = groomInputOf(project(), m_state->resolver.maps(), m_state->shownPatches());
    input.revision = m_state->revision;
    input.preview = previewing();
    return input;
}

void Document::apply(const Change& change, const std::function<void(Project&)>& edit)
{
    State& state = *m_state;
    // A running edit makes room for what is applied: its own command, or an undo that knows nothing of it.
    std::optional<RunningEdit> over = std::exchange(state.running, std::nullopt);
    if (over)
        over->shown = {}; // Shares maps, which would be copied to be written.
    const std::vector<Worn> worn = state.committed.worn;
    edit(state.committed);
    if (needsPatches(change) || change.aspect == Change::Aspect::Environment)
        state.patches.update(state.committed);
    // Resolving compares tile pointers, so what a preview already showed costs nothing here.
    if (over)
        state.resolver.update(state.shown());
    else
        state.resolveFor(change);
    if (over)
        for (const Change& shown : over->changes())
            if (!covers(change, shown))
                tell(shown, true);
    tell(change, false);
    if (change.aspect == Change::Aspect::GroupList && worn != state.committed.worn)
        tell({.aspect = Change::Aspect::Environment}, false);
    if (over)
        Q_EMIT editEnded();
}

void Document::setWindOn(bool on)
{
    State& state = *m_state;
    if (state.committed.wind.enabled == on && project().wind.enabled == on)
        return;
    state.committed.wind.enabled = on;
    if (state.running)
        state.running->shown.wind.enabled = on;
    tell({.aspect = Change::Aspect::Environment}, previewing());
}

EditSession Document::begin(EditOwner owner)
{
    endEdit();
    State& state = *m_state;
    state.running = RunningEdit{
        .session = ++state.sessions, .owner = std::move(owner), .shown = state.committed, .parts = {}, .tiles = {}};
    state.running->plainWorn = state.running->toldWorn = state.committed.worn;
    state.running->plainNextId = state.committed.nextId;
    return {*this, state.running->session};
}

void Document::show(EditSession& session, const EditOwner& owner, const Change& change,
                    const std::function<void(Project&)>& edit)
{
    if (!session.active())
        session = begin(owner);
    session.preview(change, edit);
}

void Document::endEdit()
{
    if (m_state->committing)
        return;
    if (m_state->changing())
        commitEdit();
    else
        dropEdit();
}

bool Document::mayBecome(const Project& after)
{
    const ContentExcess excess = excessOver(m_state->committed.groups, after.groups);
    if (excess == ContentExcess::None)
        return true;
    Q_EMIT refused(excessText(excess));
    return false;
}

void Document::settle()
{
    if (m_state->changing())
        endEdit();
}

bool Document::runs(std::uint64_t session) const
{
    return m_state->running && m_state->running->session == session;
}

void Document::preview(const Change& change, const std::function<void(Project&)>& edit)
{
    State& state = *m_state;
    state.running->showPart(state.committed, {.change = change, .edit = edit});
    state.resolveFor(change);
    const bool followed = state.followPatches(change);
    tell(change, true);
    if (followed)
        tell({.aspect = Change::Aspect::Environment}, true);
}

void Document::previewTiles(const LayerAddress& address, const LayerTiles& tiles)
{
    State& state = *m_state;
    if (state.committed.layer(address.group, address.map, address.layer) == nullptr)
        return;
    const std::optional<Change> change = state.running->showTiles(address, tiles);
    if (!change)
        return;
    state.resolver.updateTiles(project(), address, change->tiles);
    const bool followed = state.followPatches(*change);
    tell(*change, true);
    if (followed)
        tell({.aspect = Change::Aspect::Environment}, true);
}

void Document::setEditText(const QString& text)
{
    m_state->running->owner.text = text;
}

void Document::commitEdit()
{
    State& state = *m_state;
    if (!state.running || state.committing)
        return;
    state.committing = true;
    CommandPtr command = state.running->command(*this);
    const bool changes = command != nullptr;
    push(std::move(command)); // Its redo() replaces what is shown.
    state.committing = false;
    if (!changes)
        dropEdit();
}

void Document::dropEdit()
{
    State& state = *m_state;
    if (!state.running || state.committing)
        return;
    const RunningEdit over = std::move(*state.running);
    state.running.reset();
    const std::vector<Change> changes = over.changes();
    for (const Change& change : changes)
        state.resolveFor(change);
    for (const Change& change : changes)
        tell(change, true);
    Q_EMIT editEnded();
}

bool Document::previewing() const
{
    return m_state->running && m_state->running->showsSomething();
}

void Document::tell(Change change, bool preview)
{
    change.preview = preview;
    ++m_state->revision;
    Q_EMIT changed(change);
}

void Document::tellResolved(const ResolvedMaps::Addresses& maps)
{
    for (const auto& [group, map] : maps)
        tell({.aspect = Change::Aspect::Resolved, .group = group, .map = map}, previewing());
}

void Document::undo()
{
    if (m_state->running) {
        // By value: it may end the edit that holds it.
        const std::function<bool()> stepBack = m_state->running->owner.stepBack;
        if (stepBack != nullptr && stepBack()) {
            Q_EMIT editSteppedBack();
            return;
        }
        const bool changing = m_state->changing();
        dropEdit();
        if (changing)
            return;
    }
    if (!canUndo())
        return;
    const QString name = m_state->undoStack.undoText();
    {
        const QScopedValueRollback steps(m_state->stepping, true);
        m_state->undoStack.undo();
    }
    Q_EMIT undone(name);
}

void Document::redo()
{
    endEdit();
    if (!m_state->undoStack.canRedo())
        return;
    const QString name = m_state->undoStack.redoText();
    {
        const QScopedValueRollback steps(m_state->stepping, true);
        m_state->undoStack.redo();
    }
    Q_EMIT redone(name);
}

void Document::push(std::unique_ptr<QUndoCommand> command)
{
    if (command == nullptr)
        return;
    endEdit();
    m_state->undoStack.push(command.release());
    m_state->undoBudget.pushed(m_state->undoStack);
}

} // namespace hairpaint::model
