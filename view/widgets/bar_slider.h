// A number as a filled bar: label left, value and unit right.
#pragma once

#include <QList>
#include <QPointer>
#include <QTimer>
#include <QWidget>

#include <optional>

namespace hairpaint::view {

class NumberEdit;

/// 24 px high. Drag sets, Ctrl makes it ten times finer, double-click or Enter types (see number_text.h), right-click
/// resets, arrows and (only while it has the focus) the wheel step. Esc while dragging or typing takes the change back.
///
/// One change by the user: editingBegan, any number of valueChanged, then exactly one of editingFinished (the value
/// differs from before) or editingCancelled (it does not: whoever took values puts back what was there at
/// editingBegan). setValue tells nothing; while the user is changing the value it is shown when that is over.
class BarSlider : public QWidget
{
    Q_OBJECT
    Q_PROPERTY(double value READ value WRITE setValue NOTIFY valueChanged USER true)
public:
    explicit BarSlider(const QString& label, QWidget* parent = nullptr);

    [[nodiscard]] double value() const { return m_value; }
    void setValue(double value);
    [[nodiscard]] double minimum() const { return m_minimum; }
    [[nodiscard]] double maximum() const { return m_maximum; }
    /// In the unit shown; values are rounded to `decimals`.
    void setRange(double minimum, double maximum, int decimals = 0);
    void setUnit(const QString& unit); ///< "cm"; shown after a thin space.
    /// The bar is `fraction^exponent` of the range: 2 to 4 give small values more room.
    void setExponent(double exponent);
    void setDefaultValue(double value); ///< What right-click resets to.
    void setLabel(const QString& label);
    void setPreferredWidth(int width); ///< Of the size hint; the least width is what label and value need.
    void setHint(const QString& hint); ///< What the value does; in the tooltip.
    [[nodiscard]] const QString& label() const { return m_label; }
    /// Fills the whole bar with a map's scale, from the smallest to the greatest value; empty for the plain fill.
    void setGradient(const QList<QColor>& colours);
    [[nodiscard]] bool editing() const { return m_editing; }
    /// Before it stands for something else: a change by the user is done, and what is being typed is dropped.
    void release();
    [[nodiscard]] QString valueText() const;

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

Q_SIGNALS:
    void editingBegan();
    void valueChanged(double value); ///< While the user changes it.
    void editingFinished(double value);
    void editingCancelled();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool event(QEvent* event) override;

private:
    /// A key that is the first of a number.
    [[nodiscard]] bool startsTyping(const QKeyEvent& event) const;
    void begin();
    void moveTo(double value);
    void finish();
    void cancel();
    void stepBy(double steps);
    void openEditor();
    void take(double typed);
    void closeEditor(const QString& problem);
    [[nodiscard]] QString numberText(double value) const; ///< With the unit.
    [[nodiscard]] double fractionOf(double value) const;
    [[nodiscard]] double valueAt(double fraction) const;
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
    bool m_reachedByKey = false; ///< Whatever has the focus now, the last time it came by mouse or key.
    int m_decimals = 0;
    QList<QColor> m_gradient;
    bool m_editing = false;
    bool m_dragging = false;
    bool m_moved = false;
    double m_before = 0.0;
    std::optional<double> m_told; ///< By setValue while the user was changing it.
    double m_dragFraction = 0.0;
    double m_lastX = 0.0;
    double m_pressX = 0.0;
    int m_wheelRest = 0;
    QTimer m_settle; ///< After a click or a notch of the wheel, until the change counts as done.
    QPointer<NumberEdit> m_editor;
};

} // namespace hairpaint::view
