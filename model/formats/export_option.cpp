// The rows, with their ranges and texts.
#include "model/formats/export_option.h"

#include <array>

namespace hairpaint::model {

namespace {

using Cards = CardSettings;

constexpr double kMetresPerMm = 1e-3;

/// Doubled from the smallest to the largest.
constexpr std::array kAtlasSizesPx = {Cards::kSmallestAtlasPx, 2 * Cards::kSmallestAtlasPx, Cards::kLargestAtlasPx};

} // namespace

constexpr ExportOption kToleranceOption{
    .flag = "tolerance",
    .operand = "MM",
    .help =
        QT_TRANSLATE_NOOP("CommandLine", "leaves out points of the hairs that lie so near to the line without them"),
    .label = QT_TRANSLATE_NOOP("Export", "Tolerance"),
    .hint = QT_TRANSLATE_NOOP("Export", "Leaves out points of the hairs that lie so near to the line without them; "
                                        "with 0 all points are kept."),
    .kind = ExportNumber{
        .read =
            [](const ExportRequest& request) { return static_cast<double>(request.curves.toleranceM) / kMetresPerMm; },
        .write = [](ExportRequest& request,
                    double mm) { request.curves.toleranceM = static_cast<float>(mm * kMetresPerMm); },
        .greatest = 10.0,
        .decimals = 2,
        .exponent = 3.0,
        .unit = QT_TRANSLATE_NOOP("Export", "mm")}};

constexpr ExportOption kTrianglesOption{
    .flag = "triangles",
    .operand = "N",
    .help = QT_TRANSLATE_NOOP("CommandLine", "at most so many of all cards, %1 to %2; %3 unless given"),
    .label = QT_TRANSLATE_NOOP("Export", "Triangles"),
    .hint = QT_TRANSLATE_NOOP("Export", "At most so many of all cards together: 2,000 to 8,000 for phones and avatars, "
                                        "10,000 to 20,000 for consoles and PCs."),
    .kind = ExportNumber{
        .read = [](const ExportRequest& request) { return static_cast<double>(request.cards.triangles); },
        .write = [](ExportRequest& request, double count) { request.cards.triangles = static_cast<int>(count); },
        .least = Cards::kFewestTriangles,
        .greatest = Cards::kMostTriangles,
        .exponent = 2.0}};

constexpr ExportOption kAtlasOption{
    .flag = "atlas",
    .help = QT_TRANSLATE_NOOP("CommandLine", "a side of the cards' textures: %1; %3 unless given"),
    .label = QT_TRANSLATE_NOOP("Export", "Te&xture"),
    .hint = "",
    .kind = ExportChoice{
        .field = &Cards::atlasPx, .values = kAtlasSizesPx, .text = QT_TRANSLATE_NOOP("Export", "%1 × %1 pixels")}};

constexpr ExportOption kLevelsOption{
    .flag = "lods",
    .operand = "N",
    .help =
        QT_TRANSLATE_NOOP("CommandLine", "levels of detail, %1 to %2, each of half the triangles of the one before, "
                                         "with the same textures (MSFT_lod); %3 unless given"),
    .label = QT_TRANSLATE_NOOP("Export", "&Levels of detail"),
    .hint = QT_TRANSLATE_NOOP("Export", "Each further one has half the triangles of the one before and shows the same "
                                        "texture; engines take it for hair that is far away."),
    .kind = ExportNumber{
        .read = [](const ExportRequest& request) { return static_cast<double>(request.cards.levels); },
        .write = [](ExportRequest& request, double count) { request.cards.levels = static_cast<int>(count); },
        .least = 1.0,
        .greatest = Cards::kMostLevels,
        .isList = true}};

constexpr ExportOption kBonesOption{
    .flag = "bones",
    .help = QT_TRANSLATE_NOOP("CommandLine",
                              "joints along the cards' locks, with spring bones (VRMC_springBone) for avatar programs"),
    .label = QT_TRANSLATE_NOOP("Export", "Spring &bones"),
    .hint = QT_TRANSLATE_NOOP("Export", "Joints along the locks, so that avatar programs let the hair swing."),
    .kind = ExportSwitch{&Cards::springBones}};

constexpr ExportOption kWithHeadOption{.flag = "with-head",
                                       .help = QT_TRANSLATE_NOOP("CommandLine", "the head's mesh beside the cards"),
                                       .label = QT_TRANSLATE_NOOP("Export", "With the &head"),
                                       .hint = QT_TRANSLATE_NOOP("Export", "The head's mesh goes into the same file."),
                                       .kind = ExportSwitch{&Cards::withHead}};

constexpr ExportOption kAuthorOption{
    .flag = "author",
    .operand = "NAME",
    .help = QT_TRANSLATE_NOOP("CommandLine", "of an avatar, as its file tells; \"Unknown\" unless given"),
    .label = QT_TRANSLATE_NOOP("Export", "&Author"),
    .hint = QT_TRANSLATE_NOOP("Export", "Whom the avatar's file names as its author. Others may use it only as the "
                                        "author allows."),
    .kind = ExportText{.field = &ExportRequest::author,
                       .longest = Avatar::kLongestText,
                       .whenEmpty = QT_TRANSLATE_NOOP("Export", "Unknown")}};

void ExportOption::reset(ExportRequest& request) const
{
    const ExportRequest standard;
    if (const auto* number = std::get_if<ExportNumber>(&kind))
        number->write(request, number->read(standard));
    else if (const auto* choice = std::get_if<ExportChoice>(&kind))
        request.cards.*choice->field = standard.cards.*choice->field;
    else if (const auto* one = std::get_if<ExportSwitch>(&kind))
        request.cards.*one->field = standard.cards.*one->field;
    else if (const auto* text = std::get_if<ExportText>(&kind))
        request.*text->field = standard.*text->field;
}

} // namespace hairpaint::model
