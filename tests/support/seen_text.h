// Everything that a person can read of a widget: what it paints, its tooltips, and what a screen reader says.
#pragma once

#include <QStringList>

class QWidget;

namespace hairpaint::test {

/// The texts that rendering the widget and its children draws, whoever draws them; lines apart, cut texts as they are
/// cut.
[[nodiscard]] QStringList paintedTexts(QWidget& widget);

/// Titles, tooltips, names for screen readers, menus, items of boxes and lists: of the widget and all its children,
/// shown or not.
[[nodiscard]] QStringList carriedTexts(QWidget& widget);

} // namespace hairpaint::test
