// The sentences with which reading and writing files fails: each names the file and says what to do.
#pragma once

#include "model/values/guarded.h"

#include <cstdint>
#include <type_traits>

namespace hairpaint::model {

/// The path as it stands in a sentence: native separators, on one line.
[[nodiscard]] QString shownPath(const QString& path);

/// A name out of a file as it stands in a sentence.
[[nodiscard]] QString onOneLine(QString text);

/// Text in translation context "Files"; mark it with QT_TRANSLATE_NOOP.
[[nodiscard]] QString say(const char* text);

/// Why reading or writing stopped: inner functions know no path and give a clause ("its archive is cut short").
struct Clause
{
    enum class Cure : std::uint8_t
    {
        EarlierCopy,
        NewerProgram,
        OtherFile
    };
    QString text;
    Cure cure = Cure::EarlierCopy;
};

template<typename T>
using Checked = tl::expected<T, Clause>;

[[nodiscard]] tl::unexpected<Clause> refuse(QString clause, Clause::Cure cure = Clause::Cure::EarlierCopy);

/// Clauses as sentences.
[[nodiscard]] tl::unexpected<Error> cannotOpen(const QString& path, const Clause& clause);
[[nodiscard]] tl::unexpected<Error> cannotWrite(const QString& path, const Clause& clause);
[[nodiscard]] tl::unexpected<Error> cancelled(const QString& path);

/// The system's reason for refusing, as a clause that says what to do.
[[nodiscard]] QString readRefusal(const QString& reason);
[[nodiscard]] QString writeRefusal(const QString& reason);

/// Clauses: want of memory, and a disk that does not answer.
[[nodiscard]] Clause notEnoughMemory();
[[nodiscard]] Clause silentDisk();

/// cannotOpen or cannotWrite.
using Phrase = tl::unexpected<Error> (*)(const QString& path, const Clause& clause);

/// What `work` returns; where it runs out of memory, the phrase's sentence of `path`. Files say how large they are, so
/// this may happen wherever one is read, and it must not get past the file's own functions.
template<typename Work>
[[nodiscard]] std::invoke_result_t<Work> withinMemory(const QString& path, Phrase phrase, const Work& work)
{
    return whereMemoryLasts(work, [&] { return phrase(path, notEnoughMemory()); });
}

/// Fails where no reading is needed to know: missing, a folder, unreadable, empty, larger than `mostBytes`.
[[nodiscard]] Result<void> checkReadable(const QString& path, qint64 mostBytes);

} // namespace hairpaint::model
