// A step of the history that was read from a journal.
#pragma once

#include "model/document/document.h"

#include <QUndoCommand>

#include <memory>

namespace hairpaint::model {

/// Holds the content before and after, not the edit between them. `dormant`: while it is true, pushing,
/// undoing and redoing the step changes nothing, since the content is there already.
class RestoredStep : public QUndoCommand
{
public:
    RestoredStep(Document& document, const QString& text, Project before, Project after,
                 std::shared_ptr<const bool> dormant);

    void undo() override;
    void redo() override;

private:
    void put(const Project& from, const Project& to);

    Document& m_document;
    Project m_before;
    Project m_after;
    std::shared_ptr<const bool> m_dormant;
};

} // namespace hairpaint::model
