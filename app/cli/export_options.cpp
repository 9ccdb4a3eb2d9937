// The format by the name's ending and the options that ask for it, then the values of its rows.
#include "app/cli/export_options.h"

#include "app/cli/verb_options.h"
#include "model/formats/export_format.h"

#include <algorithm>

namespace hairpaint::app {

namespace {

QStringList wordsOf(std::span<const int> values)
{
    QStringList words;
    for (const int value : values)
        words += QString::number(value);
    return words;
}

/// "--atlas 1024|2048|4096".
QString spellingOf(const model::ExportOption& option)
{
    QString spelling = QStringLiteral("--") + QLatin1StringView(option.flag);
    if (const auto* choice = std::get_if<model::ExportChoice>(&option.kind))
        spelling += QLatin1Char(' ') + wordsOf(choice->values).join(QLatin1Char('|'));
    else if (*option.operand != '\0')
        spelling += QLatin1Char(' ') + QLatin1StringView(option.operand);
    return spelling;
}

/// Its range and default are those of its row.
QString meaningOf(const model::ExportOption& option)
{
    QString meaning = CommandLine::tr(option.help);
    const model::ExportRequest standard;
    if (const auto* number = std::get_if<model::ExportNumber>(&option.kind))
        meaning.replace(QLatin1String("%1"), QString::number(number->least))
            .replace(QLatin1String("%2"), QString::number(number->greatest, 'g', 10))
            .replace(QLatin1String("%3"), QString::number(number->read(standard)));
    else if (const auto* choice = std::get_if<model::ExportChoice>(&option.kind))
        meaning.replace(QLatin1String("%1"), listOf(wordsOf(choice->values)))
            .replace(QLatin1String("%3"), QString::number(standard.cards.*choice->field));
    return meaning;
}

bool isSet(const QCommandLineParser& parser, const char* flag)
{
    return *flag != '\0' && parser.isSet(QLatin1StringView(flag));
}

/// Whether two formats have one ending.
bool sharesEnding(const model::ExportFormat& format)
{
    return std::ranges::count_if(model::exportFormats(), [&format](const model::ExportFormat& other) {
               return QLatin1StringView(other.suffix) == QLatin1StringView(format.suffix);
           }) > 1;
}

/// ".glb with --cards", ".vrm": how a format is asked for.
QString askingFor(const model::ExportFormat& format)
{
    const QString ending = QLatin1Char('.') + QLatin1StringView(format.suffix);
    return *format.flag != '\0' && sharesEnding(format)
               ? CommandLine::tr("%1 with --%2").arg(ending, QLatin1StringView(format.flag))
               : ending;
}

/// What is wrong with an option that the format has not, and which have.
template<class Test>
QString notFor(const QString& flag, const model::ExportFormat& format, Test has)
{
    QStringList others;
    for (const model::ExportFormat& other : model::exportFormats())
        if (has(other))
            others += askingFor(other);
    return CommandLine::tr("--%1 is not for %2, but for %3")
        .arg(flag, format.titleText(), others.join(QLatin1String(", ")));
}

/// The one that the ending and the flags ask for; the problem in words.
tl::expected<const model::ExportFormat*, QString> formatOf(const QCommandLineParser& parser, const QString& output)
{
    const model::ExportFormat* format = model::findExportFormat(output);
    for (const model::ExportFormat& other : model::exportFormats()) {
        if (!isSet(parser, other.flag))
            continue;
        if (model::findExportFormat(output, &other) == &other)
            format = &other;
    }
    if (format == nullptr)
        return tl::unexpected(CommandLine::tr("-o takes a name that ends in %1")
                                  .arg(QLatin1Char('.') + model::exportSuffixes().join(QLatin1String(", ."))));
    for (const model::ExportFormat& other : model::exportFormats())
        if (isSet(parser, other.flag) && QLatin1StringView(other.flag) != QLatin1StringView(format->flag))
            return tl::unexpected(CommandLine::tr("With --%1 -o takes a name that ends in .%2")
                                      .arg(QLatin1StringView(other.flag), QLatin1StringView(other.suffix)));
    return format;
}

/// Puts what is given into the request; the problem in words.
std::optional<QString> readOption(const model::ExportOption& option, const QString& given,
                                  model::ExportRequest& request)
{
    const QLatin1StringView flag(option.flag);
    if (const auto* number = std::get_if<model::ExportNumber>(&option.kind)) {
        bool isNumber = false;
        const double value = number->decimals > 0 ? given.toDouble(&isNumber) : given.toInt(&isNumber);
        if (!isNumber || !(value >= number->least && value <= number->greatest))
            return CommandLine::tr("--%1 takes a number from %2 to %3, not '%4'")
                .arg(flag)
                .arg(number->least)
                .arg(number->greatest, 0, 'g', 10)
                .arg(given);
        number->write(request, value);
    } else if (const auto* choice = std::get_if<model::ExportChoice>(&option.kind)) {
        const QStringList values = wordsOf(choice->values);
        if (!values.contains(given))
            return CommandLine::tr("--%1 takes %2, not '%3'").arg(flag, values.join(QLatin1String(", ")), given);
        request.cards.*choice->field = given.toInt();
    } else if (const auto* one = std::get_if<model::ExportSwitch>(&option.kind)) {
        request.cards.*one->field = true;
    } else if (const auto* text = std::get_if<model::ExportText>(&option.kind)) {
        request.*text->field = given;
    }
    return std::nullopt;
}

} // namespace

std::vector<CommandOption> formatOptions()
{
    std::vector<CommandOption> rows;
    const auto add = [&rows](const QString& spelling, const QString& meaning) {
        if (std::ranges::find(rows, spelling, &CommandOption::spelling) == rows.end())
            rows.push_back({spelling, meaning});
    };
    for (const model::ExportFormat& format : model::exportFormats()) {
        if (*format.flag != '\0')
            add(QStringLiteral("--") + QLatin1StringView(format.flag), CommandLine::tr(format.flagHelp));
        for (const model::ExportOption* option : format.options)
            add(spellingOf(*option), meaningOf(*option));
    }
    return rows;
}

tl::expected<model::ExportRequest, QString> readRequest(const QCommandLineParser& parser, const QString& output)
{
    model::ExportRequest request{.format = &model::exportFormats().front(), .target = &model::exportTargets().front()};
    if (parser.isSet(QStringLiteral("o"))) {
        const tl::expected<const model::ExportFormat*, QString> format = formatOf(parser, output);
        if (!format)
            return tl::unexpected(format.error());
        request.format = *format;
    }
    if (parser.isSet(QStringLiteral("frames")) && !request.format->hasFilms)
        return tl::unexpected(notFor(QStringLiteral("frames"), *request.format,
                                     [](const model::ExportFormat& format) { return format.hasFilms; }));
    for (const model::ExportOption* option : model::exportOptionRows()) {
        if (!isSet(parser, option->flag))
            continue;
        if (!request.format->takes(*option))
            return tl::unexpected(
                notFor(QLatin1StringView(option->flag), *request.format,
                       [option](const model::ExportFormat& format) { return format.takes(*option); }));
        if (const auto problem = readOption(*option, parser.value(QLatin1StringView(option->flag)), request); problem)
            return tl::unexpected(*problem);
    }
    if (parser.isSet(QStringLiteral("target"))) {
        const QString id = parser.value(QStringLiteral("target"));
        request.target = model::findExportTarget(id);
        if (request.target == nullptr) {
            QStringList ids;
            for (const model::ExportTarget& target : model::exportTargets())
                ids += QString::fromLatin1(target.id);
            return tl::unexpected(
                CommandLine::tr("--target takes %1, not '%2'").arg(ids.join(QLatin1String(", ")), id));
        }
    }
    return request;
}

} // namespace hairpaint::app
