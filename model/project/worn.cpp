// Worn things: made, placed, and as other floors know them.
#include "model/project/worn.h"

#include "model/project/worn_kinds.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <limits>

namespace hairpaint::model {

namespace {

template<typename Wanted>
std::vector<sim::Ellipsoid> shapesWhere(const std::vector<Worn>& all, const Wanted& wanted)
{
    std::vector<sim::Ellipsoid> shapes;
    for (const Worn& one : all)
        if (wanted(one))
            shapes.push_back(one.shape);
    return shapes;
}

/// What it is made of; null for a kind without makes.
const WornMake* makeOf(const Worn& worn)
{
    const std::span<const WornMake> makes = wornSpec(worn.kind).makes;
    return makes.empty() ? nullptr : &makes[std::min<std::size_t>(worn.make, makes.size() - 1)];
}

/// z along the normal, y as upright as can be.
glm::quat standing(glm::vec3 normalHd)
{
    constexpr float kUpright = 0.95F; // There y points back, where the head's y would have no length.
    const glm::vec3 up = std::abs(normalHd.y) < kUpright ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, -1);
    const glm::vec3 x = glm::normalize(glm::cross(up, normalHd));
    return glm::normalize(glm::quat_cast(glm::mat3(x, glm::cross(normalHd, x), normalHd)));
}

/// Upright as meshes are modelled, turned to the side that the skin faces.
glm::quat upright(glm::vec3 normalHd)
{
    constexpr float kLevel = 0.6F; // Above it, as on the crown, things face ahead.
    const float level = glm::length(glm::vec2(normalHd.x, normalHd.z));
    if (level < kLevel)
        return {1.0F, 0.0F, 0.0F, 0.0F};
    const float cosine = std::clamp(normalHd.z / level, -1.0F, 1.0F);
    const float sine = std::sqrt(0.5F * (1.0F - cosine)); // Of half the angle.
    return glm::normalize(glm::quat(std::sqrt(0.5F * (1.0F + cosine)), 0.0F, std::copysign(sine, normalHd.x), 0.0F));
}

/// Where gathered hair leaves: away from the skin, and a little down.
glm::vec3 leaving(glm::vec3 normalHd)
{
    return glm::normalize(normalHd + glm::vec3(0.0F, -0.15F, 0.0F));
}

} // namespace

std::span<const WornSpec> wornSpecs()
{
    return tableOfWornKinds();
}

const WornSpec& wornSpec(WornKind kind)
{
    return wornSpecs()[static_cast<std::size_t>(kind)];
}

const WornSpec* findWornSpec(const QString& id)
{
    const std::span<const WornSpec> specs = wornSpecs();
    const auto found =
        std::ranges::find_if(specs, [&id](const WornSpec& spec) { return id == QLatin1StringView(spec.id); });
    return found != specs.end() ? &*found : nullptr;
}

const WornSpec* wornOfPalette(int index)
{
    const std::span<const PaletteEntry> palette = mapSpec(MapKind::Accessory).palette;
    return index > 0 && static_cast<std::size_t>(index) < palette.size()
               ? findWornSpec(QLatin1StringView(palette[static_cast<std::size_t>(index)].id))
               : nullptr;
}

std::uint16_t paletteIndexOf(const WornSpec& spec)
{
    const std::span<const PaletteEntry> palette = mapSpec(MapKind::Accessory).palette;
    const auto found = std::ranges::find_if(palette, [&spec](const PaletteEntry& entry) {
        return QLatin1StringView(entry.id) == QLatin1StringView(spec.id);
    });
    return static_cast<std::uint16_t>(found - palette.begin());
}

QString wornText(const char* text)
{
    return QCoreApplication::translate("Worn", text);
}

std::size_t surfaceCount(const Worn& worn)
{
    if (worn.ownMesh.isRead())
        return worn.ownMesh.own->surfaces.size();
    return wornSpec(worn.kind).drawn() ? 1 : 0;
}

std::vector<HeadPart> wornSurfaces(const Worn& worn, const sim::Skin* skin)
{
    std::vector<HeadPart> surfaces;
    if (worn.ownMesh.isRead()) {
        for (const OwnSurface& own : worn.ownMesh.own->surfaces) {
            HeadPart& surface = surfaces.emplace_back(own.part);
            surface.doubleSided = true; // It need not be closed.
            if (worn.mirrored)
                surface.mesh = own.mirrored;
        }
        return surfaces;
    }
    const WornSpec& spec = wornSpec(worn.kind);
    if (!spec.drawn())
        return surfaces;
    const WornMake* make = makeOf(worn);
    HeadPart& surface = surfaces.emplace_back();
    surface.colour = glm::vec3(1.0F);
    if (spec.fitted != nullptr && skin != nullptr)
        surface.mesh = spec.fitted(worn.shape, *skin);
    else
        surface.mesh = make != nullptr ? make->mesh() : spec.mesh();
    return surfaces;
}

std::span<const HangingPart> hangingParts(const Worn& worn)
{
    if (worn.ownMesh.isRead())
        return {};
    const WornMake* make = makeOf(worn);
    const auto hanging = make != nullptr ? make->hanging : wornSpec(worn.kind).hanging;
    return hanging != nullptr ? hanging() : std::span<const HangingPart>();
}

