// The pictures of the 3D area: who draws them, when, and whether they are being made finer.
#pragma once

#include "sim/motion/strand_frame.h"
#include "view/head_area/frame_pacer.h"
#include "view/head_area/frame_presenter.h"
#include "view/head_area/stillness.h"

#include <QImage>
#include <QObject>
#include <QRect>
#include <QWidget>

#include <memory>

namespace hairpaint::view {

class HeadScene;

/// Draws a scene into a child of a widget: fast while something moves, ever finer while all is still. GUI thread.
class HeadFrames : public QObject
{
    Q_OBJECT
public:
    /// Both outlive it; it is a child of the area.
    HeadFrames(HeadScene& scene, QWidget& area, PresenterChoice choice);
    ~HeadFrames() override;

    /// Puts it into the scene, unless nobody would see the difference.
    void setHair(std::shared_ptr<const sim::StrandFrame> frame);

    void wake() { m_pacer.wake(); }               ///< What is shown changes: draws fast until it is still again.
    void requestDraw() { m_pacer.requestDraw(); } ///< Soon.
    void setGeometry(const QRect& rect) { m_presenter->widget().setGeometry(rect); }

    /// One picture at full quality, waited for.
    [[nodiscard]] QImage grab(const rendering::Scene& scene, QSize size) { return m_presenter->grab(scene, size); }
    /// What draws, for people; empty until the first frame.
    [[nodiscard]] QString description() const { return m_presenter->description(); }
    /// Whether more is to be drawn without anybody's doing.
    [[nodiscard]] bool awake() const { return !m_presenter->resting() || m_pacer.waiting(); }
    [[nodiscard]] bool refining() const { return m_refining; }
    /// Whether what is shown stays as it is for a moment.
    [[nodiscard]] bool still() const { return m_pacer.still(); }

Q_SIGNALS:
    /// As FramePresenter::shows and FramePresenter::frameDrawn.
    void shows(const hairpaint::view::Sight& sight);
    void frameDrawn(const hairpaint::rendering::FrameStatistics& statistics);
    void finenessChanged();                    ///< Refining began or ended, or something moves again.
    void presenterChanged();                   ///< Its widget is another one.
    void glUnavailable(const QString& reason); ///< The graphics card can't draw; our own renderer goes on.

private:
    void makePresenter(PresenterChoice choice);
    void onFailed(const QString& reason);
    [[nodiscard]] bool mayRefine() const;
    void draw();

    HeadScene& m_scene;
    QWidget& m_area;
    FramePresenter* m_presenter = nullptr; ///< A child of the area.
    FramePacer m_pacer;
    Stillness m_stillness;
    bool m_refining = false;
};

} // namespace hairpaint::view
