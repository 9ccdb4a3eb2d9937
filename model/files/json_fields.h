// One description of an object's keys serves reading and writing: a function template visits each field with a
// FieldReader or a FieldWriter, and so the ranges are stated once.
// Rules of hairpaint_format.md: an absent key leaves the value, a wrong type is a problem, a number outside its range
// moves to the nearest end.
#pragma once

#include <QColor>
#include <QJsonArray>
#include <QJsonObject>
#include <QString>

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <utility>

namespace hairpaint::model {

inline constexpr int kLongestName = 200;

/// A float as the shortest decimal number that reads back as the same float.
[[nodiscard]] double shortestDouble(float value);

template<typename Enum>
using Choice = std::pair<const char*, Enum>;

/// The first problem met, as a clause for a sentence of sentences.h.
class FieldReader
{
public:
    FieldReader(const QJsonObject& object, QString& problem) : m_object(object), m_problem(problem) {}

    void number(const char* key, float& value, float least, float greatest);
    void integer(const char* key, int& value, int least, int greatest);
    void boolean(const char* key, bool& value);
    void text(const char* key, QString& value);
    void colour(const char* key, QRgb& value); ///< "#rrggbb", opaque.
    /// `values.size()` numbers in an array.
    void numbers(const char* key, std::span<float> values, float least, float greatest);
    template<typename Enum, std::size_t N>
    void choice(const char* key, Enum& value, const std::array<Choice<Enum>, N>& choices)
    {
        QString id;
        text(key, id);
        if (!m_object.contains(QLatin1String(key)))
            return;
        for (const auto& [name, meaning] : choices)
            if (id == QLatin1String(name)) {
                value = meaning;
                return;
            }
        complain(key);
    }
    template<typename Visit>
    void object(const char* key, const Visit& visit)
    {
        FieldReader inner(child(key), m_problem);
        visit(inner);
    }
    [[nodiscard]] bool contains(const char* key) const { return m_object.contains(QLatin1String(key)); }
    void complain(const char* key);

private:
    QJsonObject child(const char* key);

    QJsonObject m_object;
    QString& m_problem;
};

/// Writes what a reader will give back: numbers are moved into their range, names cut to kLongestName.
class FieldWriter
{
public:
    void number(const char* key, float value, float least, float greatest);
    void integer(const char* key, int value, int least, int greatest);
    void boolean(const char* key, bool value);
    void text(const char* key, const QString& value);
    void colour(const char* key, QRgb value);
    void numbers(const char* key, std::span<const float> values, float least, float greatest);
    template<typename Enum, std::size_t N>
    void choice(const char* key, Enum value, const std::array<Choice<Enum>, N>& choices)
    {
        for (const auto& [name, meaning] : choices)
            if (value == meaning)
                text(key, QString::fromLatin1(name));
    }
    template<typename Visit>
    void object(const char* key, const Visit& visit)
    {
        FieldWriter inner;
        visit(inner);
        m_object.insert(QLatin1String(key), inner.take());
    }
    [[nodiscard]] QJsonObject take() { return std::move(m_object); }

private:
    QJsonObject m_object;
};

/// A vector's components, for `numbers`.
template<typename Vector>
[[nodiscard]] auto components(Vector& vector)
{
    return std::span(&vector[0], static_cast<std::size_t>(vector.length()));
}

} // namespace hairpaint::model
