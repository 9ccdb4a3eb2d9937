// Names cut into words.
#include "model/files/map_names.h"

#include "model/values/names.h"

#include <QFileInfo>
#include <QRegularExpression>

#include <algorithm>

namespace hairpaint::model {

namespace {

struct MapWords
{
    QStringList words;
    MapKind kind;
};

QStringList wordsOf(const QString& name)
{
    static const QRegularExpression kBetween(QStringLiteral("[^\\p{L}\\p{N}]+"));
    return name.toLower().split(kBetween, Qt::SkipEmptyParts);
}

/// Those of two words first, since one of theirs may be another map's.
const std::vector<MapWords>& knownWords()
{
    static const std::vector<MapWords> known = [] {
        std::vector<MapWords> made;
        const auto add = [&made](const QString& name, MapKind kind) {
            const QStringList words = wordsOf(name);
            made.push_back({words, kind});
            if (words.size() > 1)
                made.push_back({{words.join(QString())}, kind});
        };
        for (const MapSpec& spec : mapSpecs()) {
            const QString id = QLatin1StringView(spec.id);
            add(id, spec.kind);
            add(spec.titleText(), spec.kind);
            if (id.contains(QLatin1String("colour")))
                add(QString(id).replace(QLatin1String("colour"), QLatin1String("color")), spec.kind);
        }
        std::ranges::stable_sort(made,
                                 [](const MapWords& a, const MapWords& b) { return a.words.size() > b.words.size(); });
        return made;
    }();
    return known;
}

bool standsAt(const QStringList& words, qsizetype at, const QStringList& wanted)
{
    return at + wanted.size() <= words.size() && std::equal(wanted.begin(), wanted.end(), words.begin() + at);
}

} // namespace

std::optional<NamedMap> mapNamedBy(const QString& path, std::span<const HairGroup> groups)
{
    const QStringList words = wordsOf(QFileInfo(path).completeBaseName());
    for (qsizetype end = words.size(); end > 0; --end)
        for (const MapWords& known : knownWords()) {
            const qsizetype at = end - known.words.size();
            if (at < 0 || !standsAt(words, at, known.words))
                continue;
            NamedMap named{.group = {}, .kind = known.kind};
            qsizetype most = 0; // The number of words of the longest group name found.
            for (std::size_t i = 0; i < groups.size(); ++i)
                for (const QString& name : {groups[i].name, shownName(groups[i].name)}) {
                    const QStringList of = wordsOf(name);
                    if (of.size() > most && of.size() <= at && standsAt(words, 0, of)) {
                        most = of.size();
                        named.group = i;
                    }
                }
            return named;
        }
    return std::nullopt;
}

const QStringList& imageEndings()
{
    static const QStringList endings{QStringLiteral("png"),  QStringLiteral("jpg"),  QStringLiteral("jpeg"),
                                     QStringLiteral("tif"),  QStringLiteral("tiff"), QStringLiteral("exr"),
                                     QStringLiteral("hdr"),  QStringLiteral("tga"),  QStringLiteral("bmp"),
                                     QStringLiteral("webp"), QStringLiteral("psd"),  QStringLiteral("gif"),
                                     QStringLiteral("dds")};
    return endings;
}

} // namespace hairpaint::model
