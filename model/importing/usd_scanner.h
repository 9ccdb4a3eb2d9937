// The words, numbers and nested values of USD text.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace hairpaint::model {

/// Over a text that must outlive it. Where something else stands than is asked for, it is broken from there on: every
/// question is answered with no. Blanks and comments are passed over.
class UsdScanner
{
public:
    explicit UsdScanner(std::string_view text) : m_text(text) {}

    [[nodiscard]] bool isBroken() const { return m_broken; }
    void setBroken() { m_broken = true; }
    [[nodiscard]] bool atEnd();
    [[nodiscard]] std::size_t position() const { return m_at; }

    /// The next character; '\0' at the end.
    [[nodiscard]] char peek();
    /// Passes over it where it is next.
    bool accept(char wanted);
    void expect(char wanted);
    /// A name with namespaces and a type's [] ("point3f[]", "xformOp:translate"); empty where none is next.
    [[nodiscard]] std::string_view word();
    /// What stands between quotes, as it is written.
    [[nodiscard]] std::string_view quoted();
    /// What stands between @, of a file; and between < and >, of a prim.
    [[nodiscard]] std::string_view asset();
    [[nodiscard]] std::string_view path();
    [[nodiscard]] std::optional<double> number();
    /// All numbers of a value, however they are bracketed; stops where `goesOn`, asked now and then, is false. False
    /// where it was stopped, or there are more than `most`.
    template<typename GoesOn>
    bool numbers(std::vector<float>& values, std::size_t most, const GoesOn& goesOn);
    /// Passes over a value of any kind.
    void skipValue();

private:
    void skipBlanks();
    void skipQuoted();
    void skipUntil(std::string_view end);
    [[nodiscard]] std::string_view rest() const { return m_text.substr(m_at); }

    std::string_view m_text;
    std::size_t m_at = 0;
    bool m_broken = false;
};

template<typename GoesOn>
bool UsdScanner::numbers(std::vector<float>& values, std::size_t most, const GoesOn& goesOn)
{
    constexpr std::size_t kBetween = std::size_t{1} << 16U; ///< Questions whether it goes on.
    int depth = 0;
    do {
        const char next = peek();
        if (next == '[' || next == '(') {
            ++m_at;
            ++depth;
        } else if (next == ']' || next == ')') {
            ++m_at;
            --depth;
        } else if (next == ',') {
            ++m_at;
        } else {
            const std::optional<double> value = number();
            if (!value || values.size() == most) {
                m_broken = true;
                return false;
            }
            values.push_back(static_cast<float>(*value));
            if (values.size() % kBetween == 0 && !goesOn())
                return false;
        }
    } while (depth > 0 && !m_broken);
    if (depth < 0)
        m_broken = true;
    return !m_broken;
}

} // namespace hairpaint::model
