// One start of the helper for many files, and nothing of one of them in the next.
#include "app/importer/request_service.h"

#include "model/exporting/map_images.h"
#include "model/files/importer_client.h"
#include "model/files/wire_format.h"
#include "tests/model/archive_maker.h"
#include "tests/model/sample_project.h"
#include "tests/support/locations.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#ifdef Q_OS_UNIX
#include <array>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#endif

using namespace hairpaint;
using namespace hairpaint::model;

#ifdef Q_OS_UNIX
namespace {

/// A pipe whose ends this process and its forks share until they close them.
struct Pipe
{
    std::array<int, 2> ends = {-1, -1};

    Pipe()
    {
        if (::pipe2(ends.data(), O_CLOEXEC) != 0)
            std::abort();
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    ~Pipe()
    {
        closeReading();
        closeWriting();
    }
    void closeReading() { close(ends[0]); }
    void closeWriting() { close(ends[1]); }
    bool write(char byte) const { return ::write(ends[1], &byte, 1) == 1; }
    /// All that comes, at most so much; less where nobody can write any more.
    [[nodiscard]] QByteArray read(std::size_t most) const
    {
        QByteArray bytes;
        char byte = 0;
        while (static_cast<std::size_t>(bytes.size()) < most && ::read(ends[0], &byte, 1) == 1)
            bytes += byte;
        return bytes;
    }
    [[nodiscard]] bool holdsNothing() const
    {
        pollfd end{.fd = ends[0], .events = POLLIN, .revents = 0};
        return ::poll(&end, 1, 0) == 0;
    }

private:
    static void close(int& end)
    {
        if (end >= 0)
            ::close(end);
        end = -1;
    }
};

const QByteArray kServed(wire::kServed.data(), static_cast<qsizetype>(wire::kServed.size()));

/// importer::serveEach in a process of its own, whose requests are a byte each.
struct Service
{
    Pipe requests, told;
    pid_t process = -1;

    explicit Service(const std::function<int(char)>& serve)
    {
        process = ::fork();
        if (process != 0) {
            requests.closeReading();
            told.closeWriting();
            return;
        }
        ::signal(SIGABRT, SIG_DFL); // QtTest would look for the reason.
        const rlimit none{.rlim_cur = 0, .rlim_max = 0};
        ::setrlimit(RLIMIT_CORE, &none);
        ::dup2(requests.ends[0], STDIN_FILENO);
        ::dup2(told.ends[1], STDERR_FILENO);
        requests.closeReading();
        requests.closeWriting();
        told.closeReading();
        told.closeWriting();
        ::_exit(importer::serveEach([&serve] {
            char byte = 0;
            return ::read(STDIN_FILENO, &byte, 1) == 1 ? serve(byte) : 9;
        }));
    }
    /// Its exit code, once it has ended; -1 where a signal ended it.
    [[nodiscard]] int ended() const
    {
        int status = -1;
        ::waitpid(process, &status, 0);
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
};

} // namespace
#endif

class TestRequestService : public QObject
{
    Q_OBJECT
#ifdef Q_OS_UNIX
private:
    QTemporaryDir m_folder;

    [[nodiscard]] QString path(const QString& name) const
    {
        return m_folder.filePath(name);
    }
    /// Process ids of the helpers that were started, in order.
    [[nodiscard]] QList<QByteArray> starts() const
    {
        QFile file(path(QStringLiteral("starts")));
        return file.open(QIODevice::ReadOnly) ? file.readAll().trimmed().split('\n') : QList<QByteArray>();
    }
    static ForeignImage imageOf(int number)
    {
        ForeignImage image{.width = 20 + number, .height = 10, .channels = 3, .pixels = {}};
        image.pixels.assign(static_cast<std::size_t>(image.width) * 30, static_cast<std::uint16_t>(7000 * number));
        return image;
    }

private Q_SLOTS:
    /// A helper whose starts are counted.
    void init()
    {
        const QString script = path(QStringLiteral("counted"));
        test::writeBytes(script, "#!/bin/sh\necho $$ >>" + path(QStringLiteral("starts")).toLocal8Bit() + "\nexec " +
                                     test::importProgram().toLocal8Bit() + "\n");
        QVERIFY(QFile::setPermissions(script, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner));
        qputenv("HAIRPAINT_IMPORT", script.toLocal8Bit());
        QFile::remove(path(QStringLiteral("starts")));
    }
    void cleanupTestCase()
    {
        qunsetenv("HAIRPAINT_IMPORT");
    }

    void manyFilesCostOneStart()
    {
        ImporterClient client;
        for (const int number : {1, 2, 3})
            QVERIFY(client.writeImage(imageOf(number), path(QStringLiteral("%1.png").arg(number))));
        for (const int number : {3, 1, 2}) {
            const Result<ForeignImage> image = client.readImage(path(QStringLiteral("%1.png").arg(number)));
            QVERIFY(image);
            QCOMPARE(image->width, imageOf(number).width);
            QVERIFY(image->pixels == imageOf(number).pixels);
        }
        QCOMPARE(starts().size(), qsizetype{1});
    }

