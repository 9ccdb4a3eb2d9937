// What can be chosen of an export, as rows. A format names the rows that it takes; the command line, its --help and its
// usage line, and the window's dialog read them.
#pragma once

#include "model/formats/export_request.h"

#include <QCoreApplication>
#include <QString>

#include <span>
#include <variant>

namespace hairpaint::model {

/// A number, in the unit that is shown and given.
struct ExportNumber
{
    double (*read)(const ExportRequest& request) = nullptr;
    void (*write)(ExportRequest& request, double value) = nullptr;
    double least = 0.0;
    double greatest = 0.0;
    int decimals = 0;      ///< 0: whole numbers alone.
    double exponent = 1.0; ///< Above 1 a slider gives low values more room.
    const char* unit = ""; ///< To be translated in context "Export".
    bool isList = false;   ///< So few that a list shows them.
};

/// One of a few whole numbers.
struct ExportChoice
{
    int CardSettings::*field = nullptr;
    std::span<const int> values;
    const char* text = "%1"; ///< "%1 × %1 pixels"; to be translated in context "Export".
};

struct ExportSwitch
{
    bool CardSettings::*field = nullptr;
};

struct ExportText
{
    QString ExportRequest::*field = nullptr;
    int longest = 0;
    const char* whenEmpty = ""; ///< What is shown, and taken, then; to be translated in context "Export".
};

struct ExportOption
{
    const char* flag;         ///< "triangles": on the command line, after two dashes.
    const char* operand = ""; ///< "N": what the flag takes; of a choice its values are named instead.
    /// --help tells it: %1 the least and %2 the greatest number, or %1 the numbers to choose from; %3 the default. To
    /// be translated in context "CommandLine".
    const char* help;
    const char* label; ///< In the dialog; to be translated in context "Export", as is the next.
    const char* hint;
    std::variant<ExportNumber, ExportChoice, ExportSwitch, ExportText> kind;

    [[nodiscard]] QString labelText() const { return QCoreApplication::translate("Export", label); }
    [[nodiscard]] QString hintText() const { return QCoreApplication::translate("Export", hint); }
    /// Puts the default into the request.
    void reset(ExportRequest& request) const;
};

using ExportOptions = std::span<const ExportOption* const>;

extern const ExportOption kToleranceOption;
extern const ExportOption kTrianglesOption;
extern const ExportOption kAtlasOption;
extern const ExportOption kLevelsOption;
extern const ExportOption kBonesOption;
extern const ExportOption kWithHeadOption;
extern const ExportOption kAuthorOption;

} // namespace hairpaint::model
