// Draws frames on a thread of its own and hands them back as images.
#pragma once

#include "sim/base/mailbox.h"
#include "view/head_area/shot.h"
#include "view/rendering/backend.h"

#include <QImage>
#include <QObject>

#include <memory>
#include <optional>

namespace hairpaint::view {

/// Needs no OpenGL. Methods are called on the GUI thread; the renderer and the governor live on the other.
/// Shots and finished frames wait in mailboxes: the latest wins on both sides. A shot that comes while a still picture
/// is refined ends that within a piece of its hair.
class RenderThread : public QObject
{
    Q_OBJECT
public:
    explicit RenderThread(QObject* parent = nullptr);
    ~RenderThread() override; ///< Waits for the frame being drawn, of a still picture for a piece of its hair.

    void draw(const Shot& shot, QSize size);
    /// Waits for it; null where memory runs out.
    [[nodiscard]] QImage grab(const rendering::Scene& scene, QSize size);

    struct Frame
    {
        QImage image;
        Sight sight;
        rendering::FrameStatistics statistics;
        bool refines = false; ///< A finer one follows unless something moves.
    };
    /// The newest frame since the last call.
    [[nodiscard]] std::optional<Frame> takeFrame();
    /// All that was asked for is drawn and taken.
    [[nodiscard]] bool resting() const;

Q_SIGNALS:
    // Emitted on the thread that draws.
    void frameReady();
    /// A piece of a still picture is drawn: 0 to 1 of its hair are.
    void pieceDrawn(double fraction);

private:
    class Worker;
    std::unique_ptr<Worker> m_worker;
};

} // namespace hairpaint::view
