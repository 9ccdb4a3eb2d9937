// The program's colours and metrics, in a dark and a light variant.
#pragma once

#include <QColor>
#include <QPalette>
#include <QString>

namespace hairpaint::view {

enum class ThemeKind
{
    Dark,
    Light
};

struct Theme
{
    ThemeKind kind = ThemeKind::Dark;
    QColor window, panel, raised, line, text, dimText, accent, onAccent, error;

    [[nodiscard]] static Theme of(ThemeKind kind);
    [[nodiscard]] QPalette palette() const;
    [[nodiscard]] QString styleSheet() const; ///< resources/themes/hairpaint.qss with the colours put in.
};

} // namespace hairpaint::view
