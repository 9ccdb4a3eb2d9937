// Ranges and sentences of the values of options.
#include "app/cli/option_values.h"

#include "app/cli/command.h"
#include "model/project/project.h"

#include <cmath>

namespace hairpaint::app {

std::optional<double> numberOption(const QCommandLineParser& parser, const char* command, const QString& option)
{
    const auto [least, greatest, standard] = *optionOf(command, option).number;
    if (!parser.isSet(option))
        return standard;
    bool isNumber = false;
    const double value = parser.value(option).toDouble(&isNumber);
    if (isNumber && value >= least && value <= greatest)
        return value;
    (void)wrongUsage(command, CommandLine::tr("--%1 takes a number from %2 to %3, not '%4'")
                                  .arg(option)
                                  .arg(least)
                                  .arg(greatest, 0, 'g', 10)
                                  .arg(parser.value(option)));
    return std::nullopt;
}

std::optional<std::int64_t> countOption(const QCommandLineParser& parser, const char* command, const QString& option,
                                        std::int64_t fallback, std::int64_t most)
{
    if (!parser.isSet(option))
        return fallback;
    bool isNumber = false;
    const std::int64_t value = parser.value(option).toLongLong(&isNumber);
    if (isNumber && value >= 1 && value <= most)
        return value;
    (void)wrongUsage(command, CommandLine::tr("--%1 takes a whole number from 1 to %2, not '%3'")
                                  .arg(option)
                                  .arg(most)
                                  .arg(parser.value(option)));
    return std::nullopt;
}

std::optional<std::optional<glm::vec3>> windOption(const QCommandLineParser& parser, const char* command)
{
    constexpr float kStrongest = 30.0F;
    const QString option = QStringLiteral("wind");
    if (!parser.isSet(option))
        return std::optional<glm::vec3>();
    const QStringList parts = parser.value(option).split(QLatin1Char(','));
    glm::vec3 velocity(0.0F);
    bool good = parts.size() == 3;
    for (int i = 0; good && i < 3; ++i) {
        velocity[i] = parts[i].toFloat(&good);
        good = good && std::abs(velocity[i]) <= kStrongest;
    }
    if (good)
        return velocity;
    (void)wrongUsage(command, CommandLine::tr("--wind takes X,Y,Z in m/s, each from -30 to 30"));
    return std::nullopt;
}

std::optional<std::optional<sim::NeckMotion>> motionOption(const QCommandLineParser& parser, const char* command)
{
    const QString option = QStringLiteral("motion");
    if (!parser.isSet(option))
        return std::optional<sim::NeckMotion>();
    const QString name = parser.value(option);
    if (const std::optional<sim::NeckMotion> motion = sim::neckMotionNamed(name.toStdString()))
        return motion;
    (void)wrongUsage(command, CommandLine::tr("--motion takes nod, shake or turn, not '%1'").arg(name));
    return std::nullopt;
}

std::optional<std::optional<std::size_t>> hairsOption(const QCommandLineParser& parser, const char* command)
{
    const QString option = QStringLiteral("hairs");
    if (!parser.isSet(option))
        return std::optional<std::size_t>();
    const std::optional<std::int64_t> count = countOption(parser, command, option, 1, model::kMostHairs);
    if (!count)
        return std::nullopt;
    return static_cast<std::size_t>(*count);
}

} // namespace hairpaint::app
