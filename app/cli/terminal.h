// The only access to standard output and standard error.
#pragma once

#include <QList>
#include <QStringList>

namespace hairpaint::app {

/// Escapes text for a terminal: characters that control it, break lines or columns, or change the writing direction
/// (C0 and C1 controls, DEL, line separators, direction marks, overrides and isolates) become \uXXXX, which JSON reads
/// as the same character.
[[nodiscard]] QString safeForTerminal(const QString& text);

/// Prints lines on standard output, escaped; false if writing fails.
[[nodiscard]] bool printLines(const QStringList& lines);
/// The same for rows; fields are separated by tabs.
[[nodiscard]] bool printTable(const QList<QStringList>& rows);
/// One line on standard error.
void printError(const QString& line);

} // namespace hairpaint::app
