// USD text character by character.
#include "model/importing/usd_scanner.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace hairpaint::model {

namespace {

bool isBlank(char c)
{
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

bool isOfWord(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == ':' ||
           c == '.';
}

/// Of a nested value: brackets, texts, names of files and prims, comments.
bool opensOrCloses(char c)
{
    static constexpr auto kSuch = [] {
        std::array<bool, 256> such{};
        for (const unsigned char each : {'[', ']', '(', ')', '{', '}', '"', '\'', '@', '<', '#'})
            such[each] = true;
        return such;
    }();
    return kSuch[static_cast<unsigned char>(c)];
}

} // namespace

void UsdScanner::skipBlanks()
{
    while (m_at < m_text.size()) {
        if (isBlank(m_text[m_at]))
            ++m_at;
        else if (m_text[m_at] == '#')
            m_at = std::min(m_text.find('\n', m_at), m_text.size());
        else
            return;
    }
}

bool UsdScanner::atEnd()
{
    skipBlanks();
    return m_at == m_text.size();
}

char UsdScanner::peek()
{
    return m_broken || atEnd() ? '\0' : m_text[m_at];
}

bool UsdScanner::accept(char wanted)
{
    if (peek() != wanted)
        return false;
    ++m_at;
    return true;
}

void UsdScanner::expect(char wanted)
{
    if (!accept(wanted))
        m_broken = true;
}

std::string_view UsdScanner::word()
{
    if (peek() == '\0')
        return {};
    const std::size_t begin = m_at;
    while (m_at < m_text.size() && isOfWord(m_text[m_at]))
        ++m_at;
    if (m_at > begin && rest().starts_with("[]"))
        m_at += 2;
    return m_text.substr(begin, m_at - begin);
}

void UsdScanner::skipUntil(std::string_view end)
{
    const std::size_t found = m_text.find(end, m_at);
    if (found == std::string_view::npos)
        m_broken = true;
    else
        m_at = found + end.size();
}

void UsdScanner::skipQuoted()
{
    const char quote = m_text[m_at];
    const std::string_view three = rest().substr(0, 3);
    if (three.size() == 3 && three[1] == quote && three[2] == quote) {
        m_at += 3;
        skipUntil(three);
        return;
    }
    for (++m_at; m_at < m_text.size() && m_text[m_at] != '\n'; ++m_at) {
        if (m_text[m_at] == '\\') {
            ++m_at;
        } else if (m_text[m_at] == quote) {
            ++m_at;
            return;
        }
    }
    m_at = std::min(m_at, m_text.size());
    m_broken = true;
}

std::string_view UsdScanner::quoted()
{
    if (const char next = peek(); next != '"' && next != '\'') {
        m_broken = true;
        return {};
    }
    const std::size_t begin = m_at;
    skipQuoted();
    if (m_broken)
        return {};
    const std::string_view whole = m_text.substr(begin, m_at - begin);
    const std::size_t marks = whole.size() >= 6 && whole[1] == whole[0] && whole[2] == whole[0] ? 3 : 1;
    return whole.substr(marks, whole.size() - 2 * marks);
}

std::string_view UsdScanner::asset()
{
    if (peek() != '@') {
        m_broken = true;
        return {};
    }
    const std::string_view mark = rest().starts_with("@@@") ? "@@@" : "@";
    m_at += mark.size();
    const std::size_t begin = m_at;
    skipUntil(mark);
    return m_broken ? std::string_view() : m_text.substr(begin, m_at - mark.size() - begin);
}

std::string_view UsdScanner::path()
{
    expect('<');
    const std::size_t begin = m_at;
    skipUntil(">");
    return m_broken ? std::string_view() : m_text.substr(begin, m_at - 1 - begin);
}

std::optional<double> UsdScanner::number()
{
    if (peek() == '\0')
        return std::nullopt;
    if (m_text[m_at] == '+')
        ++m_at;
    double value = 0.0;
    const char* const begin = m_text.data() + m_at;
    const auto [end, problem] = std::from_chars(begin, m_text.data() + m_text.size(), value);
    if (problem != std::errc() && problem != std::errc::result_out_of_range) {
        m_broken = true;
        return std::nullopt;
    }
    m_at += static_cast<std::size_t>(end - begin);
    return value;
}

void UsdScanner::skipValue()
{
    int depth = 0;
    do {
        const char next = peek();
        switch (next) {
        case '\0':
            m_broken = true;
            return;
        case '[':
        case '(':
        case '{':
            ++m_at;
            ++depth;
            break;
        case ']':
        case ')':
        case '}':
            ++m_at;
            --depth;
            break;
        case '"':
        case '\'':
            skipQuoted();
            break;
        case '@': {
            const bool isTriple = rest().starts_with("@@@");
            m_at += isTriple ? 3 : 1;
            skipUntil(isTriple ? "@@@" : "@");
            if (depth == 0 && peek() == '<') // The prim in that file.
                skipUntil(">");
            break;
        }
        case '<':
            skipUntil(">");
            break;
        default:
            if (depth > 0) { // Arrays are long: passed over at once.
                while (m_at < m_text.size() && !opensOrCloses(m_text[m_at]))
                    ++m_at;
            } else if (const auto isPlain = [](char c) { return isOfWord(c) || c == '-' || c == '+'; }; isPlain(next)) {
                while (m_at < m_text.size() && isPlain(m_text[m_at]))
                    ++m_at;
            } else {
                m_broken = true;
            }
        }
    } while (depth > 0 && !m_broken);
    if (depth < 0)
        m_broken = true;
}

} // namespace hairpaint::model
