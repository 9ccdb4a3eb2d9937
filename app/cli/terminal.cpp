// Text made safe, and written.
#include "app/cli/terminal.h"

#include <algorithm>
#include <cstdio>

namespace hairpaint::app {

namespace {

/// Whether the character has Unicode's property Bidi_Control, or is the byte order mark.
bool turnsWriting(QChar c)
{
    const char16_t code = c.unicode();
    return code == 0x061C || code == 0x200E || code == 0x200F || (code >= 0x202A && code <= 0x202E) ||
           (code >= 0x2066 && code <= 0x2069) || code == 0xFEFF;
}

bool isObeyed(QChar c)
{
    return c.category() == QChar::Other_Control || c.category() == QChar::Separator_Line ||
           c.category() == QChar::Separator_Paragraph || turnsWriting(c);
}

bool write(std::FILE* to, const QString& text)
{
    const QByteArray bytes = text.toUtf8();
    const auto size = static_cast<std::size_t>(bytes.size());
    const bool isWhole = std::fwrite(bytes.constData(), 1, size, to) == size;
    return std::fflush(to) == 0 && isWhole;
}

} // namespace

QString safeForTerminal(const QString& text)
{
    if (std::ranges::none_of(text, isObeyed))
        return text;
    QString safe;
    for (const QChar c : text)
        safe += isObeyed(c) ? QStringLiteral("\\u%1").arg(c.unicode(), 4, 16, QLatin1Char('0')) : QString(c);
    return safe;
}

bool printLines(const QStringList& lines)
{
    QString text;
    for (const QString& line : lines)
        text += safeForTerminal(line) + QLatin1Char('\n');
    return write(stdout, text);
}

bool printTable(const QList<QStringList>& rows)
{
    QString text;
    for (const QStringList& row : rows) {
        QStringList fields;
        for (const QString& field : row)
            fields += safeForTerminal(field);
        text += fields.join(QLatin1Char('\t')) + QLatin1Char('\n');
    }
    return write(stdout, text);
}

void printError(const QString& line)
{
    (void)write(stderr, safeForTerminal(line.trimmed()) + QLatin1Char('\n'));
}

} // namespace hairpaint::app
