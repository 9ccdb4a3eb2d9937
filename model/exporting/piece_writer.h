// Writes the text or bytes of many curves, a piece at a time.
#pragma once

#include "model/disk/atomic_file.h"
#include "model/exporting/curve_set.h"
#include "model/values/error.h"

#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace hairpaint::model {

/// Has the bytes of pieces of curves made on several threads, and passes them on in the curves' order. One thread.
class PieceWriter
{
public:
    using Sink = std::function<void(std::string_view)>;

    /// Where `file`, which they end in, has failed, no more bytes are made.
    PieceWriter(AtomicFile& file, Progress progress);
    /// From now on `sink` takes the bytes before they reach the file.
    void divert(Sink sink);

    /// Appends to a string what some curves become. Called on several threads.
    using Make = std::function<void(std::span<const Curve> curves, CurveScratch& scratch, std::string& out)>;
    /// Progress goes on to `until`, 0..1. Does nothing once it was cancelled.
    void write(std::span<const Curve> curves, double until, const Make& make);
    void write(std::string_view bytes);
    /// Writes everything; progress reaches 1.
    void end();
    [[nodiscard]] bool cancelled() const { return m_cancelled; }

private:
    void tell(double fraction);

    const AtomicFile& m_file;
    Sink m_sink;
    Progress m_progress;
    double m_done = 0.0;
    bool m_cancelled = false;
};

/// Has `write` fill a file that takes its name once it is whole, and not where anything fails or `progress` cancels.
/// Refuses before anything is written where `bytes`, about what it will take, is more than 2 GB.
[[nodiscard]] Result<void> writeInPieces(const QString& path, std::size_t bytes, const Progress& progress,
                                         const std::function<Checked<void>(AtomicFile&, PieceWriter&)>& write);

/// The error of a format whose counts or sizes are too small for the content.
[[nodiscard]] tl::unexpected<Clause> tooManyPoints();

/// The bytes of a value as they lie in memory.
template<typename T>
void appendBytes(std::string& out, const T& value)
{
    out.append(reinterpret_cast<const char*>(&value), sizeof(T));
}

/// The shortest decimal number that reads back as the same float.
void appendNumber(std::string& out, float value);
void appendNumber(std::string& out, std::uint64_t value);
/// With `decimals` digits after the point at most, for values of 0..1 that nobody sees more finely.
void appendFraction(std::string& out, float value, int decimals);

} // namespace hairpaint::model
