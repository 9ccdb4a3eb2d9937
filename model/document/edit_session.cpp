// The owner's end of a running edit; the document holds what it shows.
#include "model/document/edit_session.h"

#include "model/document/document.h"

namespace hairpaint::model {

EditSession::EditSession(Document& document, std::uint64_t number) : m_document(&document), m_number(number) {}

EditSession::EditSession(EditSession&& other) noexcept
    : m_document(std::exchange(other.m_document, nullptr)), m_number(std::exchange(other.m_number, 0))
{}

EditSession& EditSession::operator=(EditSession&& other) noexcept
{
    if (this != &other) {
        drop();
        m_document = std::exchange(other.m_document, nullptr);
        m_number = std::exchange(other.m_number, 0);
    }
    return *this;
}

EditSession::~EditSession()
{
    drop();
}

bool EditSession::active() const
{
    return m_document != nullptr && m_document->runs(m_number);
}

void EditSession::preview(const Change& change, const std::function<void(Project&)>& edit)
{
    if (active())
        m_document->preview(change, edit);
}

void EditSession::previewTiles(const LayerAddress& address, const LayerTiles& tiles)
{
    if (active())
        m_document->previewTiles(address, tiles);
}

void EditSession::commit()
{
    if (active())
        m_document->commitEdit();
}

void EditSession::setText(const QString& text)
{
    if (active())
        m_document->setEditText(text);
}

void EditSession::drop()
{
    if (active())
        m_document->dropEdit();
}

} // namespace hairpaint::model
