// The rows, and how a file is opened for them.
#include "model/importing/curve_reader.h"

#include "model/files/archive.h"
#include "model/importing/hair_file_reader.h"
#include "model/importing/usd_reader.h"
#include "model/values/sentences.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <array>
#include <cmath>

namespace hairpaint::model {

namespace {

using MaybeCurves = Checked<std::optional<ForeignCurves>>;

MaybeCurves readHairAt(const QString& path, const Progress& progress)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return refuse(readRefusal(file.errorString()), Clause::Cure::OtherFile);
    return readHairFile(file, progress);
}

/// So that what is computed of it stays a number.
bool isNearBy(const glm::vec3& point)
{
    constexpr float kFurthest = 1e9F;
    return std::abs(point.x) < kFurthest && std::abs(point.y) < kFurthest && std::abs(point.z) < kFurthest;
}

/// Takes out the strands that are none: of one point, or with a point that is no number. Returns how many.
std::size_t dropBroken(ForeignStrands& strands)
{
    ForeignStrands kept{.name = strands.name,
                        .ends = {},
                        .points = {},
                        .looks = {},
                        .hasColours = strands.hasColours,
                        .isGuides = strands.isGuides};
    const auto isWhole = [&strands](std::size_t i) {
        const std::span<const glm::vec3> points = strands.strand(i);
        return points.size() >= 2 && std::ranges::all_of(points, isNearBy);
    };
    std::size_t broken = 0;
    for (std::size_t i = 0; i < strands.count(); ++i)
        broken += isWhole(i) ? 0 : 1;
    if (broken == 0)
        return 0;
    for (std::size_t i = 0; i < strands.count(); ++i) {
        if (!isWhole(i))
            continue;
        const std::span<const glm::vec3> points = strands.strand(i);
        kept.points.insert(kept.points.end(), points.begin(), points.end());
        kept.ends.push_back(static_cast<std::uint32_t>(kept.points.size()));
        kept.looks.push_back(strands.looks[i]);
    }
    strands = std::move(kept);
    return broken;
}

constexpr qint64 kMostUsdBytes = qint64{1} << 30; ///< 100,000 strands of 16 points are a tenth.

MaybeCurves readUsdAt(const QString& path, const Progress& progress)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return refuse(readRefusal(file.errorString()), Clause::Cure::OtherFile);
    return readUsdText(file.readAll(), progress, usdFilesBeside(path));
}

/// The first of its files that is text: the others are what that one refers to.
MaybeCurves readUsdArchiveAt(const QString& path, const Progress& progress)
{
    const Checked<ArchiveReader> archive = ArchiveReader::open(path);
    if (!archive)
        return tl::unexpected(archive.error());
    for (const QString& name : archive->names())
        if (name.endsWith(QLatin1String(".usda"), Qt::CaseInsensitive)) {
            const Checked<QByteArray> text = archive->read(name, kMostUsdBytes);
            const auto opener = [&](const QString& asset, const QString& from) -> std::optional<UsdLayer> {
                const QString within = QFileInfo(from.isEmpty() ? name : from).path();
                const QString other = QDir::cleanPath(within + QLatin1Char('/') + asset);
                Checked<QByteArray> own =
                    archive->contains(other) ? archive->read(other, kMostUsdBytes) : Checked<QByteArray>(QByteArray());
                if (!own || !own->startsWith("#usda "))
                    return std::nullopt;
                return UsdLayer{.text = *std::move(own), .path = other};
            };
            return text ? readUsdText(*text, progress, opener) : tl::unexpected(text.error());
        }
    return refuse(say(QT_TRANSLATE_NOOP("Files", "it holds no USD text; save it with the ending .usda")),
                  Clause::Cure::OtherFile);
}

struct CurveFormat
{
    const char* ending;
    qint64 mostBytes;
    MaybeCurves (*read)(const QString& path, const Progress& progress);
};

constexpr std::array kCurveFormats{
    CurveFormat{.ending = "hair", .mostBytes = qint64{1} << 32, .read = readHairAt},
    CurveFormat{.ending = "usda", .mostBytes = kMostUsdBytes, .read = readUsdAt},
    CurveFormat{.ending = "usd", .mostBytes = kMostUsdBytes, .read = readUsdAt},
    CurveFormat{.ending = "usdz", .mostBytes = kMostUsdBytes, .read = readUsdArchiveAt},
};

} // namespace

const QStringList& curveFileEndings()
{
    static const QStringList endings = [] {
        QStringList made;
        for (const CurveFormat& format : kCurveFormats)
            made += QString::fromLatin1(format.ending);
        return made;
    }();
    return endings;
}

Result<ForeignCurves> readCurves(const QString& path, const Progress& progress)
{
    const QString ending = QFileInfo(path).suffix().toLower();
    const auto* const format = std::ranges::find_if(
        kCurveFormats, [&ending](const CurveFormat& one) { return ending == QLatin1StringView(one.ending); });
    if (format == kCurveFormats.end())
        return cannotOpen(path,
                          {.text = say(QT_TRANSLATE_NOOP("Files", "hair is read from files that end in %1; choose one "
                                                                  "of those"))
                                       .arg(QLatin1Char('.') + curveFileEndings().join(QLatin1String(", ."))),
                           .cure = Clause::Cure::OtherFile});
    if (const Result<void> readable = checkReadable(path, format->mostBytes); !readable)
        return tl::unexpected(readable.error());
    return withinMemory(path, cannotOpen, [&]() -> Result<ForeignCurves> {
        MaybeCurves curves = format->read(path, progress);
        if (!curves)
            return cannotOpen(path, curves.error());
        if (!*curves)
            return cancelled(path);
        leaveOutBroken(**curves);
        if ((*curves)->groups.empty() && (*curves)->leftOut > 0)
            return cannotOpen(path,
                              {.text = say(QT_TRANSLATE_NOOP("Files", "its hair is cut short or broken; export it "
                                                                      "again")),
                               .cure = Clause::Cure::OtherFile});
        if ((*curves)->groups.empty())
            return cannotOpen(path, {.text = say(QT_TRANSLATE_NOOP("Files", "it holds no hair; choose another file")),
                                     .cure = Clause::Cure::OtherFile});
        return std::move(**curves);
    });
}

void leaveOutBroken(ForeignCurves& curves)
{
    for (ForeignStrands& strands : curves.groups)
        curves.leftOut += dropBroken(strands);
    std::erase_if(curves.groups, [](const ForeignStrands& strands) { return strands.count() == 0; });
}

} // namespace hairpaint::model
