// A reader by descent: sum, term, number, unit.
#include "view/look/number_text.h"

#include "view/look/number_units.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <cmath>
#include <optional>

namespace hairpaint::view {

namespace {

struct NumberTexts
{
    Q_DECLARE_TR_FUNCTIONS(NumberText)
};

/// Digits with their separators as a number; none where these can mean neither decimals nor thousands.
std::optional<double> numberOf(QString digits, bool whole)
{
    static const QRegularExpression grouped(
        QStringLiteral(R"(^(\d{1,3}(?: \d{3})+(?:[.,]\d*)?|\d{1,3}(?:,\d{3})+\.\d*|\d{1,3}(?:\.\d{3})+,\d*|)"
                       R"(\d{1,3}(?:,\d{3}){2,}|\d{1,3}(?:\.\d{3}){2,}))"
                       "$"));
    static const QRegularExpression thousands(QStringLiteral(R"(^[1-9]\d{0,2}[.,]\d{3}$)"));
    const auto count = digits.count(QLatin1Char('.')) + digits.count(QLatin1Char(','));
    if (grouped.match(digits).hasMatch() || (whole && thousands.match(digits).hasMatch())) {
        const bool mixed = digits.contains(QLatin1Char(' ')) ||
                           (digits.contains(QLatin1Char('.')) && digits.contains(QLatin1Char(',')));
        const qsizetype last = digits.lastIndexOf(QRegularExpression(QStringLiteral("[.,]")));
        const QString fraction = mixed && last >= 0 ? digits.mid(last + 1) : QString();
        QString leading = mixed && last >= 0 ? digits.left(last) : digits;
        leading.remove(QRegularExpression(QStringLiteral("[ .,]")));
        digits = leading + QLatin1Char('.') + fraction;
    } else if (count > 1 || digits.contains(QLatin1Char(' '))) {
        return std::nullopt;
    }
    bool fine = false;
    const double value = digits.replace(QLatin1Char(','), QLatin1Char('.')).toDouble(&fine);
    return fine ? std::optional(value) : std::nullopt;
}

class NumberReader
{
public:
    NumberReader(const QString& text, const NumberField& field)
        : m_field(field), m_asTyped(text.trimmed()), m_text(plainNumberText(text)),
          m_ownName(plainNumberText(field.unit)), m_own(findNumberUnit(m_ownName))
    {}

    tl::expected<double, QString> read()
    {
        if (m_text.isEmpty())
            return tl::unexpected(NumberTexts::tr("There is no number."));
        double sum = 0.0;
        double sign = readSigns();
        const NumberUnit* before = nullptr;
        while (true) {
            const NumberUnit* unit = nullptr;
            const std::optional<double> term = readTerm(unit);
            if (!term)
                return tl::unexpected(problem());
            // "5 ft 2 in": what follows a unit without a sign has a smaller one.
            if (before != nullptr && (unit == nullptr || unit->factor >= before->factor))
                return tl::unexpected(problem());
            sum += sign * *term;
            skipSpaces();
            if (m_at == m_text.size())
                break;
            before = isOneOf("+-") ? nullptr : unit;
            if (isOneOf("+-"))
                sign = readSigns();
            else if (before == nullptr)
                return tl::unexpected(problem());
        }
        if (!std::isfinite(sum))
            return tl::unexpected(NumberTexts::tr("“%1” is too large a number; type a smaller one.").arg(m_asTyped));
        return sum;
    }

private:
    void skipSpaces()
    {
        while (m_at < m_text.size() && m_text[m_at] == QLatin1Char(' '))
            ++m_at;
    }
    [[nodiscard]] bool isOneOf(const char* signs) const
    {
        return m_at < m_text.size() && QLatin1StringView(signs).contains(m_text[m_at]);
    }
    double readSigns()
    {
        double sign = 1.0;
        for (skipSpaces(); isOneOf("+-"); skipSpaces())
            sign *= m_text[m_at++] == QLatin1Char('-') ? -1.0 : 1.0;
        return sign;
    }
    QString take(const QRegularExpression& pattern)
    {
        const QRegularExpressionMatch found =
            pattern.match(m_text, m_at, QRegularExpression::NormalMatch, QRegularExpression::AnchorAtOffsetMatchOption);
        if (!found.hasMatch())
            return {};
        m_at = found.capturedEnd();
        return found.captured();
    }

