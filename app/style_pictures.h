// Pictures of styles that have none, drawn in the background and kept in the style's own file.
#pragma once

#include "model/preset.h"

#include <QImage>
#include <QObject>
#include <QThreadPool>

#include <atomic>
#include <functional>

namespace hairpaint::app {

class PictureMaker;

/// The style as it hangs on the built-in head after two calm seconds. Null where `cancelled` says so between two steps.
[[nodiscard]] QImage stylePicture(const model::Preset& preset, PictureMaker& maker,
                                  const std::function<bool()>& cancelled = {});

/// One style at a time on a thread of its own. Where there is no OpenGL, or the file can't be read, nothing comes;
/// where it can't be written, the picture comes all the same. The destructor waits for the step under way.
class StylePictures : public QObject
{
    Q_OBJECT
public:
    explicit StylePictures(QObject* parent = nullptr);
    ~StylePictures() override;

    void make(const QString& path);

Q_SIGNALS:
    void made(const QString& path, const QImage& picture);

private:
    void work(const QString& path);

    std::atomic<bool> m_stop = false;
    QThreadPool m_threads;
};

} // namespace hairpaint::app
