// What Windows does not take as a file's name, told before it is written to something else. Pure text: on every system.
#pragma once

#include <QString>

namespace hairpaint::model {

/// Why no file can have this name (without its folder), as a clause: a device's name (NUL, CON, COM1, with any ending),
/// a character that names do not have there, a space or full stop at the end, which the system would silently leave
/// out. Empty where it can.
[[nodiscard]] QString windowsNameProblem(const QString& name);

/// An absolute path with backslashes as Windows takes it at any length: \\?\C:\..., \\?\UNC\server\... for those of 248
/// characters and more, others as they are.
[[nodiscard]] QString windowsPath(const QString& path);

} // namespace hairpaint::model
