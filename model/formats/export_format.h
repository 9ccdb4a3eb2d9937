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
    /// Of several with one ending: the option of the command line that asks for this one. Where it is the only one the
    /// option may be given too.
    const char* flag = "";
    const char* flagHelp = "";  ///< To be translated in context "CommandLine"; of the first with that flag.
    ExportOptions options = {}; ///< What can be chosen, in this order.
    ExportOptions unasked = {}; ///< What the command line takes besides; the window leaves the defaults.
    ExportOptions implied = {}; ///< Switches that are on, whatever is wanted.
    bool hasFilms = true;       ///< Can show a frame of hair in motion.
    bool hasCards = false;      ///< Made by ExportRequest::cards; they can be looked at before.
    bool isAvatar = false;      ///< They come with ExportRequest::avatar.
    [[nodiscard]] QString titleText() const;
    [[nodiscard]] QString useText() const;
    [[nodiscard]] ExportSettings settingsFor(const ExportTarget& target) const;
    /// Whether the option changes what is written, or says what it is anyway.
    [[nodiscard]] bool takes(const ExportOption& option) const;
    /// The wishes as this format can have them: at its default what it does not take, on what it implies.
    [[nodiscard]] ExportRequest requestFor(const ExportRequest& wanted) const;
};

[[nodiscard]] std::span<const ExportFormat> exportFormats();
/// By the name's ending; null where it is none of theirs. Of those with that ending `preferred`, else the first.
[[nodiscard]] const ExportFormat* findExportFormat(const QString& path, const ExportFormat* preferred = nullptr);
/// All endings, without dots, each once.
[[nodiscard]] QStringList exportSuffixes();
/// The one with cards alone.
[[nodiscard]] const ExportFormat& cardFormat();

/// Those of all formats, each once, in their order.
[[nodiscard]] const std::vector<const ExportOption*>& exportOptionRows();

} // namespace hairpaint::model
