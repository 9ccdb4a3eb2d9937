// The window is killed while somebody paints: the file opens, and the next start has all that was in the journal.
#include "app/background/journal_folder.h"
#include "app/recovery/recovery_dialog.h"
#include "model/document/paint_command.h"
#include "model/journal/journal_reader.h"
#include "model/journal/journal_writer.h"
#include "tests/app/box_answer.h"
#include "tests/app/thin_project.h"
#include "tests/app/window_fixture.h"
#include "tests/model/archive_maker.h"
#include "tests/support/file_faults.h"
#include "tests/support/full_disk.h"
#include "tests/support/test_program.h"

#include <QCryptographicHash>
#include <QDialogButtonBox>
#include <QLineEdit>
#include <QProcess>
#include <QtEndian>

#include <algorithm>
#include <array>
#include <chrono>
#include <functional>
#include <optional>
#include <random>

namespace hairpaint::app {

namespace {

constexpr const char* kFolderVariable = "HAIRPAINT_KILLED_FOLDER";
constexpr const char* kSeedVariable = "HAIRPAINT_KILLED_SEED";
constexpr std::array kZones{"EAST-14", "WEST+12"};        ///< Each start is in the other one, a day and more away.
constexpr int kStartMs = 10 * kPatienceMs;                ///< Among many windows, some start late.
constexpr qsizetype kMostShown = 800;                     ///< Greatest number of a log's letters that a failure shows.
constexpr const char* kGoesBack = "goes back or forth\n"; ///< Written down before an undo or a redo.

QByteArray hashOf(const QByteArray& bytes)
{
    return QCryptographicHash::hash(bytes, QCryptographicHash::Sha256).toHex();
}

constexpr const char* kIsKept = "is kept\n"; ///< Written down once the journal has the moment before it.
constexpr const char* kIsLost = "is lost\n"; ///< Before somebody removes the journals' folder.

/// Restores what is offered, exports to `exported`, and calls off whatever else asks.
class Restorer : public BoxAnswer
{
public:
    explicit Restorer(QString exported = {}) : BoxAnswer(QStringLiteral("Cancel")), m_exported(std::move(exported)) {}

protected:
    bool ends(QWidget& dialog) override
    {
        if (auto* offered = qobject_cast<RecoveryDialog*>(&dialog))
            offered->accept();
        if (m_exported.isEmpty())
            return false;
        if (auto* box = qobject_cast<QMessageBox*>(&dialog);
            box != nullptr && box->button(QMessageBox::Yes) != nullptr) {
            box->button(QMessageBox::Yes)->click(); // The export before is replaced.
            return true;
        }
        auto* files = qobject_cast<QFileDialog*>(&dialog);
        if (files == nullptr)
            return false;
        files->findChild<QLineEdit*>()->setText(m_exported);
        pressAccept(*files);
        return true;
    }

public:
    static void pressAccept(QDialog& dialog)
    {
        auto* buttons = dialog.findChild<QDialogButtonBox*>();
        for (QAbstractButton* button : buttons->buttons())
            if (buttons->buttonRole(button) == QDialogButtonBox::AcceptRole)
                return button->click();
    }

private:
    QString m_exported;
};

/// Whether that is a file of the HAIR format from its first byte to its last.
bool isWholeHair(const QByteArray& bytes)
{
    constexpr qsizetype kHeader = 128;
    if (bytes.size() < kHeader || !bytes.startsWith("HAIR"))
        return false;
    const auto number = [&bytes](qsizetype at) {
        return static_cast<qsizetype>(qFromLittleEndian<quint32>(bytes.constData() + at));
    };
    const qsizetype hairs = number(4);
    const qsizetype points = number(8);
    const qsizetype arrays = number(12);
    // Segments of a hair; position, thickness, opacity, colour of a point.
    constexpr std::array<qsizetype, 5> kBytes{2, 12, 4, 4, 12};
    qsizetype expected = kHeader;
    for (std::size_t array = 0; array < kBytes.size(); ++array)
        if ((arrays >> array & 1) != 0)
            expected += kBytes[array] * (array == 0 ? hairs : points);
    return bytes.size() == expected && hairs > 0;
}

/// What windows of these seeds do besides.
bool hasHair(unsigned seed)
{
    return seed % 3 == 1;
}
bool fillsTheJournal(unsigned seed)
{
    return seed % 5 == 4;
}

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
    std::optional<test::FileStall> m_silent;
#endif
    QByteArray m_journals;
    unsigned m_seed = 0;

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

