// The table of maps and the arithmetic of their colour scales.
#include "model/map_spec.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>

namespace hairpaint::model {

namespace {

constexpr std::array kBlendable{BlendMode::Normal, BlendMode::Multiply};
constexpr std::array kReplacing{BlendMode::Normal};
constexpr int kPlait = 1;

constexpr std::array kBraidPalette{
    PaletteEntry{"none", QT_TRANSLATE_NOOP("MapSpec", "None"), 0xFFFFFFFF},
    PaletteEntry{"plait", QT_TRANSLATE_NOOP("MapSpec", "Plait"), 0xFFFF00FF},
    PaletteEntry{"twist", QT_TRANSLATE_NOOP("MapSpec", "Twist"), 0xFFFF8000},
    PaletteEntry{"loc", QT_TRANSLATE_NOOP("MapSpec", "Loc"), 0xFF00C080},
};

constexpr sim::Texel kDarkBrown{0x3B3B, 0x2626, 0x1818, 0};

MapSpec scalar(MapKind kind, const char* id, const char* title, const char* letter, const MapScale& scale,
               std::uint16_t defaultValue, QRgb scaleColour)
{
    return {.kind = kind,
            .id = id,
            .title = title,
            .letter = letter,
            .texel = TexelKind::Scalar,
            .scale = &scale,
            .valueChannels = 1,
            .defaultValue = {defaultValue, 0, 0, 0},
            .scaleColour = scaleColour,
            .palette = {},
            .blendModes = kBlendable};
}

std::array<MapSpec, kMapKindCount> makeTable()
{
    return {
        scalar(MapKind::Density, "density", QT_TRANSLATE_NOOP("MapSpec", "Density"),
               QT_TRANSLATE_NOOP("MapLetter", "D"), kDensityScale, 0, 0xFF00FF00),
        scalar(MapKind::Length, "length", QT_TRANSLATE_NOOP("MapSpec", "Length"), QT_TRANSLATE_NOOP("MapLetter", "L"),
               kLengthScale, 32768, 0xFF0000FF),
        scalar(MapKind::Curl, "curl", QT_TRANSLATE_NOOP("MapSpec", "Curl"), QT_TRANSLATE_NOOP("MapLetter", "C"),
               kTurnsScale, 0, 0xFFFF0000),
        MapSpec{.kind = MapKind::Braid,
                .id = "braid",
                .title = QT_TRANSLATE_NOOP("MapSpec", "Braid"),
                .letter = QT_TRANSLATE_NOOP("MapLetter", "B"),
                .texel = TexelKind::Index,
                .scale = nullptr,
                .valueChannels = 1,
                .defaultValue = {},
                .scaleColour = 0xFFFF00FF,
                .palette = kBraidPalette,
                .blendModes = kReplacing},
        MapSpec{.kind = MapKind::Colour,
                .id = "colour",
                .title = QT_TRANSLATE_NOOP("MapSpec", "Colour"),
                .letter = QT_TRANSLATE_NOOP("MapLetter", "H"),
                .texel = TexelKind::Colour,
                .scale = nullptr,
                .valueChannels = 3,
                .defaultValue = kDarkBrown,
                .scaleColour = 0xFF3B2618,
                .palette = {},
                .blendModes = kBlendable},
        scalar(MapKind::Clump, "clump", QT_TRANSLATE_NOOP("MapSpec", "Clump"), QT_TRANSLATE_NOOP("MapLetter", "U"),
               kShareScale, 0, 0xFFFFFF00),
        scalar(MapKind::Gel, "gel", QT_TRANSLATE_NOOP("MapSpec", "Gel"), QT_TRANSLATE_NOOP("MapLetter", "G"),
               kShareScale, 0, 0xFF00FFFF),
    };
}

std::array<float, 3> channelsOf(QRgb colour)
{
    return {static_cast<float>(qRed(colour)) / 255.0F, static_cast<float>(qGreen(colour)) / 255.0F,
            static_cast<float>(qBlue(colour)) / 255.0F};
}

float squaredDistance(const std::array<float, 3>& a, const std::array<float, 3>& b)
{
    float sum = 0.0F;
    for (std::size_t i = 0; i < 3; ++i)
        sum += (a[i] - b[i]) * (a[i] - b[i]);
    return sum;
}

} // namespace

QString MapSpec::titleText() const
{
    return QCoreApplication::translate("MapSpec", title);
}

QString MapSpec::letterText() const
{
    return QCoreApplication::translate("MapLetter", letter);
}

std::span<const MapSpec> mapSpecs()
{
    static const std::array<MapSpec, kMapKindCount> table = makeTable();
    return table;
}

const MapSpec& mapSpec(MapKind kind)
{
    return mapSpecs()[static_cast<std::size_t>(kind)];
}

const MapSpec* findMapSpec(QStringView id)
{
    const std::span<const MapSpec> table = mapSpecs();
    const auto found = std::ranges::find_if(table, [id](const MapSpec& spec) { return id == QLatin1String(spec.id); });
    return found == table.end() ? nullptr : &*found;
}

QRgb scaleToColour(const MapSpec& spec, float value, bool nightPaper)
{
    const float share = std::clamp(value, 0.0F, 1.0F);
    const std::array<float, 3> full = channelsOf(spec.scaleColour);
    const float paper = nightPaper ? 0.0F : 1.0F;
    std::array<int, 3> mixed{};
    for (std::size_t i = 0; i < 3; ++i)
        mixed[i] = static_cast<int>(std::lround((paper + (full[i] - paper) * share) * 255.0F));
    return qRgb(mixed[0], mixed[1], mixed[2]);
}

/// Of a scale whose full colour has channels of 1 and of 0: the least of those that are 1, less the greatest of those
/// that are 0. For green that is G - max(R, B), for yellow min(R, G) - B.
float colourToScale(const MapSpec& spec, float red, float green, float blue)
{
    const std::array<float, 3> full = channelsOf(spec.scaleColour);
    const std::array<float, 3> read{red, green, blue};
    float least = 1.0F;
    float greatest = 0.0F;
    for (std::size_t i = 0; i < 3; ++i) {
        if (full[i] > 0.5F)
            least = std::min(least, read[i]);
        else
            greatest = std::max(greatest, read[i]);
    }
    return std::clamp(least - greatest, 0.0F, 1.0F);
}

/// Plait is a magenta of 1/2 or more. The others are the nearest palette colour, where "none" is the whole grey axis.
std::uint16_t colourToIndex(const MapSpec& spec, float red, float green, float blue)
{
    if (std::min(red, blue) - green >= 0.5F)
        return kPlait;
    const std::array<float, 3> read{red, green, blue};
    const float grey = (red + green + blue) / 3.0F;
    float nearest = squaredDistance(read, {grey, grey, grey});
    std::uint16_t index = 0;
    for (std::size_t i = kPlait + 1; i < spec.palette.size(); ++i) {
        const float distance = squaredDistance(read, channelsOf(spec.palette[i].colour));
        if (distance < nearest) {
            nearest = distance;
            index = static_cast<std::uint16_t>(i);
        }
    }
    return index;
}

} // namespace hairpaint::model
