// What lies over the areas while a file is dragged over the window: a frame, and what letting go will do.
#pragma once

#include <QWidget>

namespace hairpaint::view {

/// Fills its parent while it is shown; mouse and drag go through it.
class DropHint : public QWidget
{
    Q_OBJECT
public:
    explicit DropHint(QWidget* parent);
    void showText(const QString& text);
    [[nodiscard]] const QString& text() const { return m_text; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QString m_text;
};

} // namespace hairpaint::view
