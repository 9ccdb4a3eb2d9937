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
    HelperConfinement confinement(process, timeoutMs);
    process.start(program, QStringList());
    if (!process.waitForStarted(timeoutMs))
        return tl::unexpected(HelperFailure::NotStarted);
    confinement.started();
    process.write(reinterpret_cast<const char*>(request.data()), static_cast<qint64>(request.size()));
    process.closeWriteChannel();

    AnswerReader reader;
    const std::optional<HelperFailure> failed = converse(process, reader, timeoutMs, progress);
    if (failed) {
        confinement.kill();
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