    std::optional<double> readDigits()
    {
        static const QRegularExpression digits(
            QStringLiteral(R"((?:\d[\d.,]*|[.,]\d+)(?: \d{3}(?![\d/]))*(?:[.,]\d+)?)"));
        static const QRegularExpression exponent(QStringLiteral(R"(e[+-]?\d+)"));
        skipSpaces();
        const QString run = take(digits);
        if (run.isEmpty())
            return std::nullopt;
        const std::optional<double> value = numberOf(run, m_field.whole);
        const QString power = take(exponent);
        return value && !power.isEmpty() ? *value * std::pow(10.0, power.mid(1).toDouble()) : value;
    }

    /// A number, or a whole one and a fraction: "1 1/2".
    std::optional<double> readValue()
    {
        static const QRegularExpression mixed(QStringLiteral(R"((\d+) (\d+) ?/ ?([1-9]\d*))"));
        skipSpaces();
        const QRegularExpressionMatch found =
            mixed.match(m_text, m_at, QRegularExpression::NormalMatch, QRegularExpression::AnchorAtOffsetMatchOption);
        if (!found.hasMatch())
            return readDigits();
        m_at = found.capturedEnd();
        return found.captured(1).toDouble() + found.captured(2).toDouble() / found.captured(3).toDouble();
    }

    /// Times and divided by plain numbers, as long as they follow.
    bool readFactors(double& value)
    {
        static const QRegularExpression factor(QStringLiteral(R"( ?([*/]) ?(?=[\d.,]))"));
        for (QString sign = take(factor).trimmed(); !sign.isEmpty(); sign = take(factor).trimmed()) {
            const std::optional<double> by = readDigits();
            if (!by)
                return false;
            if (sign == QLatin1String("/") && *by == 0.0) {
                m_problem = NumberTexts::tr("Nothing can be divided by 0.");
                return false;
            }
            value = sign == QLatin1String("/") ? value / *by : value * *by;
        }
        return true;
    }

    /// In the field's unit. `unit`: the one that stands there, where it is of the table.
    std::optional<double> readTerm(const NumberUnit*& unit)
    {
        std::optional<double> value = readValue();
        if (!value || !readFactors(*value) || !readUnit(*value, unit) || !readFactors(*value))
            return std::nullopt;
        return value;
    }

    bool readUnit(double& value, const NumberUnit*& unit)
    {
        static const QRegularExpression name(QStringLiteral(R"(''|["'°%]|\p{L}*/ ?\p{L}+2?|\p{L}+)"));
        skipSpaces();
        if (takeOwn()) {
            unit = m_own;
            return true;
        }
        const QString found = take(name).remove(QLatin1Char(' '));
        if (found.isEmpty())
            return true; // The field's.
        unit = findNumberUnit(found);
        if (unit != nullptr && m_own != nullptr && unit->dimension == m_own->dimension) {
            value *= unit->factor / m_own->factor;
            return true;
        }
        m_problem =
            m_ownName.isEmpty()
                ? NumberTexts::tr("“%1” means nothing here; type the number alone.").arg(found)
                : NumberTexts::tr("“%1” is no unit for this; use %2.").arg(found, usableUnits(m_field.unit, m_own));
        return false;
    }

    /// The field's own unit, or its first word: "turns" of "turns per 10 cm".
    bool takeOwn()
    {
        if (m_ownName.isEmpty())
            return false;
        for (const QString& name : {m_ownName, m_ownName.section(QLatin1Char(' '), 0, 0)}) {
            if (QStringView(m_text).mid(m_at).startsWith(name) &&
                (m_at + name.size() == m_text.size() || !name.back().isLetter() ||
                 !(m_text[m_at + name.size()].isLetter() || m_text[m_at + name.size()] == QLatin1Char('/')))) {
                m_at += name.size();
                return true;
            }
        }
        return false;
    }

    [[nodiscard]] QString problem() const
    {
        if (!m_problem.isEmpty())
            return m_problem;
        return NumberTexts::tr("“%1” is not a number; type one such as 12 or 0.5.").arg(m_asTyped);
    }

    const NumberField& m_field;
    QString m_asTyped;
    QString m_text;
    QString m_ownName;
    const NumberUnit* m_own;
    QString m_problem; ///< More exact than that it is no number.
    qsizetype m_at = 0;
};

} // namespace

tl::expected<double, QString> readNumber(const QString& text, const NumberField& field)
{
    return NumberReader(text, field).read();
}

} // namespace hairpaint::view
