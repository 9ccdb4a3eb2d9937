// Reads colours from text, such as the clipboard's.
#pragma once

#include <QColor>
#include <QString>

#include <optional>

namespace hairpaint::view {

/// "#1a2b3c", "1A2B3C", "#abc", "0x1a2b3c", "rgb(26, 43, 60)", "rgb(10% 17% 24%)"; an alpha after them ("#1a2b3cff",
/// "rgba(...)") is left out. None where it is no colour.
[[nodiscard]] std::optional<QColor> colourFromText(const QString& text);

} // namespace hairpaint::view
