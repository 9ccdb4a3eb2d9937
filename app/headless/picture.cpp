// Pictures without a window: see the header.
#include "app/headless/picture.h"

#include "app/headless/exr_file.h"
#include "view/head_area/scene_light.h"

#include "model/disk/atomic_file.h"
#include "view/rendering/software/software_renderer.h"

#include <QBuffer>
#include <QCoreApplication>

#include <algorithm>

namespace hairpaint::app {

namespace {

constexpr std::size_t kSketchedHairs = 20'000;

} // namespace

PictureMaker::PictureMaker() : m_renderer(std::make_unique<rendering::SoftwareRenderer>()) {}

rendering::Scene pictureScene(const model::Project& project, std::shared_ptr<const sim::StrandFrame> frame,
                              const rendering::Camera& camera)
{
    std::vector<rendering::Solid> solids = view::sceneSolids(project.worn, project.head->skin.get());
    std::ranges::move(view::sceneParts(project.head.get()), std::back_inserter(solids));
    return {.head = project.head->shownMesh,
            .headInMotion = {},
            .hair = std::move(frame),
            .cards = {},
            .solids = std::move(solids),
            .camera = camera,
            .light = view::sceneLight(project.light),
            .skin = view::sceneSkin(project.skin),
            .skinTexture = view::sceneSkinTexture(project),
            .background = view::linearColour(project.background),
            .transparent = false,
            .ring = {},
            .mirroredRing = {}};
}

model::Result<QImage> PictureMaker::take(const model::Project& project, std::shared_ptr<const sim::StrandFrame> frame,
                                         const rendering::Camera& camera, QSize size, const model::Progress& progress)
{
    return take(pictureScene(project, std::move(frame), camera), size, progress);
}

model::Result<QImage> PictureMaker::take(const rendering::Scene& scene, QSize size, const model::Progress& progress)
{
    return draw(scene, rendering::pictureQuality(), size, progress);
}

model::Result<QImage> PictureMaker::sketch(const rendering::Scene& scene, QSize size, const model::Progress& progress)
{
    const std::size_t hairs = scene.hair ? scene.hair->hairCount : 0;
    rendering::Quality quality = rendering::pictureQuality();
    if (hairs > kSketchedHairs)
        quality.detail = static_cast<float>(kSketchedHairs) / static_cast<float>(hairs);
    return draw(scene, quality, size, progress);
}

model::Result<void> PictureMaker::drawOnly(const rendering::Scene& scene, rendering::Quality quality, QSize size,
                                           const model::Progress& progress)
{
    const rendering::Capabilities able = m_renderer->capabilities();
    Q_ASSERT(able.transparent && able.linear); // Pictures may ask for both.
    quality.samples =
        std::max(size.width(), size.height()) > kLargestFinePx ? 1 : std::min(quality.samples, able.mostSamples);
    if (!m_renderer->drawPatiently(scene, quality, size.width(), size.height(), progress))
        return model::failure(QCoreApplication::translate("Picture", "Drawing the picture was cancelled."));
    return {};
}

model::Result<QImage> PictureMaker::draw(const rendering::Scene& scene, const rendering::Quality& quality, QSize size,
                                         const model::Progress& progress)
{
    if (const model::Result<void> drawn = drawOnly(scene, quality, size, progress); !drawn)
        return tl::unexpected(drawn.error());
    std::vector<std::uint8_t> pixels;
    if (std::max(size.width(), size.height()) > kLargestFinePx)
        pixels = m_renderer->takePicture();
    else
        m_renderer->read(pixels); // Another of the kind may follow.
    const QImage drawn(pixels.data(), size.width(), size.height(), size.width() * 4, QImage::Format_RGBA8888);
    QImage picture = drawn.convertToFormat(scene.transparent ? QImage::Format_ARGB32 : QImage::Format_RGB888);
    constexpr int kDotsPerMetre = 2835; // 72 an inch; else the file would tell of this machine's screen.
    picture.setDotsPerMeterX(kDotsPerMetre);
    picture.setDotsPerMeterY(kDotsPerMetre);
    return picture;
}

model::Result<void> PictureMaker::save(const rendering::Scene& scene, QSize size, const PictureLook& look,
                                       const QString& path, const model::Progress& progress)
{
    rendering::Quality quality = rendering::pictureQuality();
    quality.samples = look.samples;
    quality.linear = isExr(path);
    if (!quality.linear) {
        rendering::Scene drawn = scene;
        drawn.transparent = drawn.transparent && !isJpeg(path);
        const model::Result<QImage> picture = draw(drawn, quality, size, progress);
        return picture ? writePicture(*picture, path, progress) : tl::unexpected(picture.error());
    }
    if (qint64{size.width()} * size.height() > kMostLinearPixels)
        return model::cannotWrite(
            path, {.text = QCoreApplication::translate("Picture", "pictures in linear light have at most %1 million "
                                                                  "pixels; choose a smaller size, or PNG")
                               .arg(kMostLinearPixels / 1'000'000)});
    if (model::Result<void> drawn = drawOnly(scene, quality, size, progress); !drawn)
        return drawn;
    return model::writeWanted(path, exrBytes(m_renderer->takeLinear(), size), progress);
}

model::Result<void> writePicture(const QImage& picture, const QString& path, const model::Progress& progress)
{
    // Into memory first: libpng would tell of a full disk on standard error, in a line of its own.
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    constexpr int kJpegQuality = 95;
    if (!(isJpeg(path) ? picture.save(&buffer, "JPG", kJpegQuality) : picture.save(&buffer, "PNG")))
        return model::cannotWrite(
            path, {.text = QCoreApplication::translate("Picture", "there is no picture of that size; choose another")});
    return model::writeWanted(path, bytes, progress);
}

bool isJpeg(const QString& path)
{
    return path.endsWith(QLatin1String(".jpg"), Qt::CaseInsensitive) ||
           path.endsWith(QLatin1String(".jpeg"), Qt::CaseInsensitive);
}

bool isExr(const QString& path)
{
    return path.endsWith(QLatin1String(".exr"), Qt::CaseInsensitive);
}

} // namespace hairpaint::app