    /// Somebody removes the journals, or their disk is full, can't be written to or does not answer for a few edits.
    void trouble([[maybe_unused]] const std::function<void(const char*)>& begins)
    {
#ifdef Q_OS_LINUX
        const bool wasTroubled = m_full || m_readOnly || m_silent;
        m_full.reset();
        m_readOnly.reset();
        m_silent.reset();
        if (wasTroubled)
            return;
        switch (below(4)) {
        case 0:
            begins(kIsLost);
            QDir(JournalFolder::root()).removeRecursively();
            return;
        case 1:
            return beFull();
        case 2:
            m_silent.emplace(m_journals.constData());
            return;
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

    void exportHair()
    {
        m_window->actions().find(QLatin1StringView("file.exportHair"))->trigger();
        for (const QPointer<QDialog>& dialog : openDialogs(*m_window))
            Restorer::pressAccept(*dialog);
    }

    /// A layer of noise, 4 MB, so that the journal is soon so large that it is written anew.
    void fillJournal()
    {
        const model::HairGroup& group = session().document().project().groups.front();
        const model::Layer& layer = group.map(model::MapKind::Length).layers.front();
        model::LayerTiles tiles;
        for (int i = 0; i < layer.raster.tileCount(); ++i) {
            auto tile = std::make_shared<sim::RasterTile>();
            tile->pixels.resize(sim::kTileTexels * 2);
            std::ranges::generate(tile->pixels, [this] { return static_cast<std::uint16_t>(m_random()); });
            tiles.push_back({i, sim::RasterTilePtr(std::move(tile))});
        }
        session().document().push(model::paintCommand(
            session().document(), {.group = group.id, .map = model::MapKind::Length, .layer = layer.id},
            std::move(tiles), QStringLiteral("Noise")));
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
        if (hasHair(m_seed) && what > 11) {
            begins("goes on\n");
            return exportHair();
        }
        if (fillsTheJournal(m_seed) && what > 4) {
            begins("goes on\n");
            return fillJournal();
        }
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

    /// The work of the window that was killed last.
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
        m_seed = static_cast<unsigned>(qEnvironmentVariableIntValue(kSeedVariable));
        m_random.seed(m_seed);
        openWindow(hasHair(m_seed) ? test::thinned(starterProject()) : model::newProject());
        m_window->journal().setPatience(std::chrono::milliseconds(20)); // With a disk that does not answer.
        const QString path = QDir(folder).filePath(QStringLiteral("work.hairpaint"));
        QVERIFY(model::saveProject(session().document().committed(), path, {}));
        QVERIFY(m_window->files().openPath(path));
        QFile log(QDir(folder).filePath(QStringLiteral("log")));
        QVERIFY(log.open(QIODevice::WriteOnly | QIODevice::Unbuffered));
        m_journals = QFile::encodeName(QFileInfo(JournalFolder::root()).absolutePath());
        const Restorer answers(QDir(folder).filePath(QStringLiteral("out.hair")));
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
        const QString out = m_folder.filePath(QStringLiteral("out.hair"));
        int exports = 0;
        int fromJournal = 0;
        int stepsLost = 0;
        int restoredTurns = 0;
        m_random.seed(4 + static_cast<unsigned>(first));
        for (int turn = first; turn < first + kills; ++turn) {
            QFile::remove(log);
            if (below(2) == 0)
                QFile::remove(out);
            QProcess window;
            window.setProcessChannelMode(QProcess::ForwardedErrorChannel);
            QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
            environment.insert(QLatin1StringView(kFolderVariable), m_folder.path());
            environment.insert(QLatin1StringView(kSeedVariable), QString::number(turn));
            auto starts = static_cast<std::size_t>(turn);
            const auto start = [&](const char* what) {
                environment.insert(QStringLiteral("TZ"), QLatin1StringView(kZones[starts++ % kZones.size()]));
                window.setProcessEnvironment(environment);
                window.start(QCoreApplication::applicationFilePath(),
                             {QStringLiteral("killed_window"), QLatin1StringView(what), QStringLiteral("-maxwarnings"),
                              QStringLiteral("0")});
            };
            start("editsUntilItIsKilled");
            const std::size_t momentsLived = 2 + below(16) + (fillsTheJournal(static_cast<unsigned>(turn)) ? 18 : 0);
            QTRY_VERIFY_WITH_TIMEOUT(momentsIn(log).size() >= momentsLived, kStartMs);
            QCOMPARE(window.state(), QProcess::Running);
            window.kill();
            QVERIFY(window.waitForFinished(kPatienceMs));

            const model::Result<model::Project> file = model::loadProject(saved);
            QVERIFY2(file, file ? "" : qPrintable(file.error().message));
            const QByteArray exported = test::readBytes(out);
            QVERIFY2(exported.isEmpty() || isWholeHair(exported), qPrintable(QStringLiteral("Kill %1").arg(turn)));
            exports += exported.isEmpty() ? 0 : 1;
            const std::vector<Moment> moments = momentsIn(log);
            const QString written = contentOf(log);
            const std::size_t foldersLeft = JournalFolder::abandoned(JournalFolder::root()).size();
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
                const std::size_t gone = work->current - again->current; // Only the oldest steps may be lost.
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
                                                          "last moments; %6 folders; log:\n%4")
                                               .arg(turn)
                                               .arg(work ? QLatin1String("journal") : QLatin1String("file"))
                                               .arg(moments.size() - oldest)
                                               .arg(written.right(kMostShown), QString::fromLatin1(came))
                                               .arg(foldersLeft)));
            stepsLost += lost > 0 ? 1 : 0;
            if (turn % 50 == 49)
                qInfo("%d killed, %d from the journal", turn + 1 - first, fromJournal);
        }
        qInfo(
            "%d kills: %d came back from the journal, %d of them killed once more while they were restored, the others "
            "from the file; %d lost something; %d times an export lay there, whole",
            kills, fromJournal, restoredTurns, stepsLost, exports);
    }
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestKilledWindow, Widgets)
#include "test_killed_window.moc"
