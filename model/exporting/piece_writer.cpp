// Pieces small enough to stay in memory, large enough for every thread to have some.
#include "model/exporting/piece_writer.h"

#include "sim/base/parallel.h"

#include <QLocale>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <vector>

namespace hairpaint::model {

namespace {

constexpr std::size_t kCurvesAPiece = 256;
constexpr std::size_t kPieces = 32; ///< At once.
constexpr std::size_t kLongestNumber = 32;

template<typename... Arguments>
void appendChars(std::string& out, Arguments... arguments)
{
    std::array<char, kLongestNumber> text{};
    const auto [end, problem] = std::to_chars(text.data(), text.data() + text.size(), arguments...);
    out.append(text.data(), end);
}

} // namespace

PieceWriter::PieceWriter(AtomicFile& file, Progress progress)
    : m_file(file), m_sink([&file](std::string_view bytes) {
          file.write({bytes.data(), static_cast<qsizetype>(bytes.size())});
      }),
      m_progress(std::move(progress))
{}

void PieceWriter::divert(Sink sink)
{
    m_sink = std::move(sink);
}

void PieceWriter::tell(double fraction)
{
    m_done = fraction;
    m_cancelled = m_cancelled || (m_progress && !m_progress(fraction));
}

void PieceWriter::write(std::span<const Curve> curves, double until, const Make& make)
{
    const double from = m_done;
    for (std::size_t first = 0; first < curves.size(); first += kPieces * kCurvesAPiece) {
        tell(from + (until - from) * static_cast<double>(first) / static_cast<double>(curves.size()));
        if (m_cancelled || m_file.failed())
            return;
        const std::span<const Curve> some =
            curves.subspan(first, std::min(kPieces * kCurvesAPiece, curves.size() - first));
        std::vector<std::string> pieces((some.size() + kCurvesAPiece - 1) / kCurvesAPiece);
        sim::parallelFor(pieces.size(), 1, [&](std::size_t begin, std::size_t end) {
            CurveScratch scratch;
            for (std::size_t piece = begin; piece < end; ++piece) {
                const std::size_t at = piece * kCurvesAPiece;
                make(some.subspan(at, std::min(kCurvesAPiece, some.size() - at)), scratch, pieces[piece]);
            }
        });
        for (const std::string& piece : pieces)
            m_sink(piece);
    }
    m_done = until;
}

void PieceWriter::write(std::string_view bytes)
{
    if (!m_cancelled && !m_file.failed())
        m_sink(bytes);
}

void PieceWriter::end()
{
    if (!m_cancelled)
        tell(1.0);
}

Result<void> writeInPieces(const QString& path, std::size_t bytes, const Progress& progress,
                           const std::function<Checked<void>(AtomicFile&, PieceWriter&)>& write)
{
    constexpr std::size_t kMostBytes = 2'000'000'000; // More is no file that anyone can use.
    if (bytes > kMostBytes)
        return cannotWrite(
            path, {.text = say(QT_TRANSLATE_NOOP("Files", "it would take %1, and %2 is the most; make the hair "
                                                          "less dense or less curled, or export fewer hairs"))
                               .arg(QLocale().formattedDataSize(static_cast<qint64>(bytes)),
                                    QLocale().formattedDataSize(static_cast<qint64>(kMostBytes)))});
    AtomicFile file(path);
    if (const Checked<void> opened = file.open(); !opened)
        return cannotWrite(path, opened.error());
    PieceWriter writer(file, progress);
    if (const Checked<void> made = write(file, writer); !made)
        return cannotWrite(path, made.error());
    writer.end();
    if (writer.cancelled())
        return cancelled(path);
    return commitWanted(file, path, progress);
}

tl::unexpected<Clause> tooManyPoints()
{
    return refuse(say(QT_TRANSLATE_NOOP("Files", "the hair has too many points for this format; export fewer "
                                                 "hairs")));
}

void appendNumber(std::string& out, float value)
{
    appendChars(out, value);
}

void appendNumber(std::string& out, std::uint64_t value)
{
    appendChars(out, value);
}

void appendFraction(std::string& out, float value, int decimals)
{
    std::uint32_t power = 1;
    for (int i = 0; i < decimals; ++i)
        power *= 10;
    auto digits = static_cast<std::uint32_t>(std::lround(std::clamp(value, 0.0F, 1.0F) * static_cast<float>(power)));
    if (digits == power || digits == 0) {
        out.push_back(digits == 0 ? '0' : '1');
        return;
    }
    std::array<char, kLongestNumber> text{};
    int length = decimals;
    while (digits % 10 == 0) {
        digits /= 10;
        --length;
    }
    for (int i = length - 1; i >= 0; --i) {
        text.at(static_cast<std::size_t>(i)) = static_cast<char>('0' + digits % 10);
        digits /= 10;
    }
    out.append("0.");
    out.append(text.data(), static_cast<std::size_t>(length));
}

} // namespace hairpaint::model
