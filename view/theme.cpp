// Colours of the two themes, and the look of the whole program.
#include "view/theme.h"

#include "view/resources.h"

#include <QApplication>
#include <QFile>
#include <QFontDatabase>
#include <QStyleFactory>

namespace hairpaint::view {

Theme Theme::of(ThemeKind kind)
{
    if (kind == ThemeKind::Light)
        return {.kind = kind,
                .window = QColor(0xEA, 0xE8, 0xE4),
                .panel = QColor(0xF6, 0xF5, 0xF2),
                .raised = QColor(0xFF, 0xFF, 0xFF),
                .line = QColor(0xD3, 0xD0, 0xCA),
                .text = QColor(0x25, 0x27, 0x2A),
                .dimText = QColor(0x62, 0x67, 0x6C),
                .accent = QColor(0x8A, 0x53, 0x10),
                .onAccent = QColor(0xFF, 0xFF, 0xFF),
                .error = QColor(0xB3, 0x37, 0x2F)};
    return {.kind = kind,
            .window = QColor(0x1B, 0x1C, 0x1E),
            .panel = QColor(0x23, 0x25, 0x28),
            .raised = QColor(0x2C, 0x2F, 0x33),
            .line = QColor(0x3A, 0x3E, 0x43),
            .text = QColor(0xD9, 0xDB, 0xDD),
            .dimText = QColor(0x9A, 0xA0, 0xA6),
            .accent = QColor(0xE3, 0xA8, 0x57),
            .onAccent = QColor(0x1B, 0x1C, 0x1E),
            .error = QColor(0xE5, 0x73, 0x6B)};
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
    const std::pair<const char*, QColor> colours[] = {
        {"@window", window},   {"@panel", panel},   {"@raised", raised},     {"@line", line},  {"@text", text},
        {"@dimText", dimText}, {"@accent", accent}, {"@onAccent", onAccent}, {"@error", error}};
    for (const auto& [name, colour] : colours)
        sheet.replace(QLatin1String(name) + QLatin1Char(';'), colour.name() + QLatin1Char(';'));
    return sheet;
}

QFont themeFont(TextRole role)
{
    static const bool hasInter = QFontDatabase::hasFamily(QStringLiteral("Inter"));
    QFont font = hasInter ? QFont(QStringLiteral("Inter")) : QFontDatabase::systemFont(QFontDatabase::GeneralFont);
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
    QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    QApplication::setFont(themeFont(TextRole::Body));
    QApplication::setPalette(theme.palette());
    application.setStyleSheet(theme.styleSheet());
}

} // namespace hairpaint::view
