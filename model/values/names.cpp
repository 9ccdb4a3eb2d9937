// The program's own names in other languages: see the header.
#include "model/values/names.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <algorithm>
#include <array>

namespace hairpaint::model {

namespace {

/// What newProject and the files of resources/presets hold; a test compares.
constexpr std::array kNames = {
    QT_TRANSLATE_NOOP("Names", "Scalp"),
    QT_TRANSLATE_NOOP("Names", "Brows"),
    QT_TRANSLATE_NOOP("Names", "Lashes"),
    QT_TRANSLATE_NOOP("Names", "Beard"),
    QT_TRANSLATE_NOOP("Names", "Base"), // A layer of what unpainted skin has (model/document/range_change.h).
    // Styles
    QT_TRANSLATE_NOOP("Names", "Bald"),
    QT_TRANSLATE_NOOP("Names", "Long straight"),
    QT_TRANSLATE_NOOP("Names", "Bob"),
    QT_TRANSLATE_NOOP("Names", "Ringlets"),
    QT_TRANSLATE_NOOP("Names", "Round afro"),
    QT_TRANSLATE_NOOP("Names", "Two plaits"),
    QT_TRANSLATE_NOOP("Names", "Gelled mohawk"),
    QT_TRANSLATE_NOOP("Names", "Split dye"),
    QT_TRANSLATE_NOOP("Names", "Buzz cut"),
    QT_TRANSLATE_NOOP("Names", "Slicked undercut"),
    QT_TRANSLATE_NOOP("Names", "Quiff"),
    QT_TRANSLATE_NOOP("Names", "Side part"),
    QT_TRANSLATE_NOOP("Names", "French crop"),
    QT_TRANSLATE_NOOP("Names", "High ponytail"),
    QT_TRANSLATE_NOOP("Names", "Low ponytail"),
    QT_TRANSLATE_NOOP("Names", "Low bun"),
    QT_TRANSLATE_NOOP("Names", "Half-up with bow"),
    QT_TRANSLATE_NOOP("Names", "Twin tails"),
    QT_TRANSLATE_NOOP("Names", "Top knot with undercut"),
    QT_TRANSLATE_NOOP("Names", "Crown braid"),
    QT_TRANSLATE_NOOP("Names", "Fishtail plait"),
    QT_TRANSLATE_NOOP("Names", "Box braids"),
    QT_TRANSLATE_NOOP("Names", "Cornrows"),
    QT_TRANSLATE_NOOP("Names", "Locs"),
    QT_TRANSLATE_NOOP("Names", "Pixie"),
    QT_TRANSLATE_NOOP("Names", "Curtain layers"),
    QT_TRANSLATE_NOOP("Names", "Jaw bob with fringe"),
    QT_TRANSLATE_NOOP("Names", "Beach waves balayage"),
    QT_TRANSLATE_NOOP("Names", "Wolf cut"),
    QT_TRANSLATE_NOOP("Names", "Shag"),
    QT_TRANSLATE_NOOP("Names", "Curly bob"),
    QT_TRANSLATE_NOOP("Names", "Curly top with fade"),
    QT_TRANSLATE_NOOP("Names", "High-top fade"),
    QT_TRANSLATE_NOOP("Names", "Liberty spikes"),
    QT_TRANSLATE_NOOP("Names", "Fade with line-up"),
    QT_TRANSLATE_NOOP("Names", "Stubble"),
    QT_TRANSLATE_NOOP("Names", "Goatee"),
    QT_TRANSLATE_NOOP("Names", "Full beard"),
    QT_TRANSLATE_NOOP("Names", "Hime cut"),
    QT_TRANSLATE_NOOP("Names", "Headband with long hair"),
    QT_TRANSLATE_NOOP("Names", "Bantu knots"),
    QT_TRANSLATE_NOOP("Names", "Twist-out"),
    QT_TRANSLATE_NOOP("Names", "360 waves"),
    QT_TRANSLATE_NOOP("Names", "Full brows"),
    // Their tags
    QT_TRANSLATE_NOOP("Names", "short"),
    QT_TRANSLATE_NOOP("Names", "medium"),
    QT_TRANSLATE_NOOP("Names", "long"),
    QT_TRANSLATE_NOOP("Names", "straight"),
    QT_TRANSLATE_NOOP("Names", "wavy"),
    QT_TRANSLATE_NOOP("Names", "curly"),
    QT_TRANSLATE_NOOP("Names", "coily"),
    QT_TRANSLATE_NOOP("Names", "braided"),
    QT_TRANSLATE_NOOP("Names", "tied"),
    QT_TRANSLATE_NOOP("Names", "face"),
    QT_TRANSLATE_NOOP("Names", "gelled"),
    QT_TRANSLATE_NOOP("Names", "coloured"),
    QT_TRANSLATE_NOOP("Names", "beard"),
    // Folders of the library
    QT_TRANSLATE_NOOP("Names", "built-in"),
    QT_TRANSLATE_NOOP("Names", "own"),
};

constexpr std::array kNumbered = {
    QT_TRANSLATE_NOOP("Names", "Group %1"),
    QT_TRANSLATE_NOOP("Names", "Layer %1"),
};

QString translated(const char* name)
{
    return QCoreApplication::translate("Names", name);
}

} // namespace

QString groupName(qsizetype number)
{
    return QStringLiteral("Group %1").arg(number);
}

QString numberedName(const QString& name, qsizetype number)
{
    return QStringLiteral("%1 %2").arg(name).arg(number);
}

QString layerName(qsizetype number)
{
    return QStringLiteral("Layer %1").arg(number);
}

QString shownName(const QString& name)
{
    const auto* const found =
        std::ranges::find_if(kNames, [&name](const char* known) { return name == QLatin1StringView(known); });
    if (found != kNames.end())
        return translated(*found);
    static const QRegularExpression number(QStringLiteral("^(\\w+ )(\\d+)$"));
    if (const QRegularExpressionMatch match = number.match(name); match.hasMatch())
        for (const char* pattern : kNumbered)
            if (match.captured(1) + QStringLiteral("%1") == QLatin1StringView(pattern))
                return translated(pattern).arg(match.captured(2));
    const qsizetype end = name.lastIndexOf(QLatin1Char(' '));
    bool isNumber = false;
    const qlonglong last = name.mid(end + 1).toLongLong(&isNumber);
    if (end > 0 && isNumber)
        if (const QString known = shownName(name.left(end)); known != name.left(end))
            return numberedName(known, last);
    return name;
}

} // namespace hairpaint::model
