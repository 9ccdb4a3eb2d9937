// Fonts for systems that have none.
#pragma once

namespace hairpaint::view {

/// Where the system has no font, those that were packed with the program (in share/hairpaint/fonts beside its folder).
/// False where there is none then either: text will be boxes. After the QApplication is made, before the first text.
[[nodiscard]] bool provideFonts();

} // namespace hairpaint::view
