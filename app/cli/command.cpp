// What the verbs share: the table of them, their errors, their options.
#include "app/cli/command.h"

#include "app/cli/terminal.h"
#include "model/disk/output_place.h"
#include "model/project/project.h"
#include "model/values/sentences.h"

#include <QFileInfo>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <new>

namespace hairpaint::app {

namespace {

using Use = CommandOption::Use;

constexpr std::array<CommandOption, 9> kNewOptions = {{
    {"-o, --output P.hairpaint", QT_TRANSLATE_NOOP("CommandLine", "the project to write"), Use::Required},
    {"--head MESH", QT_TRANSLATE_NOOP("CommandLine", "a mesh with uv coordinates instead of the built-in head")},
    {"--preset NAME", QT_TRANSLATE_NOOP("CommandLine", "a style of the library")},
    {"--curves FILE.hair|.usda|.usdz",
     QT_TRANSLATE_NOOP("CommandLine",
                       "hair of another program as hair groups: its density, length, direction, curl and "
                       "colours become maps; may be given again for more"),
     Use::Repeated},
    {"--curves-unit UNIT",
     QT_TRANSLATE_NOOP("CommandLine", "of those files: m, dm, cm, mm or in; as they say, or as it fits, unless given")},
    {"--curves-axis y|z",
     QT_TRANSLATE_NOOP("CommandLine",
                       "that points up in those files: y or z; as they say, or as it fits, unless given")},
    {"--map [GROUP/]KIND[:grey]=IMAGE",
     QT_TRANSLATE_NOOP("CommandLine", "an image as a map, by its colours, or by its brightness with :grey"),
     Use::Repeated},
    {"--seed N", QT_TRANSLATE_NOOP("CommandLine", "another drawing of the roots; 1 unless given")},
    {"--max-candidates N",
     QT_TRANSLATE_NOOP("CommandLine",
                       "limit on the places, over the whole head, where hair may stand (was: --max-hairs)"),
     Use::Optional, "max-hairs"},
}};
constexpr CommandOption kJson{"--json", QT_TRANSLATE_NOOP("CommandLine", "as JSON, for scripts")};
constexpr CommandOption kSettle{
    "--settle SECONDS", QT_TRANSLATE_NOOP("CommandLine", "how long the hair falls first; 0 is the shape it was given")};
constexpr CommandOption kHairs{
    "--hairs N", QT_TRANSLATE_NOOP("CommandLine", "only so many of the hairs that are there, an even share")};
constexpr CommandOption kWind{
    "--wind X,Y,Z",
    QT_TRANSLATE_NOOP("CommandLine", "in m/s, instead of the project's; x to the head's left, y up, z forward")};
constexpr CommandOption kRate{"--fps F",
                              QT_TRANSLATE_NOOP("CommandLine", "frames a second of a film; 30 unless given")};
constexpr const char* kMotion = "--motion nod|shake|turn";
constexpr std::array<CommandOption, 1> kJsonOptions = {{kJson}};
constexpr std::array<CommandOption, 22> kExportOptions = {{
    {"-o, --output FILE.hair|.usda|.usdz|.obj|.glb|.vrm",
     QT_TRANSLATE_NOOP("CommandLine", "the file to write: curves, USD, lines, ribbons as a mesh, or an avatar: cards "
                                      "on spring bones with the body of a head that came with a skeleton")},
    {"--target NAME",
     QT_TRANSLATE_NOOP("CommandLine", "whose unit and axes: blender, unreal, godot, unity or maya; any, in metres with "
                                      "y up, unless given")},
    {"--group NAME", QT_TRANSLATE_NOOP("CommandLine", "only this hair group; may be given again for more"),
     Use::Repeated},
    {"--tolerance MM",
     QT_TRANSLATE_NOOP("CommandLine", "leaves out points of the hairs that lie so near to the line without them")},
    {"--cards",
     QT_TRANSLATE_NOOP("CommandLine", "as .glb: strips along locks of hair, with textures made from the hair, "
                                      "instead of a ribbon a hair")},
    {"--triangles N",
     QT_TRANSLATE_NOOP("CommandLine", "at most so many of all cards, 1000 to 60000; 15000 unless given")},
    {"--atlas 1024|2048|4096",
     QT_TRANSLATE_NOOP("CommandLine", "a side of the cards' textures: 1024, 2048 or 4096; 2048 unless given")},
    {"--lods N",
     QT_TRANSLATE_NOOP("CommandLine", "levels of detail, 1 to 3, each of half the triangles of the one before, with "
                                      "the same textures (MSFT_lod); 1 unless given")},
    {"--bones",
     QT_TRANSLATE_NOOP("CommandLine",
                       "joints along the cards' locks, with spring bones (VRMC_springBone) for avatar programs")},
    {"--with-head", QT_TRANSLATE_NOOP("CommandLine", "the head's mesh beside the cards")},
    {"--author NAME", QT_TRANSLATE_NOOP("CommandLine", "of an avatar, as its file tells; \"Unknown\" unless given")},
    kSettle,
    kHairs,
    kWind,
    {kMotion, QT_TRANSLATE_NOOP("CommandLine", "the head moves once after that, and the hair settles for 1 s more; of "
                                               "a film, from frame 0 on, again and again")},
    {"--frames A-B", QT_TRANSLATE_NOOP("CommandLine", "hair in motion, a file a frame: FILE.0001.hair and on")},
    kRate,
    {"--maps FOLDER", QT_TRANSLATE_NOOP("CommandLine", "writes every map as an image into that folder")},
    {"--image png|tif|exr|tga",
     QT_TRANSLATE_NOOP("CommandLine", "of those images: png, tif, exr or tga; png unless given")},
    {"--depth 8|16", QT_TRANSLATE_NOOP("CommandLine", "8 or 16 a channel of png and tif; 16 unless given")},
    {"--grey", QT_TRANSLATE_NOOP("CommandLine", "values as brightness instead of the scales' colours")},
    {"--uv-sheet FILE.pdf|.svg",
     QT_TRANSLATE_NOOP("CommandLine", "writes the head's UV layout as a sheet to print and draw on")},
}};
constexpr std::array<CommandOption, 15> kRenderOptions = {{
    {"-o, --output FILE.png|.exr",
     QT_TRANSLATE_NOOP("CommandLine", "the picture to write; as OpenEXR in linear light, alpha in its colours"),
     Use::Required},
    {"--size WxH", QT_TRANSLATE_NOOP("CommandLine", "in pixels; 1024x1024 unless given")},
    {"--view NAME", QT_TRANSLATE_NOOP("CommandLine", "front, back, left, right, top, bottom or three-quarter")},
    {"--fit hair|head|bust",
     QT_TRANSLATE_NOOP("CommandLine", "what fills the picture: hair (with the head), head or bust; hair unless given")},
    {"--camera AZIMUTH,ELEVATION[,DISTANCE]",
     QT_TRANSLATE_NOOP("CommandLine",
                       "instead of a view: degrees from the face toward the head's left, and upward; the "
                       "distance in cm, else as --fit asks")},
    {"--samples 1|4|16",
     QT_TRANSLATE_NOOP("CommandLine",
                       "1, 4 or 16 a pixel; 4 unless given, and 1 in pictures of more than 4096 pixels a side")},
    {"--transparent", QT_TRANSLATE_NOOP("CommandLine", "no background: alpha tells what is covered")},
    {"--skin NAME", QT_TRANSLATE_NOOP("CommandLine", "clay, porcelain, fair, beige, olive, brown or deep, instead of "
                                                     "the project's")},
    {"--light NAME", QT_TRANSLATE_NOOP("CommandLine", "studio, daylight, sunset, club or backlit, instead of the "
                                                      "project's")},
    kSettle,
    {"--frames A-B", QT_TRANSLATE_NOOP("CommandLine", "a film instead of one picture: FILE.0001.png and on")},
    kRate,
    kHairs,
    kWind,
    {kMotion, QT_TRANSLATE_NOOP("CommandLine", "the head moves from frame 0 on, again and again; for films")},
}};

constexpr std::array<CommandOption, 1> kRepairOptions = {{
    {"-o, --output P.hairpaint", QT_TRANSLATE_NOOP("CommandLine", "the project to write"), Use::Required},
}};

constexpr std::array<Command, 6> kCommands = {{
    {"new", "", QT_TRANSLATE_NOOP("CommandLine", "makes a project"), kNewOptions, runNew},
    {"info", "P.hairpaint", QT_TRANSLATE_NOOP("CommandLine", "tells what a project holds"), kJsonOptions, runInfo},
    {"presets", "", QT_TRANSLATE_NOOP("CommandLine", "lists the library of styles"), kJsonOptions, runPresets},
    {"export", "P.hairpaint",
     QT_TRANSLATE_NOOP("CommandLine", "writes hair, maps and the UV layout for other programs"), kExportOptions,
     runExport},
    {"render", "P.hairpaint", QT_TRANSLATE_NOOP("CommandLine", "takes pictures"), kRenderOptions, runRender},
    {"repair", "DAMAGED.hairpaint",
     QT_TRANSLATE_NOOP("CommandLine", "writes what can be read of a damaged project, and tells what was lost"),
     kRepairOptions, runRepair},
}};

/// A row's spelling taken apart.
struct Spelling
{
    QStringList names; ///< Without their dashes.
    QString first;     ///< With them.
    QString value;     ///< What it takes; empty where it takes nothing.
};

Spelling spellingOf(const CommandOption& option)
{
    Spelling spelling;
    QStringList value;
    for (QString word : QString::fromLatin1(option.spelling).split(QLatin1Char(' '))) {
        if (!word.startsWith(QLatin1Char('-'))) {
            value += word;
            continue;
        }
        if (word.endsWith(QLatin1Char(',')))
            word.chop(1);
        if (spelling.first.isEmpty())
            spelling.first = word;
        spelling.names += word.mid(word.startsWith(QLatin1String("--")) ? 2 : 1);
    }
    if (*option.former != '\0')
        spelling.names += QString::fromLatin1(option.former);
    spelling.value = value.join(QLatin1Char(' '));
    return spelling;
}

/// The project that a verb is about, else its first file.
QString projectIn(const QStringList& arguments)
{
    for (const QString& argument : arguments)
        if (isProjectName(argument))
            return argument;
    const auto file =
        std::ranges::find_if(arguments, [](const QString& argument) { return !argument.startsWith(QLatin1Char('-')); });
    return file == arguments.end() ? QString() : *file;
}

ExitCode printed(bool isWhole)
{
    return isWhole ? ExitCode::Done
                   : failed({CommandLine::tr("What was asked for could not be printed; check where standard output "
                                             "leads.")});
}

} // namespace

std::span<const Command> commands()
{
    return kCommands;
}

const Command* findCommand(const QString& name)
{
    const auto* const found = std::ranges::find_if(
        kCommands, [&name](const Command& command) { return name == QLatin1StringView(command.name); });
    return found == kCommands.end() ? nullptr : &*found;
}

QString usageOf(const Command& command)
{
    QStringList words{QStringLiteral("hairpaint"), QString::fromLatin1(command.name)};
    if (*command.operands != '\0')
        words += QString::fromLatin1(command.operands);
    for (const CommandOption& option : command.options) {
        const Spelling spelling = spellingOf(option);
        QString word = spelling.first;
        if (!spelling.value.isEmpty())
            word += QLatin1Char(' ') + spelling.value;
        if (option.use != Use::Required)
            word = QLatin1Char('[') + word + QLatin1Char(']');
        words += option.use == Use::Repeated ? word + QStringLiteral("...") : word;
    }
    return words.join(QLatin1Char(' '));
}

QStringList helpOf(const Command& command, bool options)
{
    QStringList lines{usageOf(command), QStringLiteral("    ") + CommandLine::tr(command.purpose)};
    if (options)
        for (const CommandOption& option : command.options)
            lines += QStringList{QStringLiteral("  ") + QLatin1StringView(option.spelling),
                                 QStringLiteral("    ") + CommandLine::tr(option.meaning)};
    return lines;
}

ExitCode run(const Command& command, const QStringList& arguments)
{
    if (arguments.contains(QLatin1String("--help")) || arguments.contains(QLatin1String("-h"))) {
        return printOut(helpOf(command, true));
    }
    const auto about = [&arguments] { return model::shownPath(projectIn(arguments)); };
    try {
        return command.run(arguments);
    } catch (const std::bad_alloc&) {
        return failed({CommandLine::tr("There is not enough memory for what is wanted of '%1'; give a smaller size or "
                                       "fewer hairs.")
                           .arg(about())});
    } catch (const std::exception& other) {
        return failed(
            {CommandLine::tr("What is wanted of '%1' failed: %2; try again, and report it where it fails again.")
                 .arg(about(), QString::fromLocal8Bit(other.what()))});
    }
}

ExitCode failed(const model::Error& error)
{
    printError(error.message);
    return ExitCode::Failed;
}

ExitCode wrongUsage(const char* command, const QString& problem)
{
    const Command* entry = findCommand(QLatin1StringView(command));
    printError(CommandLine::tr("%1. Usage: %2").arg(problem, usageOf(*entry)));
    return ExitCode::WrongUsage;
}

std::optional<QStringList> parse(QCommandLineParser& parser, const char* command, const QStringList& arguments,
                                 qsizetype positionals)
{
    for (const CommandOption& option : findCommand(QLatin1StringView(command))->options) {
        const Spelling spelling = spellingOf(option);
        parser.addOption(QCommandLineOption(spelling.names, {}, spelling.value));
    }
    // The parser expects a program name first.
    if (!parser.parse(QStringList{QLatin1StringView(command)} + arguments)) {
        QString problem = parser.errorText();
        if (problem.endsWith(QLatin1Char('.')))
            problem.chop(1);
        (void)wrongUsage(command, problem);
        return std::nullopt;
    }
    for (const QString& option : parser.optionNames()) {
        if (parser.values(option).contains(QString())) {
            (void)wrongUsage(command, CommandLine::tr("--%1 is given nothing").arg(option));
            return std::nullopt;
        }
    }
    const QStringList found = parser.positionalArguments();
    if (found.size() != positionals) {
        (void)wrongUsage(command, positionals == 0 ? CommandLine::tr("No file name belongs here")
                                                   : CommandLine::tr("Exactly one project is wanted"));
        return std::nullopt;
    }
    return found;
}

std::optional<double> numberOption(const QCommandLineParser& parser, const char* command, const QString& option,
                                   double fallback, double least, double most)
{
    if (!parser.isSet(option))
        return fallback;
    bool isNumber = false;
    const double value = parser.value(option).toDouble(&isNumber);
    if (isNumber && value >= least && value <= most)
        return value;
    (void)wrongUsage(command, CommandLine::tr("--%1 takes a number from %2 to %3, not '%4'")
                                  .arg(option)
                                  .arg(least)
                                  .arg(most, 0, 'g', 10)
                                  .arg(parser.value(option)));
    return std::nullopt;
}

std::optional<std::int64_t> countOption(const QCommandLineParser& parser, const char* command, const QString& option,
                                        std::int64_t fallback, std::int64_t most)
{
    if (!parser.isSet(option))
        return fallback;
    bool isNumber = false;
    const std::int64_t value = parser.value(option).toLongLong(&isNumber);
    if (isNumber && value >= 1 && value <= most)
        return value;
    (void)wrongUsage(command, CommandLine::tr("--%1 takes a whole number from 1 to %2, not '%3'")
                                  .arg(option)
                                  .arg(most)
                                  .arg(parser.value(option)));
    return std::nullopt;
}

std::optional<std::optional<glm::vec3>> windOption(const QCommandLineParser& parser, const char* command)
{
    constexpr float kStrongest = 30.0F;
    const QString option = QStringLiteral("wind");
    if (!parser.isSet(option))
        return std::optional<glm::vec3>();
    const QStringList parts = parser.value(option).split(QLatin1Char(','));
    glm::vec3 velocity(0.0F);
    bool good = parts.size() == 3;
    for (int i = 0; good && i < 3; ++i) {
        velocity[i] = parts[i].toFloat(&good);
        good = good && std::abs(velocity[i]) <= kStrongest;
    }
    if (good)
        return velocity;
    (void)wrongUsage(command, CommandLine::tr("--wind takes X,Y,Z in m/s, each from -30 to 30"));
    return std::nullopt;
}

std::optional<std::optional<sim::NeckMotion>> motionOption(const QCommandLineParser& parser, const char* command)
{
    const QString option = QStringLiteral("motion");
    if (!parser.isSet(option))
        return std::optional<sim::NeckMotion>();
    const QString name = parser.value(option);
    if (const std::optional<sim::NeckMotion> motion = sim::neckMotionNamed(name.toStdString()))
        return motion;
    (void)wrongUsage(command, CommandLine::tr("--motion takes nod, shake or turn, not '%1'").arg(name));
    return std::nullopt;
}

std::optional<std::optional<std::size_t>> hairsOption(const QCommandLineParser& parser, const char* command)
{
    const QString option = QStringLiteral("hairs");
    if (!parser.isSet(option))
        return std::optional<std::size_t>();
    const std::optional<std::int64_t> count = countOption(parser, command, option, 1, model::kMostHairs);
    if (!count)
        return std::nullopt;
    return static_cast<std::size_t>(*count);
}

bool isProjectName(const QString& output)
{
    return output.endsWith(QLatin1String(".hairpaint"), Qt::CaseInsensitive);
}

model::Result<void> checkOutput(const QString& output, const QStringList& inputs)
{
    if (const model::Checked<void> writable = model::checkWritable(output); !writable)
        return model::cannotWrite(output, writable.error());
    const QString canonical = QFileInfo(output).canonicalFilePath();
    for (const QString& input : inputs)
        if (!canonical.isEmpty() && canonical == QFileInfo(input).canonicalFilePath())
            return model::failure(QCoreApplication::translate("CommandLine",
                                                              "'%1' would be overwritten, and it is read from; give "
                                                              "another name after -o.")
                                      .arg(model::shownPath(input)));
    return {};
}

ExitCode printOut(const QStringList& lines)
{
    return printed(printLines(lines));
}

ExitCode printOut(const QList<QStringList>& rows)
{
    return printed(printTable(rows));
}

ExitCode printJson(const QByteArray& document)
{
    // Its strings hold no line break as it is, so that these are all its own.
    QStringList lines = QString::fromUtf8(document).split(QLatin1Char('\n'));
    if (lines.back().isEmpty())
        lines.pop_back();
    return printOut(lines);
}

} // namespace hairpaint::app
