// Reading and writing single JSON fields.
#include "model/files/json_fields.h"

#include <QCoreApplication>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace hairpaint::model {

namespace {

/// NaN becomes the range's nearest value to zero.
float inRange(float value, float least, float greatest)
{
    if (std::isnan(value))
        value = 0.0F;
    return std::clamp(value, least, greatest);
}

float inRange(double value, float least, float greatest)
{
    return inRange(static_cast<float>(std::clamp(value, -1e30, 1e30)), least, greatest);
}

} // namespace

double shortestDouble(float value)
{
    std::array<char, 32> text{};
    const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
    bool ok = false;
    const double wide = QByteArray(text.data(), end - text.data()).toDouble(&ok);
    return error == std::errc() && ok && static_cast<float>(wide) == value ? wide : static_cast<double>(value);
}

void FieldReader::complain(const char* key)
{
    if (m_problem.isEmpty())
        m_problem = QCoreApplication::translate("Files", "'%1' in project.json is not what it should be")
                        .arg(QLatin1String(key));
}

void FieldReader::number(const char* key, float& value, float least, float greatest)
{
    const QJsonValue found = m_object.value(QLatin1String(key));
    if (found.isDouble())
        value = inRange(found.toDouble(), least, greatest);
    else if (!found.isUndefined())
        complain(key);
}

void FieldReader::integer(const char* key, int& value, int least, int greatest)
{
    const QJsonValue found = m_object.value(QLatin1String(key));
    if (found.isUndefined())
        return;
    const double number = found.toDouble(std::nan(""));
    if (!found.isDouble() || number != std::floor(number))
        return complain(key);
    value = static_cast<int>(std::clamp(number, static_cast<double>(least), static_cast<double>(greatest)));
}

void FieldReader::boolean(const char* key, bool& value)
{
    const QJsonValue found = m_object.value(QLatin1String(key));
    if (found.isBool())
        value = found.toBool();
    else if (!found.isUndefined())
        complain(key);
}

void FieldReader::text(const char* key, QString& value)
{
    const QJsonValue found = m_object.value(QLatin1String(key));
    if (found.isUndefined())
        return;
    const QString string = found.toString();
    if (!found.isString() || string.size() > kLongestName || string.contains(QChar::Null))
        return complain(key);
    value = string;
}

void FieldReader::colour(const char* key, QRgb& value)
{
    constexpr qsizetype kLength = 7;
    QString text;
    this->text(key, text);
    if (!contains(key))
        return;
    const QColor colour(text);
    if (text.size() != kLength || !text.startsWith(QLatin1Char('#')) || !colour.isValid())
        return complain(key);
    value = colour.rgb();
}

void FieldReader::numbers(const char* key, std::span<float> values, float least, float greatest)
{
    const QJsonValue found = m_object.value(QLatin1String(key));
    if (found.isUndefined())
        return;
    const QJsonArray array = found.toArray();
    if (!found.isArray() || array.size() != static_cast<qsizetype>(values.size()))
        return complain(key);
    for (qsizetype i = 0; i < array.size(); ++i) {
        if (!array.at(i).isDouble())
            return complain(key);
        values[static_cast<std::size_t>(i)] = inRange(array.at(i).toDouble(), least, greatest);
    }
}

QJsonObject FieldReader::child(const char* key)
{
    const QJsonValue found = m_object.value(QLatin1String(key));
    if (!found.isUndefined() && !found.isObject())
        complain(key);
    return found.toObject();
}

void FieldWriter::number(const char* key, float value, float least, float greatest)
{
    m_object.insert(QLatin1String(key), shortestDouble(inRange(value, least, greatest)));
}

void FieldWriter::integer(const char* key, int value, int least, int greatest)
{
    m_object.insert(QLatin1String(key), std::clamp(value, least, greatest));
}

void FieldWriter::boolean(const char* key, bool value)
{
    m_object.insert(QLatin1String(key), value);
}

void FieldWriter::text(const char* key, const QString& value)
{
    QString kept = value.left(kLongestName);
    kept.remove(QChar::Null);
    m_object.insert(QLatin1String(key), kept);
}

void FieldWriter::colour(const char* key, QRgb value)
{
    text(key, QColor(value).name(QColor::HexRgb));
}

void FieldWriter::numbers(const char* key, std::span<const float> values, float least, float greatest)
{
    QJsonArray array;
    for (const float value : values)
        array.append(shortestDouble(inRange(value, least, greatest)));
    m_object.insert(QLatin1String(key), array);
}

} // namespace hairpaint::model
