// The rows, and how one of them is carried out.
#include "model/exporting/export_format.h"

#include "model/exporting/cards/card_file.h"
#include "model/exporting/hair_file.h"
#include "model/exporting/obj_file.h"
#include "model/exporting/ribbon_file.h"
#include "model/exporting/usd_file.h"
#include "model/values/sentences.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace hairpaint::model {

namespace {

constexpr ExportSpace kMetres{};
constexpr ExportSpace kCentimetres{.unitsPerMetre = 100.0F};
constexpr ExportSpace kMetresZ{.zUp = true};
constexpr ExportSpace kCentimetresZ{.unitsPerMetre = 100.0F, .zUp = true};

constexpr std::array<ExportTarget, 6> kTargets = {{
    {.id = "any", .title = QT_TRANSLATE_NOOP("Export", "Any program: metres, y up"), .space = kMetres},
    {.id = "blender", .title = "Blender", .space = kMetresZ},
    {.id = "unreal", .title = "Unreal Engine", .space = kCentimetresZ, .groomColours = true},
    {.id = "godot", .title = "Godot", .space = kMetres},
    {.id = "unity", .title = "Unity", .space = kMetres},
    {.id = "maya", .title = "Maya", .space = kCentimetres},
}};

constexpr std::array<ExportFormat, 7> kFormats = {{
    {.id = "hair",
     .suffix = "hair",
     .title = QT_TRANSLATE_NOOP("Export", "Hair curves"),
     .use = QT_TRANSLATE_NOOP("Export", "Strands with width, transparency and colour, small and quickly read."),
     .space = FormatSpace::Target,
     .write = writeHairFile},
    {.id = "usda",
     .suffix = "usda",
     .title = QT_TRANSLATE_NOOP("Export", "USD text"),
     .use = QT_TRANSLATE_NOOP("Export", "Strands and guides for Unreal, Houdini, Maya and Blender 4."),
     .space = FormatSpace::Target,
     .write = writeUsdFile},
    {.id = "usdz",
     .suffix = "usdz",
     .title = QT_TRANSLATE_NOOP("Export", "USD archive"),
     .use = QT_TRANSLATE_NOOP("Export", "The same as USD text, in one archive."),
     .space = FormatSpace::Target,
     .write = writeUsdArchive},
    {.id = "obj",
     .suffix = "obj",
     .title = QT_TRANSLATE_NOOP("Export", "OBJ lines"),
     .use = QT_TRANSLATE_NOOP("Export", "Lines that nearly every program reads; without widths."),
     .space = FormatSpace::TargetUnit,
     .write = writeObjFile},
    {.id = "ribbons",
     .suffix = "glb",
     .title = QT_TRANSLATE_NOOP("Export", "glTF ribbons"),
     .use = QT_TRANSLATE_NOOP("Export", "A flat ribbon a strand, as a mesh for engines and the web. Fewer hairs are "
                                        "wider, so that they cover as much."),
     .space = FormatSpace::Own,
     .write = writeRibbonFile},
    {.id = "cards",
     .suffix = "glb",
     .title = QT_TRANSLATE_NOOP("Export", "glTF cards"),
     .use = QT_TRANSLATE_NOOP("Export", "Strips along locks of hair with textures made from the hair, for games and "
                                        "avatars; further textures lie beside the file."),
     .space = FormatSpace::Own,
     .write = writeCardFile,
     .hasCards = true},
    {.id = "vrm",
     .suffix = "vrm",
     .title = QT_TRANSLATE_NOOP("Export", "VRM avatar"),
     .use = QT_TRANSLATE_NOOP("Export", "Cards on spring bones with the whole body, where the head came with a "
                                        "skeleton; for avatar programs, virtual worlds and the web (VRM 1.0)."),
     .space = FormatSpace::Own,
     .write = writeCardFile,
     .hasCards = true,
     .isAvatar = true},
}};

/// Of all work, finding the curves.
constexpr double kMeasured = 0.2;

QString exportText(const char* text)
{
    return QCoreApplication::translate("Export", text);
}

} // namespace

QString ExportTarget::titleText() const
{
    return exportText(title);
}

std::span<const ExportTarget> exportTargets()
{
    return kTargets;
}

const ExportTarget* findExportTarget(const QString& id)
{
    const auto* const found = std::ranges::find_if(
        kTargets, [&id](const ExportTarget& target) { return id == QLatin1StringView(target.id); });
    return found == kTargets.end() ? nullptr : &*found;
}

QString ExportFormat::titleText() const
{
    return exportText(title);
}

QString ExportFormat::useText() const
{
    return exportText(use);
}

ExportSettings ExportFormat::settingsFor(const ExportTarget& target) const
{
    ExportSettings settings{.space = target.space, .groomColours = target.groomColours};
    if (space != FormatSpace::Target)
        settings.space.zUp = false;
    if (space == FormatSpace::Own)
        settings.space.unitsPerMetre = 1.0F;
    return settings;
}

CardSettings ExportFormat::cardsFor(const CardSettings& wanted) const
{
    CardSettings cards = wanted;
    if (isAvatar) {
        cards.levels = 1; // VRM has none.
        cards.springBones = true;
        cards.withHead = true;
    }
    return cards;
}

std::span<const ExportFormat> exportFormats()
{
    return kFormats;
}

const ExportFormat* findExportFormat(const QString& path, const ExportFormat* preferred)
{
    const auto fits = [&path](const ExportFormat& format) {
        return path.endsWith(QLatin1Char('.') + QLatin1StringView(format.suffix), Qt::CaseInsensitive);
    };
    if (preferred != nullptr && fits(*preferred))
        return preferred;
    const auto* const found = std::ranges::find_if(kFormats, fits);
    return found == kFormats.end() ? nullptr : &*found;
}

QStringList exportSuffixes()
{
    QStringList suffixes;
    for (const ExportFormat& format : kFormats)
        suffixes += QString::fromLatin1(format.suffix);
    suffixes.removeDuplicates();
    return suffixes;
}

const ExportFormat& cardFormat()
{
    return *std::ranges::find_if(kFormats,
                                 [](const ExportFormat& format) { return format.hasCards && !format.isAvatar; });
}

Result<void> exportHair(const std::shared_ptr<const sim::StrandFrame>& frame, const ExportRequest& request,
                        const QString& path, const Progress& progress)
{
    return withinMemory(path, cannotWrite, [&]() -> Result<void> {
        const auto part = [&progress](double from, double to) -> Progress {
            return [&progress, from, to](double done) { return !progress || progress(from + (to - from) * done); };
        };
        const std::optional<CurveSet> curves = CurveSet::of(frame, request.curves, part(0.0, kMeasured));
        if (!curves)
            return cancelled(path);
        ExportSettings settings = request.format->settingsFor(*request.target);
        settings.cards = request.format->cardsFor(request.cards);
        Q_ASSERT(!request.format->isAvatar || request.avatar != nullptr);
        if (request.format->isAvatar)
            settings.avatar = request.avatar;
        settings.worn = request.worn;
        settings.skinColour = request.skinColour;
        return request.format->write(*curves, settings, path, part(kMeasured, 1.0));
    });
}

} // namespace hairpaint::model
