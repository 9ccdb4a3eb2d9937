// The textures of what is worn as images that files name.
#pragma once

#include "model/exporting/side_files.h"
#include "model/exporting/worn_body.h"

#include <QByteArray>
#include <QString>

#include <memory>
#include <span>
#include <vector>

namespace hairpaint::model {

/// Each texture once, in the order of bodies. Any thread.
class WornImages
{
public:
    /// Their names are `base`-worn-1.png and so on.
    WornImages(std::span<const WornBody> bodies, QString base);

    [[nodiscard]] QString nameOf(const WornBody& body) const; ///< Empty where it has no texture.
    [[nodiscard]] std::vector<SideFile> files() const;        ///< PNG, by their names alone.
    [[nodiscard]] std::vector<SideFile> filesBeside(const QString& path) const;

private:
    [[nodiscard]] QString nameAt(std::size_t index) const;

    QString m_base;
    std::vector<std::shared_ptr<const sim::MeshTexture>> m_textures;
};

} // namespace hairpaint::model
