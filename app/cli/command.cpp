// The table of verbs, and what they share: usage, errors, files, printing.
#include "app/cli/command.h"

#include "app/cli/terminal.h"
#include "app/cli/verb_options.h"
#include "model/disk/output_path.h"
#include "model/values/sentences.h"

#include <QFileInfo>

#include <algorithm>
#include <array>
#include <exception>
#include <new>

namespace hairpaint::app {

namespace {

constexpr std::array<Command, 6> kCommands = {{
    {"new", "", QT_TRANSLATE_NOOP("CommandLine", "makes a project"), newOptions, runNew},
    {"info", "P.hairpaint", QT_TRANSLATE_NOOP("CommandLine", "tells what a project holds"), listingOptions, runInfo},
    {"presets", "", QT_TRANSLATE_NOOP("CommandLine", "lists the library of styles"), listingOptions, runPresets},
    {"export", "P.hairpaint",
     QT_TRANSLATE_NOOP("CommandLine", "writes hair, maps and the UV layout for other programs"), exportOptions,
     runExport},
    {"render", "P.hairpaint", QT_TRANSLATE_NOOP("CommandLine", "takes pictures"), renderOptions, runRender},
    {"repair", "DAMAGED.hairpaint",
     QT_TRANSLATE_NOOP("CommandLine", "writes what can be read of a damaged project, and tells what was lost"),
     repairOptions, runRepair},
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
    for (QString word : option.spelling.split(QLatin1Char(' '))) {
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
    if (!option.former.isEmpty())
        spelling.names += option.former;
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

CommandOption optionOf(const char* command, const QString& name)
{
    const std::vector<CommandOption> rows = findCommand(QLatin1StringView(command))->options();
    return *std::ranges::find_if(rows,
                                 [&name](const CommandOption& row) { return spellingOf(row).names.contains(name); });
}

QString usageOf(const Command& command)
{
    QStringList words{QStringLiteral("hairpaint"), QString::fromLatin1(command.name)};
    if (*command.operands != '\0')
        words += QString::fromLatin1(command.operands);
    for (const CommandOption& option : command.options()) {
        const Spelling spelling = spellingOf(option);
        QString word = spelling.first;
        if (!spelling.value.isEmpty())
            word += QLatin1Char(' ') + spelling.value;
        if (option.use != CommandOption::Use::Required)
            word = QLatin1Char('[') + word + QLatin1Char(']');
        words += option.use == CommandOption::Use::Repeated ? word + QStringLiteral("...") : word;
    }
    return words.join(QLatin1Char(' '));
}

QStringList helpOf(const Command& command, bool options)
{
    QStringList lines{usageOf(command), QStringLiteral("    ") + CommandLine::tr(command.purpose)};
    if (options)
        for (const CommandOption& option : command.options())
            lines += QStringList{QStringLiteral("  ") + option.spelling, QStringLiteral("    ") + option.meaning};
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
    for (const CommandOption& option : findCommand(QLatin1StringView(command))->options()) {
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
