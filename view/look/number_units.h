// The units that people type behind numbers, and normalised spellings of both.
#pragma once

#include <QString>

namespace hairpaint::view {

struct NumberUnit
{
    enum class Dimension
    {
        Length,
        Angle,
        Speed,
        PerArea
    };
    Dimension dimension;
    /// Parted by bars; the first one is what a field is told to take. To be translated in context "NumberText"; those
    /// of the source are known in every language, beside the translated ones.
    const char* names;
    double factor; ///< To SI.
};

/// Normalises digits of any script, minus signs, primes, spaces and squares to one character each; in lower
/// case.
[[nodiscard]] QString plainNumberText(QString text);
/// By a plain name. Null for what is none of these.
[[nodiscard]] const NumberUnit* findNumberUnit(const QString& plainName);
/// "cm, mm, m, in, ft", the field's own first. `own`: the row of that, if there is one.
[[nodiscard]] QString usableUnits(const QString& unit, const NumberUnit* own);

} // namespace hairpaint::view
