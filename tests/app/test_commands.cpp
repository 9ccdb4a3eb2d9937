// The verbs from within, where a failure can be made to happen.
#include "app/cli/command.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <new>

using namespace hairpaint::app;

class TestCommands : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void resultIsHandedOn();
    void wantOfMemoryIsAFailure();
};

void TestCommands::resultIsHandedOn()
{
    const auto counting = [](const QStringList& arguments) {
        return arguments == QStringList{QStringLiteral("a")} ? ExitCode::Done : ExitCode::WrongUsage;
    };
    const Command command{.name = "count", .operands = "", .purpose = "", .run = counting};
    QCOMPARE(run(command, {QStringLiteral("a")}), ExitCode::Done);
    QCOMPARE(run(command, {}), ExitCode::WrongUsage);
}

void TestCommands::wantOfMemoryIsAFailure()
{
    const auto greedy = [](const QStringList&) -> ExitCode { throw std::bad_alloc(); };
    const Command command{.name = "greedy", .operands = "", .purpose = "", .run = greedy};
    QCOMPARE(run(command, {}), ExitCode::Failed);
}

HAIRPAINT_TEST(TestCommands, None)
#include "test_commands.moc"
