// Long work of the whole program: a picture stops where it is asked to, and want of memory costs one sentence.
#include "app/cli/command.h"
#include "app/headless/picture.h"
#include "app/session/session.h"
#include "app/styles/library.h"
#include "sim/motion/simulation.h"
#include "tests/app/window_fixture.h"
#include "tests/support/allocation_limit.h"
#include "tests/support/test_program.h"

#include <QTemporaryFile>

#include <algorithm>
#include <new>

#ifdef Q_OS_UNIX
#include <unistd.h>
#endif

namespace hairpaint::app {

class TestLongWork : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { QStandardPaths::setTestModeEnabled(true); }

    void drawingAPictureStopsWhereverItIsAsked()
    {
        PictureMaker maker;
        const auto frame = [] {
            sim::Simulation simulation;
            simulation.setInput(model::Document(starterProject()).groomInput());
            auto made = std::make_shared<sim::StrandFrame>();
            simulation.writeFrame(*made);
            return made;
        }();
        const model::Project project = starterProject();
        const rendering::Camera camera =
            rendering::standardCamera(rendering::StandardView::Front, project.head->skin->mesh());
        const auto take = [&](const model::Progress& progress) {
            return maker.take(project, frame, camera, QSize(64, 64), progress);
        };
        std::vector<double> told;
        const auto whole = take([&told](double drawn) {
            told.push_back(drawn);
            return true;
        });
        QVERIFY(whole);
        QVERIFY(told.size() > 3);
        QVERIFY(std::ranges::is_sorted(told));
        QCOMPARE(told.back(), 1.0);
        std::size_t count = 0;
        QVERIFY(!take([&](double) { return ++count < 2; }));
        QCOMPARE(count, std::size_t{2});
        // In pieces or at once, stopped before or not: the same picture.
        const auto again = take({});
        QVERIFY(again);
        QVERIFY(*again == *whole);
    }

    void hairThatFindsNoMemoryCostsOneSentence()
    {
        model::Project project = starterProject();
        const test::AllocationLimit limit(std::size_t{1} << 20U);
        Session session(std::move(project));
        QSignalSpy failures(&session, &Session::hairFailed);
        QTRY_COMPARE_WITH_TIMEOUT(failures.size(), 1, kPatienceMs);
        QVERIFY(failures.front().front().toString().contains(QStringLiteral("memory")));
    }

#ifdef Q_OS_UNIX
    void aVerbThatFindsNoMemoryNamesItsProject()
    {
        QTemporaryFile said;
        QVERIFY(said.open());
        const int before = dup(STDERR_FILENO);
        dup2(said.handle(), STDERR_FILENO);
        const ExitCode code = run({.name = "render",
                                   .operands = "",
                                   .purpose = "",
                                   .run = [](const QStringList&) -> ExitCode { throw std::bad_alloc(); }},
                                  {QStringLiteral("-o"), QStringLiteral("a.png"), QStringLiteral("curls.hairpaint")});
        dup2(before, STDERR_FILENO);
        close(before);
        QCOMPARE(code, ExitCode::Failed);
        said.seek(0);
        const QByteArray line = said.readAll();
        QVERIFY2(line.contains("curls.hairpaint") && line.count('\n') == 1, line.constData());
    }
#endif
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestLongWork, Widgets)
#include "test_long_work.moc"
