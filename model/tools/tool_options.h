// What tools can be set to, as rows. Each tool names its rows; the option bar and the file of settings read them.
#pragma once

#include "model/tools/tool_settings.h"

#include <QCoreApplication>
#include <QString>

#include <array>
#include <cstdint>
#include <span>
#include <variant>

namespace hairpaint::model {

/// The value that the active map is painted with. The option bar knows how; it is not kept between starts.
struct ToolValue
{};

/// A slider over a number of the settings.
struct ToolNumber
{
    enum class Unit : std::uint8_t
    {
        Percent,     ///< Shows a fraction in per cent.
        Centimetres, ///< Shows a length in metres in centimetres; the next in millimetres.
        Millimetres
    };
    float ToolSettings::*field = nullptr;
    Unit unit = Unit::Percent;
    double least = 0.0; ///< Range, in `unit`.
    double greatest = 100.0;
    double standard = 0.0; ///< Value in new settings, in `unit`.
    int decimals = 0;
    double exponent = 1.0; ///< Above 1 a slider gives low values more room.
    [[nodiscard]] double shownPerSi() const;
    [[nodiscard]] QString unitText() const; ///< "cm", translated.
};

struct ToolSwitch
{
    bool ToolSettings::*field = nullptr;
    const char* icon = "";
    bool standard = false; ///< Value in new settings.
};

/// One of a few kinds.
struct ToolChoice
{
    struct Item
    {
        const char* icon;
        const char* title;     ///< To be translated in context "ToolOptions".
        const char* step = ""; ///< Text of its undo step, in context "Tool"; "": the tool's.
        const char* hint = ""; ///< Text in the status bar, in context "Tool"; "": the tool's.
        [[nodiscard]] QString titleText() const { return QCoreApplication::translate("ToolOptions", title); }
    };
    std::span<const Item> entries;
    int (*read)(const ToolSettings& settings) = nullptr;
    void (*write)(ToolSettings& settings, int index) = nullptr;
    int standard = 0; ///< Index of the entry in new settings.
    [[nodiscard]] const Item& chosen(const ToolSettings& settings) const
    {
        return entries[static_cast<std::size_t>(read(settings))];
    }
};

/// A row. One that several tools have is the same object, or has the same key.
struct ToolOption
{
    const char* key; ///< In the file of settings.
    const char* label =
        ""; ///< To be translated in context "ToolOptions", as is the next. Switches and choices go by icons.
    const char* hint = "";
    std::variant<ToolValue, ToolNumber, ToolSwitch, ToolChoice> kind;
    bool (*isShown)(const ToolSettings& settings) = nullptr; ///< Null: always.
    bool (*isUsed)(const ToolSettings& settings) = nullptr;  ///< Null: always. Otherwise shown, but disabled.

    [[nodiscard]] QString labelText() const { return QCoreApplication::translate("ToolOptions", label); }
    [[nodiscard]] QString hintText() const { return QCoreApplication::translate("ToolOptions", hint); }
};

/// As the option bar shows them, from the left.
using ToolOptions = std::span<const ToolOption* const>;

/// A row's number in SI units, 0 or 1 of a switch, the index of a choice; 0 of a ToolValue.
[[nodiscard]] double optionOf(const ToolSettings& settings, const ToolOption& option);
/// optionOf() in new settings.
[[nodiscard]] double standardOf(const ToolOption& option);
/// Puts what optionOf() gave into the settings, at the nearest end of the range where it lies beyond; what is no number
/// is passed over.
void putOption(ToolSettings& settings, const ToolOption& option, double value);

// Rows of more than one tool.

inline constexpr ToolOption kValueOption{.key = "value",
                                         .label = QT_TRANSLATE_NOOP("ToolOptions", "Value"),
                                         .hint = QT_TRANSLATE_NOOP("ToolOptions", "What is painted on the active map"),
                                         .kind = ToolValue{}};
inline constexpr ToolOption kSizeOption{.key = "size",
                                        .label = QT_TRANSLATE_NOOP("ToolOptions", "Size"),
                                        .kind = ToolNumber{.field = &ToolSettings::brushSizeM,
                                                           .unit = ToolNumber::Unit::Centimetres,
                                                           .least = 0.1,
                                                           .greatest = 30.0,
                                                           .standard = 3.0,
                                                           .decimals = 1,
                                                           .exponent = 2.5}};
inline constexpr ToolOption kHardnessOption{.key = "hardness",
                                            .label = QT_TRANSLATE_NOOP("ToolOptions", "Hardness"),
                                            .kind = ToolNumber{.field = &ToolSettings::hardness, .standard = 60.0}};
inline constexpr ToolOption kOpacityOption{.key = "opacity",
                                           .label = QT_TRANSLATE_NOOP("ToolOptions", "Opacity"),
                                           .kind = ToolNumber{.field = &ToolSettings::opacity, .standard = 100.0}};
inline constexpr std::array kTouchKinds{
    ToolChoice::Item{
        "touch-seen",
        QT_TRANSLATE_NOOP("ToolOptions", "On what is seen in the 3D area: skin, or hair that hangs over it (T)")},
    ToolChoice::Item{"touch-skin", QT_TRANSLATE_NOOP("ToolOptions", "On the skin, through the hair (T)")},
    ToolChoice::Item{"touch-hair",
                     QT_TRANSLATE_NOOP("ToolOptions", "On the hair that is seen, whatever lies below (T)")},
};
inline constexpr ToolOption kTouchOption{
    .key = "touch",
    .kind =
        ToolChoice{.entries = kTouchKinds,
                   .read = [](const ToolSettings& settings) { return static_cast<int>(settings.touch); },
                   .write = [](ToolSettings& settings, int index) { settings.touch = static_cast<TouchKind>(index); }}};
inline constexpr ToolNumber kFlatness{.field = &ToolSettings::flatness, .standard = 90.0};
inline constexpr const char* kFlatnessLabel = QT_TRANSLATE_NOOP("ToolOptions", "Flatness");
inline constexpr const char* kFlatnessHint =
    QT_TRANSLATE_NOOP("ToolOptions", "How flat combed hair lies; pen pressure makes it less");

} // namespace hairpaint::model
