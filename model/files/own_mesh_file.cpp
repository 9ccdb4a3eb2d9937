// Meshes scaled into the box that their shape scales.
#include "model/files/own_mesh_file.h"

#include "model/files/glb.h"
#include "model/files/glb_writing.h"
#include "model/files/json_fields.h"
#include "model/files/worn_json.h"
#include "model/values/srgb.h"
#include "sim/skin/mesh_bounds.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

namespace hairpaint::model {

namespace {

constexpr float kLeastAxis = 1e-3F; ///< Least semi-axis in the longest: what is flat still has a box.

const WornSpec& ownSpec()
{
    return wornSpec(WornKind::Mesh);
}

Checked<void> checkCounts(const sim::HeadMesh& mesh)
{
    if (mesh.positionsHd.size() <= kMostOwnVertices && mesh.triangles.size() <= kMostOwnTriangles)
        return {};
    return refuse(
        say(QT_TRANSLATE_NOOP("Files", "its mesh has %1 triangles, and what is worn has at most %2; reduce it "
                                       "in a 3D program"))
            .arg(mesh.triangles.size())
            .arg(kMostOwnTriangles),
        Clause::Cure::OtherFile);
}

double areaOf(const sim::HeadMesh& mesh)
{
    double area = 0.0;
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::dvec3 a(mesh.positionsHd[t.x]);
        area +=
            0.5 * glm::length(glm::cross(glm::dvec3(mesh.positionsHd[t.y]) - a, glm::dvec3(mesh.positionsHd[t.z]) - a));
    }
    return area;
}

/// Negative where the triangles are the wrong way round.
double volumeOf(const sim::HeadMesh& mesh)
{
    double volume = 0.0;
    for (const glm::uvec3& t : mesh.triangles)
        volume += glm::dot(glm::dvec3(mesh.positionsHd[t.x]),
                           glm::cross(glm::dvec3(mesh.positionsHd[t.y]), glm::dvec3(mesh.positionsHd[t.z]))) /
                  6.0;
    return volume;
}

void turnInsideOut(sim::HeadMesh& mesh)
{
    for (glm::uvec3& t : mesh.triangles)
        std::swap(t.y, t.z);
    for (glm::vec3& normal : mesh.normalsHd)
        normal = -normal;
}

std::shared_ptr<const sim::HeadMesh> mirroredMesh(sim::HeadMesh mesh)
{
    for (glm::vec3& position : mesh.positionsHd)
        position.x = -position.x;
    for (glm::vec3& normal : mesh.normalsHd)
        normal.x = -normal.x;
    for (glm::uvec3& t : mesh.triangles)
        std::swap(t.y, t.z);
    return std::make_shared<const sim::HeadMesh>(std::move(mesh));
}

std::shared_ptr<const OwnMesh> made(const QString& name, QByteArray glb, sim::HeadMesh mesh)
{
    auto own = std::make_shared<OwnMesh>();
    own->name = name;
    own->glb = std::move(glb);
    own->mirrored = mirroredMesh(mesh);
    own->mesh = std::make_shared<const sim::HeadMesh>(std::move(mesh));
    return own;
}

/// Linear.
glm::vec3 meanOf(const MeshTexture& texture)
{
    constexpr std::size_t kMostSamples = 4096;
    const std::size_t pixels = std::size_t{texture.width} * texture.height;
    const std::size_t stride = pixels / kMostSamples + 1;
    glm::vec3 sum(0.0F);
    float count = 0.0F;
    for (std::size_t i = 0; i < pixels; i += stride, count += 1.0F)
        for (int channel = 0; channel < 3; ++channel)
            sum[channel] +=
                linearFromSrgb(static_cast<float>(texture.rgba[4 * i + static_cast<std::size_t>(channel)]) / 255.0F);
    return count > 0.0F ? sum / count : glm::vec3(1.0F);
}

QRgb colourOf(const RiggedMesh& source)
{
    const auto largest = std::ranges::max_element(source.parts, {}, &MeshPart::triangles);
    if (largest == source.parts.end())
        return ownSpec().colour;
    glm::vec3 colour = largest->colour;
    if (largest->texture >= 0 && static_cast<std::size_t>(largest->texture) < source.textures.size())
        colour *= meanOf(source.textures[static_cast<std::size_t>(largest->texture)]);
    const auto channel = [](float linear) {
        return static_cast<int>(std::lround(255.0F * srgbFromLinear(std::clamp(linear, 0.0F, 1.0F))));
    };
    return qRgb(channel(colour.x), channel(colour.y), channel(colour.z));
}

/// Metres a unit: as the file tells, where that gives something that is worn; else so that it has the usual size.
float scaleOf(const ToldSpace& told, float longest)
{
    constexpr float kSmallestM = 0.001F;
    constexpr float kLargestM = 0.5F;
    const float lengthM = told.metresPerUnit > 0.0F ? told.metresPerUnit * longest : longest;
    const bool isWorn = lengthM >= kSmallestM && lengthM <= kLargestM;
    return isWorn ? lengthM / longest : ownSpec().radiusM / longest;
}

/// Positions, and normals so that the shape that scales the box back gives those of before.
void fitIntoBox(sim::HeadMesh& mesh, glm::vec3 centre, glm::vec3 half)
{
    for (glm::vec3& position : mesh.positionsHd)
        position = glm::clamp((position - centre) / half, -1.0F, 1.0F);
    for (glm::vec3& normal : mesh.normalsHd) {
        const glm::vec3 scaled = normal * half;
        const float length = glm::length(scaled);
        normal = length > 0.0F ? scaled / length : glm::vec3(0.0F, 0.0F, 1.0F);
    }
}

} // namespace

