// Numbers, names and times of a film's frames.
#include "app/cli/film.h"

#include "app/cli/command.h"
#include "sim/solver/solver_layout.h"

#include <QFileInfo>
#include <QRegularExpression>

#include <cmath>

namespace hairpaint::app {

tl::expected<Film, QString> framesOption(const QCommandLineParser& parser)
{
    Film film;
    if (!parser.isSet(QStringLiteral("frames")))
        return film;
    const QString frames = parser.value(QStringLiteral("frames"));
    const auto match = QRegularExpression(QStringLiteral("^(\\d{1,4})-(\\d{1,4})$")).match(frames);
    film.first = match.captured(1).toInt();
    film.last = match.captured(2).toInt();
    if (!match.hasMatch() || film.last < film.first)
        return tl::unexpected(
            CommandLine::tr("--frames takes A-B with B not below A, up to 9999, not '%1'").arg(frames));
    return film;
}

QString framePath(const QString& output, int number)
{
    const QFileInfo info(output);
    return info.path() + QLatin1Char('/') + info.completeBaseName() +
           QStringLiteral(".%1.%2").arg(number, 4, 10, QLatin1Char('0')).arg(info.suffix());
}

double secondsBefore(int number, double framesPerSecond)
{
    const auto stepsAt = [framesPerSecond](int frame) {
        return std::floor(frame / (framesPerSecond * sim::kStepSeconds) + 0.5);
    };
    return number > 0 ? (stepsAt(number) - stepsAt(number - 1)) * sim::kStepSeconds : 0.0;
}

} // namespace hairpaint::app
