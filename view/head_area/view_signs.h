// Small signs over the 3D area of what state the picture is in.
#pragma once

#include <QWidget>

namespace hairpaint::view {

/// "Paused" while the simulation is, "Refining" with a dot while a still picture is made finer, how many triangles the
/// cards have that are shown. Lets every pointer event through; hidden while it has nothing to say.
class ViewSigns : public QWidget
{
    Q_OBJECT
public:
    explicit ViewSigns(QWidget* parent);
    /// `triangles`: 0 where no cards are shown.
    void show(bool paused, bool refining, std::size_t triangles);
    /// What is shown, "Paused · Refining"; empty where nothing is.
    [[nodiscard]] const QString& text() const { return m_text; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QString m_text;
    bool m_paused = false;
};

} // namespace hairpaint::view
