// Hair Paint: with a verb it works without a window, else it opens the editor.
#include "app/cli/command.h"
#include "app/library.h"
#include "app/main_window.h"
#include "view/resources.h"

#include <QApplication>
#include <QFontDatabase>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

#include <cstdio>

namespace {

using hairpaint::app::Command;
using hairpaint::app::ExitCode;

void describeApplication()
{
    QCoreApplication::setApplicationName(QStringLiteral("hairpaint"));
    QCoreApplication::setOrganizationName(QStringLiteral("Hair Paint"));
    QCoreApplication::setApplicationVersion(QStringLiteral(HAIRPAINT_VERSION));
}

void printHelp()
{
    QString text = QCoreApplication::translate("CommandLine", "hairpaint [PROJECT]  opens the editor\n");
    for (const Command& command : hairpaint::app::commands())
        text += QStringLiteral("hairpaint %1 %2\n    %3\n")
                    .arg(QLatin1StringView(command.name), QLatin1StringView(command.usage),
                         QCoreApplication::translate("CommandLine", command.purpose));
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

int runEditor(int argc, char** argv)
{
    QApplication application(argc, argv);
    QApplication::setStyle(QStringLiteral("Fusion"));
    QFont font(QStringList{QStringLiteral("Inter"), QStringLiteral("Noto Sans"), application.font().family()});
    font.setPixelSize(13);
    QApplication::setFont(font);
    hairpaint::view::initResources();

    QString path;
    hairpaint::model::Project project = hairpaint::app::starterProject();
    const QStringList arguments = QApplication::arguments();
    hairpaint::app::MainWindow window(std::move(project), path);
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
    if (argc > 1) {
        const QString first = QString::fromLocal8Bit(argv[1]);
        if (first == QLatin1String("--help") || first == QLatin1String("-h") || first == QLatin1String("--version")) {
            QCoreApplication application(argc, argv);
            if (first == QLatin1String("--version"))
                hairpaint::app::printOut(QStringLiteral("Hair Paint %1\n").arg(QCoreApplication::applicationVersion()));
            else
                printHelp();
            return 0;
        }
        if (const Command* command = hairpaint::app::findCommand(first)) {
            QCoreApplication application(argc, argv);
            return static_cast<int>(command->run(QCoreApplication::arguments().mid(2)));
        }
        if (first.startsWith(QLatin1Char('-')) && !first.startsWith(QLatin1String("-platform"))) {
            std::fprintf(stderr, "Unknown option %s. hairpaint --help lists what there is.\n", argv[1]);
            return static_cast<int>(ExitCode::WrongUsage);
        }
    }
    if (displayIsMissing()) {
        std::fputs("There is no display to open a window on. Without one the command line works: hairpaint --help\n",
                   stderr);
        return static_cast<int>(ExitCode::Failed);
    }
    return runEditor(argc, argv);
}
