// Pictures of a project without a window.
#pragma once

#include "model/error.h"
#include "model/files/project_file.h"
#include "model/project.h"
#include "view/rendering/backend.h"
#include "view/rendering/standard_views.h"

#include <QImage>

namespace hairpaint::app {

/// Needs no OpenGL: the same bytes on every machine. One thread.
class PictureMaker
{
public:
    PictureMaker();

    /// Every hair, four samples a pixel where that fits. Fails where it is stopped.
    [[nodiscard]] model::Result<QImage> take(const model::Project& project,
                                             std::shared_ptr<const sim::StrandFrame> frame,
                                             const rendering::Camera& camera, QSize size,
                                             const model::Progress& progress = {});
    /// Any scene in the same quality.
    [[nodiscard]] model::Result<QImage> take(const rendering::Scene& scene, QSize size,
                                             const model::Progress& progress = {});
    /// Quicker, for small pictures: as many hairs as can be told apart in them.
    [[nodiscard]] model::Result<QImage> sketch(const rendering::Scene& scene, QSize size,
                                               const model::Progress& progress = {});

private:
    [[nodiscard]] model::Result<QImage> draw(const rendering::Scene& scene, float detail, QSize size,
                                             const model::Progress& progress);

    std::unique_ptr<rendering::Backend> m_renderer;
};

/// Writes a PNG whole or not at all.
[[nodiscard]] model::Result<void> writePicture(const QImage& picture, const QString& path);

} // namespace hairpaint::app
