// The command line's verbs: the same program without a window, so that it can be scripted.
#pragma once

#include "model/values/error.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QStringList>

#include <optional>
#include <span>
#include <vector>

namespace hairpaint::app {

/// `CommandLine::tr`: what the verbs say, in the system's language.
struct CommandLine
{
    Q_DECLARE_TR_FUNCTIONS(CommandLine)
};

/// The exit status of the program. Failed comes with exactly one line on standard error that says what and which file.
enum class ExitCode : int
{
    Done = 0,
    Failed = 1,
    WrongUsage = 2
};

/// A verb's option: a row that the parser, the usage line, --help and the README's synopsis read.
struct CommandOption
{
    enum class Use
    {
        Optional,
        Required,
        Repeated ///< As often as is wanted.
    };
    QString spelling; ///< "-o, --output FILE": its names, and what it takes, if anything.
    QString meaning;  ///< In the system's language.
    Use use = Use::Optional;
    QString former = {}; ///< An earlier name that still works.
    /// What a number may be, and what it is where it is not given.
    struct Number
    {
        double least, greatest, standard;
    };
    std::optional<Number> number = {};
    const char* useWith = ""; ///< The option without which this one is for nothing; empty where there is none.
};

/// One verb: "new", "info", "presets", "export", "render", "repair".
struct Command
{
    const char* name;
    const char* operands;                              ///< What follows the name: "P.hairpaint".
    const char* purpose;                               ///< To be translated in context "CommandLine".
    std::vector<CommandOption> (*options)() = nullptr; ///< In the order of the usage line.
    ExitCode (*run)(const QStringList& arguments) = nullptr;
};

[[nodiscard]] std::span<const Command> commands();
/// The verb of that name, or null.
[[nodiscard]] const Command* findCommand(const QString& name);
/// The row of that verb's option of that name, which is there.
[[nodiscard]] CommandOption optionOf(const char* command, const QString& name);
/// "hairpaint new -o FILE.hairpaint [--head MESH] ...".
[[nodiscard]] QString usageOf(const Command& command);
/// Usage and purpose as lines; with `options` those of each of them, too.
[[nodiscard]] QStringList helpOf(const Command& command, bool options);
/// Runs a verb, or prints its help where the arguments ask for it; where memory runs out, that fails like any other
/// error, and the sentence names the project.
[[nodiscard]] ExitCode run(const Command& command, const QStringList& arguments);

ExitCode runNew(const QStringList& arguments);
ExitCode runInfo(const QStringList& arguments);
ExitCode runPresets(const QStringList& arguments);
ExitCode runExport(const QStringList& arguments);
ExitCode runRender(const QStringList& arguments);
ExitCode runRepair(const QStringList& arguments);

/// Prints one line on standard error.
ExitCode failed(const model::Error& error);
/// Prints what is wrong and the verb's usage.
ExitCode wrongUsage(const char* command, const QString& problem);
/// Parses the arguments after the verb, by its options: the positional ones on success, none (with the usage printed)
/// otherwise.
[[nodiscard]] std::optional<QStringList> parse(QCommandLineParser& parser, const char* command,
                                               const QStringList& arguments, qsizetype positionals);
/// Whether that is the name of a project to be written. All outputs are named with their ending: a script is to know
/// what it gets.
[[nodiscard]] bool isProjectName(const QString& output);
/// Fails, before any work is done, where `output` can't be written or is one of `inputs`.
[[nodiscard]] model::Result<void> checkOutput(const QString& output, const QStringList& inputs);
/// On standard output (terminal.h); Failed, with a line on standard error, where it takes no more.
ExitCode printOut(const QStringList& lines);
/// The same of a table's rows.
ExitCode printOut(const QList<QStringList>& rows);
/// The same of a JSON document.
ExitCode printJson(const QByteArray& document);

} // namespace hairpaint::app
