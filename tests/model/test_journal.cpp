// Journals: what comes back after a crash at any byte, what a state costs, and the history's steps.
#include "model/disk/atomic_file.h"
#include "model/files/head_file.h"
#include "model/journal/journal_format.h"
#include "model/journal/journal_reader.h"
#include "model/journal/journal_writer.h"
#include "tests/model/archive_maker.h"
#include "tests/model/fixtures.h"
#include "tests/model/sample_project.h"
#include "tests/support/allocation_limit.h"
#include "tests/support/full_disk.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>
#include <QTest>

#include <array>
#include <optional>
#include <random>

#ifdef Q_OS_UNIX
#include <csignal>
#include <sys/wait.h>
#include <unistd.h>
#endif

using namespace hairpaint;
using namespace hairpaint::model;
using namespace hairpaint::test;

namespace {

JournalState stateAt(const Project& project, int index, int count)
{
    return {.project = project,
            .path = QStringLiteral("/folder/Größe.hairpaint"),
            .step = QStringLiteral("Step %1").arg(index),
            .index = index,
            .count = count,
            .timeMs = 1'000'000 + index};
}

/// Paints a spot of one map's first layer.
void dab(Project& project, MapKind map, int seed)
{
    sim::TiledRaster& raster = project.groups.front().map(map).layers.front().raster;
    for (int i = 0; i < 20; ++i)
        raster.setTexel((seed * 37 + i) % raster.size(), (seed * 11) % raster.size(),
                        {static_cast<std::uint16_t>(seed * 977 + i), 65535, 0, 0});
}

} // namespace

class TestJournal : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_folder;

    [[nodiscard]] QString file() const { return m_folder.filePath(QStringLiteral("journal")); }
    [[nodiscard]] std::optional<RecoveredWork> recovered() const
    {
        const auto work = readJournal(file());
        return work ? *work : std::nullopt;
    }

private Q_SLOTS:
    void init() { QFile::remove(file()); }
    void whatWasAppendedComesBack();
    void aFileThatIsCutOffAnywhereGivesTheStateBefore();
    void aFileThatIsDamagedAnywhereGivesAStateOrASentence();
    void stepsComeBackWithWhatWasUndone();
    void nothingIsOfferedOnceItIsSaved();
    void aDabCostsATile();
    void aFileThatGrewIsWrittenAnew();
    void aFullDiskStopsItAndLosesNothing();
    void whatStandsForTooMuchIsLeftOut();
    void aStateThatUnpacksToTooMuchIsDamage();
    void linksInItsFolderAreNotFollowed();
    void stepsGoFromAWriterThatFailedToTheNext();
    void aWriterThatIsKilledLosesNothingItHasAcknowledged();
};

void TestJournal::whatWasAppendedComesBack()
{
    const Project sample = makeSampleProject();
    JournalWriter writer(file());
    QVERIFY(writer.append(stateAt(sample, 0, 0)));
    const auto work = recovered();
    QVERIFY(work);
    QCOMPARE(work->steps.size(), 1U);
    const JournalState& state = work->steps.front();
    QCOMPARE(difference(state.project, sample), QString());
    QCOMPARE(state.path, QStringLiteral("/folder/Größe.hairpaint"));
    QCOMPARE(state.step, QStringLiteral("Step 0"));
    QCOMPARE(state.timeMs, 1'000'000);
}

void TestJournal::aFileThatIsCutOffAnywhereGivesTheStateBefore()
{
    Project project = makeSampleProject();
    std::optional<JournalWriter> writer(file());
    std::vector<std::pair<qint64, Project>> written; // What the file held when it was so long.
    for (int i = 0; i <= 6; ++i) {
        dab(project, i % 2 == 0 ? MapKind::Length : MapKind::Curl, i);
        project.groups.front().name = QStringLiteral("Name %1").arg(i);
        QVERIFY(writer->append(stateAt(project, i, i)));
        written.emplace_back(QFileInfo(file()).size(), project);
    }
    writer.reset(); // Windows replaces no file that is open.
    const QByteArray whole = readBytes(file());
    std::mt19937 random(7);
    for (int turn = 0; turn < 60; ++turn) {
        const auto length = turn < 7 ? written[static_cast<std::size_t>(turn)].first - turn % 2
                                     : static_cast<qint64>(random() % static_cast<unsigned>(whole.size()));
        QVERIFY(writeFile(file(), QByteArrayView(whole).first(static_cast<qsizetype>(length))));
        const auto work = readJournal(file());
        QVERIFY(work);
        const auto after = std::ranges::find_if(written, [&](const auto& entry) { return entry.first > length; });
        QCOMPARE(work->has_value(), after != written.begin());
        if (*work)
            QCOMPARE(difference((*work)->steps[(*work)->current].project, std::prev(after)->second), QString());
    }
}

