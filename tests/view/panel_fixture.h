// A small project without a head, and the mouse as panels see it.
#pragma once

#include "view/editing/editor_state.h"
#include "view/widgets/bar_slider.h"

#include <QApplication>
#include <QMouseEvent>
#include <QTest>

namespace hairpaint::view {

/// Groups "Scalp" and "Beard", one empty layer a map.
inline model::Project smallProject()
{
    model::Project project;
    project.groups.push_back(model::makeGroup(project, QStringLiteral("Scalp"), 256));
    project.groups.push_back(model::makeGroup(project, QStringLiteral("Beard"), 256));
    project.wind.velocity = {3.0F, 0.0F, 4.0F};
    return project;
}

struct PanelFixture
{
    model::Document document{smallProject()};
    EditorState state{document};
    [[nodiscard]] int steps() { return document.undoStack().count(); }
    [[nodiscard]] const model::HairGroup& scalp() const { return document.project().groups.front(); }
};

/// Moves with the left button held; QTest::mouseMove sends none.
inline void dragTo(QWidget& widget, QPoint position)
{
    QMouseEvent move(QEvent::MouseMove, position, widget.mapToGlobal(position), Qt::NoButton, Qt::LeftButton,
                     QGuiApplication::keyboardModifiers());
    QApplication::sendEvent(&widget, &move);
}

/// Drags a slider to this fraction of its width, without letting go.
inline void holdAt(BarSlider& slider, double fraction)
{
    const int middle = slider.height() / 2;
    QTest::mousePress(&slider, Qt::LeftButton, Qt::NoModifier, QPoint(slider.width() / 2, middle));
    dragTo(slider, QPoint(qRound(slider.width() * fraction), middle));
}

inline void letGo(QWidget& widget, QPoint position = {})
{
    QTest::mouseRelease(&widget, Qt::LeftButton, Qt::NoModifier, position);
}

inline BarSlider* sliderNamed(const QWidget& parent, const QString& label)
{
    for (BarSlider* slider : parent.findChildren<BarSlider*>())
        if (slider->label() == label)
            return slider;
    return nullptr;
}

} // namespace hairpaint::view
