// `hairpaint render`: pictures without a display.
#include "app/cli/command.h"
#include "app/cli/film.h"
#include "app/cli/interruption.h"
#include "app/cli/option_values.h"
#include "app/headless/picture.h"
#include "app/headless/settled_hair.h"
#include "model/disk/staged_files.h"
#include "model/files/project_file.h"
#include "model/values/sentences.h"
#include "view/head_area/stage.h"

#include <QFileInfo>
#include <QRegularExpression>

#include <algorithm>
#include <array>

namespace hairpaint::app {

namespace {

constexpr const char* kName = "render";

struct FreeCamera
{
    float azimuthRad = 0.0F;
    float elevationRad = 0.0F;
    std::optional<float> distanceM; ///< Else as far away as `fit` asks.
};

struct RenderOptions
{
    QSize size{1024, 1024};
    rendering::StandardView view = rendering::StandardView::ThreeQuarter;
    std::optional<FreeCamera> camera; ///< Instead of the view.
    rendering::Fit fit = rendering::Fit::Hair;
    bool transparent = false;
    PictureLook look;
    std::optional<model::SkinTone> skin;       ///< Else the project's.
    const model::LightPreset* light = nullptr; ///< Null: the project's.
    Film film;                                 ///< Else one picture.
};

/// Azimuth and elevation in degrees, and perhaps the distance in cm.
std::optional<FreeCamera> readCamera(const QString& text)
{
    constexpr float kPerDegree = 0.01745329252F;
    constexpr float kPerCm = 0.01F;
    const QStringList parts = text.split(QLatin1Char(','));
    std::array<float, 3> numbers{};
    if (parts.size() < 2 || parts.size() > 3)
        return std::nullopt;
    for (qsizetype i = 0; i < parts.size(); ++i) {
        bool isNumber = false;
        numbers.at(static_cast<std::size_t>(i)) = parts[i].toFloat(&isNumber);
        if (!isNumber)
            return std::nullopt;
    }
    const auto within = [](float value, float least, float most) { return value >= least && value <= most; };
    if (!within(numbers[0], -360.0F, 360.0F) || !within(numbers[1], -89.0F, 89.0F) ||
        (parts.size() == 3 && !within(numbers[2], 5.0F, 1000.0F)))
        return std::nullopt;
    FreeCamera camera{.azimuthRad = numbers[0] * kPerDegree, .elevationRad = numbers[1] * kPerDegree, .distanceM = {}};
    if (parts.size() == 3)
        camera.distanceM = numbers[2] * kPerCm;
    return camera;
}

/// The problem in words, or the options.
tl::expected<RenderOptions, QString> readOptions(const QCommandLineParser& parser)
{
    RenderOptions options;
    const QString size = parser.value(QStringLiteral("size"));
    if (!size.isEmpty()) {
        const auto match = QRegularExpression(QStringLiteral("^(\\d{2,4})x(\\d{2,4})$")).match(size);
        options.size = QSize(match.captured(1).toInt(), match.captured(2).toInt());
        if (!match.hasMatch() || options.size.width() < 16 || options.size.height() < 16 ||
            options.size.width() > 8192 || options.size.height() > 8192)
            return tl::unexpected(CommandLine::tr("--size takes WxH, each from 16 to 8192, not '%1'").arg(size));
    }
    if (parser.isSet(QStringLiteral("view"))) {
        const QString name = parser.value(QStringLiteral("view"));
        const auto view = rendering::standardViewNamed(name.toStdString());
        if (!view)
            return tl::unexpected(CommandLine::tr("There is no view '%1'").arg(name));
        options.view = *view;
    }
    if (parser.isSet(QStringLiteral("camera"))) {
        const QString camera = parser.value(QStringLiteral("camera"));
        options.camera = readCamera(camera);
        if (!options.camera)
            return tl::unexpected(CommandLine::tr("--camera takes AZIMUTH,ELEVATION[,DISTANCE], -360 to 360 and -89 to "
                                                  "89 degrees, 5 to 1000 cm, not '%1'")
                                      .arg(camera));
        if (parser.isSet(QStringLiteral("view")))
            return tl::unexpected(CommandLine::tr("--camera and --view exclude each other"));
    }
    options.transparent = parser.isSet(QStringLiteral("transparent"));
    if (parser.isSet(QStringLiteral("samples"))) {
        const QString samples = parser.value(QStringLiteral("samples"));
        constexpr std::array kCounts{1, 4, 16};
        bool isNumber = false;
        options.look.samples = samples.toInt(&isNumber);
        if (!isNumber || std::ranges::find(kCounts, options.look.samples) == kCounts.end())
            return tl::unexpected(CommandLine::tr("--samples takes 1, 4 or 16, not '%1'").arg(samples));
        if (options.look.samples > 1 && std::max(options.size.width(), options.size.height()) > kLargestFinePx)
            return tl::unexpected(
                CommandLine::tr("Pictures of more than %1 pixels a side take one sample a pixel, not %2")
                    .arg(kLargestFinePx)
                    .arg(samples));
    }
    if (parser.isSet(QStringLiteral("fit"))) {
        const QString name = parser.value(QStringLiteral("fit"));
        const auto fit = rendering::fitNamed(name.toStdString());
        if (!fit)
            return tl::unexpected(CommandLine::tr("--fit takes hair, head or bust, not '%1'").arg(name));
        options.fit = *fit;
    }
    if (parser.isSet(QStringLiteral("skin"))) {
        const QString name = parser.value(QStringLiteral("skin"));
        const model::SkinLook* look = model::findSkinLook(name);
        if (look == nullptr)
            return tl::unexpected(CommandLine::tr("There is no skin '%1'").arg(name));
        options.skin = look->tone;
    }
    if (parser.isSet(QStringLiteral("light"))) {
        const QString name = parser.value(QStringLiteral("light"));
        options.light = model::findLightPreset(name);
        if (options.light == nullptr)
            return tl::unexpected(CommandLine::tr("There is no light '%1'").arg(name));
    }
    const tl::expected<Film, QString> film = framesOption(parser);
    if (!film)
        return tl::unexpected(film.error());
    options.film = *film;
    return options;
}

model::Result<void> renderPicture(PictureMaker& maker, const SettledHair& hair, const rendering::Camera& camera,
                                  const RenderOptions& options, const QString& path)
{
    rendering::Scene scene = pictureScene(hair.project(), hair.frame(), camera);
    scene.transparent = options.transparent;
    return maker.save(scene, options.size, options.look, path, Interruption::progress());
}

rendering::Camera cameraOf(const RenderOptions& options, const SettledHair& hair)
{
    const float aspect = static_cast<float>(options.size.width()) / static_cast<float>(options.size.height());
    const model::Head& head = *hair.project().head;
    if (!options.camera)
        return view::pictureCamera(options.view, options.fit, head, hair.frame().get(), aspect);
    rendering::Camera from;
    from.azimuthRad = options.camera->azimuthRad;
    from.elevationRad = options.camera->elevationRad;
    rendering::Camera camera = view::pictureCamera(from, options.fit, head, hair.frame().get(), aspect);
    camera.distanceM = options.camera->distanceM.value_or(camera.distanceM);
    return camera;
}

model::Result<void> renderFilm(PictureMaker& maker, SettledHair& hair, const RenderOptions& options,
                               const rendering::Camera& camera, const QString& output)
{
    const Interruption interruption;
    // Pictures of a film are staged beside their targets until the last one is written.
    model::StagedFiles folder(QFileInfo(output).path());
    if (model::Result<void> ready = folder.check(framePath(output, options.film.first)); !ready)
        return ready;
    QStringList frames;
    for (int number = 0; number <= options.film.last; ++number) {
        // From the film's start, also through frames that nobody wants: a frame is the same whichever one is the first.
        if (!Interruption::progress()(0.0))
            return model::cancelled(framePath(output, number));
        hair.advance(secondsBefore(number, options.film.framesPerSecond));
        if (number < options.film.first)
            continue;
        frames.append(framePath(output, number));
        if (model::Result<void> written = renderPicture(maker, hair, camera, options, folder.pathFor(frames.back()));
            !written)
            return tl::unexpected(folder.named(std::move(written.error()), frames.back()));
    }
    return folder.publish(frames);
}

ExitCode renderAll(SettledHair& hair, const RenderOptions& options, const QString& output)
{
    PictureMaker maker;
    // A film keeps the camera of its start.
    const rendering::Camera camera = cameraOf(options, hair);
    const model::Result<void> written = options.film.wanted() ? renderFilm(maker, hair, options, camera, output)
                                                              : renderPicture(maker, hair, camera, options, output);
    return written ? ExitCode::Done : failed(written.error());
}

/// An error where a file that will be written can't be.
model::Result<void> checkOutputs(const RenderOptions& options, const QString& output, const QStringList& inputs)
{
    if (!options.film.wanted())
        return checkOutput(output, inputs);
    for (int number = options.film.first; number <= options.film.last; ++number)
        if (model::Result<void> free = checkOutput(framePath(output, number), inputs); !free)
            return free;
    return {};
}

} // namespace

ExitCode runRender(const QStringList& arguments)
{
    QCommandLineParser parser;
    const std::optional<QStringList> files = parse(parser, kName, arguments, 1);
    if (!files)
        return ExitCode::WrongUsage;
    const QString output = parser.value(QStringLiteral("o"));
    if (!output.endsWith(QLatin1String(".png"), Qt::CaseInsensitive) && !isExr(output))
        return wrongUsage(kName, CommandLine::tr("-o takes a name that ends in .png or .exr"));
    tl::expected<RenderOptions, QString> options = readOptions(parser);
    if (!options)
        return wrongUsage(kName, options.error());
    if (isExr(output) && qint64{options->size.width()} * options->size.height() > kMostLinearPixels)
        return wrongUsage(kName, CommandLine::tr("A picture in linear light has at most %1 million pixels; give a "
                                                 "smaller --size, or a name that ends in .png")
                                     .arg(kMostLinearPixels / 1'000'000));
    const auto settle = numberOption(parser, kName, QStringLiteral("settle"));
    const auto rate = numberOption(parser, kName, QStringLiteral("fps"));
    const auto hairs = hairsOption(parser, kName);
    const auto wind = windOption(parser, kName);
    const auto motion = motionOption(parser, kName);
    if (!settle || !rate || !hairs || !wind || !motion)
        return ExitCode::WrongUsage;
    if (*motion && !options->film.wanted())
        return wrongUsage(kName, CommandLine::tr("--motion is for films; give --frames too"));
    options->film.framesPerSecond = *rate;

    if (const model::Result<void> free = checkOutputs(*options, output, *files); !free)
        return failed(free.error());
    model::Result<model::Project> project = model::loadProject(files->front());
    if (!project)
        return failed(project.error());
    if (options->skin == model::SkinTone::Own && !(project->head && project->head->texture))
        return failed({CommandLine::tr("The head of '%1' has no picture of its own; choose another --skin.")
                           .arg(model::shownPath(files->front()))});
    project->skin = options->skin.value_or(project->skin);
    if (options->light != nullptr)
        project->light = options->light->appliedTo(project->light);
    SettledHair hair(std::move(*project), *settle, {.hairs = *hairs, .windVelocity = *wind});
    hair.setMotion(*motion);
    return renderAll(hair, *options, output);
}

} // namespace hairpaint::app
