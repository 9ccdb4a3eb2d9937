// Named by a number, since what they were named where they come from is not kept.
#include "model/exporting/worn_images.h"

#include "model/files/glb_writing.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <utility>

namespace hairpaint::model {

WornImages::WornImages(std::span<const WornBody> bodies, QString base) : m_base(std::move(base))
{
    for (const WornBody& body : bodies)
        if (body.texture && std::ranges::find(m_textures, body.texture) == m_textures.end())
            m_textures.push_back(body.texture);
}

QString WornImages::nameAt(std::size_t index) const
{
    return QStringLiteral("%1-worn-%2.png").arg(m_base).arg(index + 1);
}

QString WornImages::nameOf(const WornBody& body) const
{
    const auto at = std::ranges::find(m_textures, body.texture);
    return body.texture ? nameAt(static_cast<std::size_t>(at - m_textures.begin())) : QString();
}

std::vector<SideFile> WornImages::files() const
{
    std::vector<SideFile> files;
    files.reserve(m_textures.size());
    for (std::size_t i = 0; i < m_textures.size(); ++i)
        files.push_back({.path = nameAt(i), .bytes = pngOfTexture(*m_textures[i])});
    return files;
}

std::vector<SideFile> WornImages::filesBeside(const QString& path) const
{
    std::vector<SideFile> beside = files();
    for (SideFile& file : beside)
        file.path = QFileInfo(path).dir().filePath(file.path);
    return beside;
}

} // namespace hairpaint::model
