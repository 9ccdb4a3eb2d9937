// OpenEXR files: pictures in linear light, as compositing programs take them.
#pragma once

#include <QByteArray>
#include <QSize>

#include <span>

namespace hairpaint::app {

/// A file of one part: scan lines of 32-bit floats, ZIP-compressed. `rgba`: [height][width][4], row 0 on top, colours
/// multiplied by alpha, as the format requires. Throws std::bad_alloc.
[[nodiscard]] QByteArray exrBytes(std::span<const float> rgba, QSize size);

} // namespace hairpaint::app
