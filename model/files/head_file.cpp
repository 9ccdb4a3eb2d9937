// The built-in head, and heads made from a source mesh.
#include "model/files/head_file.h"

#include "model/files/glb.h"
#include "model/heads/bust_landmarks.h"
#include "sim/skin/mesh_openings.h"

#include <QFile>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

/// Resources of a static library are registered on request; the macro must stand outside every namespace.
static void registerHeads() // NOLINT(misc-use-anonymous-namespace)
{
    Q_INIT_RESOURCE(heads);
}

namespace hairpaint::model {

namespace {

constexpr double kBustScalpFraction = 0.1979; ///< bust-1 is frozen; a test counts hairs on its scalp.

sim::HeadMesh builtInMesh(const QString& resource)
{
    QFile file(resource);
    [[maybe_unused]] const bool opened = file.open(QIODevice::ReadOnly);
    Checked<sim::HeadMesh> mesh = meshFromGlb(file.readAll());
    Q_ASSERT(opened && mesh); // Compiled in; a test reads it.
    return std::move(*mesh);
}

std::shared_ptr<const Head> loadBuiltIn()
{
    registerHeads();
    auto head = std::make_shared<Head>();
    head->name = QStringLiteral("bust-1");
    head->skin = std::make_shared<const sim::Skin>(builtInMesh(QStringLiteral(":/heads/bust-1.glb")));
    head->scalpFraction = kBustScalpFraction;
    // The bust's foot is open; it is shown as if it were solid.
    head->shownMesh = std::make_shared<const sim::HeadMesh>(
        sim::withOpeningsClosed(builtInMesh(QStringLiteral(":/heads/bust-1-fine.glb"))));
    return head;
}

/// Source space to Hd without scale; a rotation, so it serves normals too.
glm::vec3 turned(const glm::vec3& v, UpAxis upAxis)
{
    return upAxis == UpAxis::Y ? v : glm::vec3(v.x, v.z, -v.y);
}

struct Extent
{
    glm::vec3 least{0.0F};
    glm::vec3 greatest{0.0F};
    [[nodiscard]] glm::vec3 size() const { return greatest - least; }
};

Extent extentOf(const sim::HeadMesh& mesh)
{
    if (mesh.positionsHd.empty())
        return {};
    Extent extent{.least = mesh.positionsHd.front(), .greatest = mesh.positionsHd.front()};
    for (const glm::vec3& p : mesh.positionsHd) {
        extent.least = glm::min(extent.least, p);
        extent.greatest = glm::max(extent.greatest, p);
    }
    return extent;
}

/// Why a head of this extent, in metres, can't be used; nothing where it can.
std::optional<QString> problemOf(const Extent& extent)
{
    constexpr float kSmallestM = 0.001F;
    constexpr float kLargestM = 100.0F;
    constexpr float kFarthestM = 1000.0F;
    const glm::vec3 size = extent.size();
    const float largest = std::max({size.x, size.y, size.z});
    if (!(largest >= kSmallestM && largest <= kLargestM))
        return say(QT_TRANSLATE_NOOP("Files", "its head is %1 m large, and heads of 1 mm to 100 m can be used; choose "
                                              "another unit"))
            .arg(static_cast<double>(largest), 0, 'g', 3);
    // Further out floats are too coarse to tell hairs apart.
    const glm::vec3 reach = glm::max(glm::abs(extent.least), glm::abs(extent.greatest));
    const float farthest = std::max({reach.x, reach.y, reach.z});
    if (!(farthest <= kFarthestM))
        return say(QT_TRANSLATE_NOOP("Files", "its head stands %1 m from the scene's origin, and 1 km is the most; "
                                              "move it there in a 3D program"))
            .arg(static_cast<double>(farthest), 0, 'g', 3);
    return std::nullopt;
}

} // namespace

std::shared_ptr<const Head> builtInHead()
{
    static const std::shared_ptr<const Head> head = loadBuiltIn();
    return head;
}

std::vector<sim::Ellipsoid> builtInEllipsoids()
{
    std::vector<sim::Ellipsoid> ellipsoids;
    for (const heads::EllipsoidSpec& spec : heads::bustColliders())
        ellipsoids.push_back({.centreHd = spec.centre, .semiAxesM = spec.semiAxes, .rotation = spec.rotation});
    return ellipsoids;
}

Checked<std::shared_ptr<const Head>> headFromGlb(const QString& name, const QByteArray& sourceGlb, float unitScale,
                                                 UpAxis upAxis, const std::function<bool()>& goesOn)
{
    Checked<sim::HeadMesh> source = meshFromGlb(sourceGlb);
    if (!source)
        return tl::unexpected(source.error());
    sim::HeadMesh mesh = std::move(*source);
    for (glm::vec3& p : mesh.positionsHd)
        p = turned(p, upAxis) * unitScale;
    for (glm::vec3& n : mesh.normalsHd)
        n = turned(n, upAxis);
    if (const std::optional<QString> problem = problemOf(extentOf(mesh)))
        return refuse(*problem, Clause::Cure::OtherFile);
    auto head = std::make_shared<Head>();
    head->name = name;
    head->builtIn = false;
    head->unitScale = unitScale;
    head->upAxis = upAxis;
    head->sourceGlb = sourceGlb;
    head->skin = sim::Skin::make(std::move(mesh), goesOn);
    if (!head->skin)
        return std::shared_ptr<const Head>();
    if (!(head->skin->areaM2() > 0.0))
        return refuse(say(QT_TRANSLATE_NOOP("Files", "its mesh has no surface; choose another")),
                      Clause::Cure::OtherFile);
    head->shownMesh = std::shared_ptr<const sim::HeadMesh>(head->skin, &head->skin->mesh());
    return head;
}

Result<std::shared_ptr<const Head>> makeHead(const QString& name, const QByteArray& sourceGlb, float unitScale,
                                             UpAxis upAxis, const std::function<bool()>& goesOn)
{
    return withinMemory(name, cannotOpen, [&]() -> Result<std::shared_ptr<const Head>> {
        Checked<std::shared_ptr<const Head>> head = headFromGlb(name, sourceGlb, unitScale, upAxis, goesOn);
        if (!head)
            return cannotOpen(name, head.error());
        if (*head == nullptr)
            return cancelled(name);
        return std::move(*head);
    });
}

HeadGuess guessHead(const sim::HeadMesh& source)
{
    const glm::vec3 size = extentOf(source).size();
    HeadGuess guess;
    guess.upAxis = size.z > size.y ? UpAxis::Z : UpAxis::Y;
    const float height = std::max(size.y, size.z);
    if (!(height > 0.0F))
        return guess;
    // From the chin to the crown 0.23 m, a bust with shoulders up to 0.9 m.
    constexpr float kTypicalM = 0.3F;
    constexpr std::array kMetresPerUnit = {1.0F, 0.01F, 0.001F, 0.0254F};
    const auto distance = [height](float scale) { return std::abs(std::log(height * scale / kTypicalM)); };
    guess.unitScale = *std::ranges::min_element(kMetresPerUnit, {}, distance);
    return guess;
}

} // namespace hairpaint::model
