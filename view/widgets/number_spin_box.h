// A spin box for whole numbers that reads what the other fields read.
#pragma once

#include <QSpinBox>

#include <tl/expected.hpp>

namespace hairpaint::view {

/// Sums, thousands, the unit or none: readNumber. What can't be read is told at the box, and the value stays. GUI
/// thread.
class NumberSpinBox : public QSpinBox
{
    Q_OBJECT
public:
    /// `unit`: as it is shown behind the number.
    explicit NumberSpinBox(const QString& unit, QWidget* parent = nullptr);

protected:
    QValidator::State validate(QString& input, int& position) const override;
    [[nodiscard]] int valueFromText(const QString& text) const override;
    void fixup(QString& input) const override;

private:
    [[nodiscard]] tl::expected<double, QString> read(QString text) const;

    QString m_unit;
};

} // namespace hairpaint::view
