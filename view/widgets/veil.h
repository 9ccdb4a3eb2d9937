// Lies over an area whose picture is not up to date yet, and says what is awaited.
#pragma once

#include <QWidget>

namespace hairpaint::view {

/// Fills its parent while it is shown; what is under it stays faintly to be seen. The mouse goes through it.
class Veil : public QWidget
{
    Q_OBJECT
public:
    static constexpr float kUsualDensity = 0.8F;

    /// `density`: 0 hides nothing of what is below, 1 all of it.
    explicit Veil(QWidget* parent, float density = kUsualDensity);
    void showText(const QString& text); ///< Empty: it goes.
    [[nodiscard]] const QString& text() const { return m_text; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    float m_density;
    QString m_text;
};

} // namespace hairpaint::view
