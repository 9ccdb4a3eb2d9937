// The window is killed while somebody paints: the file opens, and the next start has all that was in the journal.
#include "app/background/journal_folder.h"
#include "app/recovery/recovery_dialog.h"
#include "model/journal/journal_reader.h"
#include "model/journal/journal_writer.h"
#include "tests/app/box_answer.h"
#include "tests/app/window_fixture.h"
#include "tests/support/file_faults.h"
#include "tests/support/full_disk.h"
#include "tests/support/test_program.h"

#include <QCryptographicHash>
#include <QProcess>

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <random>

namespace hairpaint::app {

namespace {

constexpr const char* kFolderVariable = "HAIRPAINT_KILLED_FOLDER";
constexpr const char* kSeedVariable = "HAIRPAINT_KILLED_SEED";
constexpr int kStartMs = 10 * kPatienceMs;                ///< Of many windows some start late.
constexpr qsizetype kMostShown = 800;                     ///< Letters of a log.
constexpr const char* kGoesBack = "goes back or forth\n"; ///< Written down before an undo or a redo.

QByteArray hashOf(const QByteArray& bytes)
{
    return QCryptographicHash::hash(bytes, QCryptographicHash::Sha256).toHex();
}

constexpr const char* kIsKept = "is kept\n"; ///< Written down once the journal has the moment before it.
constexpr const char* kIsLost = "is lost\n"; ///< Before somebody removes the journals' folder.

/// Restores what is offered, and calls off whatever else asks.
class Restorer : public BoxAnswer
{
public:
    Restorer() : BoxAnswer(QStringLiteral("Cancel")) {}

protected:
    bool ends(QWidget& dialog) override
    {
        if (auto* offered = qobject_cast<RecoveryDialog*>(&dialog))
            offered->accept();
        return false;
    }
};

/// One line of what the window wrote down before it was killed: what was open, and whether the journal had it all.
struct Moment
{
    QByteArray content;
    bool isKept = false;
};

} // namespace

class TestKilledWindow : public QObject, private WindowFixture
{
    Q_OBJECT
private:
    std::mt19937 m_random;
#ifdef Q_OS_LINUX
    std::optional<test::FullDisk> m_full;
    std::optional<test::FileRefusal> m_readOnly;
#endif
    QByteArray m_journals;

    void beFull()
    {
#ifdef Q_OS_LINUX
        constexpr qint64 kRoom = 60'000; // Enough for what is written down.
        m_full.emplace(kRoom);
#endif
    }
    bool endFullness()
    {
#ifdef Q_OS_LINUX
        const bool wasFull = m_full.has_value();
        m_full.reset();
        return wasFull;
#else
        return false;
#endif
    }

    /// Somebody removes the journals, or their disk is full or can't be written to for a few edits.
    void trouble([[maybe_unused]] const std::function<void(const char*)>& begins)
    {
#ifdef Q_OS_LINUX
        const bool wasTroubled = m_full || m_readOnly;
        m_full.reset();
        m_readOnly.reset();
        if (wasTroubled)
            return;
        switch (below(3)) {
        case 0:
            begins(kIsLost);
            QDir(JournalFolder::root()).removeRecursively();
            return;
        case 1:
            return beFull();
        default:
            m_readOnly.emplace(m_journals.constData(), test::FileRefusal::Why::ReadOnly);
        }
#endif
    }

    /// A question that waits, or a dialog beside the window.
    void ask()
    {
        const bool isAsked = session().document().modified() && below(2) == 0;
        m_window->actions().find(QLatin1StringView(isAsked ? "file.new" : "edit.preferences"))->trigger();
        for (const QPointer<QDialog>& dialog : openDialogs(*m_window))
            if (below(2) == 0)
                dialog->close();
    }

    unsigned below(unsigned count)
    {
        return static_cast<unsigned>(m_random() % count);
    }
    int belowInt(int count)
    {
        return static_cast<int>(below(static_cast<unsigned>(count)));
    }

    [[nodiscard]] QByteArray hashOfProject(const model::Project& project) const
    {
        const QString path = m_folder.filePath(QStringLiteral("content.hairpaint"));
        QFile file(path);
        if (!model::saveProject(project, path, {}) || !file.open(QIODevice::ReadOnly))
            return QByteArray("unknown"); // Its disk is full.
        return hashOf(file.readAll());
    }

    /// Somebody paints on some map, in either area, undoes, fills, and saves now and then. `begins` is told what.
    void edit(const std::function<void(const char*)>& begins)
    {
        constexpr std::array kMaps{Qt::Key_1, Qt::Key_2, Qt::Key_3, Qt::Key_6, Qt::Key_8, Qt::Key_9};
        constexpr std::array kTools{Qt::Key_B, Qt::Key_B, Qt::Key_E, Qt::Key_C};
        const unsigned what = below(14);
        begins(("edit " + QByteArray::number(what) + '\n').constData());
        begins(what < 3 ? kGoesBack : "goes on\n");
        switch (what) {
        case 0:
        case 1:
            return key(Qt::Key_Z, Qt::ControlModifier);
        case 2:
            return key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        case 3:
            return key(Qt::Key_Backspace, Qt::AltModifier);
        case 4:
            return m_window->actions().find(QLatin1StringView("file.save"))->trigger();
        case 5:
            return ask();
        case 6:
            return trouble(begins);
        default:
            break;
        }
        key(kMaps[below(kMaps.size())]);
        key(kTools[below(kTools.size())]);
        QWidget& area =
            below(3) == 0 ? static_cast<QWidget&>(m_window->headView()) : static_cast<QWidget&>(m_window->paintView());
        const auto somewhere = [&] { return QPoint(belowInt(area.width()), belowInt(area.height())); };
        drag(area, somewhere(), somewhere());
    }

