// Steps go from the document to the disk on a thread of the journal's, while the document goes on.
#include "app/background/journal.h"
#include "app/background/journal_folder.h"
#include "model/document/paint_command.h"
#include "model/files/project_file.h"
#include "model/journal/journal_reader.h"
#include "tests/support/await.h"
#include "tests/support/full_disk.h"
#include "tests/support/test_program.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

using namespace hairpaint;
using namespace hairpaint::app;

namespace {

/// Fills a tile of the first map with another value.
void step(model::Document& document, int number)
{
    const model::HairGroup& group = document.project().groups.front();
    const model::Layer& layer = group.map(model::MapKind::Length).layers.front();
    auto tile = std::make_shared<sim::RasterTile>();
    tile->pixels.assign(sim::kTileTexels * 2, static_cast<std::uint16_t>(number * 31));
    document.push(model::paintCommand(document, {.group = group.id, .map = model::MapKind::Length, .layer = layer.id},
                                      {{number % layer.raster.tileCount(), sim::RasterTilePtr(std::move(tile))}},
                                      QStringLiteral("Step")));
}

std::optional<model::RecoveredWork> left(const QString& root)
{
    for (const auto& folder : JournalFolder::abandoned(root))
        if (auto work = model::readJournal(folder->file()); work && *work)
            return std::move(**work);
    return std::nullopt;
}

} // namespace

class TestJournalThread : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void stepsThatComeFasterThanTheDiskEndWithTheLast();
    void aDiscardedJournalLeavesNothing();
    void whatCouldNotBeWrittenIsNeverTakenForKept();
};

void TestJournalThread::stepsThatComeFasterThanTheDiskEndWithTheLast()
{
    const QTemporaryDir root;
    model::Document document(model::newProject());
    {
        Journal journal(document, root.path());
        for (int i = 1; i <= 200; ++i) {
            step(document, i);
            (void)journal.idle(); // Asked while it writes.
        }
        document.undo();
        journal.flush();
        QVERIFY(journal.idle() || !journal.isStopped());
    }
    const auto work = left(root.path());
    QVERIFY(work);
    const model::JournalState& last = work->steps[work->current];
    QCOMPARE(last.index, 199);
    QCOMPARE(last.count, 200);
    const auto layerOf = [](const model::Project& project) {
        return project.groups.front().map(model::MapKind::Length).layers.front().raster;
    };
    QVERIFY(layerOf(last.project) == layerOf(document.committed()));
}

void TestJournalThread::aDiscardedJournalLeavesNothing()
{
    const QTemporaryDir root;
    model::Document document(model::newProject());
    Journal journal(document, root.path());
    for (int i = 1; i <= 20; ++i)
        step(document, i);
    journal.discard();
    QVERIFY(QDir(root.path()).isEmpty());
    step(document, 21);
    journal.flush();
    QVERIFY(!QDir(root.path()).isEmpty());
}

/// A look after the folder may come before anybody has heard that a step could not be written.
void TestJournalThread::whatCouldNotBeWrittenIsNeverTakenForKept()
{
#ifdef Q_OS_UNIX
    const QTemporaryDir root;
    model::Document document(model::newProject());
    std::size_t stepsFound = 0;
    {
        Journal journal(document, root.path());
        const QSignalSpy kept(&journal, &Journal::kept);
        const auto look = [&journal] {
            journal.lookAfterFolder();
            journal.flush();
            test::handleDueEvents();
        };
        step(document, 1);
        look();
        QVERIFY(!journal.isStopped());
        const qsizetype keptBefore = kept.size();
        {
            const test::FullDisk disk(1);
            step(document, 2);
            journal.flush();
            look();
            QVERIFY(journal.isStopped());
            step(document, 3);
            look();
            QVERIFY(journal.isStopped());
            QCOMPARE(kept.size(), keptBefore);
        }
        // Where there is room again no further step is needed.
        look();
        QVERIFY(!journal.isStopped());
        QCOMPARE(kept.size(), keptBefore + 1);
    }
    if (const auto work = left(root.path()))
        stepsFound = work->current;
    QCOMPARE(stepsFound, 3U); // With what undoes them.
#endif
}

HAIRPAINT_TEST(TestJournalThread, Core)
#include "test_journal_thread.moc"
