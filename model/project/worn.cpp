// The kinds of what is worn.
#include "model/project/worn.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace hairpaint::model {

namespace {

constexpr std::array kWornSpecs = {
    WornSpec{.kind = WornKind::Ellipsoid,
             .id = "ellipsoid",
             .ownArray = "ellipsoids",
             .action = "Collider",
             .addTitle = QT_TRANSLATE_NOOP("Worn", "Add &collider here"),
             .addHint =
                 QT_TRANSLATE_NOOP("Worn", "An ellipsoid where the pointer was last on the head, which hair does "
                                           "not enter; %1 at most"),
             .removeTitle = QT_TRANSLATE_NOOP("Worn", "Remove c&ollider"),
             .addStep = QT_TRANSLATE_NOOP("Worn", "Add collider"),
             .removeStep = QT_TRANSLATE_NOOP("Worn", "Remove collider"),
             .moveStep = QT_TRANSLATE_NOOP("Worn", "Move collider"),
             .sizeStep = QT_TRANSLATE_NOOP("Worn", "Size collider"),
             .limit = 32,
             .radiusM = 0.03F,
             .liftRadii = -0.5F, // Half in the head.
             .colour = 0,
             .leastRadiusM = 0.005F,
             .greatestRadiusM = 0.5F,
             .handles = WornHandles::Axes,
             .ofHead = true,
             .collides = true,
             .mesh = nullptr,
             .sheen = 0.0F},
};

template<typename Wanted>
std::vector<sim::Ellipsoid> shapesWhere(const std::vector<Worn>& all, const Wanted& wanted)
{
    std::vector<sim::Ellipsoid> shapes;
    for (const Worn& one : all)
        if (wanted(wornSpec(one.kind)))
            shapes.push_back(one.shape);
    return shapes;
}

} // namespace

std::span<const WornSpec> wornSpecs()
{
    return kWornSpecs;
}

const WornSpec& wornSpec(WornKind kind)
{
    return kWornSpecs.at(static_cast<std::size_t>(kind));
}

const WornSpec* findWornSpec(const QString& id)
{
    const auto found =
        std::ranges::find_if(kWornSpecs, [&id](const WornSpec& spec) { return id == QLatin1StringView(spec.id); });
    return found != kWornSpecs.end() ? &*found : nullptr;
}

QString wornText(const char* text)
{
    return QCoreApplication::translate("Worn", text);
}

Worn makeWorn(const WornSpec& spec, glm::vec3 positionHd, glm::vec3 normalHd)
{
    return {.id = 0,
            .kind = spec.kind,
            .shape = {.centreHd = positionHd + spec.liftRadii * spec.radiusM * normalHd,
                      .semiAxesM = glm::vec3(spec.radiusM)},
            .colour = spec.colour};
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
    return shapesWhere(all, [](const WornSpec& spec) { return spec.collides; });
}

std::vector<sim::Ellipsoid> shapesOfHead(const std::vector<Worn>& all)
{
    return shapesWhere(all, [](const WornSpec& spec) { return spec.ofHead; });
}

} // namespace hairpaint::model
