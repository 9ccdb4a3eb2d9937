// A number shown as a filled bar: label left, value and unit right.
#pragma once

#include <QList>
#include <QTimer>
#include <QWidget>

#include <optional>

namespace hairpaint::view {

/// The value without the hands that change it (BarSlider). 24 px high.
///
/// One change by the user: editingBegan, any number of valueChanged, then exactly one of editingFinished (the value
/// differs from before) or editingCancelled (it does not: whoever took values puts back what was there at
/// editingBegan). setValue tells nothing; while the user is changing the value it is shown when that is over.
class BarValue : public QWidget
{
    Q_OBJECT
    Q_PROPERTY(double value READ value WRITE setValue NOTIFY valueChanged USER true)
public:
    [[nodiscard]] double value() const { return m_value; }
    void setValue(double value);
    [[nodiscard]] double minimum() const { return m_minimum; }
    [[nodiscard]] double maximum() const { return m_maximum; }
    /// The range in the unit shown; values are rounded to `decimals`.
    void setRange(double minimum, double maximum, int decimals = 0);
    void setUnit(const QString& unit); ///< "cm"; shown after a thin space.
    /// The bar is `fraction^exponent` of the range: 2 to 4 give small values more room.
    void setExponent(double exponent);
    void setDefaultValue(double value); ///< What right-click resets to.
    void setLabel(const QString& label);
    void setPreferredWidth(int width); ///< Width of the size hint; the least width is what label and value need.
    void setHint(const QString& hint); ///< What the value does; in the tooltip.
    [[nodiscard]] const QString& label() const { return m_label; }
    /// Fills the whole bar with a map's scale, from the smallest to the greatest value; empty for the plain fill.
    void setGradient(const QList<QColor>& colours);
    [[nodiscard]] bool editing() const { return m_editing; }
    [[nodiscard]] QString valueText() const;

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

Q_SIGNALS:
    void editingBegan();
    void valueChanged(double value); ///< While the user changes it.
    void editingFinished(double value);
    void editingCancelled();

protected:
    explicit BarValue(const QString& label, QWidget* parent);

    void begin();
    void moveTo(double value);
    void finish();
    void cancel();
    void stepBy(double steps);
    /// Finishes after that time unless the user does more before.
    void finishIn(int milliseconds) { m_settle.start(milliseconds); }
    [[nodiscard]] bool finishesSoon() const { return m_settle.isActive(); }
    [[nodiscard]] const QString& unit() const { return m_unit; }
    [[nodiscard]] int decimals() const { return m_decimals; }
    /// What right-click resets to; none where there is no default.
    [[nodiscard]] std::optional<double> defaultValue() const
    {
        return m_hasDefault ? std::optional(m_default) : std::nullopt;
    }
    [[nodiscard]] QString numberText(double value) const; ///< With the unit.
    [[nodiscard]] double fractionOf(double value) const;
    [[nodiscard]] double valueAt(double fraction) const;

    void paintEvent(QPaintEvent* event) override;
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    [[nodiscard]] double rounded(double value) const;
    void describe();

    QString m_label;
    QString m_hint;
    int m_preferredWidth = 0;
    QString m_unit;
    double m_minimum = 0.0;
    double m_maximum = 1.0;
    double m_value = 0.0;
    double m_exponent = 1.0;
    double m_default = 0.0;
    bool m_hasDefault = false;
    int m_decimals = 0;
    QList<QColor> m_gradient;
    bool m_editing = false;
    double m_before = 0.0;
    std::optional<double> m_told; ///< Value that setValue() was given while the user was changing it.
    QTimer m_settle;              ///< After a click or a notch of the wheel, until the change counts as done.
};

} // namespace hairpaint::view