    /// What another process wrote down.
    static std::vector<Moment> momentsIn(const QString& path)
    {
        std::vector<Moment> moments;
        for (const QString& line : contentOf(path).split(QLatin1Char('\n')))
            if (line.size() == 64)
                moments.push_back({.content = line.toLatin1()});
            else if (line + QLatin1Char('\n') == QLatin1StringView(kIsKept) && !moments.empty())
                moments.back().isKept = true;
            else if (line + QLatin1Char('\n') == QLatin1StringView(kIsLost))
                for (Moment& moment : moments)
                    moment.isKept = false;
        return moments;
    }

    /// Of windows that were killed; the newest.
    static std::optional<model::RecoveredWork> leftWork()
    {
        for (const auto& folder : JournalFolder::abandoned(JournalFolder::root()))
            if (auto read = model::readJournal(folder->file()); read && *read)
                return std::move(**read);
        return std::nullopt;
    }
    static void removeLeft()
    {
        for (const auto& folder : JournalFolder::abandoned(JournalFolder::root()))
            folder->remove();
    }

    static QString contentOf(const QString& path)
    {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? QString::fromLatin1(file.readAll()) : QString();
    }

    /// The first moment that may come back: the last one that the journal was known to have.
    static std::size_t firstAllowed(const std::vector<Moment>& moments)
    {
        std::size_t first = 0;
        for (std::size_t i = 0; i < moments.size(); ++i)
            if (moments[i].isKept)
                first = i;
        return first;
    }

private Q_SLOTS:
    void initTestCase()
    {
        prepareApplication();
        QCoreApplication::setApplicationName(QStringLiteral("hairpaint-killed-test")); // A root of its own.
    }
    void cleanup()
    {
        m_window.reset();
    }

    /// The process that is killed: does nothing where no other one has started it.
    void editsUntilItIsKilled()
    {
        const QString folder = qEnvironmentVariable(kFolderVariable);
        if (folder.isEmpty())
            return;
        m_random.seed(static_cast<unsigned>(qEnvironmentVariableIntValue(kSeedVariable)));
        openWindow(model::newProject());
        const QString path = QDir(folder).filePath(QStringLiteral("work.hairpaint"));
        QVERIFY(model::saveProject(session().document().committed(), path, {}));
        QVERIFY(m_window->files().openPath(path));
        QFile log(QDir(folder).filePath(QStringLiteral("log")));
        QVERIFY(log.open(QIODevice::WriteOnly | QIODevice::Unbuffered));
        m_journals = QFile::encodeName(QFileInfo(JournalFolder::root()).absolutePath());
        const Restorer answers;
        const auto writeDown = [&] {
            // What is full is the journals' disk, not the tester's.
            const bool wasFull = endFullness();
            log.write(hashOfProject(session().document().committed()) + '\n');
            if (wasFull)
                beFull();
        };
        for (writeDown();; writeDown()) {
            if (below(3) == 0) {
                m_window->keepWork();
                test::handleDueEvents();
                if (m_window->isWorkKept())
                    log.write(kIsKept);
            }
            edit([&log](const char* action) { log.write(action); });
            session().document().endEdit();
            QCoreApplication::processEvents();
        }
    }

    /// The process that is killed while it restores.
    void restoresUntilItIsKilled()
    {
        const QString folder = qEnvironmentVariable(kFolderVariable);
        if (folder.isEmpty())
            return;
        openWindow(model::newProject());
        QFile log(QDir(folder).filePath(QStringLiteral("log")));
        QVERIFY(log.open(QIODevice::WriteOnly | QIODevice::Unbuffered));
        const Restorer answers;
        log.write("begins\n");
        m_window->offerUnsavedWork();
        log.write("ends\n");
        (void)test::awaitUntil([] { return false; }); // Until it is killed.
    }

