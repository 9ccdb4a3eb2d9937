// Hexadecimal digits, and the functions of CSS Color 4 that hold red, green and blue.
#include "view/look/colour_text.h"

#include <QRegularExpression>

#include <array>
#include <cmath>

namespace hairpaint::view {

namespace {

constexpr int kMost = 255;

std::optional<QColor> fromDigits(const QString& digits)
{
    if (digits.size() <= 4)
        return QColor(QLatin1Char('#') + digits.first(3));
    return QColor(QLatin1Char('#') + digits.first(6));
}

/// A channel, 0..255, from a text of 0..255 or 0..100 %.
std::optional<int> channel(const QString& text)
{
    const bool isPercent = text.endsWith(QLatin1Char('%'));
    bool isNumber = false;
    const double number = (isPercent ? text.chopped(1) : text).toDouble(&isNumber);
    const double value = isPercent ? number * kMost / 100.0 : number;
    if (!isNumber || !(value >= 0.0 && value <= kMost))
        return std::nullopt;
    return static_cast<int>(std::lround(value));
}

} // namespace

std::optional<QColor> colourFromText(const QString& text)
{
    static const QRegularExpression hexadecimal(
        QStringLiteral("^(?:#|0[xX])?([0-9A-Fa-f]{3,4}|[0-9A-Fa-f]{6}|[0-9A-Fa-f]{8})$"));
    static const QRegularExpression function(
        QStringLiteral(
            R"(^rgba?\(\s*([\d.]+%?)(?:\s*,\s*|\s+)([\d.]+%?)(?:\s*,\s*|\s+)([\d.]+%?)(?:\s*[,/]\s*[\d.]+%?)?\s*\)$)"),
        QRegularExpression::CaseInsensitiveOption);
    const QString trimmed = text.trimmed();
    if (const auto match = hexadecimal.match(trimmed); match.hasMatch())
        return fromDigits(match.captured(1));
    const auto match = function.match(trimmed);
    if (!match.hasMatch())
        return std::nullopt;
    std::array<int, 3> channels{};
    for (int i = 0; i < 3; ++i) {
        const std::optional<int> value = channel(match.captured(i + 1));
        if (!value)
            return std::nullopt;
        channels[static_cast<std::size_t>(i)] = *value;
    }
    return QColor(channels[0], channels[1], channels[2]);
}

} // namespace hairpaint::view
