// A button that shows a colour and, where it has one, its name or number under it.
#pragma once

#include <QAbstractButton>

namespace hairpaint::view {

/// Checked ones carry a ring and a tick, so that the choice does not rest on colour alone.
class Swatch : public QAbstractButton
{
    Q_OBJECT
public:
    explicit Swatch(const QColor& colour, const QString& name, QWidget* parent = nullptr);
    void setColour(const QColor& colour);
    [[nodiscard]] QColor colour() const { return m_colour; }
    void setCaption(const QString& caption); ///< Small text under the colour; none by default.
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QColor m_colour;
    QString m_caption;
};

} // namespace hairpaint::view