    void aKilledWindowLosesNothingThatItHadKept()
    {
        // HAIRPAINT_KILLS=100 HAIRPAINT_KILLS_FIRST=300: the fourth hundred of many.
        const int kills = std::max(qEnvironmentVariableIntValue("HAIRPAINT_KILLS"), 2);
        const int first = qEnvironmentVariableIntValue("HAIRPAINT_KILLS_FIRST");
        const QString log = m_folder.filePath(QStringLiteral("log"));
        const QString saved = m_folder.filePath(QStringLiteral("work.hairpaint"));
        int fromJournal = 0;
        int stepsLost = 0;
        int restoredTurns = 0;
        m_random.seed(4 + static_cast<unsigned>(first));
        for (int turn = first; turn < first + kills; ++turn) {
            QFile::remove(log);
            QProcess window;
            window.setProcessChannelMode(QProcess::ForwardedErrorChannel);
            QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
            environment.insert(QLatin1StringView(kFolderVariable), m_folder.path());
            environment.insert(QLatin1StringView(kSeedVariable), QString::number(turn));
            window.setProcessEnvironment(environment);
            const auto start = [&window](const char* what) {
                window.start(QCoreApplication::applicationFilePath(),
                             {QStringLiteral("killed_window"), QLatin1StringView(what), QStringLiteral("-maxwarnings"),
                              QStringLiteral("0")});
            };
            start("editsUntilItIsKilled");
            const std::size_t momentsLived = 2 + below(16);
            QTRY_VERIFY_WITH_TIMEOUT(momentsIn(log).size() >= momentsLived, kStartMs);
            QCOMPARE(window.state(), QProcess::Running);
            window.kill();
            QVERIFY(window.waitForFinished(kPatienceMs));

            const model::Result<model::Project> file = model::loadProject(saved);
            QVERIFY2(file, file ? "" : qPrintable(file.error().message));
            const std::vector<Moment> moments = momentsIn(log);
            const QString written = contentOf(log);
            std::optional<model::RecoveredWork> work = leftWork();
            // What is killed while it restores has restored, or leaves all as it was.
            if (work && (kills < 5 || turn % 3 == 0)) {
                QFile::remove(log);
                start("restoresUntilItIsKilled");
                QTRY_VERIFY_WITH_TIMEOUT(contentOf(log).startsWith(QLatin1String("begins")), kStartMs);
                unsigned looks = below(400);
                (void)test::awaitUntil(
                    [&] { return looks-- == 0 || contentOf(log).endsWith(QLatin1String("ends\n")); });
                window.kill();
                QVERIFY(window.waitForFinished(kPatienceMs));
                const std::optional<model::RecoveredWork> again = leftWork();
                QVERIFY2(again, qPrintable(QStringLiteral("Kill %1: nothing is left of what was restored").arg(turn)));
                QVERIFY(again->current <= work->current);
                const std::size_t gone = work->current - again->current; // Of the oldest steps.
                QVERIFY(gone == 0 || again->steps.size() >= model::JournalWriter::kKeptStates - 1);
                QCOMPARE(again->steps.size() + gone, work->steps.size());
                for (std::size_t i = 0; i < again->steps.size(); ++i)
                    QCOMPARE(hashOfProject(again->steps[i].project), hashOfProject(work->steps[i + gone].project));
                ++restoredTurns;
            }
            removeLeft();
            const std::size_t oldest = firstAllowed(moments);
            const auto among = [&](const QByteArray& content) {
                for (std::size_t i = moments.size(); i > oldest; --i)
                    if (moments[i - 1].content == content)
                        return static_cast<int>(moments.size() - i);
                return -1;
            };
            fromJournal += work ? 1 : 0;
            const QByteArray came = hashOfProject(work ? work->steps[work->current].project : *file);
            int lost = among(came);
            // A journal that could not be told of a save is offered beside the file that holds more.
            if (lost < 0 && work)
                lost = among(hashOfProject(*file));
            // One step further than what was written down? That stands beside it in the history; or an undo led back to
            // what the file holds, and there is nothing unsaved.
            const bool isBetweenSteps = written.endsWith(QString::fromLatin1(moments.back().content) + u'\n') ||
                                        written.endsWith(QLatin1StringView(kIsKept));
            if (lost < 0 && work && !isBetweenSteps)
                for (const std::size_t beside : {work->current - 1, work->current + 1})
                    if (lost < 0 && beside < work->steps.size() &&
                        hashOfProject(work->steps[beside].project) == moments.back().content)
                        lost = 0;
            if (lost < 0 && !work && written.endsWith(QLatin1StringView(kGoesBack)))
                lost = std::ranges::any_of(moments, [&](const Moment& m) { return m.content == came; }) ? 0 : -1;
            QVERIFY2(lost >= 0, qPrintable(QStringLiteral("Kill %1: what came back from the %2 (%5) is none of the %3 "
                                                          "last moments; log:\n%4")
                                               .arg(turn)
                                               .arg(work ? QLatin1String("journal") : QLatin1String("file"))
                                               .arg(moments.size() - oldest)
                                               .arg(written.right(kMostShown), QString::fromLatin1(came))));
            stepsLost += lost > 0 ? 1 : 0;
            if (turn % 50 == 49)
                qInfo("%d killed, %d from the journal", turn + 1 - first, fromJournal);
        }
        qInfo(
            "%d kills: %d came back from the journal, %d of them killed once more while they were restored, the others "
            "from the file; %d lost something",
            kills, fromJournal, restoredTurns, stepsLost);
    }
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestKilledWindow, Widgets)
#include "test_killed_window.moc"
