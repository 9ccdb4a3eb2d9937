// The undo command behind every change but painting: it runs an edit once and keeps what the edit changed.
#pragma once

#include "model/commands/commands.h"

#include <functional>

namespace hairpaint::model {

/// `Slice` is a value type with
///   static Slice take(const Project&, const Change&)  - copies the part that such a change may touch;
///   void put(Project&, const Change&) const           - puts it back.
/// The history is linear, so putting back the slices gives exactly the content of before and after. Slices share tiles.
template<typename Slice>
class SliceCommand : public QUndoCommand
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

private:
    Document& m_document;
    Change m_change;
    Edit m_edit; ///< Until it ran.
    std::optional<Slice> m_before, m_after;
};

} // namespace hairpaint::model
