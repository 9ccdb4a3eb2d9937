// A fuzzer's bytes, read as choices, numbers and pieces; and files made of them.
#pragma once

#include <QByteArray>
#include <QFile>
#include <QString>
#include <QTemporaryDir>
#include <QtEndian>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>

namespace hairpaint::fuzz {

/// Past its end everything is zero and empty.
class Input
{
public:
    Input(const std::uint8_t* data, std::size_t size)
        : m_bytes(reinterpret_cast<const char*>(data), static_cast<qsizetype>(size))
    {}

    [[nodiscard]] int byte() { return static_cast<std::uint8_t>(take(1).append('\0').front()); }
    template<typename Number>
    [[nodiscard]] Number number()
    {
        QByteArray bytes = take(sizeof(Number));
        bytes.append(static_cast<qsizetype>(sizeof(Number)) - bytes.size(), '\0');
        Number value{};
        std::memcpy(&value, bytes.constData(), sizeof(Number));
        return value;
    }
    [[nodiscard]] QByteArray take(qsizetype count)
    {
        const qsizetype there = std::min(count, m_bytes.size() - m_at);
        m_at += there;
        return m_bytes.sliced(m_at - there, there);
    }
    /// With its length, two bytes, before it.
    [[nodiscard]] QByteArray piece() { return take(number<std::uint16_t>()); }
    [[nodiscard]] QByteArray rest() { return take(m_bytes.size()); }
    [[nodiscard]] bool atEnd() const { return m_at >= m_bytes.size(); }

private:
    QByteArray m_bytes;
    qsizetype m_at = 0;
};

/// What Input reads as a piece.
inline QByteArray pieceOf(const QByteArray& bytes)
{
    const auto length = static_cast<std::uint16_t>(bytes.size());
    return QByteArray(reinterpret_cast<const char*>(&length), sizeof(length)) + bytes;
}

/// A file that lives as long as the program.
inline QString scratchPath(const QString& name)
{
    static const QTemporaryDir folder;
    return folder.filePath(name);
}

inline QString scratchFile(const QString& name, const QByteArray& bytes)
{
    QFile file(scratchPath(name));
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
        std::abort();
    return file.fileName();
}

/// A finding: what must hold did not.
inline void require(bool holds)
{
    if (!holds)
        std::abort();
}

} // namespace hairpaint::fuzz

/// What a fuzzer calls, and the replay of its findings.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
