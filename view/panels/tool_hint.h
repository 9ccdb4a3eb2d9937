// The card that explains a tool in words and, if there is one, with an animation.
#pragma once

#include "view/widgets/tool_demo.h"

#include <QFrame>

class QLabel;
class QToolButton;

namespace hairpaint::view {

/// Instead of the tooltips of the buttons it watches, whose text it shows. GUI thread.
class ToolHint : public QFrame
{
    Q_OBJECT
public:
    explicit ToolHint(QWidget* parent);
    void watch(QToolButton& button, model::ToolId tool);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void showFor(const QToolButton& button);

    QLabel* m_words;
    ToolDemo* m_demo;
};

} // namespace hairpaint::view
