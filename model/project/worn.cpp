// The kinds of what is worn.
#include "model/project/worn.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>

namespace hairpaint::model {

namespace {

/// An octahedron whose faces are divided and blown up: square roots alone, so that pictures are the same everywhere.
std::shared_ptr<const sim::HeadMesh> madeBall()
{
    constexpr int kSteps = 16; // Along an edge of the octahedron.
    auto mesh = std::make_shared<sim::HeadMesh>();
    for (unsigned octant = 0; octant < 8; ++octant) {
        const glm::vec3 side((octant & 1U) != 0 ? -1 : 1, (octant & 2U) != 0 ? -1 : 1, (octant & 4U) != 0 ? -1 : 1);
        const bool isMirrored = side.x * side.y * side.z < 0.0F;
        const auto first = static_cast<int>(mesh->positionsHd.size());
        for (int row = 0; row <= kSteps; ++row)
            for (int i = 0; i <= kSteps - row; ++i) {
                const glm::vec3 flat = side * glm::vec3(kSteps - row - i, i, row);
                mesh->positionsHd.push_back(flat / std::sqrt(glm::dot(flat, flat)));
                mesh->uvs.push_back(glm::vec2(i, row) / static_cast<float>(kSteps));
            }
        const auto add = [&](glm::ivec2 a, glm::ivec2 b, glm::ivec2 c) {
            const auto at = [first](glm::ivec2 corner) { // Row and number in it.
                const int row = corner.x;
                return static_cast<unsigned>(first + row * (kSteps + 1) - row * (row - 1) / 2 + corner.y);
            };
            mesh->triangles.emplace_back(at(a), at(isMirrored ? c : b), at(isMirrored ? b : c));
        };
        for (int row = 0; row < kSteps; ++row)
            for (int i = 0; i < kSteps - row; ++i) {
                add({row, i}, {row, i + 1}, {row + 1, i});
                if (i + 1 < kSteps - row)
                    add({row, i + 1}, {row + 1, i + 1}, {row + 1, i});
            }
    }
    mesh->normalsHd = mesh->positionsHd;
    return mesh;
}

std::shared_ptr<const sim::HeadMesh> unitBall()
{
    static const std::shared_ptr<const sim::HeadMesh> ball = madeBall();
    return ball;
}

constexpr std::array kWornSpecs = {
    WornSpec{.kind = WornKind::Ellipsoid,
             .id = "ellipsoid",
             .ownArray = "ellipsoids",
             .title = QT_TRANSLATE_NOOP("Worn", "Collider"),
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
             .lookStep = nullptr,
             .limit = 32,
             .radiusM = 0.03F,
             .liftRadii = -0.5F, // Half in the head.
             .colour = 0,
             .sheen = 0.0F,
             .leastRadiusM = 0.005F,
             .greatestRadiusM = 0.5F,
             .handles = WornHandles::Axes,
             .ofHead = true,
             .collides = true,
             .mesh = nullptr},
    WornSpec{.kind = WornKind::Ball,
             .id = "ball",
             .ownArray = nullptr,
             .title = QT_TRANSLATE_NOOP("Worn", "Ball"),
             .action = "Ball",
             .addTitle = QT_TRANSLATE_NOOP("Worn", "Pu&t a ball here"),
             .addHint = QT_TRANSLATE_NOOP("Worn", "A bead where the pointer was last on the head, which hair does not "
                                                  "enter; %1 at most"),
             .removeTitle = QT_TRANSLATE_NOOP("Worn", "Take the ball o&ff"),
             .addStep = QT_TRANSLATE_NOOP("Worn", "Add ball"),
             .removeStep = QT_TRANSLATE_NOOP("Worn", "Remove ball"),
             .moveStep = QT_TRANSLATE_NOOP("Worn", "Move ball"),
             .sizeStep = QT_TRANSLATE_NOOP("Worn", "Size ball"),
             .lookStep = QT_TRANSLATE_NOOP("Worn", "Change look of ball"),
             .limit = 32,
             .radiusM = 0.01F,
             .liftRadii = 1.0F, // Touches the skin.
             .colour = 0xFFC8402E,
             .sheen = 1.0F,
             .leastRadiusM = 0.002F,
             .greatestRadiusM = 0.1F,
             .handles = WornHandles::Radius,
             .ofHead = false,
             .collides = true,
             .mesh = unitBall},
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

Worn makeWorn(const WornSpec& spec, const sim::SurfacePoint& point, Id group)
{
    Worn worn{.id = 0,
              .kind = spec.kind,
              .shape = {.centreHd = point.positionHd + spec.liftRadii * spec.radiusM * point.normalHd,
                        .semiAxesM = glm::vec3(spec.radiusM)},
              .colour = spec.colour,
              .sheen = spec.sheen};
    if (!spec.ofHead) {
        worn.group = group;
        worn.anchor = WornAnchor{.face = point.face, .barycentric = point.barycentric};
    }
    return worn;
}

void anchorWorn(Worn& worn, const sim::Skin* skin)
{
    worn.anchor.reset();
    if (skin == nullptr || wornSpec(worn.kind).ofHead)
        return;
    const sim::SurfacePoint point = skin->nearest(worn.shape.centreHd);
    worn.anchor = WornAnchor{.face = point.face, .barycentric = point.barycentric};
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