Checked<BroughtMesh> broughtMesh(const RiggedMesh& source, const QString& name)
{
    if (Checked<void> counts = checkCounts(source); !counts)
        return tl::unexpected(counts.error());
    RiggedMesh mesh(static_cast<const sim::HeadMesh&>(source));
    mesh.marks.clear();
    if (source.told.up == ToldAxis::Z)
        for (auto* all : {&mesh.positionsHd, &mesh.normalsHd})
            for (glm::vec3& v : *all)
                v = glm::vec3(v.x, v.z, -v.y);
    const sim::MeshBounds bounds = sim::boundsOf(mesh);
    const glm::vec3 extents = 0.5F * bounds.size();
    const float longest = std::max({extents.x, extents.y, extents.z});
    if (!(longest > 0.0F) || !(areaOf(mesh) > 0.0))
        return refuse(say(QT_TRANSLATE_NOOP("Files", "its mesh has no surface; choose another")),
                      Clause::Cure::OtherFile);
    const glm::vec3 half = glm::max(extents, kLeastAxis * longest);
    fitIntoBox(mesh, 0.5F * (bounds.least + bounds.greatest), half);
    constexpr double kBall = 4.0 / 3.0 * std::numbers::pi;
    const double filled = volumeOf(mesh) / kBall;
    constexpr double kInsideOut = -0.02;
    constexpr double kSolid = 0.3; // Of the ellipsoid; shells, rings and frames are less.
    if (filled < kInsideOut)
        turnInsideOut(mesh);
    const QByteArray glb = glbFromMesh(mesh);
    return BroughtMesh{.own = made(name.left(kLongestName), glb, std::move(mesh)),
                       .semiAxesM = half * scaleOf(source.told, longest),
                       .colour = colourOf(source),
                       .passable = std::abs(filled) < kSolid};
}

Worn wornFrom(const BroughtMesh& mesh, const sim::SurfacePoint& point, Id group)
{
    Worn worn = makeWorn(ownSpec(), point, group);
    worn.shape.semiAxesM = mesh.semiAxesM;
    worn.colour = mesh.colour;
    worn.passable = mesh.passable;
    worn.ownMesh.own = mesh.own;
    standOn(worn, point);
    return worn;
}

Checked<std::shared_ptr<const OwnMesh>> ownMeshFromGlb(const QString& name, const QByteArray& glb)
{
    Checked<sim::HeadMesh> mesh = meshFromGlb(glb);
    if (!mesh)
        return tl::unexpected(mesh.error());
    if (Checked<void> counts = checkCounts(*mesh); !counts)
        return tl::unexpected(counts.error());
    fitIntoBox(*mesh, glm::vec3(0.0F), glm::vec3(1.0F)); // Where it is, unless the file was made otherwise.
    return made(name, glb, std::move(*mesh));
}

Checked<void> readOwnMeshes(std::vector<Worn>& worn, const MeshReader& read)
{
    std::map<int, std::shared_ptr<const OwnMesh>> known;
    for (Worn& one : worn) {
        if (one.ownMesh.own == nullptr || one.ownMesh.isRead())
            continue;
        std::shared_ptr<const OwnMesh>& mesh = known[one.ownMesh.own->entry];
        if (mesh == nullptr) {
            const Checked<QByteArray> glb = read(one.ownMesh.own->entry);
            if (!glb)
                return tl::unexpected(glb.error());
            Checked<std::shared_ptr<const OwnMesh>> made = ownMeshFromGlb(one.ownMesh.own->name, *glb);
            if (!made)
                return brokenEntry(ownMeshEntryName(one.ownMesh.own->entry));
            mesh = std::move(*made);
        }
        one.ownMesh.own = mesh;
    }
    return {};
}

Checked<void> readOwnMeshes(std::vector<Worn>& worn, const ArchiveReader& archive)
{
    return readOwnMeshes(worn,
                         [&archive](int number) { return archive.read(ownMeshEntryName(number), kMostOwnMeshBytes); });
}

QString ownMeshEntryName(int number)
{
    return QStringLiteral("worn/%1.glb").arg(number);
}

void addOwnMeshes(ArchiveWriter& archive, const std::vector<Worn>& worn)
{
    int number = 0;
    for (const std::shared_ptr<const OwnMesh>& mesh : ownMeshesOf(worn))
        archive.add(ownMeshEntryName(++number).toLatin1(), mesh->glb, ArchiveWriter::Method::Deflated);
}

} // namespace hairpaint::model
