// Names, strings and tuples of USD's text form.
#include "model/exporting/usd_text.h"

#include "model/exporting/piece_writer.h"

namespace hairpaint::model {

QString usdName(const QString& name, QSet<QString>& taken)
{
    QString made;
    for (const QChar c : name) {
        const bool plain = c.unicode() < 128 && (c.isLetterOrNumber() || c == QLatin1Char('_'));
        made += plain ? c : QLatin1Char('_');
    }
    if (made.isEmpty() || !made.front().isLetter())
        made.prepend(QLatin1String("Group_"));
    QString free = made;
    for (int number = 2; taken.contains(free); ++number)
        free = QStringLiteral("%1_%2").arg(made).arg(number);
    taken.insert(free);
    return free;
}

std::string usdQuoted(const QString& text)
{
    std::string out = "\"";
    for (const char c : text.toUtf8()) {
        if (c == '"' || c == '\\')
            out.push_back('\\');
        out.push_back(static_cast<unsigned char>(c) < 0x20U ? ' ' : c);
    }
    return out + '"';
}

void appendUsdPoint(std::string& out, const glm::vec3& point)
{
    out.push_back('(');
    for (int axis = 0; axis < 3; ++axis) {
        if (axis > 0)
            out.push_back(',');
        appendNumber(out, point[axis]);
    }
    out.push_back(')');
}

void appendUsdColour(std::string& out, const glm::vec3& colour)
{
    out.push_back('(');
    constexpr int kColourDecimals = 4;
    for (int channel = 0; channel < 3; ++channel) {
        if (channel > 0)
            out.push_back(',');
        appendFraction(out, colour[channel], kColourDecimals);
    }
    out.push_back(')');
}

} // namespace hairpaint::model
