// Starting, feeding, reading and ending the helper.
#include "model/files/helper_process.h"

#include <QElapsedTimer>
#include <QProcess>

#include <algorithm>
#include <optional>

#ifdef Q_OS_UNIX
#include <csignal>
#ifdef Q_OS_LINUX
#include <sys/prctl.h>
#endif
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace hairpaint::model {

namespace {

constexpr int kPollMs = 50;
/// More than the greatest request and its encoded answer need together.
[[maybe_unused]] constexpr quint64 kMostMemoryBytes = 1'900'000'000;
[[maybe_unused]] constexpr quint64 kMappedBytes = 1'500'000'000;

#ifdef Q_OS_UNIX

#if defined(HAIRPAINT_ASAN)
constexpr bool kLimitMemory = false; // address sanitizers reserve terabytes
#else
constexpr bool kLimitMemory = true;
#endif

/// Runs in the child between fork and exec: only async-signal-safe calls.
void confineChild(int timeoutMs)
{
    setpgid(0, 0);
#ifdef Q_OS_LINUX
    prctl(PR_SET_PDEATHSIG, SIGKILL); // Nobody is left to read what it says.
#endif
    const rlimit none{.rlim_cur = 0, .rlim_max = 0};
    setrlimit(RLIMIT_CORE, &none);
    const rlim_t seconds = static_cast<rlim_t>(timeoutMs / 1000) + 2;
    // Two cores may be at work.
    const rlimit processor{.rlim_cur = 2 * seconds, .rlim_max = 2 * seconds + 1};
    setrlimit(RLIMIT_CPU, &processor);
    if (kLimitMemory) {
#ifdef Q_OS_LINUX
        // What it writes to; libraries alone map most of a gigabyte that is never in memory.
        const rlimit written{.rlim_cur = kMostMemoryBytes, .rlim_max = kMostMemoryBytes};
        setrlimit(RLIMIT_DATA, &written);
        const rlimit memory{.rlim_cur = kMostMemoryBytes + kMappedBytes, .rlim_max = kMostMemoryBytes + kMappedBytes};
#else
        const rlimit memory{.rlim_cur = kMostMemoryBytes, .rlim_max = kMostMemoryBytes};
#endif
        setrlimit(RLIMIT_AS, &memory);
    }
}

void confine(QProcess& process, int timeoutMs)
{
    process.setChildProcessModifier([timeoutMs] { confineChild(timeoutMs); });
}

void killGroup(QProcess& process)
{
    if (const qint64 id = process.processId(); id > 0)
        ::kill(static_cast<pid_t>(-id), SIGKILL);
    process.kill();
}

#else

// On Windows the helper bounds itself by a job object (app/importer/resource_limits.cpp).
void confine(QProcess& /*process*/, int /*timeoutMs*/) {}

void killGroup(QProcess& process)
{
    process.kill();
}

#endif

/// Collects an answer's bytes; allocates the body only after its header was found good.
class AnswerReader
{
public:
    /// False where the bytes are not an answer's.
    bool take(QProcess& process)
    {
        if (!m_header) {
            m_start.append(process.read(static_cast<qint64>(wire::kHeaderBytes) - m_start.size()));
            if (m_start.size() < static_cast<qsizetype>(wire::kHeaderBytes))
                return true;
            m_header = wire::decodeHeader(std::as_bytes(std::span(m_start.constData(), wire::kHeaderBytes)));
            if (!m_header || m_header->kind < wire::Kind::Image)
                return false;
        }
        // Grows with what has really come, so a claim alone costs nothing.
        while (process.bytesAvailable() > 0) {
            const std::size_t room = static_cast<std::size_t>(m_header->bodyBytes) - m_body.size();
            const std::size_t count = std::min<std::size_t>(room, static_cast<std::size_t>(process.bytesAvailable()));
            if (count == 0)
                return false;
            const std::size_t before = m_body.size();
            if (m_body.capacity() < before + count)
                m_body.reserve(std::min<std::size_t>(static_cast<std::size_t>(m_header->bodyBytes),
                                                     std::max(2 * m_body.capacity(), before + count)));
            m_body.resize(before + count);
            if (process.read(reinterpret_cast<char*>(m_body.data() + before), static_cast<qint64>(count)) !=
                static_cast<qint64>(count))
                return false;
        }
        return true;
    }
    [[nodiscard]] bool complete() const { return m_header && m_body.size() == m_header->bodyBytes; }
    [[nodiscard]] double fraction() const
    {
        return m_header ? static_cast<double>(m_body.size()) / static_cast<double>(m_header->bodyBytes) : 0.0;
    }
    HelperAnswer answer() { return {.kind = m_header->kind, .body = std::move(m_body)}; }

private:
    QByteArray m_start;
    std::optional<wire::Header> m_header;
    wire::Bytes m_body;
};

std::optional<HelperFailure> converse(QProcess& process, AnswerReader& reader, int timeoutMs, const Progress& progress)
{
    QElapsedTimer clock;
    clock.start();
    while (process.state() == QProcess::Running || process.bytesAvailable() > 0) {
        if (process.state() == QProcess::Running && !process.waitForReadyRead(kPollMs) &&
            process.state() == QProcess::Running)
            process.waitForFinished(1);
        if (!reader.take(process))
            return HelperFailure::Nonsense;
        if (reader.complete() && process.state() != QProcess::Running)
            break;
        if (progress && !progress(reader.fraction()))
            return HelperFailure::Cancelled;
        if (clock.elapsed() > timeoutMs)
            return HelperFailure::TimedOut;
    }
    return std::nullopt;
}

} // namespace

tl::expected<HelperAnswer, HelperFailure> runHelper(const QString& program, const wire::Bytes& request, int timeoutMs,
                                                    const Progress& progress)
{
    QProcess process;
    // Decoders print lines of their own; the program's one line is its own.
    process.setStandardErrorFile(QProcess::nullDevice());
    confine(process, timeoutMs);
    process.start(program, QStringList());
    if (!process.waitForStarted(timeoutMs))
        return tl::unexpected(HelperFailure::NotStarted);
    process.write(reinterpret_cast<const char*>(request.data()), static_cast<qint64>(request.size()));
    process.closeWriteChannel();

    AnswerReader reader;
    const std::optional<HelperFailure> failed = converse(process, reader, timeoutMs, progress);
    if (failed) {
        killGroup(process);
        process.waitForFinished();
        return tl::unexpected(*failed);
    }
    if (process.exitStatus() != QProcess::NormalExit || process.exitCode() != 0)
        return tl::unexpected(HelperFailure::Crashed);
    if (!reader.complete())
        return tl::unexpected(HelperFailure::Nonsense);
    return reader.answer();
}

} // namespace hairpaint::model
