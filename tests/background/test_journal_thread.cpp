// Steps go from the document to the disk on a thread of the journal's, while the document goes on.
#include "app/background/journal.h"
#include "app/background/journal_folder.h"
#include "model/document/commands.h"
#include "model/files/project_file.h"
#include "model/journal/journal_reader.h"
#include "tests/support/test_program.h"

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

HAIRPAINT_TEST(TestJournalThread, Core)
#include "test_journal_thread.moc"
