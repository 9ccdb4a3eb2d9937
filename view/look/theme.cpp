// Colours of the two themes, and the look of the whole program.
#include "view/look/theme.h"

#include "view/look/resources.h"
#include "view/look/title_bar.h"

#include <QApplication>
#include <QFile>
#include <QFontDatabase>
#include <QStyleFactory>

namespace hairpaint::view {

namespace {

/// Every colour once: its name in the style sheet, its member of Theme, and what it is in either theme.
struct ColourRow
{
    const char* name;
    QColor Theme::*colour;
    QRgb dark, light;
};

constexpr ColourRow kColours[] = {
    {"@window", &Theme::window, 0x1B1C1E, 0xEAE8E4}, {"@panel", &Theme::panel, 0x232528, 0xF6F5F2},
    {"@raised", &Theme::raised, 0x2C2F33, 0xFFFFFF}, {"@line", &Theme::line, 0x3A3E43, 0xD3D0CA},
    {"@text", &Theme::text, 0xD9DBDD, 0x25272A},     {"@dimText", &Theme::dimText, 0x9AA0A6, 0x62676C},
    {"@accent", &Theme::accent, 0xE3A857, 0x8A5310}, {"@onAccent", &Theme::onAccent, 0x1B1C1E, 0xFFFFFF},
    {"@error", &Theme::error, 0xE5736B, 0xB3372F}};

} // namespace

Theme Theme::of(ThemeKind kind)
{
    Theme theme;
    theme.kind = kind;
    for (const ColourRow& row : kColours)
        theme.*row.colour = QColor(kind == ThemeKind::Light ? row.light : row.dark);
    return theme;
}

Theme Theme::current()
{
    return of(QGuiApplication::palette().color(QPalette::Window).lightness() < 128 ? ThemeKind::Dark
                                                                                   : ThemeKind::Light);
}

QPalette Theme::palette() const
{
    QPalette palette;
    palette.setColor(QPalette::Window, window);
    palette.setColor(QPalette::WindowText, text);
    palette.setColor(QPalette::Base, panel);
    palette.setColor(QPalette::AlternateBase, raised);
    palette.setColor(QPalette::Text, text);
    palette.setColor(QPalette::Button, raised);
    palette.setColor(QPalette::ButtonText, text);
    palette.setColor(QPalette::BrightText, error);
    palette.setColor(QPalette::Highlight, accent);
    palette.setColor(QPalette::HighlightedText, onAccent);
    palette.setColor(QPalette::ToolTipBase, raised);
    palette.setColor(QPalette::ToolTipText, text);
    palette.setColor(QPalette::PlaceholderText, dimText);
    palette.setColor(QPalette::Link, accent);
    palette.setColor(QPalette::Mid, line);
    palette.setColor(QPalette::Dark, line);
    for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, dimText);
    return palette;
}

QString Theme::styleSheet() const
{
    QFile file(QStringLiteral(":/themes/hairpaint.qss"));
    if (!file.open(QIODevice::ReadOnly))
        return {};
    QString sheet = QString::fromUtf8(file.readAll());
    const QString folder = kind == ThemeKind::Light ? QStringLiteral("light") : QStringLiteral("dark");
    sheet.replace(QStringLiteral("@theme;"), folder);
    for (const ColourRow& row : kColours)
        sheet.replace(QLatin1String(row.name) + QLatin1Char(';'), (this->*row.colour).name() + QLatin1Char(';'));
    return sheet;
}

QFont themeFont(TextRole role)
{
    QFont font(QStringList{QStringLiteral("Inter"), QStringLiteral("Noto Sans"),
                           QFontDatabase::systemFont(QFontDatabase::GeneralFont).family()});
    font.setStyleHint(QFont::SansSerif);
    switch (role) {
    case TextRole::Body:
        font.setPixelSize(13);
        break;
    case TextRole::Label:
        font.setPixelSize(12);
        break;
    case TextRole::Status:
        font.setPixelSize(11);
        break;
    case TextRole::Title:
        font.setPixelSize(15);
        font.setWeight(QFont::DemiBold);
        break;
    }
    return font;
}

void applyTheme(QApplication& application, ThemeKind kind)
{
    initResources();
    const Theme theme = Theme::of(kind);
    const QString sheet = theme.styleSheet();
    if (application.styleSheet() == sheet)
        return; // As another window has it.
    QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    QApplication::setPalette(theme.palette());
    application.setStyleSheet(sheet);
    // Last: a new style brings back the fonts that Windows has for lists, menus and tips.
    QApplication::setFont(themeFont(TextRole::Body));
    matchTitleBars(application, kind);
}

} // namespace hairpaint::view
