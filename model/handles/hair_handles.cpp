// Handles told from hair, and hair made by them.
#include "model/handles/hair_handles.h"

#include "model/maps/compositor.h"
#include "model/maps/tile_paint.h"
#include "model/project/group_schema.h"
#include "model/styles/style_use.h"
#include "model/tools/lying/fallen_hair.h"
#include "model/tools/parting/part_field.h"
#include "sim/groom/direction_texel.h"
#include "sim/groom/strand_style.h"

#include <QCoreApplication>

#include <algorithm>
#include <numbers>

namespace hairpaint::model {

namespace {

constexpr std::array kHandles{
    HandleSpec{.kind = HandleKind::Length,
               .title = QT_TRANSLATE_NOOP("HairHandles", "Length all over"),
               .hint = QT_TRANSLATE_NOOP("HairHandles", "All of this hair longer or shorter; 100% is as it was"),
               .step = QT_TRANSLATE_NOOP("HairHandles", "Length of \"%1\""),
               .least = 0.25,
               .greatest = 2.0,
               .usual = 1.0},
    HandleSpec{.kind = HandleKind::Fringe,
               .title = QT_TRANSLATE_NOOP("HairHandles", "Fringe length"),
               .hint = QT_TRANSLATE_NOOP("HairHandles", "Hair over the forehead longer or shorter"),
               .step = QT_TRANSLATE_NOOP("HairHandles", "Fringe of \"%1\""),
               .least = 0.15,
               .greatest = 2.0,
               .usual = 1.0},
    HandleSpec{.kind = HandleKind::Fade,
               .title = QT_TRANSLATE_NOOP("HairHandles", "Fade height"),
               .hint = QT_TRANSLATE_NOOP("HairHandles", "How much higher clipped hair ends at the sides and the back"),
               .step = QT_TRANSLATE_NOOP("HairHandles", "Fade of \"%1\""),
               .least = -0.03,
               .greatest = 0.04,
               .usual = 0.0},
    HandleSpec{.kind = HandleKind::Part,
               .title = QT_TRANSLATE_NOOP("HairHandles", "Part"),
               .hint = QT_TRANSLATE_NOOP("HairHandles", "Where hair falls to both sides; left is the head's own left"),
               .step = QT_TRANSLATE_NOOP("HairHandles", "Part of \"%1\""),
               .least = 0.0,
               .greatest = 3.0,
               .usual = 0.0},
};

constexpr PartLook kPartLook{.reachM = 0.12F, .flatness = 0.9F, .gapM = 0.0F};

/// What grows at a point of the skin.
struct Spot
{
    float lengthM = 0.0F;
    bool isLoose = false; ///< Neither braided, tied nor gelled, and not combed upright.
};

class Spots
{
public:
    Spots(const HairGroup& group, const sim::MapRaster& density, const sim::MapRaster& length,
          const sim::MapRaster& direction)
        : m_group(group), m_density(density), m_length(length), m_direction(direction)
    {}

    /// None where no hair grows.
    [[nodiscard]] std::optional<Spot> at(glm::vec2 uv) const
    {
        constexpr float kGelled = 0.9F;
        constexpr float kLying = 0.15F;
        if (m_density->sampleScalar(uv) <= 0.0F)
            return std::nullopt;
        const bool isTied = scalar(MapKind::Braid, uv) != 0 || scalar(MapKind::Accessory, uv) != 0;
        const bool isGelled = static_cast<float>(scalar(MapKind::Gel, uv)) > kGelled * kFull16;
        const bool lies = glm::length(sim::directionAt(*m_direction, uv)) > kLying;
        return Spot{.lengthM = sim::lengthOf(m_group.settings, m_length->sampleScalar(uv)),
                    .isLoose = !isTied && !isGelled && lies};
    }

private:
    [[nodiscard]] std::uint16_t scalar(MapKind kind, glm::vec2 uv) const
    {
        const MapStack& stack = m_group.map(kind);
        const auto texel = [&stack](float fraction) {
            return std::clamp(static_cast<int>(fraction * static_cast<float>(stack.size)), 0, stack.size - 1);
        };
        return resolveTexel(stack, texel(uv.x), texel(1.0F - uv.y))[0];
    }

