// How drawn frames of the 3D area come to the screen.
#pragma once

#include "view/head_area/presenter_choice.h"
#include "view/head_area/shot.h"
#include "view/rendering/backend.h"

#include <QImage>
#include <QObject>
#include <QWidget>

namespace hairpaint::view {

/// Lives on the GUI thread and owns a renderer, wherever that lives.
class FramePresenter : public QObject
{
    Q_OBJECT
public:
    using QObject::QObject;

    /// A child of `area`, as its widget is.
    [[nodiscard]] static FramePresenter* make(PresenterChoice choice, QWidget* area);

    /// The widget that shows the frames; owned by its parent widget.
    [[nodiscard]] virtual QWidget& widget() = 0;
    /// Returns at once; a shot not drawn yet is replaced.
    virtual void present(const Shot& shot) = 0;
    /// No frame comes before another shot is presented, but those that refining() tells of.
    [[nodiscard]] virtual bool resting() const = 0;
    /// One picture at full quality, waited for. Null where drawing is impossible.
    [[nodiscard]] virtual QImage grab(const rendering::Scene& scene, QSize size) = 0;
    /// What draws, for people; empty where that is known with the first frame only.
    [[nodiscard]] virtual QString description() const = 0;

Q_SIGNALS:
    /// The picture that the next repaint of the widget shows is seen from there: what lies over it belongs there, too.
    void shows(const hairpaint::view::Sight& sight);
    void frameDrawn(const hairpaint::rendering::FrameStatistics& statistics);
    /// Whether a still picture is being made finer; false once it is as fine as a saved one or something moves.
    void refining(bool on);
    /// Drawing by this presenter is not possible any more: one sentence that says why.
    void failed(const QString& reason);
};

} // namespace hairpaint::view
