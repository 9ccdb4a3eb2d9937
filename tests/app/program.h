// The program run as a user's script runs it, and what it writes read back.
#pragma once

#include "tests/support/locations.h"
#include "tests/support/process_memory.h"

#include <QByteArray>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QString>
#include <QtEndian>

#include <glm/glm.hpp>

#include <algorithm>
#include <cstring>
#include <functional>
#include <vector>

namespace hairpaint::test {

struct Outcome
{
    int code = -1;
    QString output;
    QString error;
    double seconds = 0.0;
    qint64 peakBytes = 0; ///< In memory at once, helpers included; looked at every few milliseconds.
};

/// Runs the program without a display, or with X11's `display`. `inChild` is called in the child before the program
/// starts. `language`: of the system, "es_ES".
inline Outcome runProgram(const QStringList& arguments, [[maybe_unused]] const std::function<void()>& inChild = {},
                          const char* language = "C", const char* display = nullptr)
{
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char* name :
         {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM", "LANG", "LC_ALL", "LC_MESSAGES", "LANGUAGE"})
        environment.remove(QString::fromLatin1(name));
    environment.insert(QStringLiteral("LANG"), QLatin1StringView(language) + QStringLiteral(".UTF-8"));
    if (display != nullptr)
        environment.insert(QStringLiteral("DISPLAY"), QString::fromLatin1(display));
    process.setProcessEnvironment(environment);
#ifdef Q_OS_UNIX
    if (inChild)
        process.setChildProcessModifier(inChild);
#endif
    process.start(test::hairpaintProgram(), arguments);
    QElapsedTimer clock;
    clock.start();
    qint64 peakBytes = 0;
    while (!process.waitForFinished(5)) {
        if (process.state() == QProcess::NotRunning || clock.elapsed() > 180'000)
            return {};
        peakBytes = std::max(peakBytes, residentBytes(process.processId()));
    }
    return {.code = process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1,
            .output = QString::fromUtf8(process.readAllStandardOutput()),
            .error = QString::fromUtf8(process.readAllStandardError()),
            .seconds = static_cast<double>(clock.nsecsElapsed()) * 1e-9,
            .peakBytes = peakBytes};
}

#if defined(HAIRPAINT_ASAN)
inline constexpr double kMostSeconds = 60.0;        // All is several times slower.
inline constexpr qint64 kMostBytes = 6'000'000'000; // Shadow memory and quarantine.
#else
inline constexpr double kMostSeconds = 20.0;
inline constexpr qint64 kMostBytes = 2'000'000'000;
#endif

/// What a verb that must fail did wrong; empty where it failed as it should: one line names the file, the code is 1,
/// nothing new lies in `folder`, and it took neither long nor much.
inline QString faultOf(const QString& folder, const QStringList& arguments, const QString& named,
                       const std::function<void()>& inChild = {})
{
    const QStringList before = QDir(folder).entryList(QDir::AllEntries | QDir::Hidden | QDir::System);
    const Outcome outcome = runProgram(arguments, inChild);
    const QString said = QStringLiteral("%1: code %2, %3 s, %4 MB, '%5'")
                             .arg(arguments.join(QLatin1Char(' ')))
                             .arg(outcome.code)
                             .arg(outcome.seconds)
                             .arg(outcome.peakBytes / 1'000'000)
                             .arg(outcome.error);
    const QString shown = QDir::toNativeSeparators(named);
    const bool wellSaid = outcome.error.count(QLatin1Char('\n')) == 1 && outcome.error.endsWith(QLatin1Char('\n')) &&
                          outcome.error.contains(shown) && outcome.error.count(shown) <= 2 && outcome.output.isEmpty();
    const bool wellBehaved = outcome.code == 1 && outcome.seconds < kMostSeconds && outcome.peakBytes < kMostBytes &&
                             QDir(folder).entryList(QDir::AllEntries | QDir::Hidden | QDir::System) == before;
    return wellSaid && wellBehaved ? QString() : said;
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