std::optional<sim::Tie> tieOf(const Worn& worn)
{
    const WornSpec& spec = wornSpec(worn.kind);
    if (!spec.tie || !worn.patch)
        return std::nullopt;
    return sim::Tie{.number = worn.patch->number,
                    .pointHd = worn.shape.centreHd,
                    .directionHd = glm::normalize(worn.shape.rotation) * glm::vec3(0.0F, 0.0F, 1.0F),
                    .radiusM = spec.tieHole * worn.shape.semiAxesM.x,
                    .tightness = worn.tightness,
                    .form = *spec.tie,
                    .bunRadiusM = worn.coilRadiusM};
}

WornAnchor anchorAt(const sim::SurfacePoint& point)
{
    // Just outside of its face by rounding, it would come back from a file as another.
    return {.face = point.face, .barycentric = glm::clamp(point.barycentric, 0.0F, 1.0F)};
}

Worn makeWorn(const WornSpec& spec, const sim::SurfacePoint& point, Id group)
{
    Worn worn{.id = 0,
              .kind = spec.kind,
              .shape = {.semiAxesM = spec.radiusM * spec.proportions},
              .colour = spec.colour,
              .sheen = spec.sheen,
              .tightness = spec.tie ? 1.0F : 0.0F,
              .coilRadiusM = spec.coilRadiusM};
    if (!spec.ofHead)
        worn.group = group;
    standOn(worn, point);
    return worn;
}

void standOn(Worn& worn, const sim::SurfacePoint& point)
{
    const WornSpec& spec = wornSpec(worn.kind);
    float liftM = spec.liftRadii * worn.shape.semiAxesM.x / spec.proportions.x;
    if (spec.ownMesh) {
        worn.shape.rotation = upright(point.normalHd);
        liftM =
            spec.liftRadii * glm::length(worn.shape.semiAxesM * (glm::conjugate(worn.shape.rotation) * point.normalHd));
    }
    worn.shape.centreHd = point.positionHd + liftM * point.normalHd;
    if (spec.stands && !spec.ownMesh)
        worn.shape.rotation = standing(spec.tie ? leaving(point.normalHd) : point.normalHd);
    if (!spec.ofHead)
        worn.anchor = anchorAt(point);
}

sim::SurfacePoint anchorPoint(const Worn& worn, const sim::Skin& skin)
{
    constexpr float kNone = 1e-3F;
    if (worn.anchor && worn.anchor->face < skin.mesh().triangles.size()) {
        const glm::vec3& weights = worn.anchor->barycentric;
        const float sum = weights.x + weights.y + weights.z;
        if (sum > kNone)
            return skin.at(worn.anchor->face, weights / sum);
    }
    return skin.nearest(worn.shape.centreHd);
}

void carryTo(Worn& worn, const sim::SurfacePoint& from, const sim::SurfacePoint& to)
{
    const glm::quat turn = standing(to.normalHd) * glm::conjugate(standing(from.normalHd));
    worn.shape.centreHd = to.positionHd + turn * (worn.shape.centreHd - from.positionHd);
    worn.shape.rotation = glm::normalize(turn * worn.shape.rotation);
    worn.anchor = anchorAt(to);
    if (worn.patch)
        worn.patch->placedByHand = true;
}

Worn mirroredWorn(const Worn& worn, const sim::Skin& skin)
{
    constexpr glm::vec3 kAcross(-1.0F, 1.0F, 1.0F);
    Worn other = worn;
    other.id = 0;
    other.patch.reset();
    other.tie = 0;
    other.mirrored = worn.ownMesh.own != nullptr && !worn.mirrored;
    const sim::SurfacePoint from = anchorPoint(worn, skin);
    const sim::SurfacePoint to = skin.nearest(kAcross * from.positionHd);
    other.shape.centreHd = to.positionHd + kAcross * (worn.shape.centreHd - from.positionHd);
    const glm::quat& turn = worn.shape.rotation;
    other.shape.rotation = glm::quat(turn.w, turn.x, -turn.y, -turn.z);
    other.anchor = anchorAt(to);
    return other;
}

void holdSize(Worn& worn)
{
    if (worn.patch && !wornSpec(worn.kind).tie)
        worn.patch->placedByHand = true;
}

void anchorWorn(Worn& worn, const sim::Skin* skin)
{
    worn.anchor.reset();
    if (skin == nullptr || wornSpec(worn.kind).ofHead)
        return;
    const sim::SurfacePoint point = skin->nearest(worn.shape.centreHd);
    worn.anchor = anchorAt(point);
}

void insertWorn(std::vector<Worn>& all, const Worn& one)
{
    all.insert(std::ranges::upper_bound(all, one.kind, {}, &Worn::kind), one);
}

std::size_t countOf(const std::vector<Worn>& all, WornKind kind)
{
    return static_cast<std::size_t>(std::ranges::count(all, kind, &Worn::kind));
}

std::vector<sim::Ellipsoid> contactShapes(const std::vector<Worn>& all)
{
    return shapesWhere(all, [](const Worn& one) { return wornSpec(one.kind).collides && !one.passable; });
}

std::vector<sim::Tie> tiesIn(const std::vector<Worn>& all, Id group)
{
    std::vector<sim::Tie> ties;
    for (const Worn& one : all)
        if (one.group == group)
            if (const std::optional<sim::Tie> tie = tieOf(one))
                ties.push_back(*tie);
    std::ranges::sort(ties, {}, &sim::Tie::number);
    return ties;
}

std::vector<sim::Ellipsoid> shapesOfHead(const std::vector<Worn>& all)
{
    return shapesWhere(all, [](const Worn& one) { return wornSpec(one.kind).ofHead; });
}

} // namespace hairpaint::model
