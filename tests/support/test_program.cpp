// The main function of every test program.
#include "tests/support/test_program.h"

#include <QtTest>

#ifdef QT_WIDGETS_LIB
#include <QApplication>
#elif defined(QT_GUI_LIB)
#include <QGuiApplication>
#endif

#include <cstdio>
#include <map>

namespace hairpaint::test {

namespace {

struct Entry
{
    Application application = Application::None;
    void (*prepare)() = nullptr;
    MakeTest make = nullptr;
};

std::map<QString, Entry>& entries()
{
    static std::map<QString, Entry> all;
    return all;
}

std::unique_ptr<QCoreApplication> makeApplication(Application kind, int& argc, char** argv)
{
    if (kind == Application::None)
        return nullptr;
#ifdef QT_WIDGETS_LIB
    if (kind != Application::Core)
        return std::make_unique<QApplication>(argc, argv);
#elif defined(QT_GUI_LIB)
    if (kind != Application::Core)
        return std::make_unique<QGuiApplication>(argc, argv);
#endif
    return std::make_unique<QCoreApplication>(argc, argv);
}

int run(int argc, char** argv)
{
    const auto found = argc > 1 ? entries().find(QString::fromLocal8Bit(argv[1])) : entries().end();
    if (found == entries().end()) {
        for (const auto& [name, entry] : entries())
            std::printf("%s\n", qPrintable(name));
        return 2;
    }
    // Settings, journals and styles of its own: entries run side by side.
    const QString entry = qEnvironmentVariable("HAIRPAINT_ENTRY", QString::fromLocal8Bit(argv[1]));
    argv[1] = argv[0];
    --argc;
    ++argv;
    found->second.prepare();
    const std::unique_ptr<QCoreApplication> application = makeApplication(found->second.application, argc, argv);
    if (application) {
        application->setAttribute(Qt::AA_Use96Dpi, true);
        QCoreApplication::setApplicationName(QStringLiteral("hairpaint-test-") + entry);
    }
    const std::unique_ptr<QObject> test = found->second.make();
    return QTest::qExec(test.get(), argc, argv);
}

} // namespace

bool registerTest(const char* file, Application application, void (*prepare)(), MakeTest make)
{
    const QString name = QFileInfo(QString::fromUtf8(file)).completeBaseName().mid(5); // Without "test_".
    return entries().emplace(name, Entry{application, prepare, make}).second;
}

} // namespace hairpaint::test

int main(int argc, char** argv)
{
    return hairpaint::test::run(argc, argv);
}
