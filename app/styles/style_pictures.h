// Pictures of styles that have none, drawn in the background and kept in a cache of the program's own.
#pragma once

#include "app/background/jobs.h"
#include "model/styles/preset.h"
#include "sim/motion/strand_frame.h"
#include "view/rendering/scene.h"

#include <QImage>
#include <QObject>
#include <QStringList>

#include <functional>
#include <memory>

namespace hairpaint::app {

class PictureMaker;

/// The style as it hangs on the head of new projects after two calm seconds, from ahead or, where all its ties are
/// hidden there, from behind. Null where `progress` stops it.
[[nodiscard]] QImage stylePicture(const model::Preset& preset, PictureMaker& maker,
                                  const model::Progress& progress = {});
/// The style on that project's head, seen by a camera, likewise after two calm seconds. Any thread.
[[nodiscard]] QImage stylePictureFrom(const model::Preset& preset, model::Project project,
                                      const rendering::Camera& camera, const model::Progress& progress = {});
/// A project's hair at a moment, framed alike; null where nothing can be drawn.
[[nodiscard]] QImage stylePicture(const model::Project& project, std::shared_ptr<const sim::StrandFrame> frame,
                                  PictureMaker& maker, const model::Progress& progress = {});
/// The same of a project that nobody works on. Any thread.
[[nodiscard]] QImage projectPicture(const model::Project& project, const model::Progress& progress = {});

/// One style after the other. The styles' own files are only read: a picture is kept under what the file holds, so that
/// another style of that name never gets it. Where memory runs out, or the file can't be read or changes meanwhile,
/// nothing comes; where the cache can't be written, the picture comes all the same.
class StylePictures : public QObject
{
    Q_OBJECT
public:
    using Draw = std::function<QImage(const model::Preset& preset, const model::Progress& progress)>;

    /// `draw` runs on another thread; null: as stylePicture() does.
    explicit StylePictures(Jobs& jobs, Draw draw = {}, QObject* parent = nullptr);

    void make(const QString& path);
    /// The library has changed: pending requests are dropped.
    void forget();
    /// Whether no request is pending.
    [[nodiscard]] bool idle() const { return !m_busy && m_wanted.isEmpty(); }

Q_SIGNALS:
    void made(const QString& path, const QImage& picture);

private:
    void next();

    Jobs& m_jobs;
    Draw m_draw;
    QStringList m_wanted;
    bool m_busy = false;
    bool m_forgotten = false; ///< The picture being drawn is not wanted any more.
};

} // namespace hairpaint::app
