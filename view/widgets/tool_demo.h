// A small moving picture of what a tool does to hair, for those tools that words do not explain.
#pragma once

#include "model/tools/demo_strokes.h"

#include <QVariantAnimation>
#include <QWidget>

namespace hairpaint::view {

/// Plays again and again while it is shown. GUI thread.
class ToolDemo : public QWidget
{
    Q_OBJECT
public:
    explicit ToolDemo(QWidget* parent = nullptr);

    /// `stroke` outlives the widget.
    void setStroke(const model::DemoStroke& stroke);
    [[nodiscard]] QSize sizeHint() const override { return {240, 72}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    const model::DemoStroke* m_stroke = nullptr;
    QVariantAnimation m_play{this}; ///< 0 to 1: the stroke, and a rest at its end.
};

} // namespace hairpaint::view
