// The table of formats that hair is exported in, and of programs it is exported for. Menus, dialogs and the command
// line read it: another format is another row.
#pragma once

#include "model/formats/export_option.h"
#include "model/formats/export_request.h"

#include <QString>
#include <QStringList>

#include <cstdint>
#include <span>
#include <vector>

namespace hairpaint::model {

/// A program that reads what is exported, and the space that is its own.
struct ExportTarget
{
    const char* id;    ///< "blender": what scripts call it.
    const char* title; ///< Translated in context "Export".
    ExportSpace space;
    bool groomColours = false; ///< See ExportSettings.
    [[nodiscard]] QString titleText() const;
};

/// The first is no program in particular: metres, y up.
[[nodiscard]] std::span<const ExportTarget> exportTargets();
/// Null where there is none of that id.
[[nodiscard]] const ExportTarget* findExportTarget(const QString& id);

/// How much of a target's space a format takes on.
enum class FormatSpace : std::uint8_t
{
    Target,     ///< All of it, and the file tells so where it can.
    TargetUnit, ///< Its unit; readers expect y up and turn it themselves.
    Own         ///< Metres and y up, as the format prescribes.
};

struct ExportFormat
{
    const char* id;     ///< "cards": what tests and scripts call it.
    const char* suffix; ///< "hair", without the dot.
    const char* title;  ///< "Hair curves", translated in context "Export".
    const char* use;    ///< A sentence on what it is good for; translated in context "Export".
    FormatSpace space;
    Result<void> (*write)(const CurveSet& curves, const ExportSettings& settings, const QString& path,
                          const Progress& progress);
    /// Option of the command line that chooses this format among those with the same ending. It may also be given where
    /// no other format has the ending.
    const char* flag = "";
    /// Help of `flag`, to be translated in context "CommandLine"; set in the first row with that flag.
    const char* flagHelp = "";
    ExportOptions options = {}; ///< Options that the window and the command line offer, in this order.
    ExportOptions unasked = {}; ///< Further options of the command line; the window leaves their defaults.
    ExportOptions implied = {}; ///< Switches that are always on.
    bool hasFilms = true;       ///< Whether a frame of hair in motion can be exported.
    bool hasCards = false;      ///< Whether it has hair cards, made by ExportRequest::cards, which can be previewed.
    bool isAvatar = false;      ///< Whether it needs ExportRequest::avatar.
    [[nodiscard]] QString titleText() const;
    [[nodiscard]] QString useText() const;
    [[nodiscard]] ExportSettings settingsFor(const ExportTarget& target) const;
    /// Whether the format accepts the option: it changes what is written, or the format implies it.
    [[nodiscard]] bool takes(const ExportOption& option) const;
    /// The request as this format can meet it: options that it does not take are at their defaults, implied ones are
    /// on.
    [[nodiscard]] ExportRequest requestFor(const ExportRequest& wanted) const;
};

[[nodiscard]] std::span<const ExportFormat> exportFormats();
/// The format for the ending of a file's name; null where none has it. Where several do, `preferred` if it is one of
/// them, else the first.
[[nodiscard]] const ExportFormat* findExportFormat(const QString& path, const ExportFormat* preferred = nullptr);
/// All endings, without dots, each once.
[[nodiscard]] QStringList exportSuffixes();
/// The format that holds cards alone.
[[nodiscard]] const ExportFormat& cardFormat();

/// The options of all formats, each once, in their order.
[[nodiscard]] const std::vector<const ExportOption*>& exportOptionRows();

} // namespace hairpaint::model
