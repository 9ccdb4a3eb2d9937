// The rows. What a table of the program lists is listed from that table.
#include "app/cli/verb_options.h"

#include "app/cli/export_options.h"
#include "app/cli/film.h"
#include "model/exporting/map_images.h"
#include "model/formats/export_format.h"
#include "model/importing/curve_reader.h"
#include "model/project/light_settings.h"
#include "model/project/skin_tone.h"
#include "view/rendering/standard_views.h"

namespace hairpaint::app {

namespace {

using Use = CommandOption::Use;

CommandOption projectOutput()
{
    return {QStringLiteral("-o, --output P.hairpaint"), CommandLine::tr("the project to write"), Use::Required};
}

CommandOption settleOption(double standard)
{
    CommandOption option{
        QStringLiteral("--settle SECONDS"),
        CommandLine::tr("how long the hair falls first; 0 is the shape it was given; %1 unless given").arg(standard)};
    option.number = {.least = 0.0, .greatest = 60.0, .standard = standard};
    return option;
}

CommandOption numberOfHairs()
{
    return {QStringLiteral("--hairs N"), CommandLine::tr("only so many of the hairs that are there, an even share")};
}

CommandOption windVelocity()
{
    return {QStringLiteral("--wind X,Y,Z"),
            CommandLine::tr("in m/s, instead of the project's; x to the head's left, y up, z forward")};
}

CommandOption frameRate()
{
    constexpr double kStandard = Film().framesPerSecond;
    CommandOption option{QStringLiteral("--fps F"),
                         CommandLine::tr("frames a second of a film; %1 unless given").arg(kStandard)};
    option.number = {.least = 1.0, .greatest = 240.0, .standard = kStandard};
    return option;
}

CommandOption headMotion(const QString& meaning)
{
    return {QStringLiteral("--motion nod|shake|turn"), meaning};
}

CommandOption withHair(CommandOption option)
{
    option.useWith = "o";
    return option;
}

CommandOption withMaps(CommandOption option)
{
    option.useWith = "maps";
    return option;
}

/// "FILE.hair|.usda|.usdz".
QString fileWith(const QStringList& endings)
{
    return QStringLiteral("FILE.") + endings.join(QLatin1String("|."));
}

/// The `id` of each row of a table.
template<class Rows>
QString idsOf(const Rows& rows)
{
    QStringList ids;
    for (const auto& row : rows)
        ids += QString::fromLatin1(row.id);
    return listOf(ids);
}

QString viewNames()
{
    QStringList names;
    for (const std::string_view name : rendering::standardViewNames())
        names += QString::fromLatin1(name.data(), static_cast<qsizetype>(name.size()));
    return listOf(names);
}

} // namespace

QString listOf(const QStringList& words)
{
    if (words.size() < 2)
        return words.join(QString());
    return CommandLine::tr("%1 or %2").arg(words.first(words.size() - 1).join(QLatin1String(", ")), words.back());
}

std::vector<CommandOption> newOptions()
{
    return {
        projectOutput(),
        {QStringLiteral("--head MESH"), CommandLine::tr("a mesh with uv coordinates instead of the built-in head")},
        {QStringLiteral("--head-unit UNIT"),
         CommandLine::tr(
             "of that mesh: m, dm, cm, mm or in; as it says, or as a head or a body is tall, unless given")},
        {QStringLiteral("--head-axis y|z"),
         CommandLine::tr("that points up in that mesh: y or z; as it says, or as it is tall, unless given")},
        {QStringLiteral("--head-facing AXIS"),
         CommandLine::tr("where the face of that mesh looks: x, -x, y, -y, z or -z; z, or -y where z points up, unless "
                         "given")},
        {QStringLiteral("--head-part NAME"),
         CommandLine::tr(
             "a part of that mesh, or its material, that comes in; all unless given; may be given again for "
             "more"),
         Use::Repeated},
        {QStringLiteral("--grow-on NAME"),
         CommandLine::tr("a part that hair grows on; that with the scalp unless given; may be given again for more"),
         Use::Repeated},
        {QStringLiteral("--own-layout"),
         CommandLine::tr("a uv layout made anew, in which no two points share a texel")},
        {QStringLiteral("--preset NAME"), CommandLine::tr("a style of the library")},
        {QStringLiteral("--curves ") + fileWith(model::curveFileEndings()),
         CommandLine::tr("hair of another program as hair groups: its density, length, direction, curl and "
                         "colours become maps; may be given again for more"),
         Use::Repeated},
        {QStringLiteral("--curves-unit UNIT"),
         CommandLine::tr("of those files: m, dm, cm, mm or in; as they say, or as it fits, unless given")},
        {QStringLiteral("--curves-axis y|z"),
         CommandLine::tr("that points up in those files: y or z; as they say, or as it fits, unless given")},
        {QStringLiteral("--map [GROUP/]KIND[:grey]=IMAGE"),
         CommandLine::tr("an image as a map: a grey one by its brightness, one in colours by the scale of the map; "
                         "with :grey by its brightness in any case; IMAGE.<UDIM>.png takes an image for each uv tile"),
         Use::Repeated},
        {QStringLiteral("--maps FOLDER"),
         CommandLine::tr("each image of it as the map that its name tells: Scalp-density.png, head_length.0001.exr")},
        {QStringLiteral("--seed N"), CommandLine::tr("another drawing of the roots; 1 unless given")},
        {QStringLiteral("--max-candidates N"),
         CommandLine::tr("limit on hair candidates, over the whole head (was: --max-hairs)"), Use::Optional,
         QStringLiteral("max-hairs")},
    };
}

std::vector<CommandOption> listingOptions()
{
    return {{QStringLiteral("--json"), CommandLine::tr("as JSON, for scripts")}};
}

std::vector<CommandOption> exportOptions()
{
    std::vector<CommandOption> options = {
        {QStringLiteral("-o, --output ") + fileWith(model::exportSuffixes()),
         CommandLine::tr(
             "the file to write: curves, USD, lines, ribbons as a mesh, or an avatar: cards on spring bones "
             "with the body of a head that came with a skeleton")},
        withHair(
            {QStringLiteral("--target NAME"),
             CommandLine::tr("whose unit and axes: %1; %2, in metres with y up, unless given")
                 .arg(idsOf(model::exportTargets().subspan(1)), QLatin1StringView(model::exportTargets().front().id))}),
        {QStringLiteral("--group NAME"), CommandLine::tr("only this hair group; may be given again for more"),
         Use::Repeated},
    };
    for (CommandOption& option : formatOptions())
        options.push_back(withHair(std::move(option)));
    const std::vector<CommandOption> others = {
        withHair(settleOption(0.0)),
        withHair(numberOfHairs()),
        withHair(windVelocity()),
        withHair(headMotion(CommandLine::tr("the head moves once after that, and the hair settles for 1 s more; of a "
                                            "film, from frame 0 on, again and again"))),
        withHair(
            {QStringLiteral("--frames A-B"), CommandLine::tr("hair in motion, a file a frame: FILE.0001.hair and on")}),
        withHair(frameRate()),
        {QStringLiteral("--maps FOLDER"), CommandLine::tr("writes every map as an image into that folder")},
        withMaps({QStringLiteral("--image ") + model::mapImageSuffixes().join(QLatin1Char('|')),
                  CommandLine::tr("of those images: %1; %2 unless given")
                      .arg(listOf(model::mapImageSuffixes()), model::mapImageSuffixes().front())}),
        withMaps(
            {QStringLiteral("--depth 8|16"), CommandLine::tr("8 or 16 a channel of png and tif; 16 unless given")}),
        withMaps({QStringLiteral("--grey"), CommandLine::tr("values as brightness instead of the scales' colours")}),
        withMaps({QStringLiteral("--udim"),
                  CommandLine::tr("an image for each uv tile of the head, in its own layout: Scalp-density.1001.png")}),
        {QStringLiteral("--uv-sheet FILE.pdf|.svg"),
         CommandLine::tr("writes the head's UV layout as a sheet to print and draw on")},
    };
    options.insert(options.end(), others.begin(), others.end());
    return options;
}

std::vector<CommandOption> renderOptions()
{
    return {
        {QStringLiteral("-o, --output FILE.png|.exr"),
         CommandLine::tr("the picture to write; as OpenEXR in linear light, alpha in its colours"), Use::Required},
        {QStringLiteral("--size WxH"), CommandLine::tr("in pixels; 1024x1024 unless given")},
        {QStringLiteral("--view NAME"), viewNames()},
        {QStringLiteral("--fit hair|head|bust"),
         CommandLine::tr("what fills the picture: hair (with the head), head or bust; hair unless given")},
        {QStringLiteral("--camera AZIMUTH,ELEVATION[,DISTANCE]"),
         CommandLine::tr("instead of a view: degrees from the face toward the head's left, and upward; the "
                         "distance in cm, else as --fit asks")},
        {QStringLiteral("--samples 1|4|16"),
         CommandLine::tr("1, 4 or 16 a pixel; 4 unless given, and 1 in pictures of more than 4096 pixels a side")},
        {QStringLiteral("--transparent"), CommandLine::tr("no background: alpha tells what is covered")},
        {QStringLiteral("--skin NAME"), CommandLine::tr("%1, instead of the project's").arg(idsOf(model::skinLooks()))},
        {QStringLiteral("--light NAME"),
         CommandLine::tr("%1, instead of the project's").arg(idsOf(model::lightPresets()))},
        settleOption(2.0),
        {QStringLiteral("--frames A-B"), CommandLine::tr("a film instead of one picture: FILE.0001.png and on")},
        frameRate(),
        numberOfHairs(),
        windVelocity(),
        headMotion(CommandLine::tr("the head moves from frame 0 on, again and again; for films")),
    };
}

std::vector<CommandOption> repairOptions()
{
    return {projectOutput()};
}

} // namespace hairpaint::app
