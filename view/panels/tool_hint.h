// The card that explains a tool in words and, if there is one, with an animation.
#pragma once

#include "view/widgets/tool_demo.h"

#include <QFrame>
#include <QHash>

class QLabel;
class QToolButton;

namespace hairpaint::view {

/// Instead of the tooltips of the buttons it watches, whose text it shows. GUI thread.
class ToolHint : public QFrame
{
    Q_OBJECT
public:
    explicit ToolHint(QWidget* parent);
    /// `demo` is shown below the words; null where words are enough. It outlives this.
    void watch(QToolButton& button, const model::DemoStroke* demo);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void showFor(const QToolButton& button);

    QLabel* m_words;
    ToolDemo* m_demo;
    QHash<const QObject*, const model::DemoStroke*> m_demos; ///< By the button that they explain.
};

} // namespace hairpaint::view
