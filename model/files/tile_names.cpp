// Numbers of four digits taken for what they are.
#include "model/files/tile_names.h"

#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>

#include <optional>

namespace hairpaint::model {

namespace {

const QString kToken = QStringLiteral("<UDIM>");

struct NamedTile
{
    QString pattern;
    int number = 0;
};

/// A number between what is neither letter nor digit, the last before the ending: "map.1002.png", "map_1002.v2.png"
/// too. None where the name has none.
std::optional<NamedTile> tileNamedBy(const QString& path)
{
    static const QRegularExpression kNumber(QStringLiteral("(?<=[._-])1(?:0\\d\\d|100)(?=[._-][^/\\\\]*$)"));
    std::optional<NamedTile> named;
    for (auto found = kNumber.globalMatch(path); found.hasNext();) {
        const QRegularExpressionMatch match = found.next();
        const int number = match.captured().toInt();
        if (number >= kFirstUdim && number <= kLastUdim)
            named = {.pattern = QString(path).replace(match.capturedStart(), match.capturedLength(), kToken),
                     .number = number};
    }
    return named;
}

} // namespace

QString tilePatternOf(const QString& path, const UvTiles& tiles)
{
    const std::optional<NamedTile> named = tileNamedBy(path);
    return named && !tiles.isOneMap() && tiles.cellOf(named->number) ? named->pattern : path;
}

QStringList tilePatternsOf(const QStringList& paths, const UvTiles& tiles)
{
    QStringList patterns;
    for (const QString& path : paths)
        patterns.append(tilePatternOf(path, tiles));
    for (qsizetype i = 0; i < patterns.size(); ++i)
        if (const std::optional<NamedTile> named = tileNamedBy(patterns[i]); named && patterns.contains(named->pattern))
            patterns[i] = named->pattern;
    patterns.removeDuplicates();
    return patterns;
}

bool isTilePattern(const QString& path)
{
    return QFileInfo(path).fileName().contains(kToken) && !QFileInfo::exists(path);
}

QString mapTitleOf(const QString& path)
{
    QString name = QFileInfo(path).completeBaseName();
    for (const char* const between : {".", "_", "-", ""})
        name.remove(QLatin1StringView(between) + kToken);
    return name;
}

QString nameOfTile(const QString& name, int number)
{
    const qsizetype ending = name.lastIndexOf(QLatin1Char('.'));
    return QString(name).insert(ending, QStringLiteral(".%1").arg(number));
}

Checked<std::vector<TileFile>> tileFilesOf(const QString& pattern)
{
    const QFileInfo told(pattern);
    const qsizetype at = told.fileName().indexOf(kToken);
    const QString before = told.fileName().left(at);
    const QString after = told.fileName().mid(at + kToken.size());
    std::vector<TileFile> files;
    for (const QString& name : told.dir().entryList(QDir::Files, QDir::Name)) {
        const QString digits = name.mid(before.size(), name.size() - before.size() - after.size());
        const int number = digits.size() == 4 && name == before + digits + after ? digits.toInt() : 0;
        if (number >= kFirstUdim && number <= kLastUdim)
            files.push_back({.path = told.dir().filePath(name), .number = number});
    }
    if (files.empty())
        return refuse(say(QT_TRANSLATE_NOOP("Files", "no file of that name has a tile's number instead of <UDIM>, as "
                                                     "'%1' would; name one image for each tile so"))
                          .arg(before + QString::number(kFirstUdim) + after),
                      Clause::Cure::OtherFile);
    return files;
}

} // namespace hairpaint::model
