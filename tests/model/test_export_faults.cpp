// Whichever call to the disk fails, and whichever large piece of memory is refused, while hair is exported: all files
// are there and whole, or the folder is as it was.
#include "model/files/atomic_file.h"
#include "model/files/staged_files.h"
#include "tests/model/each_fault.h"
#include "tests/model/exported_hair.h"
#include "tests/model/sample_project.h"
#include "tests/support/allocation_limit.h"
#include "tests/support/file_faults.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>
#include <QTest>

using namespace hairpaint;
using namespace hairpaint::model;

namespace {

constexpr std::size_t kLargeBytes = 32 << 10;
constexpr std::size_t kPictureBytes = 2 << 20; ///< Cards ask for so many smaller pieces that it would take minutes.

/// With the address sanitizer they take minutes; their files go the way of
/// severalFilesTakeTheirPlacesTogetherOrNotAtAll.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool kTakesCards = false;
#else
constexpr bool kTakesCards = true;
#endif

} // namespace

class TestExportFaults : public QObject
{
    Q_OBJECT
private:
    std::unique_ptr<QTemporaryDir> m_folder;
    std::shared_ptr<const sim::StrandFrame> m_frame;
    QString m_message; ///< Of the last failure.

    [[nodiscard]] bool exportAs(const ExportFormat& format, const QString& path)
    {
        ExportRequest request{.format = &format,
                              .target = &exportTargets().front(),
                              .curves = test::allOf(*m_frame),
                              .cards = {.triangles = 1000, .atlasPx = 1024}};
        if (format.isAvatar)
            request.avatar = test::mannequinAvatar();
        const Result<void> done = exportHair(m_frame, request, path);
        m_message = done ? QString() : done.error().message;
        return done.has_value();
    }

    /// The folder as it should be, and a sentence where it was not done.
    [[nodiscard]] QString judge(bool done, const test::FolderContent& before, const test::FolderContent& after)
    {
        const test::FolderContent now = test::contentOf(m_folder->path());
        test::putBack(m_folder->path(), before);
        if (now != (done ? after : before))
            return QStringLiteral("done %1, and the folder holds %2")
                .arg(done)
                .arg(QStringList(now.keys()).join(QLatin1Char(' ')));
        // Cards come with pictures, and the one that failed is named.
        return done || test::isOneSentenceNaming(m_message, m_folder->path()) ? QString() : m_message;
    }

    template<typename Fault, typename... Options>
    [[nodiscard]] QString underEach(const ExportFormat& format, Options... options)
    {
        const QString path = m_folder->filePath(QStringLiteral("hair.") + QLatin1StringView(format.suffix));
        test::writeBytes(path, "old");
        const test::FolderContent before = test::contentOf(m_folder->path());
        if (!exportAs(format, path))
            return QStringLiteral("it fails without a fault: ") + m_message;
        const test::FolderContent after = test::contentOf(m_folder->path());
        test::putBack(m_folder->path(), before);
        return test::underEachFault<Fault>([&] { return exportAs(format, path); },
                                           [&](bool done) { return judge(done, before, after); }, options...);
    }

    static void everyFormat()
    {
        QTest::addColumn<int>("number");
        int number = 0;
        for (const ExportFormat& format : exportFormats()) {
            if (!format.hasCards || kTakesCards)
                QTest::newRow(format.id) << number;
            ++number;
        }
    }

private Q_SLOTS:
    void initTestCase() { m_frame = test::frameOf({test::hairGroup(1, 4'000, 40'000, 0)}); }

    void init() { m_folder = std::make_unique<QTemporaryDir>(); }

#ifdef Q_OS_LINUX
    void severalFilesTakeTheirPlacesTogetherOrNotAtAll()
    {
        QStringList places;
        for (const char* name : {"a", "b", "c", "d"})
            places += m_folder->filePath(QLatin1StringView(name));
        test::writeBytes(places[1], "old b");
        test::writeBytes(places[3], "old d");
        const test::FolderContent before = test::contentOf(m_folder->path());
        const auto work = [&] {
            const StagedFiles staged(m_folder->path());
            Result<void> done = staged.check(places[0]);
            for (qsizetype i = 0; i < places.size() && done; ++i)
                if (const Checked<void> written = writeFile(staged.pathFor(places[i]), "new"); !written)
                    done = cannotWrite(places[i], written.error());
            if (done)
                done = staged.publish(places);
            m_message = done ? QString() : done.error().message;
            return done.has_value();
        };
        QVERIFY(work());
        const test::FolderContent after = test::contentOf(m_folder->path());
        QCOMPARE(after.size(), 4);
        test::putBack(m_folder->path(), before);
        QCOMPARE(test::underEachFault<test::FileFault>(work, [&](bool done) { return judge(done, before, after); }),
                 QString());
    }

    void hairIsExportedOrTheOldFilesAreThere_data()
    {
        everyFormat();
    }
    void hairIsExportedOrTheOldFilesAreThere()
    {
        QFETCH(int, number);
        QCOMPARE(underEach<test::FileFault>(exportFormats()[static_cast<std::size_t>(number)]), QString());
    }
#endif

    void whereMemoryIsRefusedHairIsExportedOrTheOldFilesAreThere_data()
    {
        everyFormat();
    }
    void whereMemoryIsRefusedHairIsExportedOrTheOldFilesAreThere()
    {
        QFETCH(int, number);
        const ExportFormat& format = exportFormats()[static_cast<std::size_t>(number)];
        QCOMPARE(underEach<test::AllocationFault>(format, format.hasCards ? kPictureBytes : kLargeBytes), QString());
    }
};

HAIRPAINT_TEST(TestExportFaults, Gui)
#include "test_export_faults.moc"
