// Cut, copy, paste, fill and clear: see the header.
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
    if (!mayChange())
        return;
    copy();
    clearSelected(tr("Cut %1"));
}

void ClipCommands::paste()
{
    if (!m_clip) {
        Q_EMIT told(tr("Nothing was copied yet: select a part of a map and copy it first"));
        return;
    }
    if (mayChange())
        m_session.document().push(model::pasteCommand(m_session.document(), m_session.editor().target(), *m_clip,
                                                      m_session.editor().selection()));
}

void ClipCommands::fill()
{
    if (!mayChange())
        return;
    view::EditorState& editor = m_session.editor();
    const model::LayerAddress target = editor.target();
    const model::MapSpec& spec = model::mapSpec(target.map);
    sim::Texel texel = editor.toolSettings().value(target.map).texel(spec);
    texel[static_cast<std::size_t>(spec.valueChannels)] = 65535;
    m_session.document().push(model::fillCommand(m_session.document(), target, editor.selection(), texel,
                                                 tr("Fill %1").arg(spec.titleText())));
}

void ClipCommands::clear()
{
    if (mayChange())
        clearSelected(tr("Clear %1"));
}

bool ClipCommands::mayChange()
{
    return m_session.editor().mayPaint({m_session.editor().activeMap()});
}

void ClipCommands::clearSelected(const QString& text)
{
    const model::LayerAddress target = m_session.editor().target();
    m_session.document().push(model::clearCommand(m_session.document(), target, m_session.editor().selection(),
                                                  text.arg(model::mapSpec(target.map).titleText())));
}

} // namespace hairpaint::app
