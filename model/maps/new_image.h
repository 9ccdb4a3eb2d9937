// Images that hold their memory.
#pragma once

#include <QImage>

#include <new>

namespace hairpaint::model {

/// Not filled. Throws std::bad_alloc where QImage would give a null image, which can't be written to. Any thread.
[[nodiscard]] inline QImage newImage(int width, int height, QImage::Format format)
{
    QImage image(width, height, format);
    if (image.isNull())
        throw std::bad_alloc();
    return image;
}

} // namespace hairpaint::model
