// The only way to standard output and standard error.
#pragma once

#include <QList>
#include <QStringList>

namespace hairpaint::app {

/// A text as it may be given to a terminal: what that would obey, what makes another line or column and what turns the
/// direction of writing (C0 and C1 controls, DEL, other separators of lines, marks of direction, overrides and
/// isolates) stands there as \uXXXX, which JSON reads as the same character.
[[nodiscard]] QString safeForTerminal(const QString& text);

/// On standard output, each line made safe; false where it takes no more.
[[nodiscard]] bool printLines(const QStringList& lines);
/// The same of rows, their fields parted by tabs.
[[nodiscard]] bool printTable(const QList<QStringList>& rows);
/// One line on standard error.
void printError(const QString& line);

} // namespace hairpaint::app
