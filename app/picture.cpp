// Pictures without a window: see the header.
#include "app/picture.h"

#include "view/gl_problem.h"
#include "view/scene_light.h"

#include "model/files/atomic_file.h"

#include <QBuffer>
#include <QCoreApplication>

namespace hairpaint::app {

namespace {

/// Larger pictures are drawn at their own size: memory, and no driver promises more than 16384.
constexpr int kLargestDoubledPx = 2048;
constexpr std::size_t kSketchedHairs = 20'000;

} // namespace

model::Result<std::unique_ptr<PictureMaker>> PictureMaker::create()
{
    std::unique_ptr<PictureMaker> maker(new PictureMaker);
    const auto failed = [](const std::string& why) {
        return model::failure(QCoreApplication::translate("Picture",
                                                          "No picture can be drawn: %1 Install a driver with "
                                                          "OpenGL 4.3 (Debian: libgl1-mesa-dri).")
                                  .arg(view::glProblem(why)));
    };
    auto context = rendering::OffscreenContext::create();
    if (!context)
        return failed(context.error());
    maker->m_context = std::move(*context);
    if (!maker->m_context->makeCurrent())
        return failed("The OpenGL driver refuses to draw.");
    auto renderer = rendering::Renderer::create();
    if (!renderer)
        return failed(renderer.error());
    maker->m_renderer = std::move(*renderer);
    return maker;
}

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
    return draw(scene, 1.0F, size, std::max(size.width(), size.height()) <= kLargestDoubledPx ? 2 : 1, progress);
}

model::Result<QImage> PictureMaker::sketch(const rendering::Scene& scene, QSize size, const model::Progress& progress)
{
    const std::size_t hairs = scene.hair ? scene.hair->hairCount : 0;
    return draw(scene, hairs > kSketchedHairs ? static_cast<float>(kSketchedHairs) / static_cast<float>(hairs) : 1.0F,
                size, 1, progress);
}

model::Result<QImage> PictureMaker::draw(const rendering::Scene& scene, float detail, QSize size, int scale,
                                         const model::Progress& progress)
{
    const QSize drawn = size * scale;
    const rendering::Quality quality{.detail = detail, .samples = 4, .smoothSegments = 12};
    if (!m_renderer->drawPatiently(scene, quality, drawn.width(), drawn.height(), progress))
        return model::failure(QCoreApplication::translate("Picture", "Drawing the picture was cancelled."));
    if (!m_renderer->statistics().complete)
        return model::failure(QCoreApplication::translate("Picture",
                                                          "No picture of %1 x %2 pixels can be drawn: the OpenGL "
                                                          "driver gave up, most likely for want of memory. Choose a "
                                                          "smaller size.")
                                  .arg(size.width())
                                  .arg(size.height()));
    std::vector<std::uint8_t> pixels;
    m_renderer->read(pixels);
    const QImage image(pixels.data(), drawn.width(), drawn.height(), drawn.width() * 4, QImage::Format_RGBA8888);
    return image.scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation).convertToFormat(QImage::Format_RGB888);
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
