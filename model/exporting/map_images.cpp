// Encoded by the helper program into a folder beside, then renamed to their targets.
#include "model/exporting/map_images.h"

#include "model/disk/output_path.h"
#include "model/disk/staged_files.h"
#include "model/files/image_map.h"
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

QStringList mapImageNames(std::span<const WantedMap> maps, const MapImageFormat& format)
{
    QStringList names;
    QSet<QString> taken;
    for (const WantedMap& map : maps) {
        const QString word = fileWord(map.group) + QLatin1Char('-') + QLatin1StringView(mapSpec(map.kind).id);
        QString name = word;
        for (int number = 2; taken.contains(name.toLower()); ++number)
            name = QStringLiteral("%1-%2").arg(word).arg(number);
        taken.insert(name.toLower());
        names += name + QLatin1Char('.') + QLatin1StringView(format.suffix);
    }
    return names;
}

Result<void> writeMapImages(std::span<const WantedMap> maps, const QString& folder, const MapImageOptions& options,
                            const Progress& progress)
{
    QStringList paths;
    for (const QString& name : mapImageNames(maps, *options.format))
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
        const QString& target = paths[static_cast<qsizetype>(i)];
        const auto part = [&](double done) {
            return !progress || progress((static_cast<double>(i) + done) / static_cast<double>(maps.size()));
        };
        if (!part(0.0))
            return cancelled(target);
        const Result<void> written = withinMemory(target, cannotWrite, [&] {
            return client.writeImage(imageFromMap(*maps[i].resolved, mapSpec(maps[i].kind), options.grey),
                                     staged.pathFor(target), options.bits, part);
        });
        if (!written)
            return tl::unexpected(staged.named(written.error(), target));
    }
    if (progress && !progress(1.0))
        return cancelled(folder);
    return staged.publish(paths);
}

} // namespace hairpaint::model
