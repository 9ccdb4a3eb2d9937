// The frame that the system draws round a window, in the theme's brightness.
#pragma once

class QApplication;

namespace hairpaint::view {

enum class ThemeKind;

/// From now on title bars of all windows, open ones too, are as dark as the theme; may be called again with another.
/// Only Windows leaves this to programs: elsewhere it does nothing. On the GUI thread.
void matchTitleBars(QApplication& application, ThemeKind kind);

} // namespace hairpaint::view
