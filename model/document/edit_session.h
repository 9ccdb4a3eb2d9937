// A running edit of the document: what a tool, a slider or a hovered style shows before it is kept.
#pragma once

#include "model/project/change.h"
#include "sim/base/tiled_raster.h"

#include <QPointer>
#include <QString>

#include <functional>
#include <utility>
#include <vector>

namespace hairpaint::model {

class Document;
struct Project;

/// What becomes of a running edit when another one begins or a command is made. Undo drops it in both cases.
enum class EditPolicy : std::uint8_t
{
    Commit, ///< The user changes something: nothing of it may be lost.
    Drop    ///< The user only looks: a hovered style.
};

/// What the document needs to know of an edit.
struct EditOwner
{
    EditPolicy policy = EditPolicy::Commit;
    QString text = {}; ///< What undo says of it: "Brush on Length".
    /// Called by undo while it runs: reverts its last part and returns true. If it returns false, or is empty, the
    /// whole edit is dropped.
    std::function<bool()> stepBack = {};
};

using LayerTiles = std::vector<std::pair<int, sim::RasterTilePtr>>; ///< Tile index and content.

/// Active from Document::begin() until commit(), drop(), its destruction (which drops it), or until another edit ends
/// it by its policy. Only one is active at a time. An inactive one does nothing. It may touch any layers
/// and parts. GUI thread.
class EditSession
{
public:
    EditSession() = default;
    EditSession(EditSession&& other) noexcept; ///< `other` is not active after it.
    EditSession& operator=(EditSession&& other) noexcept;
    ~EditSession();

    [[nodiscard]] bool active() const;

    /// Shows `edit`, run on the committed content; it may touch what `change` says and nothing else. Replaces what this
    /// session showed before of the same part; its other parts stay.
    void preview(const Change& change, const std::function<void(Project&)>& edit);
    /// Shows these tiles instead of a committed layer's, all others as they are. Work in proportion to the tiles.
    void previewTiles(const LayerAddress& address, const LayerTiles& tiles);

    /// What is shown becomes one step of the history, with the same bytes; none where nothing differs.
    void commit();
    void setText(const QString& text); ///< What undo will say of it instead.
    void drop();

private:
    friend class Document;
    EditSession(Document& document, std::uint64_t number);

    QPointer<Document> m_document;
    std::uint64_t m_number = 0;
};

} // namespace hairpaint::model
