// A titled part of a panel that folds.
#pragma once

#include <QWidget>

class QToolButton;
class QVBoxLayout;

namespace hairpaint::view {

class Section : public QWidget
{
    Q_OBJECT
public:
    explicit Section(const QString& title, QWidget* parent = nullptr);
    [[nodiscard]] QVBoxLayout& body() const { return *m_layout; }
    void setOpen(bool open);

private:
    QToolButton* m_title;
    QWidget* m_body;
    QVBoxLayout* m_layout;
    bool m_open = true;
};

} // namespace hairpaint::view
