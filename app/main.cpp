// Hair Paint: with a verb it works without a window, else it opens the editor.
#include "app/cli/command.h"
#include "app/languages.h"
#include "app/library.h"
#include "app/main_window.h"
#include "app/settings.h"
#include "view/head_view.h"
#include "view/resources.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QLoggingCategory>

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

void printHelp()
{
    QString text = CommandLine::tr("hairpaint [PROJECT]\n    opens the editor") + QLatin1Char('\n');
    for (const Command& command : hairpaint::app::commands())
        text += QStringLiteral("hairpaint %1 %2\n    %3\n")
                    .arg(QLatin1StringView(command.name), QLatin1StringView(command.usage),
                         CommandLine::tr(command.purpose));
    hairpaint::app::printOut(text);
}

/// Qt would end the program with a message that names plugins, not what the user can do.
bool displayIsMissing()
{
#ifdef Q_OS_LINUX
    return qEnvironmentVariableIsEmpty("DISPLAY") && qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY") &&
           qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM");
#else
    return false;
#endif
}

/// An option that is none of the editor's, or a verb.
bool isForCommandLine(const QString& argument)
{
    if (argument.startsWith(QLatin1Char('-')))
        return !argument.startsWith(QLatin1String("-platform"));
    return hairpaint::app::findCommand(argument) != nullptr;
}

int runCommandLine(int argc, char** argv)
{
    QCoreApplication application(argc, argv);
    hairpaint::app::speak();
    const QStringList arguments = QCoreApplication::arguments();
    const QString& first = arguments.at(1);
    if (const Command* command = hairpaint::app::findCommand(first))
        return static_cast<int>(run(*command, arguments.mid(2)));
    if (first == QLatin1String("--version")) {
        hairpaint::app::printOut(QStringLiteral("Hair Paint %1\n").arg(QCoreApplication::applicationVersion()));
        return 0;
    }
    if (first == QLatin1String("--help") || first == QLatin1String("-h")) {
        printHelp();
        return 0;
    }
    (void)hairpaint::app::failed(
        {CommandLine::tr("There is no option %1; hairpaint --help lists those there are.").arg(first)});
    return static_cast<int>(ExitCode::WrongUsage);
}

int failWithoutDisplay(int argc, char** argv)
{
    QCoreApplication application(argc, argv);
    hairpaint::app::speak();
    return static_cast<int>(hairpaint::app::failed({CommandLine::tr(
        "There is no display to open a window on. Without one the command line works: hairpaint --help")}));
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
    QApplication application(argc, argv);
    hairpaint::app::speak(hairpaint::app::Settings().preferences().language);
    QApplication::setStyle(QStringLiteral("Fusion"));
    QFont font(QStringList{QStringLiteral("Inter"), QStringLiteral("Noto Sans"), application.font().family()});
    font.setPixelSize(13);
    QApplication::setFont(font);
    hairpaint::view::initResources();

    QString path;
    hairpaint::model::Project project = hairpaint::app::starterProject();
    const QStringList arguments = QApplication::arguments();
    hairpaint::app::MainWindow window(std::move(project), path);
    logFirstHair(window, sinceStart);
    window.show();
    if (arguments.size() > 1)
        QMetaObject::invokeMethod(
            &window, [&window, file = arguments.at(1)] { window.openFile(file); }, Qt::QueuedConnection);
    return QApplication::exec();
}

} // namespace

int main(int argc, char** argv)
{
    describeApplication();
    if (argc > 1 && isForCommandLine(QString::fromLocal8Bit(argv[1])))
        return runCommandLine(argc, argv);
    return displayIsMissing() ? failWithoutDisplay(argc, argv) : runEditor(argc, argv);
}
