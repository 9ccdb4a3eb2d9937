// A copied part of a map as bytes in the system's clipboard: another window takes it with its position, size, 16 bits
// and map.
#pragma once

#include "model/tools/selecting/clipboard.h"

#include <QByteArray>

#include <optional>

namespace hairpaint::app {

inline constexpr const char* kClipFormat = "application/x-hairpaint-clip";

/// Empty where the clip is, or where it is too large to be handed round.
[[nodiscard]] QByteArray bytesFromClip(const model::Clip& clip);
/// None where they are broken, or of another version of the program.
[[nodiscard]] std::optional<model::Clip> clipFromBytes(const QByteArray& bytes);

} // namespace hairpaint::app
