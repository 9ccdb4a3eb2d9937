// The open project: its content, its undo history and the resolved maps. Every change goes through it.
#pragma once

#include "model/project.h"
#include "sim/groom/groom_input.h"

#include <QObject>
#include <QUndoStack>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace hairpaint::model {

struct LayerAddress
{
    Id group = 0;
    MapKind map = MapKind::Density;
    Id layer = 0;
    friend bool operator==(const LayerAddress&, const LayerAddress&) = default;
};

/// What one edit touched. `aspect` says which of the other members mean something.
struct Change
{
    enum class Aspect : std::uint8_t
    {
        Texels,      ///< group, map, layer, tiles
        LayerList,   ///< group, map: layers added, removed, moved, renamed, or their properties
        GroupList,   ///< groups added, removed, renamed, reordered, shown
        Settings,    ///< group: its settings
        Environment, ///< wind, light, background
        Head,
        Everything ///< another project
    };
    Aspect aspect = Aspect::Everything;
    Id group = 0;
    MapKind map = MapKind::Density;
    Id layer = 0;
    std::vector<int> tiles = {}; ///< Of the map's raster; empty with Texels means all.
    bool preview = false;        ///< Not committed yet, or a preview taken back.
};

/// Lives on the GUI thread. Content changes only through undo commands (model/commands) and previews; both take the
/// same path, so a preview gives the bytes of its commit.
class Document : public QObject
{
    Q_OBJECT
public:
    explicit Document(Project project, QObject* parent = nullptr);
    ~Document() override;

    [[nodiscard]] const Project& project() const;
    [[nodiscard]] QUndoStack& undoStack();
    /// True also while a stroke runs or wind or light are being changed; false too where the oldest steps left were
    /// freed to bound the history's memory.
    [[nodiscard]] bool canUndo() const;
    /// The tiles that only the history holds; 1 GiB unless set. The newest step can always be undone.
    void setUndoBudget(std::size_t bytes);
    [[nodiscard]] bool modified() const; ///< Since the last markSaved().
    void markSaved();
    /// Puts another project in place of this one; clears the history.
    void replace(Project project);

    /// The map with all visible layers (and a running preview) applied: `spec.valueChannels` channels.
    [[nodiscard]] std::shared_ptr<const sim::TiledRaster> resolved(Id group, MapKind map) const;
    /// Grows with every change, previews too; frames of hair name the one they show.
    [[nodiscard]] std::uint64_t revision() const;
    /// Everything the simulation needs, sharing tiles.
    [[nodiscard]] sim::GroomInput groomInput() const;

    /// Runs `edit` on the content and tells of `change`; re-resolves what it names. For undo commands and previews
    /// only: everybody else pushes a command.
    void apply(const Change& change, const std::function<void(Project&)>& edit);

    /// Previews (a hovered preset, a slider being dragged, a running stroke): `edit` runs on a copy-on-write copy of
    /// the committed content; a further preview replaces the first. commit... ends with the copy thrown away, then the
    /// command that gives the same bytes is pushed.
    void setPreview(const Change& change, const std::function<void(Project&)>& edit);
    void clearPreview();
    /// The preview of a running stroke: these tiles in place of the layer's, all others as they are. Work in proportion
    /// to the tiles. A preview of another kind or layer is dropped first.
    void previewTiles(const LayerAddress& address, const std::vector<std::pair<int, sim::RasterTilePtr>>& tiles);
    [[nodiscard]] bool previewing() const;
    /// The content without any preview; what files are written from.
    [[nodiscard]] const Project& committed() const;

Q_SIGNALS:
    void changed(const hairpaint::model::Change& change);
    void modifiedChanged(bool modified);
    /// Somebody other than the stroke changes the document: the stroke must end. `undoing`: it is cancelled, else
    /// committed.
    void strokeMustEnd(bool undoing);
    /// After undo() or redo() took the step of that name.
    void undone(const QString& name);
    void redone(const QString& name);

public:
    /// Undo and redo as the user means them: a running stroke is cancelled by undo, committed by anything else. Wind or
    /// light that are being changed are all that undo takes back.
    void undo();
    void redo();
    /// Pushes after ending what is running. Null is ignored.
    void push(std::unique_ptr<QUndoCommand> command);

private:
    struct State;
    void tell(Change change, bool preview);
    void dropPreview();

    std::unique_ptr<State> m_state;
};

} // namespace hairpaint::model
