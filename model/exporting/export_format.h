// The table of formats that hair is exported in, and of programs it is exported for. Menus, dialogs and the command
// line read it; a format more is a row more.
#pragma once

#include "model/exporting/avatar.h"
#include "model/exporting/curve_set.h"
#include "model/exporting/export_space.h"
#include "model/values/error.h"

#include <QString>
#include <QStringList>

#include <cstdint>
#include <memory>
#include <span>

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
    bool hasCards = false; ///< Made by ExportRequest::cards.
    bool isAvatar = false; ///< They come with ExportRequest::avatar, on spring bones, in one level.
    [[nodiscard]] QString titleText() const;
    [[nodiscard]] QString useText() const;
    [[nodiscard]] ExportSettings settingsFor(const ExportTarget& target) const;
    /// What of the wishes it can have.
    [[nodiscard]] CardSettings cardsFor(const CardSettings& wanted) const;
};

[[nodiscard]] std::span<const ExportFormat> exportFormats();
/// By the name's ending; null where it is none of theirs. Of those with that ending `preferred`, else the first.
[[nodiscard]] const ExportFormat* findExportFormat(const QString& path, const ExportFormat* preferred = nullptr);
/// All endings, without dots, each once.
[[nodiscard]] QStringList exportSuffixes();
/// The one with cards alone.
[[nodiscard]] const ExportFormat& cardFormat();

struct ExportRequest
{
    const ExportFormat* format = nullptr;
    const ExportTarget* target = nullptr;
    CurveOptions curves{};
    CardSettings cards{};
    std::vector<Worn> worn{};               ///< See ExportSettings.
    QRgb skinColour = 0xFF808080;           ///< Likewise.
    std::shared_ptr<const Avatar> avatar{}; ///< There where the format is one of avatars.
};

/// Atomic: nothing is written where it fails or `progress`, which never steps back, cancels. Any thread.
[[nodiscard]] Result<void> exportHair(const std::shared_ptr<const sim::StrandFrame>& frame,
                                      const ExportRequest& request, const QString& path, const Progress& progress = {});

} // namespace hairpaint::model
