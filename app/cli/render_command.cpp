// `hairpaint render`: pictures without a display.
#include "app/cli/command.h"
#include "app/cli/settled_hair.h"
#include "app/picture.h"
#include "model/files/project_file.h"

#include <QFileInfo>
#include <QRegularExpression>
#include <QSaveFile>

namespace hairpaint::app {

namespace {

constexpr const char* kName = "render";

struct RenderOptions
{
    QSize size{1024, 1024};
    rendering::StandardView view = rendering::StandardView::ThreeQuarter;
    double settleSeconds = 2.0;
    int firstFrame = 0;
    int lastFrame = -1; ///< Below the first: one picture.
    double framesPerSecond = 30.0;
    std::optional<glm::vec3> windVelocity;
};

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
    if (parser.isSet(QStringLiteral("frames"))) {
        const QString frames = parser.value(QStringLiteral("frames"));
        const auto match = QRegularExpression(QStringLiteral("^(\\d{1,4})-(\\d{1,4})$")).match(frames);
        options.firstFrame = match.captured(1).toInt();
        options.lastFrame = match.captured(2).toInt();
        if (!match.hasMatch() || options.lastFrame < options.firstFrame)
            return tl::unexpected(
                CommandLine::tr("--frames takes A-B with B not below A, up to 9999, not '%1'").arg(frames));
    }
    if (parser.isSet(QStringLiteral("wind"))) {
        const QStringList parts = parser.value(QStringLiteral("wind")).split(QLatin1Char(','));
        glm::vec3 velocity(0.0F);
        bool good = parts.size() == 3;
        for (int i = 0; good && i < 3; ++i) {
            velocity[i] = parts[i].toFloat(&good);
            good = good && std::abs(velocity[i]) <= 30.0F;
        }
        if (!good)
            return tl::unexpected(CommandLine::tr("--wind takes X,Y,Z in m/s, each from -30 to 30"));
        options.windVelocity = velocity;
    }
    return options;
}

model::Result<void> writePicture(const QImage& picture, const QString& path)
{
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || !picture.save(&file, "PNG") || !file.commit())
        return model::failure(CommandLine::tr("'%1' could not be written: %2. Choose a folder you may write to.")
                                  .arg(path, file.errorString()));
    return {};
}

QString framePath(const QString& output, int number)
{
    const QFileInfo info(output);
    return info.path() + QLatin1Char('/') + info.completeBaseName() +
           QStringLiteral(".%1.png").arg(number, 4, 10, QLatin1Char('0'));
}

ExitCode renderAll(SettledHair& hair, const RenderOptions& options, const QString& output)
{
    model::Result<std::unique_ptr<PictureMaker>> maker = PictureMaker::create();
    if (!maker)
        return failed(maker.error());
    const bool film = options.lastFrame >= options.firstFrame;
    for (int number = options.firstFrame; number <= std::max(options.firstFrame, options.lastFrame); ++number) {
        if (number > 0 && film)
            hair.advance(1.0 / options.framesPerSecond);
        const QImage picture = (*maker)->take(hair.project(), hair.frame(), options.view, options.size);
        const QString path = film ? framePath(output, number) : output;
        if (const model::Result<void> written = writePicture(picture, path); !written)
            return failed(written.error());
    }
    return ExitCode::Done;
}

} // namespace

ExitCode runRender(const QStringList& arguments)
{
    QCommandLineParser parser;
    parser.addOptions({{{QStringLiteral("o"), QStringLiteral("output")}, {}, QStringLiteral("file")},
                       {QStringLiteral("size"), {}, QStringLiteral("WxH")},
                       {QStringLiteral("view"), {}, QStringLiteral("name")},
                       {QStringLiteral("settle"), {}, QStringLiteral("seconds")},
                       {QStringLiteral("frames"), {}, QStringLiteral("A-B")},
                       {QStringLiteral("fps"), {}, QStringLiteral("number")},
                       {QStringLiteral("wind"), {}, QStringLiteral("X,Y,Z")}});
    const std::optional<QStringList> files = parse(parser, kName, arguments, 1);
    if (!files)
        return ExitCode::WrongUsage;
    const QString output = parser.value(QStringLiteral("o"));
    if (!output.endsWith(QLatin1String(".png"), Qt::CaseInsensitive))
        return wrongUsage(kName, CommandLine::tr("-o takes a name that ends in .png"));
    tl::expected<RenderOptions, QString> options = readOptions(parser);
    if (!options)
        return wrongUsage(kName, options.error());
    const auto settle = numberOption(parser, kName, QStringLiteral("settle"), options->settleSeconds, 0.0, 60.0);
    const auto rate = numberOption(parser, kName, QStringLiteral("fps"), options->framesPerSecond, 1.0, 240.0);
    if (!settle || !rate)
        return ExitCode::WrongUsage;
    options->framesPerSecond = *rate;

    model::Result<model::Project> project = model::loadProject(files->front());
    if (!project)
        return failed(project.error());
    if (options->windVelocity) {
        project->wind.enabled = true;
        project->wind.velocity = *options->windVelocity;
    }
    SettledHair hair(std::move(*project), *settle);
    return renderAll(hair, *options, output);
}

} // namespace hairpaint::app
