// Reads what people type into a field for a number: "0,5", "4mm", "3 in", "5' 2\"", "1.5+2", "10 cm - 5 mm", "1 1/2
// in".
#pragma once

#include <QString>

#include <tl/expected.hpp>

namespace hairpaint::view {

/// A field that a number is typed into.
struct NumberField
{
    QString unit = {};  ///< As it is shown: "cm", "\u00b0", "%", "hairs/cm\u00b2"; empty for a plain number.
    bool whole = false; ///< It takes whole numbers, so "4,096" and "4.096" are four thousand.
};

/// In the field's unit. Terms with a unit of the same kind are converted, terms without one are in the field's; terms
/// are added, subtracted, and multiplied or divided by plain numbers. Both point and comma are the decimal sign in
/// every language; where they can only part thousands they do. The error is a sentence.
[[nodiscard]] tl::expected<double, QString> readNumber(const QString& text, const NumberField& field);

} // namespace hairpaint::view
