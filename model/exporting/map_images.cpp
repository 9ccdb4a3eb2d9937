// Encoded by the helper program into a folder beside, then renamed to their targets.
#include "model/exporting/map_images.h"

#include "model/disk/output_path.h"
#include "model/disk/staged_files.h"
#include "model/files/image_map.h"
#include "model/files/map_source.h"
#include "model/files/tile_names.h"
#include "model/values/sentences.h"

#include <QDir>
#include <QSet>

#include <algorithm>
#include <array>

namespace hairpaint::model {

namespace {

constexpr std::array<MapImageFormat, 4> kImageFormats = {{
    {.suffix = "png", .hasDepths = true},
    {.suffix = "tif", .hasDepths = true},
    {.suffix = "exr", .hasDepths = false},
    {.suffix = "tga", .hasDepths = false},
}};

/// Without what is no part of a file's name on some system.
QString fileWord(const QString& name)
{
    QString word;
    for (const QChar c : name.simplified())
        word += c.isPrint() && !QStringLiteral("/\\:*?\"<>|.").contains(c) ? c : QLatin1Char('_');
    return word.isEmpty() ? QStringLiteral("_") : word.left(64);
}

} // namespace

std::span<const MapImageFormat> mapImageFormats()
{
    return kImageFormats;
}

QStringList mapImageSuffixes()
{
    QStringList suffixes;
    for (const MapImageFormat& format : mapImageFormats())
        suffixes += QString::fromLatin1(format.suffix);
    return suffixes;
}

const MapImageFormat* findMapImageFormat(const QString& suffix)
{
    const auto* const found = std::ranges::find_if(kImageFormats, [&suffix](const MapImageFormat& format) {
        return suffix.compare(QLatin1StringView(format.suffix), Qt::CaseInsensitive) == 0;
    });
    return found == kImageFormats.end() ? nullptr : &*found;
}

QStringList mapImageNames(std::span<const WantedMap> maps, const MapImageOptions& options)
{
    QStringList names;
    QSet<QString> taken;
    for (const WantedMap& map : maps) {
        const QString word = fileWord(map.group) + QLatin1Char('-') + QLatin1StringView(mapSpec(map.kind).id);
        QString name = word;
        for (int number = 2; taken.contains(name.toLower()); ++number)
            name = QStringLiteral("%1-%2").arg(word).arg(number);
        taken.insert(name.toLower());
        name += QLatin1Char('.') + QLatin1StringView(options.format->suffix);
        if (!options.tiles)
            names += name;
        else
            for (const int number : options.tiles->numbers())
                names += nameOfTile(name, number);
    }
    return names;
}

Result<void> writeMapImages(std::span<const WantedMap> maps, const QString& folder, const MapImageOptions& options,
                            const Progress& progress)
{
    if (const std::optional<int> shared = options.tiles ? options.tiles->shared() : std::nullopt)
        return cannotWrite(folder,
                           {.text = say(QT_TRANSLATE_NOOP("Files", "several layouts of the head lie in its tile "
                                                                   "%1, so images by tile would lie over each "
                                                                   "other; write one image a map"))
                                        .arg(*shared),
                            .cure = Clause::Cure::OtherFile});
    QStringList paths;
    for (const QString& name : mapImageNames(maps, options))
        paths += QDir(folder).filePath(name);
    for (const QString& target : paths)
        if (const Checked<void> writable = checkWritable(target); !writable)
            return cannotWrite(target, writable.error());
    if (paths.isEmpty())
        return {};
    StagedFiles staged(folder);
    if (Result<void> ready = staged.check(paths.front()); !ready)
        return ready;
    ImporterClient client;
    for (std::size_t i = 0; i < maps.size(); ++i) {
        const qsizetype files = paths.size() / static_cast<qsizetype>(maps.size()); // A map.
        const qsizetype first = static_cast<qsizetype>(i) * files;
        const Result<void> written = withinMemory(paths[first], cannotWrite, [&]() -> Result<void> {
            const ForeignImage map = imageFromMap(*maps[i].resolved, mapSpec(maps[i].kind), options.grey);
            for (qsizetype file = first; file < first + files; ++file) {
                const auto part = [&](double done) {
                    return !progress ||
                           progress((static_cast<double>(file) + done) / static_cast<double>(paths.size()));
                };
                const auto write = [&](const ForeignImage& image) {
                    return client.writeImage(image, staged.pathFor(paths[file]), options.bits, part);
                };
                if (!part(0.0))
                    return cancelled(paths[file]);
                const Result<void> one =
                    options.tiles ? write(imageOfCell(map, *options.tiles, static_cast<std::size_t>(file - first)))
                                  : write(map);
                if (!one)
                    return tl::unexpected(staged.named(one.error(), paths[file]));
            }
            return {};
        });
        if (!written)
            return written;
    }
    if (progress && !progress(1.0))
        return cancelled(folder);
    return staged.publish(paths);
}

} // namespace hairpaint::model
