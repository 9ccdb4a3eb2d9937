// Whole contents put back, told of by what differs.
#include "model/document/restored_step.h"

#include <utility>

namespace hairpaint::model {

RestoredStep::RestoredStep(Document& document, const QString& text, Project before, Project after,
                           std::shared_ptr<const bool> dormant)
    : QUndoCommand(text), m_document(document), m_before(std::move(before)), m_after(std::move(after)),
      m_dormant(std::move(dormant))
{}

void RestoredStep::undo()
{
    put(m_after, m_before);
}

void RestoredStep::redo()
{
    put(m_before, m_after);
}

void RestoredStep::put(const Project& from, const Project& to)
{
    if (*m_dormant)
        return;
    if (from.head != to.head)
        m_document.apply({.aspect = Change::Aspect::Head}, [&to](Project& project) { project.head = to.head; });
    m_document.apply({.aspect = Change::Aspect::GroupList}, [&to](Project& project) {
        project.groups = to.groups;
        project.nextId = to.nextId;
    });
    m_document.apply({.aspect = Change::Aspect::Environment}, [&to](Project& project) {
        project.wind = blowingAs(project.wind, to.wind);
        project.light = to.light;
        project.background = to.background;
        project.skin = to.skin;
        project.worn = to.worn;
    });
}

} // namespace hairpaint::model