    const HairGroup& m_group;
    const sim::MapRaster& m_density;
    const sim::MapRaster& m_length;
    const sim::MapRaster& m_direction;
};

/// Whether most of the spots grow loose hair of some length on average.
bool growsLoose(const std::vector<std::optional<Spot>>& spots, float leastM)
{
    float wholeM = 0.0F;
    std::size_t loose = 0;
    for (const std::optional<Spot>& spot : spots)
        if (spot && spot->isLoose) {
            ++loose;
            wholeM += spot->lengthM;
        }
    return loose * 2 > spots.size() && wholeM / static_cast<float>(loose) >= leastM;
}

/// The layer that a stroke over all of the map would be laid on; null where layers above it would hide or change it.
const Layer* wholeLayer(const MapStack& stack)
{
    if (stack.layers.empty())
        return nullptr;
    const Layer& top = stack.layers.back();
    return top.visible && top.blend == BlendMode::Normal && unit16(top.opacity) == 65535 ? &top : nullptr;
}

} // namespace

QString HandleSpec::titleText() const
{
    return QCoreApplication::translate("HairHandles", title);
}

QString HandleSpec::hintText() const
{
    return QCoreApplication::translate("HairHandles", hint);
}

std::span<const HandleSpec> handleSpecs()
{
    return kHandles;
}

const HandleSpec& handleSpec(HandleKind kind)
{
    return kHandles.at(static_cast<std::size_t>(kind));
}

HandledHair HandledHair::of(const HairGroup& group)
{
    return {.greatestLengthM = group.settings.greatestLengthM,
            .shortestLengthM = group.settings.shortestLengthM,
            .length = group.maps[static_cast<std::size_t>(MapKind::Length)],
            .direction = group.maps[static_cast<std::size_t>(MapKind::Direction)]};
}

void HandledHair::applyTo(HairGroup& group) const
{
    group.settings.greatestLengthM = greatestLengthM;
    group.settings.shortestLengthM = shortestLengthM;
    group.maps[static_cast<std::size_t>(MapKind::Length)] = length;
    group.maps[static_cast<std::size_t>(MapKind::Direction)] = direction;
}

HairHandles::HairHandles(const HairGroup& base, std::shared_ptr<const Head> head, sim::MapRaster density,
                         sim::MapRaster direction)
    : m_base(base), m_head(std::move(head)), m_density(std::move(density)), m_direction(std::move(direction)),
      m_length(std::make_shared<const sim::TiledRaster>(resolveStack(base.map(MapKind::Length))))
{
    look();
}

HairHandles::~HairHandles() = default;

void HairHandles::look()
{
    constexpr float kFringeM = 0.02F; // Shorter hair is no fringe.
    constexpr float kPartedM = 0.042F;
    constexpr float kClippedM = 0.016F;
    constexpr float kFades = 1.8F; ///< So much longer hair is above.
    const auto set = [this](HandleKind kind, bool has) { m_has[static_cast<std::size_t>(kind)] = has; };
    if (m_density == nullptr || m_direction == nullptr || !growsHair(m_base))
        return;
    set(HandleKind::Length, true);
    if (m_head == nullptr || m_head->skin == nullptr || !m_head->landmarks)
        return;
    m_regions.emplace(*m_head->landmarks);
    const sim::Skin& skin = *m_head->skin;
    const Spots spots(m_base, m_density, m_length, m_direction);
    std::vector<std::optional<Spot>> fringe;
    for (const float backM : {0.006F, 0.016F, 0.028F})
        for (const float leftM : {-0.03F, -0.015F, 0.0F, 0.015F, 0.03F}) {
            const glm::vec3 away(leftM, 0.4F * backM, -backM - 0.25F * std::abs(leftM) - 4.0F * leftM * leftM);
            fringe.push_back(spots.at(skin.nearest(m_regions->hairlineHd() + away * m_regions->scale()).uv));
        }
    set(HandleKind::Fringe, growsLoose(fringe, kFringeM));
    std::vector<std::optional<Spot>> top;
    for (const float side : {-1.0F, 0.0F, 1.0F})
        for (const sim::SurfacePoint& point : m_regions->partLine(skin, side))
            top.push_back(spots.at(point.uv));
    set(HandleKind::Part, wholeLayer(m_base.map(MapKind::Direction)) != nullptr && growsLoose(top, kPartedM));

    m_columns.emplace(skin, *m_regions, *m_length);
    float lowM = 0.0F;
    float highM = 0.0F;
    constexpr std::array kDegrees{120.0F, 140.0F, 160.0F, 175.0F};
    for (const float degrees : kDegrees) {
        const float angle = degrees * std::numbers::pi_v<float> / 180.0F;
        const auto lengthAt = [&](float heightM) {
            return sim::lengthOf(m_base.settings, m_columns->at(angle, heightM)) / static_cast<float>(kDegrees.size());
        };
        lowM += lengthAt(m_regions->napeM() + 0.012F * m_regions->scale());
        highM += lengthAt(m_regions->topM() - 0.015F * m_regions->scale());
    }
    // Between the nape and the ears' height; an undercut is shaved there.
    bool growsLow = false;
    for (const float upM : {0.025F, 0.04F, 0.055F}) {
        const float heightM = m_regions->napeM() + upM * m_regions->scale();
        const auto point = skin.pick(m_regions->rayAt(std::numbers::pi_v<float>, heightM));
        growsLow = growsLow || (point && m_density->sampleScalar(point->uv) > 0.0F);
    }
    set(HandleKind::Fade, growsLow && lowM < kClippedM * m_regions->scale() && highM > kFades * lowM);
}

HandledHair HairHandles::at(const HandleValues& values)
{
    HandledHair made = HandledHair::of(m_base);
    if (has(HandleKind::Part))
        made.direction = parted(static_cast<PartSide>(std::clamp(values[HandleKind::Part], 0.0, 3.0)));
    sim::GroupSettings settings = m_base.settings;
    if ((has(HandleKind::Fringe) && values[HandleKind::Fringe] != handleSpec(HandleKind::Fringe).usual) ||
        (has(HandleKind::Fade) && values[HandleKind::Fade] != handleSpec(HandleKind::Fade).usual))
        made.length = factors(values).applied(m_base, settings);
    if (has(HandleKind::Length)) {
        const HandleSpec& spec = handleSpec(HandleKind::Length);
        const double factor = std::clamp(values[HandleKind::Length], spec.least, spec.greatest);
        if (factor != spec.usual)
            for (const char* key : {"greatest_length_m", "shortest_length_m"}) {
                const GroupSetting& row = groupSetting(QLatin1StringView(key));
                row.write(settings, std::clamp(row.read(settings) * factor, row.least, row.greatest));
            }
    }
    made.greatestLengthM = settings.greatestLengthM;
    made.shortestLengthM = settings.shortestLengthM;
    return made;
}

LengthFactors HairHandles::factors(const HandleValues& values)
{
    constexpr float kMost = 30.0F;
    if (m_frames == nullptr)
        m_frames = std::make_unique<SkinFrames>(m_head->skin);
    const auto valueOf = [&](HandleKind kind) {
        const HandleSpec& spec = handleSpec(kind);
        return static_cast<float>(has(kind) ? std::clamp(values[kind], spec.least, spec.greatest) : spec.usual);
    };
    const float fringe = valueOf(HandleKind::Fringe);
    const float fadeM = valueOf(HandleKind::Fade) * m_regions->scale();
    LengthFactors all;
    if (fringe != 1.0F)
        all.multiply(*m_frames, [&](glm::vec3 rootHd) { return 1.0F + (fringe - 1.0F) * m_regions->fringe(rootHd); });
    if (fadeM != 0.0F)
        all.multiply(*m_frames, [&](glm::vec3 rootHd) {
            const float weight = m_regions->faded(rootHd);
            if (weight == 0.0F)
                return 1.0F;
            const float angle = m_regions->angle(rootHd);
            const float before = m_columns->at(angle, rootHd.y);
            return before <= 0.0F
                       ? 1.0F
                       : std::clamp(m_columns->at(angle, rootHd.y - fadeM * weight) / before, 1.0F / kMost, kMost);
        });
    all.spread(*m_frames);
    return all;
}

SharedStack HairHandles::parted(PartSide side)
{
    const SharedStack& base = m_base.maps[static_cast<std::size_t>(MapKind::Direction)];
    std::optional<SharedStack>& known = m_parted.at(static_cast<std::size_t>(side));
    if (side == PartSide::AsCombed)
        return base;
    if (known)
        return *known;
    if (m_frames == nullptr)
        m_frames = std::make_unique<SkinFrames>(m_head->skin);
    const float aside = side == PartSide::Left ? 1.0F : side == PartSide::Right ? -1.0F : 0.0F;
    PartLook look = kPartLook;
    look.reachM *= m_regions->scale();
    PartCurve curve = ledToHairline(*m_head->skin, m_regions->partLine(*m_head->skin, aside), *m_density, look);
    const PartField field(*m_frames, std::move(curve), look);
    SharedStack stack = base;
    Layer& layer = stack.write().layers.back();
    FallenHair fallen(m_base.settings, m_head->naturalDirection, m_direction, m_length, *m_frames, base->size);
    for (const int index : field.laidTiles(base->size)) {
        fallen.look(index);
        const PartField::LaidTile laid = field.laid(index, base->size);
        const sim::RasterTilePtr under = fallen.under(index, layer.raster.tile(index), laid.mask);
        layer.raster.setTile(index,
                             paintTile(mapSpec(MapKind::Direction), under, laid.mask, {.values = laid.values.data()}));
    }
    known = stack;
    return stack;
}

} // namespace hairpaint::model
