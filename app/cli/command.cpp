// What the verbs share: the table of them, their errors, their options.
#include "app/cli/command.h"

#include "model/files/sentences.h"

#include <QFileInfo>

#include <algorithm>
#include <array>
#include <cstdio>
#include <new>

namespace hairpaint::app {

namespace {

constexpr std::array<Command, 5> kCommands = {{
    {"new",
     "-o P.hairpaint [--head MESH] [--preset NAME] [--map [GROUP/]KIND[:grey]=IMAGE]... [--seed N] [--max-hairs N]",
     QT_TRANSLATE_NOOP("CommandLine", "makes a project"), runNew},
    {"info", "P.hairpaint [--json]", QT_TRANSLATE_NOOP("CommandLine", "tells what a project holds"), runInfo},
    {"presets", "[--json]", QT_TRANSLATE_NOOP("CommandLine", "lists the library of styles"), runPresets},
    {"export", "P.hairpaint -o FILE.hair [--settle SECONDS]",
     QT_TRANSLATE_NOOP("CommandLine", "writes the hair as curves"), runExport},
    {"render",
     "P.hairpaint -o FILE.png [--size WxH] [--view front|back|left|right|top|three-quarter] "
     "[--fit hair|head|bust] [--settle SECONDS] "
     "[--frames A-B] [--fps F] [--wind X,Y,Z]",
     QT_TRANSLATE_NOOP("CommandLine", "takes pictures"), runRender},
}};

void printError(const QString& text)
{
    const QByteArray line = text.simplified().toUtf8() + '\n';
    std::fwrite(line.constData(), 1, static_cast<std::size_t>(line.size()), stderr);
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

ExitCode run(const Command& command, const QStringList& arguments)
{
    try {
        return command.run(arguments);
    } catch (const std::bad_alloc&) {
        return failed({CommandLine::tr("There is not enough memory for this; give a smaller size or fewer hairs.")});
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
    printError(CommandLine::tr("%1. Usage: hairpaint %2 %3")
                   .arg(problem, QLatin1StringView(entry->name), QLatin1StringView(entry->usage)));
    return ExitCode::WrongUsage;
}

std::optional<QStringList> parse(QCommandLineParser& parser, const char* command, const QStringList& arguments,
                                 qsizetype positionals)
{
    // The parser expects a program name first.
    if (!parser.parse(QStringList{QLatin1StringView(command)} + arguments)) {
        QString problem = parser.errorText();
        if (problem.endsWith(QLatin1Char('.')))
            problem.chop(1);
        (void)wrongUsage(command, problem);
        return std::nullopt;
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

model::Result<void> checkOutput(const QString& output, const QStringList& inputs)
{
    if (const model::Checked<void> writable = model::checkWritable(output); !writable)
        return model::cannotWrite(output, writable.error());
    const QString place = QFileInfo(output).canonicalFilePath();
    for (const QString& input : inputs)
        if (!place.isEmpty() && place == QFileInfo(input).canonicalFilePath())
            return model::failure(QCoreApplication::translate("CommandLine",
                                                              "'%1' would be overwritten, and it is read from; give "
                                                              "another name after -o.")
                                      .arg(model::shownPath(input)));
    return {};
}

void printOut(const QString& text)
{
    const QByteArray bytes = text.toUtf8();
    std::fwrite(bytes.constData(), 1, static_cast<std::size_t>(bytes.size()), stdout);
    std::fflush(stdout);
}

} // namespace hairpaint::app
