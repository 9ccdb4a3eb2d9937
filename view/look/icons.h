// The program's own icons: line drawings that take the theme's colour when they are painted.
#pragma once

#include <QIcon>
#include <QPixmap>
#include <QString>
#include <QStringList>

namespace hairpaint::view {

/// The icon of resources/icons/NAME.svg, sharp at every size and pixel ratio. Text-coloured; dim where disabled;
/// follows a change of theme by itself. An unknown name gives a plain dot, so that nothing is ever empty.
[[nodiscard]] QIcon icon(const QString& name);
/// The same for a switch: where it is on, the icon takes the accent colour, so that it can't be taken for the chosen
/// tool.
[[nodiscard]] QIcon switchIcon(const QString& name);
/// One picture of it in `colour`, `side` device-independent pixels wide.
[[nodiscard]] QPixmap iconPixmap(const QString& name, int side, const QColor& colour, qreal pixelRatio);
[[nodiscard]] bool hasIcon(const QString& name);
/// Every name, sorted.
[[nodiscard]] QStringList iconNames();

} // namespace hairpaint::view
