// The rows of formats and programs.
#include "model/formats/export_format.h"

#include "model/cards/card_file.h"
#include "model/exporting/hair_file.h"
#include "model/exporting/obj_file.h"
#include "model/exporting/ribbon_file.h"
#include "model/exporting/usd_file.h"

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

constexpr const char* kCardsFlag = "cards";

// What formats take.
constexpr std::array kOfCurves = {&kToleranceOption};
constexpr std::array kOfCards = {&kTrianglesOption, &kAtlasOption, &kLevelsOption, &kBonesOption, &kWithHeadOption};
constexpr std::array kOfAvatars = {&kTrianglesOption, &kAtlasOption, &kAuthorOption}; // VRM has one level of detail.
constexpr std::array kAvatarsHave = {&kBonesOption, &kWithHeadOption};

constexpr std::array<ExportFormat, 7> kFormats = {{
    {.id = "hair",
     .suffix = "hair",
     .title = QT_TRANSLATE_NOOP("Export", "Hair curves"),
     .use = QT_TRANSLATE_NOOP("Export", "Strands with width, transparency and colour, small and quickly read."),
     .space = FormatSpace::Target,
     .write = writeHairFile,
     .options = kOfCurves},
    {.id = "usda",
     .suffix = "usda",
     .title = QT_TRANSLATE_NOOP("Export", "USD text"),
     .use = QT_TRANSLATE_NOOP("Export", "Strands and guides for Unreal, Houdini, Maya and Blender 4."),
     .space = FormatSpace::Target,
     .write = writeUsdFile,
     .options = kOfCurves},
    {.id = "usdz",
     .suffix = "usdz",
     .title = QT_TRANSLATE_NOOP("Export", "USD archive"),
     .use = QT_TRANSLATE_NOOP("Export", "The same as USD text, in one archive."),
     .space = FormatSpace::Target,
     .write = writeUsdArchive,
     .options = kOfCurves},
    {.id = "obj",
     .suffix = "obj",
     .title = QT_TRANSLATE_NOOP("Export", "OBJ lines"),
     .use = QT_TRANSLATE_NOOP("Export", "Lines that nearly every program reads; without widths."),
     .space = FormatSpace::TargetUnit,
     .write = writeObjFile,
     .options = kOfCurves},
    {.id = "ribbons",
     .suffix = "glb",
     .title = QT_TRANSLATE_NOOP("Export", "glTF ribbons"),
     .use = QT_TRANSLATE_NOOP("Export", "A flat ribbon a strand, as a mesh for engines and the web. Fewer hairs are "
                                        "wider, so that they cover as much."),
     .space = FormatSpace::Own,
     .write = writeRibbonFile,
     .options = kOfCurves},
    {.id = "cards",
     .suffix = "glb",
     .title = QT_TRANSLATE_NOOP("Export", "glTF cards"),
     .use = QT_TRANSLATE_NOOP("Export", "Strips along locks of hair with textures made from the hair, for games and "
                                        "avatars; further textures lie beside the file."),
     .space = FormatSpace::Own,
     .write = writeCardFile,
     .flag = kCardsFlag,
     .flagHelp = QT_TRANSLATE_NOOP("CommandLine", "as .glb: strips along locks of hair, with textures made from the "
                                                  "hair, instead of a ribbon a hair"),
     .options = kOfCards,
     .unasked = kOfCurves, // Cards follow hairs by themselves.
     .hasFilms = false,
     .hasCards = true},
    {.id = "vrm",
     .suffix = "vrm",
     .title = QT_TRANSLATE_NOOP("Export", "VRM avatar"),
     .use = QT_TRANSLATE_NOOP("Export", "Cards on spring bones with the whole body, where the head came with a "
                                        "skeleton; for avatar programs, virtual worlds and the web (VRM 1.0)."),
     .space = FormatSpace::Own,
     .write = writeCardFile,
     .flag = kCardsFlag,
     .options = kOfAvatars,
     .unasked = kOfCurves,
     .implied = kAvatarsHave,
     .hasFilms = false,
     .hasCards = true,
     .isAvatar = true},
}};

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

bool ExportFormat::takes(const ExportOption& option) const
{
    return std::ranges::any_of(std::array{options, unasked, implied}, [&option](ExportOptions some) {
        return std::ranges::find(some, &option) != some.end();
    });
}

ExportRequest ExportFormat::requestFor(const ExportRequest& wanted) const
{
    ExportRequest request = wanted;
    request.format = this;
    for (const ExportOption* option : exportOptionRows())
        if (!takes(*option))
            option->reset(request);
    for (const ExportOption* option : implied)
        request.cards.*std::get<ExportSwitch>(option->kind).field = true;
    return request;
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

const std::vector<const ExportOption*>& exportOptionRows()
{
    static const std::vector<const ExportOption*> all = [] {
        std::vector<const ExportOption*> options;
        for (const ExportFormat& format : kFormats)
            for (const ExportOption* option : format.options)
                if (std::ranges::find(options, option) == options.end())
                    options.push_back(option);
        return options;
    }();
    return all;
}

} // namespace hairpaint::model
