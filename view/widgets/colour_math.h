// Mixing colours and telling how well one is read on another.
#pragma once

#include <QColor>

namespace hairpaint::view {

/// `fraction` 0 gives `a`, 1 gives `b`.
[[nodiscard]] QColor mixed(const QColor& a, const QColor& b, double fraction);
/// Contrast ratio of WCAG 2, 1..21.
[[nodiscard]] double contrast(const QColor& a, const QColor& b);
/// Black or white, whichever is read better on `ground`.
[[nodiscard]] QColor inkOn(const QColor& ground);

} // namespace hairpaint::view