void TestJournal::aFileThatIsDamagedAnywhereGivesAStateOrASentence()
{
    Project project = makeSampleProject();
    std::optional<JournalWriter> writer(file());
    for (int i = 0; i < 3; ++i) {
        dab(project, MapKind::Length, i);
        QVERIFY(writer->append(stateAt(project, i, i)));
    }
    writer.reset(); // Windows replaces no file that is open.
    const QByteArray whole = readBytes(file());
    std::mt19937 random(11);
    int states = 0;
    constexpr unsigned kLastBytes = 4000; // Most of the file is the first state; what damages a later one leaves that.
    for (int turn = 0; turn < 150; ++turn) {
        QByteArray damaged = whole;
        const auto size = static_cast<unsigned>(whole.size());
        const unsigned first = turn % 2 == 0 ? 0 : size - std::min(size, kLastBytes);
        for (int k = 0; k <= turn % 3; ++k)
            damaged[static_cast<qsizetype>(first) + static_cast<qsizetype>(random() % (size - first))] =
                static_cast<char>(random());
        QVERIFY(writeFile(file(), damaged));
        const auto work = readJournal(file());
        if (!work)
            QVERIFY2(isOneSentenceNaming(work.error().message, file()), qPrintable(work.error().message));
        else if (*work)
            ++states;
    }
    QVERIFY(states > 0);
}

void TestJournal::stepsComeBackWithWhatWasUndone()
{
    Project project = makeSampleProject();
    std::vector<Project> contents{project};
    JournalWriter writer(file());
    QVERIFY(writer.append(stateAt(project, 0, 0)));
    for (int i = 1; i <= 4; ++i) {
        dab(project, MapKind::Length, i);
        contents.push_back(project);
        QVERIFY(writer.append(stateAt(project, i, i)));
    }
    // Two steps are taken back: the other two can be done again.
    QVERIFY(writer.append(stateAt(contents[3], 3, 4)));
    QVERIFY(writer.append(stateAt(contents[2], 2, 4)));
    auto work = recovered();
    QVERIFY(work);
    QCOMPARE(work->steps.size(), 5U);
    QCOMPARE(work->current, 2U);
    for (std::size_t i = 0; i < contents.size(); ++i)
        QCOMPARE(difference(work->steps[i].project, contents[i]), QString());
    // Another step instead of them: they are gone.
    Project other = contents[2];
    dab(other, MapKind::Curl, 9);
    QVERIFY(writer.append(stateAt(other, 3, 3)));
    work = recovered();
    QVERIFY(work);
    QCOMPARE(work->steps.size(), 4U);
    QCOMPARE(work->current, 3U);
    QCOMPARE(difference(work->steps.back().project, other), QString());
    // Another project: nothing can be undone.
    QVERIFY(writer.append(stateAt(makeSampleProject(512), 0, 0)));
    work = recovered();
    QVERIFY(work);
    QCOMPARE(work->steps.size(), 1U);
    QCOMPARE(work->steps.front().project.groups.front().maps.front()->size, 512);
}

void TestJournal::nothingIsOfferedOnceItIsSaved()
{
    Project project = makeSampleProject();
    JournalWriter writer(file());
    QVERIFY(writer.markClean());
    QVERIFY(!QFileInfo::exists(file()));
    QVERIFY(writer.append(stateAt(project, 1, 1)));
    QVERIFY(writer.markClean());
    const auto none = readJournal(file());
    QVERIFY(none && !*none);
    dab(project, MapKind::Length, 5);
    QVERIFY(writer.append(stateAt(project, 2, 2)));
    const auto work = recovered();
    QVERIFY(work);
    QCOMPARE(work->steps.size(), 2U); // What was saved can still be gone back to.
    QCOMPARE(work->current, 1U);
}

