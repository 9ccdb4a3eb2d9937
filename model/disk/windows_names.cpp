// Names of devices, forbidden characters and long paths, as Microsoft's "Naming Files, Paths, and Namespaces" lists
// them.
#include "model/disk/windows_names.h"

#include "model/values/sentences.h"

#include <QStringList>

#include <algorithm>

namespace hairpaint::model {

namespace {

bool isDevice(const QString& name)
{
    const QString stem = name.section(QLatin1Char('.'), 0, 0).trimmed().toUpper();
    static const QStringList kDevices{QStringLiteral("CON"), QStringLiteral("PRN"),    QStringLiteral("AUX"),
                                      QStringLiteral("NUL"), QStringLiteral("CONIN$"), QStringLiteral("CONOUT$")};
    if (kDevices.contains(stem))
        return true;
    const bool isPort = stem.startsWith(QLatin1String("COM")) || stem.startsWith(QLatin1String("LPT"));
    // Superscript digits count as digits there.
    return isPort && stem.size() == 4 && QStringLiteral("123456789\u00B9\u00B2\u00B3").contains(stem[3]);
}

bool isForbidden(QChar c)
{
    return c.unicode() < 32 || QStringLiteral("<>:\"/\\|?*").contains(c);
}

} // namespace

QString windowsNameProblem(const QString& name)
{
    if (isDevice(name))
        return say(QT_TRANSLATE_NOOP("Files", "it is a device, and no file can take its place; choose another name"));
    if (std::ranges::any_of(name, isForbidden))
        return say(QT_TRANSLATE_NOOP("Files", "Windows takes no file name with one of < > : \" / \\ | ? *; choose "
                                              "another name"));
    if (name.endsWith(QLatin1Char('.')) || name.endsWith(QLatin1Char(' ')))
        return say(QT_TRANSLATE_NOOP("Files",
                                     "Windows takes no file name that ends with a full stop or a space; choose "
                                     "another name"));
    return {};
}

QString windowsPath(const QString& path)
{
    constexpr qsizetype kLongest = 248; // A folder's; a file's is 260.
    const QString verbatim = QStringLiteral("\\\\?\\");
    if (path.size() < kLongest || path.startsWith(verbatim))
        return path;
    const QString network = QStringLiteral("\\\\");
    return path.startsWith(network) ? verbatim + QStringLiteral("UNC\\") + path.mid(network.size()) : verbatim + path;
}

} // namespace hairpaint::model
