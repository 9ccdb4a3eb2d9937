// Drawing styles in the background: see the header.
#include "app/styles/style_pictures.h"

#include "app/headless/picture.h"
#include "app/headless/settled_hair.h"
#include "app/styles/library.h"
#include "model/disk/own_folder.h"
#include "model/files/head_file.h"
#include "model/files/preset_file.h"
#include "model/files/project_file.h"
#include "model/project/worn.h"
#include "model/styles/style_transfer.h"
#include "model/styles/style_use.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

#include <glm/geometric.hpp>

#include <numbers>
#include <utility>

namespace hairpaint::app {

namespace {

constexpr QSize kPictureSize(192, 192);
constexpr QSize kWholeSize(480, 480);
constexpr QRect kHeadPart(105, 18, 276, 276); ///< The part of the whole picture that is kept, without the bust's foot.
/// Least cosine between the directions from the head's middle to a tie and to the eye at which the tie is seen.
constexpr float kHiddenCosine = -0.1F;
constexpr int kSteps = 10;
constexpr double kStepSeconds = 0.2;
constexpr qsizetype kMostKept = 500; ///< Pictures in the cache.
constexpr qint64 kMostCachedBytes = 1 << 22;

QString cacheFolder()
{
    return QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + QStringLiteral("/style-pictures");
}

/// A cache that takes nothing costs no more than drawing again.
void keep(const QImage& picture, const QString& path)
{
    QDir folder(cacheFolder());
    if (!folder.mkpath(QStringLiteral(".")))
        return;
    if (const std::optional<model::OwnFolder> own = model::OwnFolder::open(cacheFolder())) {
        const QString name = QFileInfo(path).fileName();
        const std::optional<model::OwnEntry> before = own->entry(name);
        if (before && before->kind == model::OwnEntry::Kind::Other)
            own->remove(name); // Not through a link to what it leads to.
    }
    if (!writePicture(picture, path))
        return;
    const QStringList newestFirst = folder.entryList({QStringLiteral("*.png")}, QDir::Files, QDir::Time);
    for (const QString& old : newestFirst.mid(kMostKept))
        folder.remove(old);
}

/// From ahead, unless all that hair is tied with lies behind the head, where it would hardly be seen.
rendering::Camera cameraOf(const model::Project& project)
{
    rendering::Camera camera =
        rendering::standardCamera(rendering::StandardView::ThreeQuarter, project.head->skin->mesh());
    const glm::vec3 towardEye = glm::normalize(camera.eyeWo() - camera.targetWo);
    bool isTied = false;
    bool isSeen = false;
    for (const model::Worn& one : project.worn) {
        if (!model::wornSpec(one.kind).tie)
            continue;
        isTied = true;
        const glm::vec3 from = one.shape.centreHd - camera.targetWo;
        isSeen = isSeen || glm::dot(from, towardEye) > kHiddenCosine * glm::length(from);
    }
    if (isTied && !isSeen)
        camera.azimuthRad = std::numbers::pi_v<float> - camera.azimuthRad;
    return camera;
}

/// Two calm seconds, less the step that it began with; false where it is stopped.
bool settle(SettledHair& hair, const model::Progress& progress)
{
    for (int step = 1; step < kSteps; ++step) {
        if (progress && !progress(static_cast<double>(step) / kSteps))
            return false;
        hair.advance(kStepSeconds);
    }
    return true;
}

QImage settledPicture(model::Project project, PictureMaker& maker, const model::Progress& progress)
{
    project.wind.enabled = false;
    SettledHair hair(project, kStepSeconds);
    if (!settle(hair, progress))
        return {};
    return stylePicture(project, hair.frame(), maker, progress);
}

QImage drawStyle(const model::Preset& preset, const model::Progress& progress)
{
    PictureMaker maker;
    return stylePicture(preset, maker, progress);
}

QImage pictureOfFile(const QString& path, const StylePictures::Draw& draw, const model::Progress& progress)
{
    const QString name = styleContentName(path);
    const QString cached = cacheFolder() + QLatin1Char('/') + model::defaultHead()->name + QLatin1Char('-') + name +
                           QStringLiteral(".png");
    if (!name.isEmpty())
        if (const auto bytes = model::contentOfOrdinaryFile(cached, kMostCachedBytes)) // No pipe keeps it waiting.
            if (const QImage known = QImage::fromData(*bytes, "PNG"); !known.isNull())
                return known;
    const model::Result<model::Preset> preset = loadStyle(path);
    if (!preset || !progress(0.0))
        return {};
    const QImage picture = draw(*preset, progress);
    if (picture.isNull() || styleContentName(path) != name)
        return {};
    if (!name.isEmpty())
        keep(picture, cached);
    return picture;
}

} // namespace

QImage stylePicture(const model::Preset& preset, PictureMaker& maker, const model::Progress& progress)
{
    model::Project project = model::newProject();
    const std::optional<model::Preset> carried = model::carriedPreset(preset, project.head, progress);
    if (!carried)
        return {};
    model::applyPreset(project, *carried);
    return settledPicture(std::move(project), maker, progress);
}

QImage stylePictureFrom(const model::Preset& preset, model::Project project, const rendering::Camera& camera,
                        const model::Progress& progress)
{
    const std::optional<model::Preset> carried = model::carriedPreset(preset, project.head, progress);
    if (!carried)
        return {};
    project.groups.clear();
    std::erase_if(project.worn, [](const model::Worn& one) { return one.group != 0; });
    model::applyPreset(project, *carried);
    project.wind.enabled = false;
    SettledHair hair(project, kStepSeconds);
    if (!settle(hair, progress))
        return {};
    PictureMaker maker;
    const model::Result<QImage> picture = maker.take(project, hair.frame(), camera, kPictureSize * 2, progress);
    return picture ? picture->scaled(kPictureSize, Qt::IgnoreAspectRatio, Qt::SmoothTransformation) : QImage();
}

QImage projectPicture(const model::Project& project, const model::Progress& progress)
{
    PictureMaker maker;
    return settledPicture(project, maker, progress);
}

QImage stylePicture(const model::Project& project, std::shared_ptr<const sim::StrandFrame> frame, PictureMaker& maker,
                    const model::Progress& progress)
{
    const model::Result<QImage> whole = maker.take(project, std::move(frame), cameraOf(project), kWholeSize, progress);
    if (!whole)
        return {};
    return whole->copy(kHeadPart).scaled(kPictureSize, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

StylePictures::StylePictures(Jobs& jobs, Draw draw, QObject* parent)
    : QObject(parent), m_jobs(jobs), m_draw(draw ? std::move(draw) : drawStyle)
{}

void StylePictures::make(const QString& path)
{
    if (!m_wanted.contains(path))
        m_wanted.append(path);
    next();
}

void StylePictures::forget()
{
    m_wanted.clear();
    m_forgotten = m_busy;
}

void StylePictures::next()
{
    if (m_busy || m_wanted.isEmpty())
        return;
    m_busy = true;
    const QString path = m_wanted.takeFirst();
    m_jobs.start<QImage>(
        tr("Drawing the style %1").arg(QFileInfo(path).fileName()),
        [path, draw = m_draw](const model::Progress& progress) -> model::Result<QImage> {
            return pictureOfFile(path, draw, progress);
        },
        this,
        [this, path](const model::Result<QImage>& picture) {
            m_busy = false;
            // Without one the tile shows a sign; that is not worth a sentence.
            if (!std::exchange(m_forgotten, false) && picture && !picture->isNull())
                Q_EMIT made(path, *picture);
            next();
        });
}

} // namespace hairpaint::app
