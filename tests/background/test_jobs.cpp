// Work in the background: what it throws becomes a sentence, Cancel ends it, and input meanwhile is lost.
#include "app/background/heads.h"
#include "app/background/jobs.h"
#include "model/files/glb_writing.h"
#include "tests/support/patience.h"
#include "tests/support/test_heads.h"
#include "tests/support/test_program.h"

#include <QAction>
#include <QDialog>
#include <QDialogButtonBox>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QVBoxLayout>
#include <QtTest>

#include <atomic>
#include <ctime>
#include <new>
#include <stdexcept>
#include <thread>

namespace hairpaint::app {

namespace {

using test::kPatienceMs;

QDialog* shownProgress(const QWidget& window)
{
    auto* progress = window.findChild<QDialog*>(QStringLiteral("progressWindow"));
    return progress != nullptr && progress->isVisible() ? progress : nullptr;
}

Doing doing(const char* text)
{
    return {.text = QString::fromLatin1(text), .whenCancelled = QStringLiteral("not done: cancelled")};
}

/// Work that ends when it is told to, and only then.
model::Result<int> untilStopped(const model::Progress& progress)
{
    while (progress(0.25))
        std::this_thread::yield();
    return model::failure(QStringLiteral("stopped"));
}

/// A second is over with each look at it.
Jobs::Clock secondALook()
{
    return [ms = qint64{0}]() mutable { return ms += 1000; };
}

/// What this process has computed for; its other threads hardly do.
double processorMs()
{
    return 1000.0 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Does something once, as soon as it may.
class When : public QTimer
{
public:
    When(std::function<bool()> ready, std::function<void()> act)
    {
        connect(this, &QTimer::timeout, this, [this, ready = std::move(ready), act = std::move(act)] {
            if (!ready())
                return;
            stop();
            act();
        });
        start(5);
    }
};

} // namespace

class TestJobs : public QObject
{
    Q_OBJECT
private:
    struct Window : QWidget
    {
        QPushButton button{QStringLiteral("Press"), this};
        QLineEdit field{this};
        QAction action;
        int pressed = 0;
        int shortcuts = 0;

        Window()
        {
            auto* layout = new QVBoxLayout(this);
            layout->addWidget(&button);
            layout->addWidget(&field);
            action.setShortcut(QKeySequence(Qt::CTRL | Qt::Key_K));
            addAction(&action);
            connect(&button, &QPushButton::clicked, this, [this] { ++pressed; });
            connect(&action, &QAction::triggered, this, [this] { ++shortcuts; });
            show();
            field.setFocus();
        }

        /// As from the system's queue, and straight to the widgets.
        void disturb()
        {
            const QPoint position = button.mapTo(this, button.rect().center());
            QTest::mouseClick(windowHandle(), Qt::LeftButton, {}, position);
            QTest::keyClick(windowHandle(), Qt::Key_A);
            QTest::mouseClick(&button, Qt::LeftButton);
            QTest::keyClick(&field, Qt::Key_B);
            QTest::keyClick(&field, Qt::Key_K, Qt::ControlModifier);
        }
    };

private Q_SLOTS:
    void workThatDoesNotStopIsLeft()
    {
        Window window;
        std::atomic<bool> goesOn = true;
        std::atomic<bool> wasTold = false;
        {
            Jobs jobs(window);
            jobs.setClock(secondALook());
            const When cancels(
                [&] { return shownProgress(window) != nullptr; },
                [&] {
                    shownProgress(window)->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Cancel)->click();
                });
            const Awaited<int> awaited = jobs.awaitOrLeave<int>(
                doing("Waiting"), [&goesOn, &wasTold](const model::Progress& progress) -> model::Result<int> {
                    goesOn.wait(true);
                    wasTold = !progress(1.0);
                    return 1;
                });
            QCOMPARE(awaited.end, WorkEnd::Left);
            QVERIFY(!awaited.result);
        }
        QVERIFY(Jobs::anyLeft());
        goesOn = false;
        goesOn.notify_all();
        QTRY_VERIFY_WITH_TIMEOUT(!Jobs::anyLeft(), kPatienceMs);
        QVERIFY(wasTold);
    }

#if defined(Q_OS_LINUX) || defined(Q_OS_WIN)
    void workThatComputesIsWaitedForHoweverLong()
    {
        Window window;
        Jobs jobs(window);
        // A second is over whenever somebody has looked and the work has computed since for much longer than a look
        // needs to see it.
        std::atomic<qint64> nowMs = 0;
        std::atomic<qint64> seenMs = 0;
        jobs.setClock([&] {
            seenMs = nowMs.load();
            return seenMs.load();
        });
        std::atomic<bool> isCancelled = false;
        const When cancels(
            [&] { return shownProgress(window) != nullptr; },
            [&] {
                shownProgress(window)->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Cancel)->click();
                isCancelled = true;
            });
        const Awaited<int> awaited = jobs.awaitOrLeave<int>(doing("Counting"), [&](const model::Progress& progress) {
            const auto compute = [] {
                const double began = processorMs();
                while (processorMs() < began + 10.0) {
                }
            };
            constexpr int kSeconds = 20;
            for (int second = 0; second < kSeconds; second += isCancelled ? 1 : 0) {
                while (seenMs != nowMs)
                    compute();
                compute();
                nowMs += 1000;
            }
            return progress(1.0) ? model::Result<int>(1) : model::failure(QStringLiteral("Stopped."));
        });
        QCOMPARE(awaited.end, WorkEnd::Cancelled);
    }
#endif

