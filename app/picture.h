// Pictures of a project without a window.
#pragma once

#include "model/error.h"
#include "model/files/project_file.h"
#include "model/project.h"
#include "view/rendering/offscreen_context.h"
#include "view/rendering/renderer.h"
#include "view/rendering/standard_views.h"

#include <QImage>

namespace hairpaint::app {

/// One thread.
class PictureMaker
{
public:
    [[nodiscard]] static model::Result<std::unique_ptr<PictureMaker>> create();

    /// Every hair, four samples, drawn twice as large where that fits and filtered down. Fails where the driver gives
    /// up.
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
    PictureMaker() = default;
    [[nodiscard]] model::Result<QImage> draw(const rendering::Scene& scene, float detail, QSize size, int scale,
                                             const model::Progress& progress);

    std::unique_ptr<rendering::OffscreenContext> m_context; ///< Outlives the renderer.
    std::unique_ptr<rendering::Renderer> m_renderer;
};

/// Writes a PNG whole or not at all.
[[nodiscard]] model::Result<void> writePicture(const QImage& picture, const QString& path);

} // namespace hairpaint::app
