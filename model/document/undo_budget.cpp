// A running sum of what the history holds, and the freeing of what does not fit.
#include "model/document/undo_budget.h"

#include <utility>

namespace hairpaint::model {

namespace {

TileHolder* holder(const QUndoStack& stack, int index)
{
    // The stack hands out const commands; releasing one changes nothing it knows of.
    return dynamic_cast<TileHolder*>(const_cast<QUndoCommand*>(stack.command(index)));
}

} // namespace

void UndoBudget::setLimit(QUndoStack& stack, std::size_t bytes)
{
    m_limit = bytes;
    enforce(stack);
}

void UndoBudget::pushed(QUndoStack& stack)
{
    const int newest = stack.count() - 1;
    // The push dropped what was undone.
    while (static_cast<int>(m_bytes.size()) > newest) {
        m_sum -= m_bytes.back();
        m_bytes.pop_back();
    }
    const TileHolder* command = holder(stack, newest);
    m_bytes.push_back(command != nullptr ? command->keptBytes() : 0);
    m_sum += m_bytes.back();
    enforce(stack);
}

void UndoBudget::enforce(QUndoStack& stack)
{
    if (stack.index() != stack.count())
        return; // Undone steps may be wanted again; the next push drops them.
    for (; m_sum > m_limit && m_floor < stack.count() - 1; ++m_floor) {
        if (TileHolder* command = holder(stack, m_floor))
            command->release();
        m_sum -= std::exchange(m_bytes[static_cast<std::size_t>(m_floor)], 0);
    }
}

void UndoBudget::reset()
{
    m_bytes.clear();
    m_sum = 0;
    m_floor = 0;
}

} // namespace hairpaint::model
