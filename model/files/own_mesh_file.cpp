// Meshes scaled into the box that their shape scales.
#include "model/files/own_mesh_file.h"

#include "model/files/glb.h"
#include "model/files/glb_writing.h"
#include "model/files/json_fields.h"
#include "model/files/worn_json.h"
#include "model/values/srgb.h"
#include "sim/skin/mesh_bounds.h"
#include "sim/skin/texture_halving.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

namespace hairpaint::model {

namespace {

constexpr float kLeastAxis = 1e-3F; ///< Least semi-axis in the longest: what is flat still has a box.

const WornSpec& ownSpec()
{
    return wornSpec(WornKind::Mesh);
}

Checked<void> checkCounts(std::size_t vertices, std::size_t triangles)
{
    if (vertices <= kMostOwnVertices && triangles <= kMostOwnTriangles)
        return {};
    return refuse(
        say(QT_TRANSLATE_NOOP("Files", "its mesh has %1 triangles, and what is worn has at most %2; reduce it "
                                       "in a 3D program"))
            .arg(triangles)
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

QRgb encoded(const glm::vec3& linear)
{
    const auto channel = [&linear](int at) {
        return static_cast<int>(std::lround(255.0F * srgbFromLinear(std::clamp(linear[at], 0.0F, 1.0F))));
    };
    return qRgb(channel(0), channel(1), channel(2));
}

bool looksAlike(const MeshPart& a, const MeshPart& b)
{
    return a.texture == b.texture && a.colour == b.colour && (a.texture < 0 || a.alpha == b.alpha);
}

template<typename Element>
void append(std::vector<Element>& to, const std::vector<Element>& from, std::size_t first, std::size_t count)
{
    const auto begin = from.begin() + static_cast<std::ptrdiff_t>(first);
    to.insert(to.end(), begin, begin + static_cast<std::ptrdiff_t>(count));
}

/// With a part for each look, in the order in which they first come, and the textures that these show.
RiggedMesh joinedByLook(const RiggedMesh& source)
{
    struct Range
    {
        std::size_t firstVertex = 0, firstTriangle = 0;
    };
    std::vector<Range> ranges;
    Range next;
    for (const MeshPart& part : source.parts) {
        ranges.push_back(next);
        next.firstVertex += part.vertices;
        next.firstTriangle += part.triangles;
    }
    RiggedMesh joined;
    std::map<std::int32_t, std::int32_t> textures;
    std::vector<bool> isTaken(source.parts.size());
    for (std::size_t look = 0; look < source.parts.size(); ++look) {
        if (isTaken[look] || source.parts[look].triangles == 0)
            continue;
        MeshPart& made = joined.parts.emplace_back(source.parts[look]);
        made.vertices = made.triangles = 0;
        for (std::size_t i = look; i < source.parts.size(); ++i) {
            const MeshPart& part = source.parts[i];
            if (isTaken[i] || part.triangles == 0 || !looksAlike(part, source.parts[look]))
                continue;
            isTaken[i] = true;
            const auto moved = static_cast<std::uint32_t>(joined.positionsHd.size() - ranges[i].firstVertex);
            append(joined.positionsHd, source.positionsHd, ranges[i].firstVertex, part.vertices);
            append(joined.normalsHd, source.normalsHd, ranges[i].firstVertex, part.vertices);
            append(joined.uvs, source.uvs, ranges[i].firstVertex, part.vertices);
            for (std::size_t t = 0; t < part.triangles; ++t)
                joined.triangles.push_back(source.triangles[ranges[i].firstTriangle + t] + moved);
            made.vertices += part.vertices;
            made.triangles += part.triangles;
        }
        if (made.texture < 0) {
            made.alpha = PartAlpha::Opaque;
            continue;
        }
        const auto [known, isNew] =
            textures.try_emplace(made.texture, static_cast<std::int32_t>(joined.textures.size()));
        if (isNew)
            joined.textures.push_back(source.textures[static_cast<std::size_t>(made.texture)]);
        made.texture = known->second;
    }
    sim::shrinkTo(joined.textures, kMostOwnPixels);
    return joined;
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
    if (Checked<void> counts = checkCounts(source.positionsHd.size(), source.triangles.size()); !counts)
        return tl::unexpected(counts.error());
    RiggedMesh mesh =
        source.parts.empty() ? RiggedMesh(static_cast<const sim::HeadMesh&>(source)) : joinedByLook(source);
    mesh.marks.clear();
    QRgb colour = source.parts.empty() ? ownSpec().colour : qRgb(255, 255, 255);
    if (mesh.parts.size() == 1 && mesh.textures.empty()) { // Its colour can then be chosen freely.
        colour = encoded(mesh.parts.front().colour);
        mesh.parts.clear();
    }
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
    const Checked<std::shared_ptr<const OwnMesh>> own = ownMeshFromGlb(name.left(kLongestName), glbFromMesh(mesh));
    if (!own)
        return tl::unexpected(own.error());
    return BroughtMesh{.own = *own,
                       .semiAxesM = half * scaleOf(source.told, longest),
                       .colour = colour,
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
    Checked<sim::HeadMesh> first = meshFromGlb(glb);
    if (!first)
        return tl::unexpected(first.error());
    Checked<GlbParts> read = partsFromGlb(glb);
    if (!read)
        return tl::unexpected(read.error());
    read->first.mesh = std::make_shared<const sim::HeadMesh>(std::move(*first));
    auto own = std::make_shared<OwnMesh>();
    own->name = name;
    own->glb = glb;
    std::size_t vertices = 0;
    std::size_t triangles = 0;
    std::size_t pixels = 0;
    std::set<const MeshTexture*> textures;
    const auto add = [&](HeadPart part) {
        vertices += part.mesh->positionsHd.size();
        triangles += part.mesh->triangles.size();
        if (part.texture != nullptr && textures.insert(part.texture.get()).second)
            pixels += part.texture->rgba.size() / 4;
        sim::HeadMesh mesh = *part.mesh;
        fitIntoBox(mesh, glm::vec3(0.0F), glm::vec3(1.0F)); // Where it is, unless the file was made otherwise.
        OwnSurface& surface = own->surfaces.emplace_back();
        surface.part = std::move(part);
        surface.mirrored = mirroredMesh(mesh);
        surface.part.mesh = std::make_shared<const sim::HeadMesh>(std::move(mesh));
    };
    add(std::move(read->first));
    for (HeadPart& part : read->parts)
        add(std::move(part));
    if (Checked<void> counts = checkCounts(vertices, triangles); !counts)
        return tl::unexpected(counts.error());
    if (pixels > kMostOwnPixels)
        return refuse(say(QT_TRANSLATE_NOOP("Files", "its head's mesh is broken")));
    return own;
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