    void oneThatIsRefusedIsNamedAndTheNextIsTaken()
    {
        ImporterClient client;
        const QString good = path(QStringLiteral("good.png"));
        const QString broken = path(QStringLiteral("broken.png"));
        QVERIFY(client.writeImage(imageOf(1), good));
        test::writeBytes(broken, "no image");
        const Result<ForeignImage> refused = client.readImage(broken);
        QVERIFY(!refused && test::isOneSentenceNaming(refused.error().message, broken));
        QVERIFY(client.readImage(good));
        QCOMPARE(starts().size(), qsizetype{1});
    }

    void mapsCostOneStartAndCancellingInTheMiddleLeavesNothing()
    {
        std::vector<WantedMap> maps;
        for (const MapKind kind : {MapKind::Length, MapKind::Density, MapKind::Colour})
            maps.push_back({.group = QStringLiteral("Scalp"),
                            .kind = kind,
                            .resolved = std::make_shared<sim::TiledRaster>(256, mapSpec(kind).valueChannels,
                                                                           sim::Texel{30'000, 20'000, 10'000})});
        const QDir folder(path(QStringLiteral("maps")));
        QVERIFY(QDir().mkpath(folder.path()));
        const auto begunSecond = [](double done) { return done <= 1.0 / 3.0; };
        QVERIFY(!writeMapImages(maps, folder.path(), {}, begunSecond));
        QVERIFY(folder.isEmpty(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot));
        QCOMPARE(starts().size(), qsizetype{1});
        QVERIFY(::kill(starts().front().toInt(), 0) != 0); // It is gone.

        QVERIFY(writeMapImages(maps, folder.path(), {}));
        QStringList names = mapImageNames(maps, {});
        names.sort();
        QCOMPARE(folder.entryList(QDir::Files), names);
        QCOMPARE(starts().size(), qsizetype{2});
    }

    void aRequestKnowsNothingOfTheOneBefore()
    {
        int served = 0;
        Service service([&served](char) { return ++served == 1 ? 0 : 3; });
        for (const char request : {'a', 'b', 'c'}) {
            QVERIFY(service.requests.write(request));
            QCOMPARE(service.told.read(wire::kServed.size()), kServed);
        }
        service.requests.closeWriting();
        QCOMPARE(service.ended(), 0);
    }

    /// Its process is held by a file: it says so itself, and wants to answer for the next.
    void onlyTheEndOfItsProcessMakesARequestServed()
    {
        Pipe done, held;
        Service service([&](char) {
            held.closeWriting();
            (void)::write(STDERR_FILENO, wire::kServed.data(), wire::kServed.size());
            (void)::write(STDOUT_FILENO, wire::kServed.data(), wire::kServed.size());
            (void)done.write('!');
            (void)held.read(1); // Until this test closes it.
            return 0;
        });
        QVERIFY(service.requests.write('a'));
        QCOMPARE(done.read(1), QByteArray("!"));
        QVERIFY(service.told.holdsNothing());
        service.requests.closeWriting();
        QVERIFY(held.write('!'));
        QCOMPARE(service.told.read(100), kServed);
        QCOMPARE(service.ended(), 0);
    }

    void aRequestThatIsNotServedIsTheLast_data()
    {
        QTest::addColumn<char>("end");
        QTest::addColumn<int>("code");
        QTest::newRow("crashed") << 'a' << 2;
        QTest::newRow("killed") << 'k' << 2;
        QTest::newRow("given up") << '7' << 7;
    }
    void aRequestThatIsNotServedIsTheLast()
    {
        QFETCH(char, end);
        QFETCH(int, code);
        Service service([](char request) {
            if (request == 'a')
                std::abort();
            if (request == 'k')
                ::raise(SIGKILL);
            return request - '0';
        });
        QVERIFY(service.requests.write('0'));
        QCOMPARE(service.told.read(wire::kServed.size()), kServed);
        QVERIFY(service.requests.write(end));
        QCOMPARE(service.told.read(100), QByteArray());
        QCOMPARE(service.ended(), code);
    }

#ifdef Q_OS_LINUX
    void aRequestEndsWithTheHelper()
    {
        Pipe done;
        Service service([&done](char) {
            (void)done.write('!');
            for (;;)
                ::pause();
            return 0;
        });
        done.closeWriting();
        QVERIFY(service.requests.write('a'));
        QCOMPARE(done.read(1), QByteArray("!"));
        ::kill(service.process, SIGKILL);
        QCOMPARE(service.ended(), -1);
        QCOMPARE(done.read(1), QByteArray()); // Returns once nobody has the other end.
    }
#endif
#endif
};

HAIRPAINT_TEST(TestRequestService, Core)
#include "test_request_service.moc"