void TestJournal::aDabCostsATile()
{
    Project project = makeSampleProject(1024);
    JournalWriter writer(file());
    QVERIFY(writer.append(stateAt(project, 0, 0)));
    const qint64 before = writer.bytesInFile();
    dab(project, MapKind::Length, 3);
    QVERIFY(writer.append(stateAt(project, 1, 1)));
    const qint64 cost = writer.bytesInFile() - before;
    QVERIFY2(cost < 24'000, qPrintable(QString::number(cost))); // project.json, a table of 256, a tile or two
    QCOMPARE(writer.bytesInFile(), QFileInfo(file()).size());
}

void TestJournal::aFileThatGrewIsWrittenAnew()
{
    Project project = makeSampleProject();
    constexpr qint64 kLeast = 200'000;
    JournalWriter writer(file(), kLeast);
    qint64 greatest = 0;
    for (int i = 0; i < 200; ++i) {
        dab(project, MapKind::Length, i);
        QVERIFY(writer.append(stateAt(project, i, i)));
        greatest = std::max(greatest, QFileInfo(file()).size());
        if (i % 20 != 19)
            continue;
        const auto work = recovered();
        QVERIFY(work);
        QCOMPARE(difference(work->steps[work->current].project, project), QString());
        QVERIFY(work->steps.size() >= std::min<std::size_t>(JournalWriter::kKeptStates, static_cast<std::size_t>(i)));
    }
    QVERIFY2(greatest < 2'000'000, qPrintable(QString::number(greatest)));
    QVERIFY(!QFileInfo::exists(file() + QStringLiteral(".new")));
}

void TestJournal::aFullDiskStopsItAndLosesNothing()
{
#ifdef Q_OS_UNIX
    Project project = makeSampleProject();
    JournalWriter writer(file());
    QVERIFY(writer.append(stateAt(project, 0, 0)));
    const Project first = project;
    for (int tile = 0; tile < 16; ++tile)
        dab(project, MapKind::Length, tile * 7);
    {
        const FullDisk disk(QFileInfo(file()).size() + 500);
        const Checked<void> written = writer.append(stateAt(project, 1, 1));
        QVERIFY(!written);
        QVERIFY(!written.error().text.isEmpty());
    }
    QVERIFY(!writer.append(stateAt(project, 2, 2))); // Not after a gap.
    const auto work = recovered();
    QVERIFY(work);
    QCOMPARE(difference(work->steps[work->current].project, first), QString());
    JournalWriter another(file());
    QVERIFY(another.append(stateAt(project, 2, 2)));
    QCOMPARE(difference(recovered()->steps.front().project, project), QString());
#endif
}

void TestJournal::whatStandsForTooMuchIsLeftOut()
{
    constexpr int kSteps = 10;
    Project project = makeSampleProject();
    JournalWriter writer(file());
    for (int i = 0; i <= kSteps; ++i) {
        dab(project, MapKind::Length, i);
        QVERIFY(writer.append(stateAt(project, i, i)));
    }
    // A few bytes stand for many, so the file's size says nothing.
    const std::optional<OwnFolder> folder = OwnFolder::open(m_folder.path());
    std::size_t most = 0;
    std::size_t before = 0;
    constexpr std::size_t kFirst = 100'000;
    for (std::size_t bytes = kFirst; before <= kSteps; bytes += bytes / 8) {
        const auto work = readJournal(*folder, QStringLiteral("journal"), {}, bytes);
        if (!work) { // Not even the last.
            QVERIFY2(isOneSentenceNaming(work.error().message, file()), qPrintable(work.error().message));
            QCOMPARE(before, 0U);
            continue;
        }
        const RecoveredWork& found = **work;
        QVERIFY(found.steps.size() >= before);
        before = found.steps.size();
        QCOMPARE(found.steps[found.current].index, kSteps);
        QCOMPARE(found.steps.front().index, kSteps + 1 - static_cast<int>(before)); // The nearest.
        QCOMPARE(difference(found.steps.back().project, project), QString());
        most = std::max(most, before);
    }
    QCOMPARE(most, static_cast<std::size_t>(kSteps + 1));
}

void TestJournal::aStateThatUnpacksToTooMuchIsDamage()
{
    Project project = makeSampleProject();
    {
        JournalWriter writer(file());
        QVERIFY(writer.append(stateAt(project, 0, 0)));
    }
    {
        QFile journal(file());
        QVERIFY(journal.open(QIODevice::Append));
        journal.write(recordBytes(RecordKind::State, packedPayload(QByteArray(qsizetype{100} << 20, ' '))));
    }
    const AllocationLimit memory(std::size_t{64} << 20U);
    const auto work = recovered();
    QVERIFY(work); // What stands before it.
    QCOMPARE(work->steps.size(), 1U);
}

void TestJournal::linksInItsFolderAreNotFollowed()
{
#ifdef Q_OS_UNIX
    const QString precious = m_folder.filePath(QStringLiteral("precious"));
    writeBytes(precious, "precious");
    for (const char* end : {"", ".new"})
        QVERIFY(QFile::link(precious, file() + QLatin1StringView(end)));
    QVERIFY(!readJournal(file()));
    Project project = makeSampleProject();
    JournalWriter writer(file(), 1);
    for (int i = 0; i < 3; ++i) {
        dab(project, MapKind::Length, i);
        QVERIFY(writer.append(stateAt(project, i, i)));
        QFile::link(precious, file() + QStringLiteral(".new"));
    }
    QCOMPARE(readBytes(precious), QByteArray("precious"));
    QCOMPARE(recovered()->steps.size(), 3U);
    QFile::remove(file() + QStringLiteral(".new"));
#endif
}

void TestJournal::stepsGoFromAWriterThatFailedToTheNext()
{
#ifdef Q_OS_UNIX
    Project project = makeSampleProject();
    JournalWriter writer(file());
    for (int i = 0; i < 3; ++i) {
        dab(project, MapKind::Length, i);
        QVERIFY(writer.append(stateAt(project, i, i)));
    }
    dab(project, MapKind::Length, 3);
    {
        const FullDisk disk(QFileInfo(file()).size() + 100);
        QVERIFY(!writer.append(stateAt(project, 3, 3)));
    }
    std::optional<OwnFolder> folder = OwnFolder::open(m_folder.path());
    JournalWriter next(std::make_shared<const OwnFolder>(std::move(*folder)), QStringLiteral("journal"),
                       writer.takeStates());
    dab(project, MapKind::Length, 4);
    QVERIFY(next.append(stateAt(project, 4, 4)));
    const auto work = recovered();
    QVERIFY(work);
    QCOMPARE(work->steps.size(), 5U);
    QCOMPARE(difference(work->steps.back().project, project), QString());
    QVERIFY(next.isAtPath());
    QVERIFY(QFile::remove(file()));
    QVERIFY(!next.isAtPath());
    QVERIFY(next.writeAnew());
    QVERIFY(next.isAtPath());
    QCOMPARE(recovered()->steps.size(), 5U);
#endif
}

void TestJournal::aWriterThatIsKilledLosesNothingItHasAcknowledged()
{
#ifdef Q_OS_UNIX
    const int kills = qEnvironmentVariableIntValue("HAIRPAINT_JOURNAL_KILLS") > 0
                          ? qEnvironmentVariableIntValue("HAIRPAINT_JOURNAL_KILLS")
                          : 15;
    constexpr qint64 kLeastRewrite = 60'000; // So that many are killed while it is written anew.
    std::mt19937 random(5);
    Project start = patchProject(256);
    start.head = defaultHead();
    int rewritten = 0;
    int lastStep = 0;
    for (int turn = 0; turn < kills; ++turn) {
        QFile::remove(file());
        std::array<int, 2> ends{};
        QCOMPARE(::pipe(ends.data()), 0);
        const pid_t child = ::fork();
        if (child == 0) {
            Project project = start;
            JournalWriter writer(file(), kLeastRewrite);
            for (std::int32_t step = 0;; ++step) {
                dab(project, MapKind::Length, step);
                project.seed = static_cast<std::uint64_t>(step);
                if (!writer.append(stateAt(project, step, step)) || ::write(ends[1], &step, sizeof step) < 0)
                    ::_exit(1);
            }
        }
        ::close(ends[1]);
        std::int32_t acknowledged = -1;
        const auto wanted = static_cast<std::int32_t>(random() % 60);
        while (acknowledged<wanted&& ::read(ends[0], &acknowledged, sizeof acknowledged)> 0) {
        }
        ::usleep(static_cast<useconds_t>(random() % 4000));
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
        while (::read(ends[0], &acknowledged, sizeof acknowledged) > 0) {
        }
        ::close(ends[0]);
        const auto work = recovered();
        QVERIFY(work);
        const JournalState& state = work->steps[work->current];
        QVERIFY2(state.index >= acknowledged, qPrintable(QStringLiteral("%1 %2").arg(state.index).arg(acknowledged)));
        Project truth = start;
        for (int step = 0; step <= state.index; ++step)
            dab(truth, MapKind::Length, step);
        truth.seed = static_cast<std::uint64_t>(state.index);
        QCOMPARE(difference(state.project, truth), QString());
        rewritten += QFileInfo::exists(file() + QStringLiteral(".new")) ? 1 : 0;
        lastStep = std::max(lastStep, state.index);
    }
    qInfo("%d kills, %d of them while the file was written anew, up to step %d", kills, rewritten, lastStep);
#endif
}

HAIRPAINT_TEST(TestJournal, Core)
#include "test_journal.moc"
