// Cut, copy, paste and clear: see the header.
#include "app/clip_commands.h"

namespace hairpaint::app {

ClipCommands::ClipCommands(Session& session) : m_session(session) {}

void ClipCommands::copy()
{
    m_session.document().endEdit(); // What is cut is what is there then.
    m_clip = model::copyClip(m_session.document(), m_session.editor().target(), m_session.editor().selection());
    Q_EMIT told(tr("Copied from %1").arg(model::mapSpec(m_clip->map).titleText()));
}

void ClipCommands::cut()
{
    copy();
    clearSelected(tr("Cut %1"));
}

void ClipCommands::paste()
{
    if (!m_clip) {
        Q_EMIT told(tr("Nothing was copied yet: select a part of a map and copy it first"));
        return;
    }
    m_session.document().push(model::pasteCommand(m_session.document(), m_session.editor().target(), *m_clip,
                                                  m_session.editor().selection()));
}

void ClipCommands::clear()
{
    clearSelected(tr("Clear %1"));
}

void ClipCommands::clearSelected(const QString& text)
{
    const model::LayerAddress target = m_session.editor().target();
    m_session.document().push(model::clearCommand(m_session.document(), target, m_session.editor().selection(),
                                                  text.arg(model::mapSpec(target.map).titleText())));
}

} // namespace hairpaint::app
