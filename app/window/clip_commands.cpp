// Cut, copy, paste, fill and clear: see the header.
#include "app/window/clip_commands.h"

#include "app/window/clip_data.h"
#include "model/maps/texel_ops.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QMimeData>
#include <QUrl>
#include <QUuid>

namespace hairpaint::app {

namespace {

constexpr const char* kMarkFormat = "application/x-hairpaint-copy";

} // namespace

ClipCommands::ClipCommands(Session& session, MapExchange& maps) : m_session(session), m_maps(maps) {}

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
    if (!takeClipboard())
        return;
    if (!m_clip) {
        Q_EMIT told(tr("Nothing was copied yet: select a part of a map and copy it first"));
        return;
    }
    lay(*m_clip);
}

void ClipCommands::take(const Dropped& dropped)
{
    if (!dropped.files.isEmpty()) {
        Q_EMIT filesWanted(dropped.files);
    } else if (!dropped.picture.isNull()) {
        if (const std::optional<model::Clip> clip = m_maps.clipFrom(dropped.picture))
            lay(*clip);
    } else if (dropped.isOnTheWeb) {
        Q_EMIT told(webText());
    }
}

void ClipCommands::lay(const model::Clip& clip)
{
    if (mayChange())
        m_session.document().push(model::pasteCommand(m_session.document(), m_session.editor().target().address(), clip,
                                                      m_session.editor().tools().selection()));
}

void ClipCommands::fill()
{
    if (!mayChange())
        return;
    view::EditorState& editor = m_session.editor();
    const model::LayerAddress target = editor.target().address();
    const model::MapSpec& spec = model::mapSpec(target.map);
    sim::Texel texel = model::texelOf(spec, editor.tools().settings().value(target.map));
    texel[static_cast<std::size_t>(spec.valueChannels)] = 65535;
    m_session.document().push(model::fillCommand(m_session.document(), target, editor.tools().selection(), texel,
                                                 tr("Fill %1").arg(spec.titleText())));
}

void ClipCommands::offerImage()
{
    m_mark = QUuid::createUuid().toByteArray();
    auto* data = new QMimeData; // The clipboard's from now on.
    data->setData(QLatin1String(kMarkFormat), m_mark);
    if (const QByteArray bytes = bytesFromClip(*m_clip); !bytes.isEmpty())
        data->setData(QLatin1String(kClipFormat), bytes);
    if (const QImage image = model::imageFromClip(*m_clip); !image.isNull())
        data->setImageData(image);
    QGuiApplication::clipboard()->setMimeData(data);
}

bool ClipCommands::takeClipboard()
{
    const QMimeData* data = QGuiApplication::clipboard()->mimeData();
    const bool isOurs = data != nullptr && !m_mark.isEmpty() && data->data(QLatin1String(kMarkFormat)) == m_mark;
    if (data == nullptr || isOurs || data->formats().isEmpty())
        return true;
    if (std::optional<model::Clip> clip = clipFromBytes(data->data(QLatin1String(kClipFormat)))) {
        m_clip = std::move(clip);
        return true;
    }
    m_clip.reset(); // Older than what is there now.
    QStringList paths;
    for (const QUrl& url : data->urls())
        if (url.isLocalFile())
            paths += url.toLocalFile();
    if (!paths.isEmpty()) {
        Q_EMIT filesWanted(paths);
        return false;
    }
    const QImage image = data->hasImage() ? qvariant_cast<QImage>(data->imageData()) : QImage();
    if (!image.isNull()) {
        m_clip = m_maps.clipFrom(image);
        return m_clip.has_value();
    }
    Q_EMIT told(data->hasText() ? tr("The clipboard holds text, which no map can take; copy a picture or a file")
                                : tr("The clipboard holds nothing that a map can take (%1); copy a picture or a file")
                                      .arg(data->formats().constFirst()));
    return false;
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
