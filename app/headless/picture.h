// Pictures of a project without a window.
#pragma once

#include "model/files/project_file.h"
#include "model/project/project.h"
#include "model/values/error.h"
#include "view/rendering/backend.h"
#include "view/rendering/standard_views.h"

#include <QImage>

namespace hairpaint::app {

inline constexpr int kLargestFinePx = 4096; ///< Pictures larger than that have one sample a pixel, for want of memory.

/// Pictures in linear light take twice the memory of others: so many pixels at most.
inline constexpr qint64 kMostLinearPixels = qint64{4096} * 4096;

/// How a picture that is kept is drawn.
struct PictureLook
{
    int samples = rendering::pictureQuality().samples; ///< Per pixel: 1, 4 or 16.
};

/// Needs no OpenGL: the same bytes on every machine. One thread.
class PictureMaker
{
public:
    PictureMaker();

    /// Draws the scene and writes it, by the name as PNG, as JPEG or as OpenEXR in linear light; whole or not at all. A
    /// JPEG can't be transparent: it shows the scene's background.
    [[nodiscard]] model::Result<void> save(const rendering::Scene& scene, QSize size, const PictureLook& look,
                                           const QString& path, const model::Progress& progress = {});
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
    [[nodiscard]] model::Result<void> drawOnly(const rendering::Scene& scene, rendering::Quality quality, QSize size,
                                               const model::Progress& progress);
    [[nodiscard]] model::Result<QImage> draw(const rendering::Scene& scene, const rendering::Quality& quality,
                                             QSize size, const model::Progress& progress);

    std::unique_ptr<rendering::Backend> m_renderer;
};

/// The scene of a project as pictures show it.
[[nodiscard]] rendering::Scene pictureScene(const model::Project& project,
                                            std::shared_ptr<const sim::StrandFrame> frame,
                                            const rendering::Camera& camera);
/// Writes a PNG, or a JPEG where the name says so, whole or not at all.
[[nodiscard]] model::Result<void> writePicture(const QImage& picture, const QString& path,
                                               const model::Progress& progress = {});
/// Whether a picture of that name is OpenEXR.
[[nodiscard]] bool isExr(const QString& path);
[[nodiscard]] bool isJpeg(const QString& path);

} // namespace hairpaint::app
