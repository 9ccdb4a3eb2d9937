// The program's colours and metrics, in a dark and a light variant.
#pragma once

#include <QColor>
#include <QFont>
#include <QPalette>
#include <QString>

class QApplication;

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
    /// The one that the application's palette belongs to. Widgets that paint themselves ask at every paint.
    [[nodiscard]] static Theme current();
    [[nodiscard]] QPalette palette() const;
    [[nodiscard]] QString styleSheet() const; ///< resources/themes/hairpaint.qss with the colours put in.
};

/// Sizes that every panel shares, in device-independent pixels.
namespace metrics {
inline constexpr int kGrid = 4;
inline constexpr int kGap = 8;
inline constexpr int kPadding = 12;
inline constexpr int kRow = 28;
inline constexpr int kSlider = 24;
inline constexpr int kRadius = 4;
inline constexpr int kIcon = 20;
inline constexpr int kTarget = 36;
inline constexpr int kToolBar = 44;
inline constexpr int kOptionBar = 40;
inline constexpr int kSidebar = 280;
inline constexpr int kStyleStrip = 164;
inline constexpr int kStatus = 24;
} // namespace metrics

enum class TextRole
{
    Body,   ///< 13 px
    Label,  ///< 12 px
    Status, ///< 11 px
    Title   ///< 15 px, semibold
};
[[nodiscard]] QFont themeFont(TextRole role);

/// Style, font, palette and style sheet of the whole program; may be called again to switch while it runs.
void applyTheme(QApplication& application, ThemeKind kind);

} // namespace hairpaint::view
