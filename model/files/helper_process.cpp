// Starting, feeding, reading and ending the helper.
#include "model/files/helper_process.h"

#include "model/files/helper_confinement.h"

#include <QElapsedTimer>
#include <QProcess>

#include <algorithm>
#include <optional>

namespace hairpaint::model {

namespace {

constexpr int kPollMs = 50;

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

/// Waits for what `channel` brings, for a moment.
void listen(QProcess& process, QProcess::ProcessChannel channel)
{
    process.setReadChannel(channel);
    if (!process.waitForReadyRead(kPollMs) && process.state() == QProcess::Running)
        process.waitForFinished(1);
    process.setReadChannel(QProcess::StandardOutput);
}

/// Whether the helper has told that the request is served, and nothing came after its answer. `told`: the end of what
/// it has told so far.
bool isServed(QProcess& process, QByteArray& told)
{
    constexpr auto kLength = static_cast<qsizetype>(wire::kServed.size());
    told = (told + process.readAllStandardError()).right(kLength);
    if (told != QByteArrayView(wire::kServed.data(), kLength))
        return false;
    process.waitForReadyRead(0); // Whatever was written before that.
    return true;
}

/// Until the request is served or the helper has ended.
std::optional<HelperFailure> converse(QProcess& process, AnswerReader& reader, int timeoutMs, const Progress& progress)
{
    QElapsedTimer clock;
    clock.start();
    QByteArray told;
    while (process.state() == QProcess::Running || process.bytesAvailable() > 0) {
        if (process.state() == QProcess::Running)
            listen(process, reader.complete() ? QProcess::StandardError : QProcess::StandardOutput);
        if (!reader.take(process))
            return HelperFailure::Nonsense;
        if (reader.complete() && (process.state() != QProcess::Running || isServed(process, told)))
            return reader.take(process) ? std::nullopt : std::optional(HelperFailure::Nonsense);
        if (progress && !progress(reader.fraction()))
            return HelperFailure::Cancelled;
        if (clock.elapsed() > timeoutMs)
            return HelperFailure::TimedOut;
    }
    return std::nullopt;
}

} // namespace

/// A helper that runs; killed with this.
struct HelperRun::Started
{
    QProcess process;
    HelperConfinement confinement;

    explicit Started(int timeoutMs) : confinement(process, timeoutMs) {}
    Started(const Started&) = delete;
    Started& operator=(const Started&) = delete;
    ~Started()
    {
        if (process.state() == QProcess::NotRunning)
            return;
        confinement.kill();
        process.waitForFinished();
    }

    [[nodiscard]] bool start(const QString& program, int timeoutMs)
    {
#ifdef Q_OS_WIN
        // There it serves one request, and a decoder could reach what tells that it is served.
        process.setStandardErrorFile(QProcess::nullDevice());
#endif
        process.start(program, QStringList());
        if (!process.waitForStarted(timeoutMs))
            return false;
        confinement.started();
        return true;
    }
    /// Also of one that has ended since it was asked last.
    [[nodiscard]] bool hasEnded()
    {
        return process.state() == QProcess::NotRunning || process.waitForFinished(0);
    }
};

HelperRun::HelperRun(QString program, int timeoutMs) : m_program(std::move(program)), m_timeoutMs(timeoutMs) {}

HelperRun::~HelperRun() = default;

tl::expected<HelperAnswer, HelperFailure> HelperRun::ask(const wire::Bytes& request, const Progress& progress)
{
    // It is kept only once the request is served: what fails or throws ends it.
    std::unique_ptr<Started> started = std::move(m_started);
    if (!started || started->hasEnded()) {
        started = std::make_unique<Started>(m_timeoutMs);
        if (!started->start(m_program, m_timeoutMs))
            return tl::unexpected(HelperFailure::NotStarted);
    }
    QProcess& process = started->process;
    process.write(reinterpret_cast<const char*>(request.data()), static_cast<qint64>(request.size()));

    AnswerReader reader;
    if (const auto failed = converse(process, reader, m_timeoutMs, progress))
        return tl::unexpected(*failed);
    const bool runsOn = process.state() == QProcess::Running;
    if (!runsOn && (process.exitStatus() != QProcess::NormalExit || process.exitCode() != 0))
        return tl::unexpected(HelperFailure::Crashed);
    if (!reader.complete())
        return tl::unexpected(HelperFailure::Nonsense);
    if (runsOn)
        m_started = std::move(started);
    return reader.answer();
}

} // namespace hairpaint::model
