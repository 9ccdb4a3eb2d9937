// The window is killed while somebody paints: the file opens, and the next start has all that was in the journal.
#include "app/background/journal_folder.h"
#include "model/journal/journal_reader.h"
#include "tests/app/window_fixture.h"
#include "tests/support/test_program.h"

#include <QCryptographicHash>
#include <QProcess>

#include <algorithm>
#include <array>
#include <functional>
#include <random>

namespace hairpaint::app {

namespace {

constexpr const char* kFolderVariable = "HAIRPAINT_KILLED_FOLDER";
constexpr const char* kSeedVariable = "HAIRPAINT_KILLED_SEED";
constexpr int kStartMs = 10 * kPatienceMs;                ///< Of many windows some start late.
constexpr const char* kGoesBack = "goes back or forth\n"; ///< Written down before an undo or a redo.

QByteArray hashOf(const QByteArray& bytes)
{
    return QCryptographicHash::hash(bytes, QCryptographicHash::Sha256).toHex();
}

constexpr const char* kIsKept = "is kept\n"; ///< Written down once the journal has the moment before it.

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

    unsigned below(unsigned count) { return static_cast<unsigned>(m_random() % count); }
    int belowInt(int count) { return static_cast<int>(below(static_cast<unsigned>(count))); }

    [[nodiscard]] QByteArray hashOfProject(const model::Project& project) const
    {
        const QString path = m_folder.filePath(QStringLiteral("content.hairpaint"));
        QFile file(path);
        if (!model::saveProject(project, path, {}) || !file.open(QIODevice::ReadOnly))
            return {};
        return hashOf(file.readAll());
    }

    /// Somebody paints on some map, in either area, undoes, fills, and saves now and then. `begins` is told what.
    void edit(const std::function<void(const char*)>& begins)
    {
        constexpr std::array kMaps{Qt::Key_1, Qt::Key_2, Qt::Key_3, Qt::Key_6, Qt::Key_8, Qt::Key_9};
        constexpr std::array kTools{Qt::Key_B, Qt::Key_B, Qt::Key_E, Qt::Key_C};
        const unsigned what = below(12);
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
        return moments;
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
    void cleanup() { m_window.reset(); }

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
        const auto writeDown = [&] { log.write(hashOfProject(session().document().committed()) + '\n'); };
        for (writeDown();; writeDown()) {
            if (below(3) == 0) {
                QTRY_VERIFY_WITH_TIMEOUT(m_window->isWorkKept(), kPatienceMs);
                log.write(kIsKept);
            }
            edit([&log](const char* action) { log.write(action); });
            session().document().endEdit();
            QCoreApplication::processEvents();
        }
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
        m_random.seed(4 + static_cast<unsigned>(first));
        for (int turn = first; turn < first + kills; ++turn) {
            QFile::remove(log);
            QProcess window;
            window.setProcessChannelMode(QProcess::ForwardedErrorChannel);
            QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
            environment.insert(QLatin1StringView(kFolderVariable), m_folder.path());
            environment.insert(QLatin1StringView(kSeedVariable), QString::number(turn));
            window.setProcessEnvironment(environment);
            window.start(QCoreApplication::applicationFilePath(),
                         {QStringLiteral("killed_window"), QStringLiteral("editsUntilItIsKilled"),
                          QStringLiteral("-maxwarnings"), QStringLiteral("0")});
            const std::size_t momentsLived = 2 + below(16);
            QTRY_VERIFY_WITH_TIMEOUT(momentsIn(log).size() >= momentsLived, kStartMs);
            QCOMPARE(window.state(), QProcess::Running);
            window.kill();
            QVERIFY(window.waitForFinished(kPatienceMs));

            const model::Result<model::Project> file = model::loadProject(saved);
            QVERIFY2(file, file ? "" : qPrintable(file.error().message));
            std::optional<model::RecoveredWork> work;
            for (const auto& folder : JournalFolder::abandoned(JournalFolder::root())) {
                auto read = model::readJournal(folder->file());
                QVERIFY2(read, read ? "" : qPrintable(read.error().message));
                if (*read)
                    work = std::move(**read);
                folder->remove();
            }
            const std::vector<Moment> moments = momentsIn(log);
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
            // One step further than what was written down? That stands beside it in the history; or an undo led back to
            // what the file holds, and there is nothing unsaved.
            const QString written = contentOf(log);
            const bool isBetweenSteps = written.endsWith(QString::fromLatin1(moments.back().content) + u'\n') ||
                                        written.endsWith(QLatin1StringView(kIsKept));
            if (lost < 0 && work && !isBetweenSteps)
                for (const std::size_t beside : {work->current - 1, work->current + 1})
                    if (lost < 0 && beside < work->steps.size() &&
                        hashOfProject(work->steps[beside].project) == moments.back().content)
                        lost = 0;
            if (lost < 0 && !work && written.endsWith(QLatin1StringView(kGoesBack)))
                lost = std::ranges::any_of(moments, [&](const Moment& m) { return m.content == came; }) ? 0 : -1;
            QVERIFY2(lost >= 0, qPrintable(QStringLiteral("Kill %1: what came back from the %2 is none of the %3 last "
                                                          "moments; log:\n%4")
                                               .arg(turn)
                                               .arg(work ? QLatin1String("journal") : QLatin1String("file"))
                                               .arg(moments.size() - oldest)
                                               .arg(written)));
            stepsLost += lost > 0 ? 1 : 0;
            if (turn % 50 == 49)
                qInfo("%d killed, %d from the journal", turn + 1 - first, fromJournal);
        }
        qInfo("%d kills: %d came back from the journal, the others from the file; %d lost something", kills,
              fromJournal, stepsLost);
    }
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestKilledWindow, Widgets)
#include "test_killed_window.moc"
