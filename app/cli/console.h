// The console that a command line was typed in. Windows gives none to a program that has windows.
#pragma once

namespace hairpaint::app {

/// Joins the console of the process that started this one, where there is one, and has text written there as it stands:
/// UTF-8, without carriage returns. Streams that lead to a file or a pipe stay. Once, on the main thread, before
/// anything is printed. Elsewhere than on Windows it does nothing.
void joinConsole();

} // namespace hairpaint::app