    void workThatMayBeLeftEndsLikeAnyOther()
    {
        Window window;
        Jobs jobs(window);
        qint64 nowMs = 0;
        jobs.setClock([&nowMs] { return nowMs; });
        const Awaited<int> done =
            jobs.awaitOrLeave<int>(doing("Counting"), [](const model::Progress&) { return model::Result<int>(42); });
        QCOMPARE(done.end, WorkEnd::Done);
        QCOMPARE(**done.result, 42);
        const When cancels(
            [&] {
                nowMs = 1000;
                return shownProgress(window) != nullptr;
            },
            [&] { shownProgress(window)->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Cancel)->click(); });
        const Awaited<int> stopped = jobs.awaitOrLeave<int>(doing("Waiting"), untilStopped);
        QCOMPARE(stopped.end, WorkEnd::Cancelled);
        QVERIFY(!*stopped.result);
    }

    void aQuestionIsNotWaitedFor()
    {
        Window window;
        std::atomic<bool> answers = false;
        int answered = 0;
        const std::function<int()> question = [&answers] {
            while (!answers)
                std::this_thread::yield();
            return 42;
        };
        {
            Jobs jobs(window);
            jobs.ask<int>(question, &window, [&answered](int answer) { answered = answer; });
        }
        QVERIFY(Jobs::anyLeft());
        answers = true;
        QTRY_VERIFY_WITH_TIMEOUT(!Jobs::anyLeft(), kPatienceMs);
        QCoreApplication::processEvents();
        QCOMPARE(answered, 0); // Who asked is gone.
        Jobs jobs(window);
        jobs.ask<int>(question, &window, [&answered](int answer) { answered = answer; });
        QTRY_COMPARE_WITH_TIMEOUT(answered, 42, kPatienceMs);
    }

    void theResultOfWorkComesBack()
    {
        Window window;
        Jobs jobs(window);
        const auto result = jobs.await<int>(doing("Counting"), [&](const model::Progress& progress) {
            return std::this_thread::get_id() != std::thread::id() && progress(0.5) ? model::Result<int>(42)
                                                                                    : model::Result<int>(0);
        });
        QVERIFY(result && *result);
        QCOMPARE(**result, 42);
    }

    void whatWorkThrowsBecomesASentenceOfWhatWasDone_data()
    {
        QTest::addColumn<bool>("memory");
        QTest::addColumn<bool>("watched");
        QTest::newRow("memory, watched") << true << true;
        QTest::newRow("memory, unwatched") << true << false;
        QTest::newRow("something else, watched") << false << true;
        QTest::newRow("something else, unwatched") << false << false;
    }
    void whatWorkThrowsBecomesASentenceOfWhatWasDone()
    {
        QFETCH(bool, memory);
        QFETCH(bool, watched);
        Window window;
        Jobs jobs(window);
        const Work<int> work = [memory](const model::Progress&) -> model::Result<int> {
            // On a pool's thread, where nobody else would catch it.
            sim::parallelFor(64, 1, [memory](std::size_t, std::size_t) {
                if (memory)
                    throw std::bad_alloc();
                throw std::runtime_error("no such thing");
            });
            return 1;
        };
        std::optional<model::Result<int>> result;
        if (watched)
            result = jobs.await<int>(doing("Reading head.glb"), work);
        else
            jobs.start<int>(QStringLiteral("Reading head.glb"), work, &window,
                            [&result](const model::Result<int>& got) { result = got; });
        QTRY_VERIFY_WITH_TIMEOUT(result.has_value(), kPatienceMs);
        QVERIFY(!*result);
        const QString& said = result->error().message;
        QVERIFY2(said.startsWith(QStringLiteral("Reading head.glb")), qPrintable(said));
        QVERIFY(said.contains(memory ? QStringLiteral("memory") : QStringLiteral("no such thing")));
        QVERIFY(said.endsWith(QLatin1Char('.')) && !said.contains(QLatin1Char('\n')));
    }

    void cancelEndsTheWork_data()
    {
        QTest::addColumn<bool>("byKey");
        QTest::newRow("by mouse") << false;
        QTest::newRow("by Esc") << true;
    }
    void cancelEndsTheWork()
    {
        QFETCH(bool, byKey);
        Window window;
        Jobs jobs(window);
        jobs.setClock(secondALook());
        When cancel([&] { return shownProgress(window) != nullptr; },
                    [&] {
                        QDialog* progress = shownProgress(window);
                        if (byKey)
                            QTest::keyClick(progress, Qt::Key_Escape);
                        else
                            QTest::mouseClick(
                                progress->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Cancel),
                                Qt::LeftButton);
                    });
        QSignalSpy told(&jobs, &Jobs::cancelled);
        QVERIFY(!jobs.await<int>(doing("Waiting"), untilStopped));
        QVERIFY(shownProgress(window) == nullptr);
        QCOMPARE(told.size(), 1);
        QCOMPARE(told.front().front().toString(), QStringLiteral("not done: cancelled"));
        // So does waiting for something that never comes.
        cancel.start();
        QVERIFY(!jobs.awaitUntil(doing("Waiting"), [] { return false; }));
        QCOMPARE(told.size(), 2);
        cancel.start();
        QCOMPARE(jobs.awaitOrLeave<int>(doing("Waiting"), untilStopped).end, WorkEnd::Cancelled);
        QCOMPARE(told.size(), 3);
        QVERIFY(jobs.awaitUntil(doing("Waiting"), [] { return true; }));
        QCOMPARE(told.size(), 3);
    }

    void keysMeantForTheDialogBeforeDoNotCancel_data()
    {
        QTest::addColumn<Qt::Key>("key");
        QTest::newRow("Return") << Qt::Key_Return;
        QTest::newRow("Enter") << Qt::Key_Enter;
        QTest::newRow("Space") << Qt::Key_Space;
    }
    void keysMeantForTheDialogBeforeDoNotCancel()
    {
        QFETCH(Qt::Key, key);
        Window window;
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        Jobs jobs(window);
        jobs.setClock(secondALook());
        std::atomic<bool> goesOn = true;
        const When typed([&] { return shownProgress(window) != nullptr && shownProgress(window)->isActiveWindow(); },
                         [&] {
                             QDialog* progress = shownProgress(window);
                             QWidget* focused = progress->focusWidget();
                             QTest::keyClick(focused != nullptr ? focused : progress, key);
                             // The keyboard reaches Cancel all the same.
                             QTest::keyClick(progress, Qt::Key_Tab);
                             QVERIFY(progress->findChild<QPushButton*>()->hasFocus());
                             goesOn = false;
                         });
        QSignalSpy told(&jobs, &Jobs::cancelled);
        const auto result = jobs.await<int>(doing("Waiting"), [&goesOn](const model::Progress& progress) {
            while (goesOn && progress(0.5))
                std::this_thread::yield();
            return goesOn ? model::Result<int>(model::failure(QStringLiteral("stopped"))) : model::Result<int>(1);
        });
        QVERIFY(result && *result);
        QVERIFY(told.isEmpty());
    }

    void whatIsUsedThoughItCameLateIsNotCancelled()
    {
        Window window;
        Jobs jobs(window);
        jobs.setClock(secondALook());
        const Work<int> doneInSpiteOfIt = [](const model::Progress& progress) {
            while (progress(0.5))
                std::this_thread::yield();
            return model::Result<int>(7);
        };
        QSignalSpy told(&jobs, &Jobs::cancelled);
        for (const Late late : {Late::Used, Late::Dropped}) {
            const When cancels([&] { return shownProgress(window) != nullptr; },
                               [&] { QTest::keyClick(shownProgress(window), Qt::Key_Escape); });
            const Awaited<int> awaited = jobs.awaitOrLeave<int>(doing("Saving"), doneInSpiteOfIt, late);
            QCOMPARE(awaited.end, late == Late::Used ? WorkEnd::Done : WorkEnd::Cancelled);
            QCOMPARE(told.size(), late == Late::Used ? 0 : 1);
        }
    }

    void whatIsClickedAndTypedMeanwhileIsLost()
    {
        Window window;
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        Jobs jobs(window);
        qint64 nowMs = 0;
        jobs.setClock([&nowMs] { return nowMs; });
        std::atomic<bool> disturbed = false;
        When early([] { return true; },
                   [&] {
                       window.disturb();
                       nowMs = 1000;
                   });
        When late([&] { return shownProgress(window) != nullptr; },
                  [&] {
                      window.disturb();
                      QVERIFY(!window.close());
                      disturbed = true;
                  });
        const auto result = jobs.await<int>(doing("Waiting"), [&](const model::Progress&) {
            while (!disturbed)
                std::this_thread::yield();
            return model::Result<int>(1);
        });
        QVERIFY(result);
        QCoreApplication::processEvents();
        QCOMPARE(window.pressed, 0);
        QCOMPARE(window.shortcuts, 0);
        QCOMPARE(window.field.text(), QString());
        QVERIFY(window.isVisible());
        // Afterwards all is as before.
        window.activateWindow();
        window.disturb();
        QTRY_COMPARE_WITH_TIMEOUT(window.pressed, 2, kPatienceMs);
        QVERIFY(window.field.text().contains(QLatin1Char('b')));
    }

    void unwatchedWorkTellsWhoIsStillThere()
    {
        Window window;
        auto jobs = std::make_unique<Jobs>(window);
        int told = 0;
        auto gone = std::make_unique<QObject>();
        std::atomic<bool> go = false;
        const Work<int> work = [&go](const model::Progress&) -> model::Result<int> {
            while (!go)
                std::this_thread::yield();
            return 7;
        };
        jobs->start<int>(QStringLiteral("One"), work, gone.get(), [&](const model::Result<int>&) { told += 100; });
        jobs->start<int>(QStringLiteral("Two"), work, &window, [&](const model::Result<int>& got) {
            QCOMPARE(QThread::currentThread(), window.thread());
            told += *got;
        });
        gone.reset();
        go = true;
        QTRY_COMPARE_WITH_TIMEOUT(told, 7, kPatienceMs);
        // Its end stops what goes on.
        jobs->start<int>(QStringLiteral("Three"), untilStopped, &window, [&](const model::Result<int>&) { told = -1; });
        jobs.reset();
        QCoreApplication::processEvents();
        QCOMPARE(told, 7);
    }

    void aLoopOfTheWindowWaitsForNoJob_data()
    {
        QTest::addColumn<bool>("watched");
        QTest::newRow("watched") << true;
        QTest::newRow("unwatched") << false;
    }
    void aLoopOfTheWindowWaitsForNoJob()
    {
        QFETCH(bool, watched);
        sim::setThreadCount(2);
        Window window;
        Jobs jobs(window);
        std::atomic<int> held = 0;
        std::atomic<bool> letGo = false;
        const Work<int> work = [&](const model::Progress&) -> model::Result<int> {
            sim::parallelFor(8, 1, [&](std::size_t, std::size_t) {
                ++held;
                while (!letGo)
                    std::this_thread::yield();
            });
            return 1;
        };
        std::atomic<std::size_t> done = 0;
        When loop([&] { return held >= 2; }, // Every thread of the work's is taken.
                  [&] {
                      sim::parallelFor(1000, 1, [&](std::size_t begin, std::size_t end) { done += end - begin; });
                      letGo = true;
                  });
        bool ended = false;
        if (watched)
            ended = jobs.await<int>(doing("Holding"), work).has_value();
        else
            jobs.start<int>(QStringLiteral("Holding"), work, &window, [&](const model::Result<int>&) { ended = true; });
        QTRY_VERIFY_WITH_TIMEOUT(ended, kPatienceMs);
        QCOMPARE(done.load(), std::size_t{1000});
        sim::setThreadCount(0);
    }

    void preparingAHeadStopsWhereverItIsAsked()
    {
        const QByteArray source = model::glbFromMesh(test::makeBallHead(192, 0.11F)); // 36,864 faces
        int asked = 0;
        int askedBeforeFitting = 0;
        QVERIFY(remakeHead(QStringLiteral("ball"), source, {}, [&](double done) {
            askedBeforeFitting += done < 0.5 ? 1 : 0;
            return ++asked > 0;
        }));
        QVERIFY(asked > 3);
        QVERIFY2(askedBeforeFitting >= 9, qPrintable(QString::number(askedBeforeFitting))); // Each face at least once.
        for (int stopAt = 1; stopAt <= asked; stopAt += 1 + asked / 8) {
            int count = 0;
            const auto head = remakeHead(QStringLiteral("ball"), source, {}, [&](double) { return ++count < stopAt; });
            QVERIFY(!head);
            QVERIFY(count <= stopAt + 2); // Nothing goes on for long.
        }
    }
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestJobs, Widgets)
#include "test_jobs.moc"
