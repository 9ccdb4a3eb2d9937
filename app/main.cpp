// Hair Paint: with a verb it works without a window, else it opens the editor.
#include "app/cli/command.h"
#include "app/cli/console.h"
#include "app/cli/terminal.h"
#include "app/cli/version.h"
#include "app/recovery/termination.h"
#include "app/session/large_memory.h"
#include "app/settings/languages.h"
#include "app/settings/settings.h"
#include "app/styles/library.h"
#include "app/window/first_activation.h"
#include "app/window/main_window.h"
#include "model/values/sentences.h"
#include "view/head_area/head_view.h"
#include "view/look/own_fonts.h"
#include "view/look/resources.h"

#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QLoggingCategory>

#include <algorithm>
#include <cstdlib>
#include <memory>

namespace {

using hairpaint::app::Command;
using hairpaint::app::CommandLine;
using hairpaint::app::ExitCode;

void describeApplication()
{
    QCoreApplication::setApplicationName(QStringLiteral("hairpaint"));
    QCoreApplication::setOrganizationName(QStringLiteral("Hair Paint"));
    QCoreApplication::setApplicationVersion(QStringLiteral(HAIRPAINT_VERSION));
}

ExitCode printHelp()
{
    QStringList lines = CommandLine::tr("hairpaint [PROJECT]\n    opens the editor").split(QLatin1Char('\n'));
    for (const Command& command : hairpaint::app::commands())
        lines += hairpaint::app::helpOf(command, false);
    lines += CommandLine::tr("hairpaint COMMAND --help\n    tells what each option does").split(QLatin1Char('\n'));
    return hairpaint::app::printOut(lines);
}

/// The program as it was called, for sentences that tell what to type.
QString calledAs()
{
    const QString program = hairpaint::model::shownPath(
        QDir::cleanPath(QCoreApplication::arguments().value(0, QCoreApplication::applicationName())));
    return program.contains(QLatin1Char(' ')) ? QStringLiteral("\"%1\"").arg(program) : program;
}

/// An option that is none of the editor's, or a verb.
bool isForCommandLine(const QString& argument)
{
    if (argument.startsWith(QLatin1Char('-')))
        return !argument.startsWith(QLatin1String("-platform"));
    return hairpaint::app::findCommand(argument) != nullptr;
}

/// Qt takes names to be UTF-8, and would write to another file than the one that such bytes name.
bool isUtf8([[maybe_unused]] const char* argument)
{
#ifdef Q_OS_UNIX
    return QByteArrayView(argument).isValidUtf8();
#else
    return true; // The system's own call gives them as UTF-16.
#endif
}

/// What libraries warn of (a missing folder of the session's, a window too small to paint) tells nobody what to do.
void keepLibrariesQuiet(QtMsgType type, const QMessageLogContext& context, const QString& text)
{
    const QByteArrayView category(context.category);
    const bool isLibrarys = category == QByteArrayView("default") || category.startsWith("qt.");
    // Their debugging is told only where somebody asked for it.
    if (!isLibrarys || type == QtDebugMsg || type == QtFatalMsg || qEnvironmentVariableIsSet("QT_DEBUG_PLUGINS"))
        hairpaint::app::printError(qFormatLogMessage(type, context, text));
}

int runCommandLine(int argc, char** argv)
{
    hairpaint::app::joinConsole();
    const bool known = std::all_of(argv + 1, argv + argc, isUtf8);
    qInstallMessageHandler(keepLibrariesQuiet);
    const QCoreApplication application(argc, argv);
    hairpaint::app::speak();
    const QStringList arguments = QCoreApplication::arguments();
    if (!known) {
        (void)hairpaint::app::failed({CommandLine::tr("The arguments hold bytes that are not UTF-8, so no file can be "
                                                      "named by them; rename the file first.")});
        return static_cast<int>(ExitCode::WrongUsage);
    }
    const QString& first = arguments.at(1);
    if (const Command* command = hairpaint::app::findCommand(first))
        return static_cast<int>(run(*command, arguments.mid(2)));
    if (first == QLatin1String("--version"))
        return static_cast<int>(hairpaint::app::printOut(hairpaint::app::versionLines()));
    if (first == QLatin1String("--help") || first == QLatin1String("-h"))
        return static_cast<int>(printHelp());
    (void)hairpaint::app::failed(
        {CommandLine::tr("There is no option %1; %2 --help lists those there are.").arg(first, calledAs())});
    return static_cast<int>(ExitCode::WrongUsage);
}

/// Where no display can be opened Qt ends the program, with words that name plugins and not what the user can do.
void listenForMissingDisplay(QtMsgType type, const QMessageLogContext& context, const QString& text)
{
    if (type == QtFatalMsg) {
        hairpaint::app::speak();
        const ExitCode code = hairpaint::app::failed(
            {CommandLine::tr("There is no display to open a window on. Without one the command line works: %1 --help")
                 .arg(calledAs())});
        std::_Exit(static_cast<int>(code)); // Qt would abort, and the application object is not whole yet.
    }
    keepLibrariesQuiet(type, context, text);
}

/// Ends the program with a sentence where there is no display.
std::unique_ptr<QApplication> openDisplay(int& argc, char** argv)
{
    qInstallMessageHandler(listenForMissingDisplay);
    auto application = std::make_unique<QApplication>(argc, argv);
    qInstallMessageHandler(keepLibrariesQuiet);
    return application;
}

/// With QT_LOGGING_RULES=hairpaint.start=true the editor tells when its first hair was seen.
Q_LOGGING_CATEGORY(startLog, "hairpaint.start", QtWarningMsg)

void logFirstHair(hairpaint::app::MainWindow& window, const QElapsedTimer& sinceStart)
{
    if (!startLog().isDebugEnabled())
        return;
    auto* const listening = new QObject(&window);
    QObject::connect(&window.headView(), &hairpaint::view::HeadView::frameDrawn, listening,
                     [listening, sinceStart](const hairpaint::rendering::FrameStatistics& statistics) {
                         if (statistics.drawnHairs == 0)
                             return;
                         qCDebug(startLog) << statistics.drawnHairs << "hairs after" << sinceStart.elapsed() << "ms";
                         listening->deleteLater();
                     });
}

int runEditor(int argc, char** argv)
{
    QElapsedTimer sinceStart;
    sinceStart.start();
    hairpaint::app::returnLargeMemory();
    const std::unique_ptr<QApplication> application = openDisplay(argc, argv);
    auto settings = std::make_unique<hairpaint::app::Settings>(); // Once: its disk may not answer.
    hairpaint::app::speak(settings->preferences().language);
    hairpaint::view::initResources();
    if (!hairpaint::view::provideFonts())
        hairpaint::app::printError(CommandLine::tr("This system has no font, so no text can be read; install one, for "
                                                   "example Debian's package fonts-inter."));

    hairpaint::model::Project project = hairpaint::app::starterProject();
    const QStringList arguments = QApplication::arguments();
    hairpaint::app::MainWindow window(std::move(project), std::move(settings));
    logFirstHair(window, sinceStart);
    window.show();
    const hairpaint::app::Termination termination;
    QObject::connect(&termination, &hairpaint::app::Termination::wanted, &window, [&window] {
        window.keepWork();
        QCoreApplication::exit();
    });
    // A question that is asked before the window has the keys would not get them on every system.
    const auto begin = [&window, file = arguments.value(1)] { window.begin(file); };
    const hairpaint::app::FirstActivation firstActivation(window, begin);
    return QApplication::exec();
}

} // namespace

int main(int argc, char** argv)
{
    describeApplication();
    if (argc > 1 && isForCommandLine(QString::fromLocal8Bit(argv[1])))
        return runCommandLine(argc, argv);
    const int code = runEditor(argc, argv);
    if (hairpaint::app::Jobs::anyLeft())
        std::_Exit(code); // A thread waits for a disk that does not answer; nothing may be taken from under it.
    return code;
}
