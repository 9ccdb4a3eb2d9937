// Pictures without a window: see the header.
#include "app/picture.h"

#include "view/rendering/software/software_renderer.h"
#include "view/scene_light.h"

#include "model/files/atomic_file.h"

#include <QBuffer>
#include <QCoreApplication>

#include <algorithm>

namespace hairpaint::app {

namespace {

constexpr int kLargestFinePx = 4096; ///< Larger pictures have one sample a pixel, for want of memory.
constexpr std::size_t kSketchedHairs = 20'000;

} // namespace

PictureMaker::PictureMaker() : m_renderer(std::make_unique<rendering::SoftwareRenderer>()) {}

model::Result<QImage> PictureMaker::take(const model::Project& project, std::shared_ptr<const sim::StrandFrame> frame,
                                         const rendering::Camera& camera, QSize size, const model::Progress& progress)
{
    return take({.head = project.head->shownMesh,
                 .headInMotion = {},
                 .hair = std::move(frame),
                 .camera = camera,
                 .light = view::sceneLight(project.light),
                 .skin = view::sceneSkin(project.skin),
                 .background = view::linearColour(project.background),
                 .ring = {},
                 .mirroredRing = {}},
                size, progress);
}

model::Result<QImage> PictureMaker::take(const rendering::Scene& scene, QSize size, const model::Progress& progress)
{
    return draw(scene, 1.0F, size, progress);
}

model::Result<QImage> PictureMaker::sketch(const rendering::Scene& scene, QSize size, const model::Progress& progress)
{
    const std::size_t hairs = scene.hair ? scene.hair->hairCount : 0;
    return draw(scene, hairs > kSketchedHairs ? static_cast<float>(kSketchedHairs) / static_cast<float>(hairs) : 1.0F,
                size, progress);
}

model::Result<QImage> PictureMaker::draw(const rendering::Scene& scene, float detail, QSize size,
                                         const model::Progress& progress)
{
    rendering::Quality quality = rendering::pictureQuality();
    quality.detail = detail;
    if (std::max(size.width(), size.height()) > kLargestFinePx)
        quality.samples = 1;
    if (!m_renderer->drawPatiently(scene, quality, size.width(), size.height(), progress))
        return model::failure(QCoreApplication::translate("Picture", "Drawing the picture was cancelled."));
    std::vector<std::uint8_t> pixels;
    m_renderer->read(pixels);
    return QImage(pixels.data(), size.width(), size.height(), size.width() * 4, QImage::Format_RGBA8888)
        .convertToFormat(QImage::Format_RGB888);
}

model::Result<void> writePicture(const QImage& picture, const QString& path)
{
    // Into memory first: libpng would tell of a full disk on standard error, in a line of its own.
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    if (!picture.save(&buffer, "PNG"))
        return model::cannotWrite(path, {.text = QCoreApplication::translate("Picture", "there is no picture")});
    if (const model::Checked<void> written = model::writeFile(path, bytes); !written)
        return model::cannotWrite(path, written.error());
    return {};
}

} // namespace hairpaint::app
