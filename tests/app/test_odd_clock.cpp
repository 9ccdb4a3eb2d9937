// Clocks and time zones that are others when unsaved work is offered than when it was written.
#include "app/project/file_stamp.h"
#include "model/journal/journal_writer.h"
#include "tests/app/box_answer.h"
#include "tests/app/recovery_fixture.h"
#include "tests/support/test_program.h"

#include <array>
#include <ctime>
#include <optional>

namespace hairpaint::app {

namespace {

// A day and more apart, as they stand in TZ: hours west of Greenwich.
constexpr const char* kEast = "EAST-14";
constexpr const char* kWest = "WEST+12";

#ifdef Q_OS_WIN
constexpr bool kHeldLocksKeepTheirTime = true;
#else
constexpr bool kHeldLocksKeepTheirTime = false;
#endif

#ifdef Q_OS_UNIX
/// This process's time zone, until it is destroyed.
class Zone
{
public:
    explicit Zone(const char* zone) { set(zone); }
    ~Zone()
    {
        if (m_before)
            qputenv("TZ", *m_before);
        else
            qunsetenv("TZ");
        ::tzset();
    }
    Zone(const Zone&) = delete;
    Zone& operator=(const Zone&) = delete;

    static void set(const char* zone)
    {
        qputenv("TZ", zone);
        ::tzset();
    }

private:
    std::optional<QByteArray> m_before = qEnvironmentVariableIsSet("TZ") ? std::optional(qgetenv("TZ")) : std::nullopt;
};
#endif

} // namespace

class TestOddClock : public QObject, private RecoveryFixture
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { prepareRecovery("hairpaint-clock-test"); }
    void init() { clearRecovery(); }
    void cleanup() { m_window.reset(); }

    void anOddClockHidesNothing()
    {
        // Times of windows that were killed while the clock was wrong by decades, or before 1970.
        constexpr qint64 kYearMs = qint64{365} * 24 * 3600 * 1000;
        const qint64 now = QDateTime::currentMSecsSinceEpoch();
        const std::array<qint64, 5> times{-kYearMs, 0, now - 30 * kYearMs, now, now + 30 * kYearMs};
        const auto setTime = [](const QString& path, qint64 time) {
            QFile file(path);
            return file.open(QIODevice::ReadWrite) &&
                   file.setFileTime(QDateTime::fromMSecsSinceEpoch(time), QFileDevice::FileModificationTime);
        };
        for (std::size_t i = 0; i < times.size(); ++i) {
            const QString folder = makeFolder();
            const QString journal = folder + QStringLiteral("/journal");
            model::JournalWriter writer(journal);
            QVERIFY(writer.append({.project = model::newProject(),
                                   .path = QStringLiteral("/folder/work %1.hairpaint").arg(i),
                                   .step = {},
                                   .index = 0,
                                   .count = 0,
                                   .timeMs = times[i]}));
            leaveLock(folder);
            QVERIFY(setTime(journal, times[i]));
            QVERIFY(setTime(folder + QStringLiteral("/lock"), times[times.size() - 1 - i]));
        }
        // Nor does it take a lock from a window that lives.
        openBald();
        stroke(0.5F);
        m_window->keepWork();
        for (const QString& name : QDir(JournalFolder::root()).entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
            const QString lock = JournalFolder::root() + QLatin1Char('/') + name + QStringLiteral("/lock");
            QVERIFY(setTime(lock, now - 30 * kYearMs) || kHeldLocksKeepTheirTime);
        }
        const auto other = std::make_unique<MainWindow>(model::newProject());
        RecoveryAnswer answer(QStringLiteral("Not now"));
        other->offerUnsavedWork();
        QCOMPARE(answer.offered.size(), static_cast<qsizetype>(times.size()));
        for (qsizetype i = 0; i < answer.offered.size(); ++i) // The newest first.
            QVERIFY2(answer.offered[i].startsWith(QStringLiteral("work %1").arg(answer.offered.size() - 1 - i)),
                     qPrintable(answer.offered[i]));
    }

#ifdef Q_OS_UNIX
    void anotherZoneHidesNothing_data()
    {
        QTest::addColumn<QByteArray>("written");
        QTest::addColumn<QByteArray>("read");
        QTest::newRow("to the west") << QByteArray(kEast) << QByteArray(kWest);
        QTest::newRow("to the east") << QByteArray(kWest) << QByteArray(kEast);
    }
    void anotherZoneHidesNothing()
    {
        QFETCH(QByteArray, written);
        QFETCH(QByteArray, read);
        const QString path = m_folder.filePath(QStringLiteral("P.hairpaint"));
        const Zone zone(written.constData());
        const QByteArray changed = crashAfterSaving(path);
        QVERIFY(!changed.isEmpty());
        // What a window left later is the newer, though its wall clock may have told an earlier hour.
        Zone::set(read.constData());
        openBald();
        stroke(0.4F);
        crash();
        openWindow(model::newProject());
        {
            RecoveryAnswer later(QStringLiteral("Not now"));
            offer();
            QCOMPARE(later.offered.size(), 2);
            QVERIFY2(later.offered[1].startsWith(QLatin1Char('P')), qPrintable(later.offered.join(u'/')));
        }
        {
            const RecoveryAnswer answer(QStringLiteral("Restore"));
            m_window->begin(path);
        }
        QCOMPARE(m_window->files().path(), path);
        QCOMPARE(savedBytes("restored.hairpaint"), changed);
        QCOMPARE(stack().index(), 2);
        // Nobody has changed its file, neither since the crash nor while the window travels back.
        const BoxAnswer question(QStringLiteral("Cancel"));
        QVERIFY(m_window->files().save());
        Zone::set(written.constData());
        stroke(0.7F);
        QVERIFY(m_window->files().save());
        QCOMPARE(question.asked, QStringList());
    }

    void aZoneThatChangesDoesNotChangeFiles()
    {
        const QString path = m_folder.filePath(QStringLiteral("P.hairpaint"));
        test::writeBytes(path, "P");
        const Zone zone(kEast);
        const FileStamp before = stampOf(path);
        Zone::set(kWest);
        QVERIFY(!isChanged(before, stampOf(path)));
    }
#endif
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestOddClock, Widgets)
#include "test_odd_clock.moc"
