// Drawing styles in the background: see the header.
#include "app/style_pictures.h"

#include "app/cli/settled_hair.h"
#include "app/library.h"
#include "app/picture.h"
#include "model/commands/commands.h"
#include "model/files/preset_file.h"
#include "model/files/project_file.h"

namespace hairpaint::app {

namespace {

constexpr QSize kPictureSize(192, 192);
constexpr QSize kWholeSize(480, 480);
constexpr QRect kHeadPart(105, 18, 276, 276); ///< Of the whole picture: the bust's foot is no hair.
constexpr int kSteps = 10;
constexpr double kStepSeconds = 0.2;

} // namespace

QImage stylePicture(const model::Preset& preset, PictureMaker& maker, const std::function<bool()>& cancelled)
{
    model::Project project = model::newProject();
    model::applyPreset(project, preset);
    project.wind.enabled = false;
    SettledHair hair(project, kStepSeconds);
    for (int step = 1; step < kSteps; ++step) {
        if (cancelled && cancelled())
            return {};
        hair.advance(kStepSeconds);
    }
    const model::Result<QImage> whole = maker.take(
        project, hair.frame(),
        rendering::standardCamera(rendering::StandardView::ThreeQuarter, project.head->skin->mesh()), kWholeSize);
    if (!whole)
        return {};
    return whole->copy(kHeadPart).scaled(kPictureSize, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

StylePictures::StylePictures(QObject* parent) : QObject(parent)
{
    m_threads.setMaxThreadCount(1);
}

StylePictures::~StylePictures()
{
    m_stop = true;
    m_threads.clear();
    m_threads.waitForDone();
}

void StylePictures::make(const QString& path)
{
    m_threads.start([this, path] { work(path); });
}

void StylePictures::work(const QString& path)
{
    model::Result<model::Preset> preset = loadStyle(path);
    if (m_stop || !preset)
        return;
    const model::Result<std::unique_ptr<PictureMaker>> maker = PictureMaker::create();
    if (!maker)
        return;
    preset->picture = stylePicture(*preset, **maker, [this] { return m_stop.load(); });
    if (preset->picture.isNull())
        return;
    // Another picture is drawn next time where the folder takes none.
    if (path != baldStylePath())
        (void)model::savePreset(*preset, path);
    QMetaObject::invokeMethod(
        this, [this, path, picture = preset->picture] { Q_EMIT made(path, picture); }, Qt::QueuedConnection);
}

} // namespace hairpaint::app
