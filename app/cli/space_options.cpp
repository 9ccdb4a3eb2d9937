// Units, axes and directions by name.
#include "app/cli/space_options.h"

#include "app/cli/command.h"

#include <QCommandLineParser>

#include <algorithm>
#include <array>
#include <utility>

namespace hairpaint::app {

namespace {

/// False where the option's word is none of a unit; 0 metres where it is not given.
bool readUnit(const QCommandLineParser& parser, const char* command, const QString& option, float& metres)
{
    constexpr std::array<std::pair<const char*, float>, 5> kUnits{
        {{"m", 1.0F}, {"dm", 0.1F}, {"cm", 0.01F}, {"mm", 0.001F}, {"in", 0.0254F}}};
    const QString unit = parser.value(option);
    if (unit.isEmpty())
        return true;
    const auto* const known =
        std::ranges::find_if(kUnits, [&unit](const auto& one) { return unit == QLatin1StringView(one.first); });
    if (known == kUnits.end()) {
        (void)wrongUsage(command, CommandLine::tr("--%1 takes m, dm, cm, mm or in, not '%2'").arg(option, unit));
        return false;
    }
    metres = known->second;
    return true;
}

/// False where the option's word is none of an axis; nothing is read where it is not given.
bool readAxis(const QCommandLineParser& parser, const char* command, const QString& option,
              std::optional<model::UpAxis>& upAxis)
{
    const QString axis = parser.value(option);
    if (axis.isEmpty())
        return true;
    if (axis != QLatin1String("y") && axis != QLatin1String("z")) {
        (void)wrongUsage(command, CommandLine::tr("--%1 takes y or z, not '%2'").arg(option, axis));
        return false;
    }
    upAxis = axis == QLatin1String("y") ? model::UpAxis::Y : model::UpAxis::Z;
    return true;
}

bool readFacing(const QCommandLineParser& parser, const char* command, std::optional<glm::ivec3>& facing)
{
    const QString kOption = QStringLiteral("head-facing");
    const QString direction = parser.value(kOption);
    if (direction.isEmpty())
        return true;
    const bool isBack = direction.startsWith(QLatin1Char('-'));
    const QString axis = isBack || direction.startsWith(QLatin1Char('+')) ? direction.sliced(1) : direction;
    const auto index = axis.size() == 1 ? QStringLiteral("xyz").indexOf(axis) : -1;
    if (index < 0) {
        (void)wrongUsage(command,
                         CommandLine::tr("--%1 takes x, -x, y, -y, z or -z, not '%2'").arg(kOption, direction));
        return false;
    }
    facing = glm::ivec3(0);
    (*facing)[static_cast<int>(index)] = isBack ? -1 : 1;
    return true;
}

} // namespace

std::optional<model::CurveSpaceChoice> curveSpaceOptions(const QCommandLineParser& parser, const char* command)
{
    model::CurveSpaceChoice choice;
    float metres = 0.0F;
    if (!readUnit(parser, command, QStringLiteral("curves-unit"), metres) ||
        !readAxis(parser, command, QStringLiteral("curves-axis"), choice.upAxis))
        return std::nullopt;
    if (metres > 0.0F)
        choice.metresPerUnit = metres;
    return choice;
}

std::optional<model::HeadChoice> headSpaceOptions(const QCommandLineParser& parser, const char* command)
{
    model::HeadChoice choice;
    float metres = 0.0F;
    if (!readUnit(parser, command, QStringLiteral("head-unit"), metres) ||
        !readAxis(parser, command, QStringLiteral("head-axis"), choice.upAxis) ||
        !readFacing(parser, command, choice.facing))
        return std::nullopt;
    if (metres > 0.0F)
        choice.metresPerUnit = metres;
    const auto names = [&parser](const QString& option) {
        const QStringList given = parser.values(option);
        return std::vector<QString>(given.begin(), given.end());
    };
    choice.comingIn = names(QStringLiteral("head-part"));
    choice.growing = names(QStringLiteral("grow-on"));
    choice.ownLayout = parser.isSet(QStringLiteral("own-layout"));
    return choice;
}

} // namespace hairpaint::app
