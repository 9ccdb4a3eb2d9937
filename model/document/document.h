// The open project: its content, its undo history and the resolved maps. Every change goes through it.
#pragma once

#include "model/document/edit_session.h"
#include "model/document/journal_state.h"
#include "model/maps/map_resolver.h"
#include "model/maps/resolved_maps.h"
#include "model/patches/project_patches.h"
#include "model/project/change.h"
#include "model/project/project.h"
#include "sim/groom/groom_input.h"

#include <QObject>
#include <QUndoStack>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace hairpaint::model {

/// Lives on the GUI thread. Content changes only through undo commands (command_ptr.h) and the previews of edit
/// sessions; both take the same path, so a preview gives the bytes of its commit.
class Document : public QObject
{
    Q_OBJECT
public:
    explicit Document(Project project, QObject* parent = nullptr);
    ~Document() override;

    [[nodiscard]] const Project& project() const;
    [[nodiscard]] QUndoStack& undoStack();
    /// Also true while an edit that commits is running. Also false if the remaining steps were freed to bound the
    /// memory of the history.
    [[nodiscard]] bool canUndo() const;
    /// Limit on the bytes of tiles that only the history holds; 1 GiB by default. The newest step can always be undone.
    void setUndoBudget(std::size_t bytes);
    [[nodiscard]] bool stepping() const; ///< While undo() or redo() changes the project.
    [[nodiscard]] bool modified() const; ///< Since the last markSaved().
    void markSaved();
    /// Replaces the project and clears the history. If memory runs out it throws std::bad_alloc
    /// and changes nothing.
    void replace(Project project);
    /// The same with its maps resolved already, on another thread.
    void replace(Project project, ResolvedMaps resolved);
    /// Restores the content of a journal and the steps of its history; counts as modified. `resolved`: the maps of the
    /// current step, which must exist.
    void restore(const RecoveredWork& work, ResolvedMaps resolved);

    /// The map with all visible layers (and a running edit's preview) applied: `spec.valueChannels` channels. It lags
    /// behind while resolving().
    [[nodiscard]] std::shared_ptr<const sim::TiledRaster> resolved(Id group, MapKind map) const;
    /// From now on long resolving runs on that thread, and changed() is emitted when it is done. Without one everything
    /// is resolved immediately.
    void resolveIn(MapResolver::Background background);
    [[nodiscard]] bool resolving() const;
    /// The same, after waiting until it is resolved; for computing from it.
    [[nodiscard]] std::shared_ptr<const sim::TiledRaster> resolvedNow(Id group, MapKind map);
    /// Grows with every change, previews and maps resolved later too; frames of hair name the one they show.
    [[nodiscard]] std::uint64_t revision() const;
    /// Everything the simulation needs, sharing tiles.
    [[nodiscard]] sim::GroomInput groomInput() const;

    /// Runs `edit` on the content and tells of `change`; re-resolves what it names. For undo commands only: everybody
    /// else pushes one.
    void apply(const Change& change, const std::function<void(Project&)>& edit);

    /// Whether the wind blows is saved with the project, but it is a matter of looking at the hair, like a pause: no
    /// step of the history, and the project does not count as modified by it. Whatever runs goes on.
    void setWindOn(bool on);

    /// Begins an edit, after the one that runs has ended by its policy.
    [[nodiscard]] EditSession begin(EditOwner owner);
    /// Previews in a session; begins it first where it does not run.
    void show(EditSession& session, const EditOwner& owner, const Change& change,
              const std::function<void(Project&)>& edit);
    /// Ends what runs by its policy. Making a command does so before it looks at the content; whoever else computes
    /// from committed() what is to be pushed calls it first.
    void endEdit();
    /// Commits what runs, unless the user only looks: before saving.
    void settle();
    /// Whether the content may become `after`, which must not be larger than can be saved
    /// (model/project/content_budget.h). Where it may not, refused() says why. For making commands.
    [[nodiscard]] bool mayBecome(const Project& after);
    /// The patches of the accessory maps in the committed content, and what is worn as them.
    [[nodiscard]] const ProjectPatches& patches() const;
    /// Whether an edit runs that shows something.
    [[nodiscard]] bool previewing() const;
    /// The content without any preview; what files are written from.
    [[nodiscard]] const Project& committed() const;

Q_SIGNALS:
    void changed(const hairpaint::model::Change& change);
    void modifiedChanged(bool modified);
    void editSteppedBack(); ///< A session took back its last part and goes on.
    void editEnded();       ///< A session is over, whoever ended it.
    /// What was asked for would make the content larger than can be saved, and was not done.
    void refused(const QString& reason);
    /// After undo() or redo() took the step of that name.
    void undone(const QString& name);
    void redone(const QString& name);

public:
    /// Undo and redo as the user means them. What is being changed is all that undo takes back, part by part where its
    /// owner can; redo commits it.
    void undo();
    void redo();
    /// Pushes after ending what is running. Null is ignored.
    void push(std::unique_ptr<QUndoCommand> command);

private:
    struct State;
    friend class EditSession;
    [[nodiscard]] bool runs(std::uint64_t session) const;
    void preview(const Change& change, const std::function<void(Project&)>& edit);
    void previewTiles(const LayerAddress& address, const LayerTiles& tiles);
    void setEditText(const QString& text);
    void commitEdit();
    void dropEdit();
    void tell(Change change, bool preview);
    void tellResolved(const ResolvedMaps::Addresses& maps);

    std::unique_ptr<State> m_state;
};

} // namespace hairpaint::model
