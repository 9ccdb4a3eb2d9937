// The table of maps and the arithmetic of their colour scales.
#include "model/project/map_spec.h"

#include "model/project/project.h"
#include "sim/groom/groom.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>

namespace hairpaint::model {

namespace {

constexpr std::array kBlendable = [] {
    std::array<BlendMode, kBlendModeCount> all{};
    for (std::size_t i = 0; i < all.size(); ++i)
        all[i] = static_cast<BlendMode>(i);
    return all;
}();
constexpr std::array kReplacing{BlendMode::Normal};
constexpr int kPlait = 1;

constexpr std::array kBraidPalette{
    PaletteEntry{"none", QT_TRANSLATE_NOOP("MapSpec", "None"), 0xFFFFFFFF},
    PaletteEntry{"plait", QT_TRANSLATE_NOOP("MapSpec", "Plait"), 0xFFFF00FF},
    PaletteEntry{"twist", QT_TRANSLATE_NOOP("MapSpec", "Twist"), 0xFFFF8000},
    PaletteEntry{"loc", QT_TRANSLATE_NOOP("MapSpec", "Loc"), 0xFF00C080},
    PaletteEntry{"plait4", QT_TRANSLATE_NOOP("MapSpec", "Plait of four"), 0xFF4060FF},
    PaletteEntry{"plait5", QT_TRANSLATE_NOOP("MapSpec", "Plait of five"), 0xFF00B0F0},
    PaletteEntry{"fishtail", QT_TRANSLATE_NOOP("MapSpec", "Fishtail"), 0xFFE0D000},
    PaletteEntry{"cornrow", QT_TRANSLATE_NOOP("MapSpec", "Cornrow"), 0xFFD03020},
};

/// Kinds of worn things, by their ids: model/project/worn.h.
constexpr std::array kAccessoryPalette{
    PaletteEntry{"none", QT_TRANSLATE_NOOP("MapSpec", "None"), 0xFFFFFFFF},
    PaletteEntry{"ponytail", QT_TRANSLATE_NOOP("MapSpec", "Ponytail"), 0xFFE6194B},
    PaletteEntry{"bun", QT_TRANSLATE_NOOP("MapSpec", "Bun"), 0xFFF58231},
    PaletteEntry{"headband", QT_TRANSLATE_NOOP("MapSpec", "Headband"), 0xFF4363D8},
    PaletteEntry{"bow", QT_TRANSLATE_NOOP("MapSpec", "Ribbon bow"), 0xFFF032E6},
    PaletteEntry{"hairpin", QT_TRANSLATE_NOOP("MapSpec", "Hairpin"), 0xFF3CB44B},
    PaletteEntry{"ball", QT_TRANSLATE_NOOP("MapSpec", "Bead"), 0xFF46F0F0},
};

std::array<MapSpec, kMapKindCount> makeTable()
{
    std::array rows{
        MapSpec{.kind = MapKind::Density,
                .id = "density",
                .title = QT_TRANSLATE_NOOP("MapSpec", "Density"),
                .letter = QT_TRANSLATE_NOOP("MapLetter", "D"),
                .scale = &kDensityScale,
                .scaleColour = 0xFF00FF00,
                .blendModes = kBlendable,
                .firstPaint = {.scalar = 0.8F}},
        MapSpec{.kind = MapKind::Length,
                .id = "length",
                .title = QT_TRANSLATE_NOOP("MapSpec", "Length"),
                .letter = QT_TRANSLATE_NOOP("MapLetter", "L"),
                .scale = &kLengthScale,
                .scaleColour = 0xFF0000FF,
                .blendModes = kBlendable,
                .firstPaint = {.scalar = 0.5F}}, // 15 of 30 cm.
        MapSpec{.kind = MapKind::Curl,
                .id = "curl",
                .title = QT_TRANSLATE_NOOP("MapSpec", "Curl"),
                .letter = QT_TRANSLATE_NOOP("MapLetter", "C"),
                .scale = &kTurnsScale,
                .scaleColour = 0xFFFF0000,
                .blendModes = kBlendable,
                .firstPaint = {.scalar = 0.6F}},
        MapSpec{.kind = MapKind::CurlSize,
                .id = "curl_size",
                .title = QT_TRANSLATE_NOOP("MapSpec", "Curl size"),
                .letter = QT_TRANSLATE_NOOP("MapLetter", "S"),
                .scale = &kRadiusScale,
                .scaleColour = 0xFFFF8000,
                .blendModes = kBlendable},
        MapSpec{.kind = MapKind::Braid,
                .id = "braid",
                .title = QT_TRANSLATE_NOOP("MapSpec", "Braid"),
                .letter = QT_TRANSLATE_NOOP("MapLetter", "B"),
                .texel = TexelKind::Index,
                .lastNumber = sim::kLastRowNumber,
                .scaleColour = 0xFFFF00FF,
                .palette = kBraidPalette,
                .blendModes = kReplacing,
                .firstPaint = {.index = kPlait}},
        MapSpec{.kind = MapKind::Colour,
                .id = "colour",
                .title = QT_TRANSLATE_NOOP("MapSpec", "Colour"),
                .letter = QT_TRANSLATE_NOOP("MapLetter", "H"),
                .texel = TexelKind::Colour,
                .scaleColour = 0xFF3B2618,
                .blendModes = kBlendable,
                .firstPaint = {.colour = QColor(0x8A, 0x4B, 0x2A)}}, // Chestnut.
        MapSpec{.kind = MapKind::TipColour,
                .id = "tip_colour",
                .title = QT_TRANSLATE_NOOP("MapSpec", "Tip colour"),
                .letter = QT_TRANSLATE_NOOP("MapLetter", "T"),
                .texel = TexelKind::Colour,
                .scaleColour = 0xFF3B2618,
                .blendModes = kBlendable,
                .firstPaint = {.colour = QColor(0xC9, 0xA2, 0x6B)}, // Honey blonde.
                .follows = MapKind::Colour},
        MapSpec{.kind = MapKind::Clump,
                .id = "clump",
                .title = QT_TRANSLATE_NOOP("MapSpec", "Clump"),
                .letter = QT_TRANSLATE_NOOP("MapLetter", "U"),
                .scale = &kPercentScale,
                .scaleColour = 0xFFFFFF00,
                .blendModes = kBlendable,
                .firstPaint = {.scalar = 0.5F}},
        MapSpec{.kind = MapKind::Gel,
                .id = "gel",
                .title = QT_TRANSLATE_NOOP("MapSpec", "Gel"),
                .letter = QT_TRANSLATE_NOOP("MapLetter", "G"),
                .scale = &kPercentScale,
                .scaleColour = 0xFF00FFFF,
                .blendModes = kBlendable},
        MapSpec{.kind = MapKind::Direction,
                .id = "direction",
                .title = QT_TRANSLATE_NOOP("MapSpec", "Direction"),
                .letter = QT_TRANSLATE_NOOP("MapLetter", "R"),
                .texel = TexelKind::Vector,
                .scaleColour = 0xFF8080FF, // The direction of hair that stands upright.
                .blendModes = kReplacing,
                .ofHead = [](const Head& head) { return head.naturalDirection; }},
        MapSpec{.kind = MapKind::Frizz,
                .id = "frizz",
                .title = QT_TRANSLATE_NOOP("MapSpec", "Frizz"),
                .letter = QT_TRANSLATE_NOOP("MapLetter", "F"),
                .scale = &kFrizzScale,
                .scaleColour = 0xFF8000FF, // Violet.
                .blendModes = kBlendable,
                .firstPaint = {.scalar = 0.5F}},
        MapSpec{.kind = MapKind::Width,
                .id = "width",
                .title = QT_TRANSLATE_NOOP("MapSpec", "Width"),
                .letter = QT_TRANSLATE_NOOP("MapLetter", "W"),
                .scale = &kWidthScale,
                .scaleColour = 0xFF964B00, // Brown.
                .blendModes = kBlendable},
        MapSpec{.kind = MapKind::Gloss,
                .id = "gloss",
                .title = QT_TRANSLATE_NOOP("MapSpec", "Gloss"),
                .letter = QT_TRANSLATE_NOOP("MapLetter", "O"),
                .scale = &kPercentScale,
                .scaleColour = 0xFFFF0080, // Rose.
                .blendModes = kBlendable},
        MapSpec{.kind = MapKind::TipStart,
                .id = "tip_start",
                .title = QT_TRANSLATE_NOOP("MapSpec", "Tip start"),
                .letter = QT_TRANSLATE_NOOP("MapLetter", "P"),
                .scale = &kPercentScale,
                .scaleColour = 0xFF0080FF, // Azure.
                .blendModes = kBlendable,
                .firstPaint = {.scalar = 0.5F}},
        MapSpec{.kind = MapKind::Accessory,
                .id = "accessory",
                .title = QT_TRANSLATE_NOOP("MapSpec", "Accessories"),
                .letter = QT_TRANSLATE_NOOP("MapLetter", "A"),
                .texel = TexelKind::Index,
                .scaleColour = 0xFFE6194B,
                .palette = kAccessoryPalette,
                .blendModes = kReplacing},
    };
    for (MapSpec& spec : rows) {
        spec.valueChannels = sim::ruleOf(spec.kind).channels;
        spec.defaultValue = sim::ruleOf(spec.kind).defaultValue;
    }
    return rows;
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

QString PaletteEntry::titleText() const
{
    return QCoreApplication::translate("MapSpec", title);
}

std::size_t MapSpec::entryOf(int number) const
{
    if (number < 0 || number > std::max(static_cast<int>(palette.size()) - 1, static_cast<int>(lastNumber)))
        return 0;
    return std::min(static_cast<std::size_t>(number), palette.size() - 1);
}

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
    const float fraction = std::clamp(value, 0.0F, 1.0F);
    const std::array<float, 3> full = channelsOf(spec.scaleColour);
    const float paper = nightPaper ? 0.0F : 1.0F;
    std::array<int, 3> mixed{};
    for (std::size_t i = 0; i < 3; ++i)
        mixed[i] = static_cast<int>(std::lround((paper + (full[i] - paper) * fraction) * 255.0F));
    return qRgb(mixed[0], mixed[1], mixed[2]);
}

/// How far the channels that the full colour has less of lie below those it has most of, in parts of what they do at 1.
/// For green that is G - max(R, B), for yellow min(R, G) - B, for orange min(R - B, 2 (R - G)).
float colourToScale(const MapSpec& spec, float red, float green, float blue)
{
    constexpr float kWhole = 0.9F; ///< Fraction of the greatest channel above which a channel counts as full.
    const std::array<float, 3> full = channelsOf(spec.scaleColour);
    const std::array<float, 3> read{red, green, blue};
    const float most = std::max({full[0], full[1], full[2]});
    if (most <= kWhole) {
        // Differences of channels tell coarsely here. What lies on the scale itself is read from the channel that
        // changes most along it.
        const auto furthest = static_cast<std::size_t>(std::ranges::min_element(full) - full.begin());
        const float told = (1.0F - read[furthest]) / (1.0F - full[furthest]);
        constexpr float kStep = 1.0F / 255.0F;
        bool isOnScale = true;
        for (std::size_t i = 0; i < 3; ++i)
            isOnScale &= std::abs(read[i] - (1.0F - (1.0F - full[i]) * told)) < kStep;
        if (isOnScale)
            return std::max(told, 0.0F);
    }
    float least = 1.0F;
    for (std::size_t i = 0; i < 3; ++i)
        if (full[i] > kWhole * most)
            least = std::min(least, read[i]);
    // What a channel does at 1 is also how exactly it tells: two that agree within a step of eight bits leave it to the
    // one that does more.
    const float agreement = (most > kWhole ? 1.5F : 3.0F / most) / 255.0F;
    float value = 1.0F;
    float exact = 1.0F;
    float greatest = 0.0F;
    for (std::size_t i = 0; i < 3; ++i) {
        if (full[i] > kWhole * most)
            continue;
        const float span = most - full[i];
        const float told = (least - read[i]) / span;
        value = std::min(value, told);
        exact = span > greatest + 0.1F ? told : span > greatest - 0.1F ? std::min(exact, told) : exact;
        greatest = std::max(greatest, span);
    }
    if (exact - value < agreement)
        value = exact;
    return std::max(value, 0.0F);
}

/// A braid's plait is a magenta of 1/2 or more. The others are the nearest palette colour, where "none" is the whole
/// grey axis.
std::uint16_t colourToIndex(const MapSpec& spec, float red, float green, float blue)
{
    const bool isBraid = spec.kind == MapKind::Braid;
    if (isBraid && std::min(red, blue) - green >= 0.5F)
        return kPlait;
    const std::array<float, 3> read{red, green, blue};
    const float grey = (red + green + blue) / 3.0F;
    float nearest = squaredDistance(read, {grey, grey, grey});
    std::uint16_t index = 0;
    for (std::size_t i = isBraid ? kPlait + 1 : 1; i < spec.palette.size(); ++i) {
        const float distance = squaredDistance(read, channelsOf(spec.palette[i].colour));
        if (distance < nearest) {
            nearest = distance;
            index = static_cast<std::uint16_t>(i);
        }
    }
    return index;
}

} // namespace hairpaint::model
