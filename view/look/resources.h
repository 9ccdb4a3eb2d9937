// The view's compiled-in icons, style sheet and programme icon.
#pragma once

namespace hairpaint::view {

/// Makes ":/icons", ":/themes" and ":/desktop" readable. Call once before the first window; calling again is harmless.
void initResources();

} // namespace hairpaint::view
