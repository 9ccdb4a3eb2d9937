// The undo command behind every change but painting: it runs an edit once and keeps what the edit changed.
#pragma once

#include "model/commands/commands.h"
#include "model/commands/undo_budget.h"

#include <functional>
#include <optional>

namespace hairpaint::model {

/// For slices that hold layers.
inline void visitTilesOf(const std::vector<Layer>& layers, const TileHolder::Visit& visit)
{
    for (const Layer& layer : layers)
        for (int index = 0; index < layer.raster.tileCount(); ++index)
            visit(layer.raster.tile(index));
}

/// `Slice` is a value type with
///   static Slice take(const Project&, const Change&)  - copies the part that such a change may touch;
///   void put(Project&, const Change&) const           - puts it back;
///   void visitTiles(const TileHolder::Visit&) const   - only where it holds rasters.
/// The history is linear, so putting back the slices gives exactly the content of before and after. Slices share tiles.
template<typename Slice>
class SliceCommand : public QUndoCommand, public TileHolder
{
public:
    using Edit = std::function<void(Project&)>;

    SliceCommand(Document& document, Change change, const QString& text, Edit edit)
        : QUndoCommand(text), m_document(document), m_change(std::move(change)), m_edit(std::move(edit))
    {}

    void redo() override
    {
        m_document.apply(m_change, [this](Project& project) {
            if (m_edit == nullptr) {
                m_after->put(project, m_change);
                return;
            }
            m_before = Slice::take(project, m_change);
            m_edit(project);
            m_edit = nullptr;
            m_after = Slice::take(project, m_change);
        });
    }
    void undo() override
    {
        m_document.apply(m_change, [this](Project& project) { m_before->put(project, m_change); });
    }

    void visitTiles(const Visit& visit) const override
    {
        if constexpr (requires(const Slice& slice) { slice.visitTiles(visit); }) {
            for (const std::optional<Slice>* slice : {&m_before, &m_after})
                if (*slice)
                    (*slice)->visitTiles(visit);
        }
    }
    void release() override
    {
        m_before.reset();
        m_after.reset();
    }

private:
    Document& m_document;
    Change m_change;
    Edit m_edit; ///< Until it ran.
    std::optional<Slice> m_before, m_after;
};

} // namespace hairpaint::model
