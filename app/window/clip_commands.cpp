// Cut, copy, paste, fill and clear: see the header.
#include "app/window/clip_commands.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QMimeData>
#include <QUuid>

namespace hairpaint::app {

namespace {

constexpr const char* kMarkFormat = "application/x-hairpaint-copy";

} // namespace

ClipCommands::ClipCommands(Session& session) : m_session(session) {}

void ClipCommands::copy()
{
    m_session.document().endEdit(); // What is cut is what is there then.
    m_clip = model::copyClip(m_session.document(), m_session.editor().target().address(),
                             m_session.editor().tools().selection());
    offerImage();
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
    if (std::optional<model::Clip> foreign = foreignClip())
        m_clip = std::move(foreign);
    if (!m_clip) {
        Q_EMIT told(tr("Nothing was copied yet: select a part of a map and copy it first"));
        return;
    }
    if (mayChange())
        m_session.document().push(model::pasteCommand(m_session.document(), m_session.editor().target().address(),
                                                      *m_clip, m_session.editor().tools().selection()));
}

void ClipCommands::fill()
{
    if (!mayChange())
        return;
    view::EditorState& editor = m_session.editor();
    const model::LayerAddress target = editor.target().address();
    const model::MapSpec& spec = model::mapSpec(target.map);
    sim::Texel texel = editor.tools().settings().value(target.map).texel(spec);
    texel[static_cast<std::size_t>(spec.valueChannels)] = 65535;
    m_session.document().push(model::fillCommand(m_session.document(), target, editor.tools().selection(), texel,
                                                 tr("Fill %1").arg(spec.titleText())));
}

void ClipCommands::offerImage()
{
    m_mark = QUuid::createUuid().toByteArray();
    auto* data = new QMimeData; // The clipboard's from now on.
    data->setData(QLatin1String(kMarkFormat), m_mark);
    if (const QImage image = model::imageFromClip(*m_clip); !image.isNull())
        data->setImageData(image);
    QGuiApplication::clipboard()->setMimeData(data);
}

std::optional<model::Clip> ClipCommands::foreignClip() const
{
    const QMimeData* data = QGuiApplication::clipboard()->mimeData();
    const bool isOurs = data != nullptr && !m_mark.isEmpty() && data->data(QLatin1String(kMarkFormat)) == m_mark;
    if (data == nullptr || isOurs || !data->hasImage())
        return std::nullopt;
    const model::LayerAddress target = m_session.editor().target().address();
    const model::HairGroup* group = m_session.document().committed().group(target.group);
    const auto image = qvariant_cast<QImage>(data->imageData());
    if (group == nullptr || image.isNull())
        return std::nullopt;
    const QRectF area = m_session.editor().tools().selection().rectangle().value_or(QRectF(0.0, 0.0, 1.0, 1.0));
    return model::clipFromImage(image, target.map, group->map(target.map).size, area);
}

void ClipCommands::clear()
{
    if (mayChange())
        clearSelected(tr("Clear %1"));
}

bool ClipCommands::mayChange()
{
    return m_session.editor().tools().mayPaint({m_session.editor().target().map()});
}

void ClipCommands::clearSelected(const QString& text)
{
    const model::LayerAddress target = m_session.editor().target().address();
    m_session.document().push(model::clearCommand(m_session.document(), target, m_session.editor().tools().selection(),
                                                  text.arg(model::mapSpec(target.map).titleText())));
}

} // namespace hairpaint::app
