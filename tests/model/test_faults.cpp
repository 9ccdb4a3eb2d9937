// Whichever call to the disk fails, and whichever large piece of memory is refused: what was to be done is done, or all
// is as it was.
#include "model/disk/atomic_file.h"
#include "model/disk/earlier_versions.h"
#include "model/files/preset_file.h"
#include "model/files/project_file.h"
#include "model/journal/journal_reader.h"
#include "model/journal/journal_writer.h"
#include "model/repair/project_repair.h"
#include "tests/model/each_fault.h"
#include "tests/model/fixtures.h"
#include "tests/model/sample_project.h"
#include "tests/support/allocation_limit.h"
#include "tests/support/file_faults.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <functional>

using namespace hairpaint;
using namespace hairpaint::model;

namespace {

constexpr std::size_t kLargeBytes = 32 << 10;

/// The sample with paint in one map of each kind of texel: whatever fails in one layer fails in those like it.
Project projectOfFewLayers()
{
    Project project = test::makeSampleProject();
    for (HairGroup& group : project.groups)
        for (const MapSpec& spec : mapSpecs()) {
            const bool isKept = spec.kind == MapKind::Density || spec.kind == MapKind::Direction ||
                                spec.kind == MapKind::Colour || spec.kind == MapKind::Braid;
            for (Layer& layer : group.map(spec.kind).layers)
                if (!isKept || group.id != project.groups.front().id)
                    layer.raster = emptyRaster(spec, group.map(spec.kind).size);
        }
    return project;
}

} // namespace

class TestFaults : public QObject
{
    Q_OBJECT
private:
    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_path;
    QString m_message; ///< Message of the last failure; empty after a success.

    template<typename T>
    [[nodiscard]] bool noted(const Result<T>& result)
    {
        m_message = result ? QString() : result.error().message;
        if (!result && result.error().isDamage)
            m_message += QStringLiteral(" It is taken for damage!");
        return result.has_value();
    }

    /// `before`, or `after` where it was done, and else a sentence.
    [[nodiscard]] QString judge(bool done, const test::FolderContent& before, const test::FolderContent& after)
    {
        const test::FolderContent now = test::contentOf(m_folder->path());
        if (now != (done ? after : before))
            return QStringLiteral("done %1, and the folder holds %2")
                .arg(done)
                .arg(QStringList(now.keys()).join(QLatin1Char(' ')));
        if (!done && !test::isOneSentenceNaming(m_message, m_path))
            return m_message;
        return {};
    }

    /// The same from the same start, again and again.
    [[nodiscard]] QString underEachFileFault(const std::function<bool()>& work)
    {
        const test::FolderContent before = test::contentOf(m_folder->path());
        if (!work())
            return QStringLiteral("it fails without a fault: ") + m_message;
        const test::FolderContent after = test::contentOf(m_folder->path());
        test::putBack(m_folder->path(), before);
        return test::underEachFault<test::FileFault>(work, [&](bool done) {
            const QString wrong = judge(done, before, after);
            test::putBack(m_folder->path(), before);
            return wrong;
        });
    }

    /// Empty where all that the journal took is in its file.
    template<typename Fault, typename... Options>
    [[nodiscard]] QString journalUnderEach(Options... options)
    {
        // Small enough that it is written anew meanwhile.
        constexpr qint64 kRewriteBytes = 4000;
        std::vector<JournalState> states;
        Project project = test::filledPatch(MapKind::Length, 1234);
        project.head = defaultHead();
        for (int step = 0; step < 6; ++step) {
            for (int tile = 0; tile < 4; ++tile)
                project.groups.front()
                    .map(MapKind::Length)
                    .layers.front()
                    .raster.setTexel(tile * 64, 0, {static_cast<std::uint16_t>(step + 1), 65535, 0, 0});
            states.push_back({.project = project,
                              .path = m_path,
                              .step = QString::number(step),
                              .index = step,
                              .count = step,
                              .timeMs = step});
        }
        const QString file = m_folder->filePath(QStringLiteral("journal"));
        int taken = 0;
        return test::underEachFault<Fault>(
            [&] {
                QFile::remove(file);
                taken = 0;
                JournalWriter writer(file, kRewriteBytes);
                bool all = true;
                for (const JournalState& state : states) {
                    all =
                        all && whereMemoryLasts([&] { return writer.append(state).has_value(); }, [] { return false; });
                    taken += all ? 1 : 0;
                }
                return all;
            },
            [&](bool done) -> QString {
                if (taken == 0)
                    return {};
                const Result<std::optional<RecoveredWork>> work = readJournal(file);
                if (!work || !*work)
                    return QStringLiteral("nothing came back of %1").arg(taken);
                // One that was not acknowledged may be there all the same.
                const RecoveredWork& found = **work;
                const int newest = found.steps[found.current].index;
                if (newest != taken - 1 && (done || newest != taken))
                    return QStringLiteral("step %1 came back of %2").arg(newest).arg(taken);
                const JournalState& was = states[static_cast<std::size_t>(newest)];
                return test::difference(was.project, found.steps[found.current].project);
            },
            options...);
    }

private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_path = m_folder->filePath(QStringLiteral("a.hairpaint"));
    }

