// The program run as a user's script runs it, and what it writes read back.
#pragma once

#include <QByteArray>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QString>
#include <QtEndian>

#include <glm/glm.hpp>

#include <cstring>
#include <functional>
#include <vector>

namespace hairpaint::test {

struct Outcome
{
    int code = -1;
    QString output;
    QString error;
};

/// Runs the program without a display. `inChild` is called in the child before the program starts.
inline Outcome runProgram(const QStringList& arguments, const std::function<void()>& inChild = {})
{
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.remove(QStringLiteral("DISPLAY"));
    environment.remove(QStringLiteral("QT_QPA_PLATFORM"));
    process.setProcessEnvironment(environment);
#ifdef Q_OS_UNIX
    if (inChild)
        process.setChildProcessModifier(inChild);
#endif
    process.start(QStringLiteral(HAIRPAINT_PROGRAM), arguments);
    if (!process.waitForFinished(180'000))
        return {};
    return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1,
            QString::fromUtf8(process.readAllStandardOutput()), QString::fromUtf8(process.readAllStandardError())};
}

inline QByteArray contentOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

inline QJsonObject infoOf(const QString& project)
{
    const Outcome outcome = runProgram({QStringLiteral("info"), project, QStringLiteral("--json")});
    return QJsonDocument::fromJson(outcome.output.toUtf8()).object();
}

/// The strands of a `.hair` file, root first.
inline std::vector<std::vector<glm::vec3>> readHair(const QString& path)
{
    const QByteArray bytes = contentOf(path);
    std::vector<std::vector<glm::vec3>> strands;
    if (bytes.size() < 128 || !bytes.startsWith("HAIR"))
        return strands;
    strands.resize(qFromLittleEndian<quint32>(bytes.constData() + 4));
    const char* segments = bytes.constData() + 128;
    const char* points = segments + strands.size() * sizeof(quint16);
    for (std::vector<glm::vec3>& strand : strands) {
        strand.resize(std::size_t{qFromLittleEndian<quint16>(segments)} + 1);
        const std::size_t count = strand.size() * sizeof(glm::vec3);
        if (points + count > bytes.constData() + bytes.size())
            return {};
        std::memcpy(strand.data(), points, count);
        segments += sizeof(quint16);
        points += count;
    }
    return strands;
}

/// Sum of a strand's segments, m.
inline double lengthOf(const std::vector<glm::vec3>& strand)
{
    double length = 0.0;
    for (std::size_t i = 1; i < strand.size(); ++i)
        length += glm::length(glm::dvec3(strand[i]) - glm::dvec3(strand[i - 1]));
    return length;
}

} // namespace hairpaint::test