#ifdef Q_OS_LINUX
    void aProjectIsSavedOrTheOldOneIsThere()
    {
        const Project project = projectOfFewLayers();
        test::writeBytes(m_path, "old");
        QCOMPARE(underEachFileFault([&] { return noted(saveProject(project, m_path, {})); }), QString());
    }

    void aStyleIsSavedOrTheOldOneIsThere()
    {
        m_path = m_folder->filePath(QStringLiteral("a.hairpreset"));
        const Preset preset = loadPreset(builtInPresets().front()).value();
        QCOMPARE(underEachFileFault([&] { return noted(savePreset(preset, m_path)); }), QString());
    }

    void earlierVersionsMoveUpTogetherOrNotAtAll()
    {
        test::writeBytes(m_path, QByteArray(3'000'000, '0'));
        for (int number = 1; number <= kEarlierVersions; ++number)
            test::writeBytes(earlierVersion(m_path, number), QByteArray::number(number));
        QCOMPARE(underEachFileFault([&] {
                     const Checked<void> kept = keepEarlierVersions(m_path);
                     return noted(kept ? Result<void>() : Result<void>(cannotWrite(m_path, kept.error())));
                 }),
                 QString());
    }

    void whatAJournalHasTakenIsThere()
    {
        QCOMPARE(journalUnderEach<test::FileFault>(), QString());
    }
#endif

    void whereMemoryIsRefusedWhatAJournalHasTakenIsThere()
    {
        QCOMPARE(journalUnderEach<test::AllocationFault>(kLargeBytes), QString());
    }

    void whereMemoryIsRefusedAProjectIsOpenedOrASentenceSaysWhyNot()
    {
        const Project project = projectOfFewLayers();
        QVERIFY(saveProject(project, m_path, {}));
        Result<Project> opened = failure({});
        QCOMPARE(test::underEachFault<test::AllocationFault>(
                     [&] {
                         opened = loadProject(m_path);
                         return noted(opened);
                     },
                     [&](bool done) {
                         return done                                           ? test::difference(project, *opened)
                                : test::isOneSentenceNaming(m_message, m_path) ? QString()
                                                                               : m_message;
                     },
                     kLargeBytes),
                 QString());
    }

    void whereMemoryIsRefusedAProjectIsSavedOrTheOldOneIsThere()
    {
        const Project project = projectOfFewLayers();
        test::writeBytes(m_path, "old");
        const test::FolderContent before = test::contentOf(m_folder->path());
        QVERIFY(saveProject(project, m_path, {}));
        const test::FolderContent after = test::contentOf(m_folder->path());
        test::putBack(m_folder->path(), before);
        QCOMPARE(test::underEachFault<test::AllocationFault>([&] { return noted(saveProject(project, m_path, {})); },
                                                             [&](bool done) {
                                                                 const QString wrong = judge(done, before, after);
                                                                 test::putBack(m_folder->path(), before);
                                                                 return wrong;
                                                             },
                                                             kLargeBytes),
                 QString());
    }

    void whereMemoryIsRefusedADamagedProjectIsRepairedOrASentenceSaysWhyNot()
    {
        QVERIFY(saveProject(projectOfFewLayers(), m_path, {}));
        const QByteArray whole = test::readBytes(m_path);
        test::writeBytes(m_path, whole.chopped(3000));
        const Project expected = repairProject(m_path).value().project;
        Result<RepairedProject> repaired = failure({});
        QCOMPARE(test::underEachFault<test::AllocationFault>(
                     [&] {
                         repaired = repairProject(m_path);
                         return noted(repaired);
                     },
                     [&](bool done) {
                         return done ? test::difference(expected, repaired->project)
                                : test::isOneSentenceNaming(m_message, m_path) ? QString()
                                                                               : m_message;
                     },
                     kLargeBytes),
                 QString());
    }
};

HAIRPAINT_TEST(TestFaults, Gui)
#include "test_faults.moc"
