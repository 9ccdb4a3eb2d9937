// The built-in heads, and heads made from a source mesh.
#include "model/files/head_file.h"

#include "model/files/glb.h"
#include "model/heads/built_in_heads.h"
#include "sim/base/parallel.h"
#include "sim/groom/stream_raster.h"
#include "sim/skin/head_warp.h"
#include "sim/skin/landmark_search.h"
#include "sim/skin/mesh_bounds.h"
#include "sim/skin/mesh_openings.h"
#include "sim/skin/mesh_subdivision.h"
#include "sim/skin/natural_stream.h"

#include <QCoreApplication>
#include <QFile>
#include <QtEndian>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <mutex>
#include <numeric>
#include <optional>
#include <span>

/// Resources of a static library are registered on request; the macro must stand outside every namespace.
static void registerHeads() // NOLINT(misc-use-anonymous-namespace)
{
    Q_INIT_RESOURCE(heads);
}

namespace hairpaint::model {

namespace {

QByteArray builtInFile(const QString& resource)
{
    QFile file(resource);
    [[maybe_unused]] const bool opened = file.open(QIODevice::ReadOnly);
    Q_ASSERT(opened); // Compiled in; a test reads it.
    return file.readAll();
}

sim::HeadMesh builtInMesh(const QString& resource)
{
    Checked<sim::HeadMesh> mesh = meshFromGlb(builtInFile(resource));
    Q_ASSERT(mesh);
    return std::move(*mesh);
}

/// In the file, numbers of 16 bits, little endian.
std::vector<float> builtInNumbers(const QString& resource)
{
    const QByteArray bytes = builtInFile(resource);
    std::vector<float> numbers;
    numbers.reserve(static_cast<std::size_t>(bytes.size()) / sizeof(qint16));
    for (qsizetype at = 0; at + 2 <= bytes.size(); at += 2)
        numbers.push_back(qFromLittleEndian<qint16>(bytes.constData() + at));
    return numbers;
}

/// The marks of the finer mesh's vertices, which begin with those of the coarser one; none where there is no such file.
std::vector<sim::SkinMarks> builtInMarks(const QString& resource)
{
    if (!QFile::exists(resource))
        return {};
    const QByteArray bytes = builtInFile(resource);
    std::vector<sim::SkinMarks> marks(static_cast<std::size_t>(bytes.size()) / sizeof(sim::SkinMarks));
    std::memcpy(marks.data(), bytes.constData(), marks.size() * sizeof(sim::SkinMarks));
    return marks;
}

/// Signed distances to the finer mesh; to `mesh` where there is no such file. Its layout: origin, cell, three sizes,
/// then the values' differences as qCompress packs them.
std::shared_ptr<const sim::DistanceGrid> builtInDistances(const sim::HeadMesh& mesh, const QString& resource)
{
    constexpr qsizetype kLayoutBytes = 28;
    if (!QFile::exists(resource))
        return sim::DistanceGrid::make(mesh);
    const QByteArray bytes = builtInFile(resource);
    const auto number = [&bytes](int index) { return qFromLittleEndian<float>(bytes.constData() + 4 * index); };
    const auto size = [&bytes](int index) { return qFromLittleEndian<qint32>(bytes.constData() + 4 * index); };
    const sim::GridLayout layout{
        .originHd = {number(0), number(1), number(2)}, .cellM = number(3), .size = {size(4), size(5), size(6)}};
    const QByteArray differences = qUncompress(bytes.sliced(kLayoutBytes));
    std::vector<std::int8_t> values(static_cast<std::size_t>(differences.size()));
    std::partial_sum(differences.begin(), differences.end(), values.begin(),
                     [](char sum, char step) { return static_cast<char>(sum + step); });
    return sim::DistanceGrid::of(layout, values);
}

/// Null where `goesOn` returns false.
sim::MapRaster naturalDirectionOf(const Head& head, const std::function<bool()>& goesOn = {})
{
    const std::vector<glm::vec3> stream = sim::naturalStream(*head.skin, head.landmarks, goesOn);
    return stream.empty() ? nullptr : sim::streamRaster(*head.skin, stream);
}

/// As it was computed when the head was made, and now where there is no such file. In it, x, y, z of each vertex:
/// floats, little endian.
std::vector<glm::vec3> builtInStream(const Head& head, const QString& resource)
{
    if (!QFile::exists(resource))
        return sim::naturalStream(*head.skin, head.landmarks);
    const QByteArray bytes = builtInFile(resource);
    std::vector<glm::vec3> directionsHd(head.skin->mesh().positionsHd.size());
    Q_ASSERT(bytes.size() == static_cast<qsizetype>(directionsHd.size() * sizeof(glm::vec3)));
    const char* at = bytes.constData();
    for (glm::vec3& direction : directionsHd)
        for (int i = 0; i < 3; ++i, at += sizeof(float))
            direction[i] = qFromLittleEndian<float>(at);
    return directionsHd;
}

/// With each edge's middle moved along its normal by as many micrometres as the head's file tells. bust-1's file tells
/// where they go and what normals they have: x, y, z in micrometres, then in 1/8192.
sim::HeadMesh finerMesh(const sim::HeadMesh& carrying, const QString& resource)
{
    constexpr float kMetresPerUnit = 1e-6F;
    constexpr float kNormalPerUnit = 1.0F / 8192.0F;
    const QString told = resource + QStringLiteral(".middles");
    if (!QFile::exists(told)) {
        std::vector<float> metres = builtInNumbers(resource + QStringLiteral(".displacement"));
        for (float& displacement : metres)
            displacement *= kMetresPerUnit;
        return sim::subdivided(carrying, metres);
    }
    const std::vector<float> numbers = builtInNumbers(told);
    std::vector<sim::MovedMiddle> middles;
    middles.reserve(numbers.size() / 6);
    for (std::size_t at = 0; at + 6 <= numbers.size(); at += 6)
        middles.push_back(
            {.offsetHd = kMetresPerUnit * glm::vec3(numbers[at], numbers[at + 1], numbers[at + 2]),
             .normalOffset = kNormalPerUnit * glm::vec3(numbers[at + 3], numbers[at + 4], numbers[at + 5])});
    return sim::subdivided(carrying, middles);
}

/// What is drawn of it: finer than what carries hair.
std::shared_ptr<const sim::HeadMesh> shownMesh(const sim::HeadMesh& carrying, std::vector<sim::SkinMarks> marks,
                                               const QString& resource)
{
    sim::HeadMesh shown = finerMesh(carrying, resource);
    shown.marks = std::move(marks);
    // The bust's foot is open; it is shown as if it were solid.
    return std::make_shared<const sim::HeadMesh>(sim::withOpeningsClosed(std::move(shown)));
}

std::shared_ptr<const Head> loadBuiltIn(const heads::HeadRow& row)
{
    registerHeads();
    auto head = std::make_shared<Head>();
    head->name = QString::fromUtf8(row.name);
    const QString resource = QStringLiteral(":/heads/") + head->name;
    const sim::HeadMesh mesh = builtInMesh(resource + QStringLiteral(".glb"));
    const std::vector<sim::SkinMarks> marks = builtInMarks(resource + QStringLiteral(".marks"));
    head->scalpFraction = row.scalpFraction;
    head->landmarks = row.landmarks;
    const auto makeSkin = [&] {
        sim::HeadMesh carrying = mesh;
        if (!marks.empty())
            carrying.marks.assign(marks.begin(),
                                  marks.begin() + static_cast<std::ptrdiff_t>(carrying.positionsHd.size()));
        head->skin = std::make_shared<const sim::Skin>(std::move(carrying));
        head->naturalDirection =
            sim::streamRaster(*head->skin, builtInStream(*head, resource + QStringLiteral(".stream")));
    };
    const auto makeShown = [&] {
        head->shownMesh = shownMesh(mesh, marks, resource);
        head->distances = builtInDistances(mesh, resource + QStringLiteral(".distances"));
    };
    // Every start waits for it: what carries hair and what is seen are made beside each other.
    sim::parallelFor(2, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t task = begin; task < end; ++task)
            task == 0 ? makeSkin() : makeShown();
    });
    return head;
}

std::shared_ptr<const Head> loaded(const heads::HeadRow& row)
{
    static std::mutex mutex;
    static std::map<const heads::HeadRow*, std::shared_ptr<const Head>> heads;
    const std::scoped_lock lock(mutex);
    std::shared_ptr<const Head>& head = heads[&row];
    if (!head)
        head = loadBuiltIn(row);
    return head;
}

/// Source space to Hd without scale; a rotation, so it serves normals too.
glm::vec3 turned(const glm::vec3& v, UpAxis upAxis)
{
    return upAxis == UpAxis::Y ? v : glm::vec3(v.x, v.z, -v.y);
}

/// Why a head of these bounds can't be used; nothing where it can.
std::optional<QString> problemOf(const sim::MeshBounds& bounds)
{
    constexpr float kSmallestM = 0.001F;
    constexpr float kLargestM = 100.0F;
    constexpr float kFarthestM = 1000.0F;
    const glm::vec3 size = bounds.size();
    const float largest = std::max({size.x, size.y, size.z});
    if (!(largest >= kSmallestM && largest <= kLargestM))
        return say(QT_TRANSLATE_NOOP("Files", "its head is %1 m large, and heads of 1 mm to 100 m can be used; choose "
                                              "another unit"))
            .arg(static_cast<double>(largest), 0, 'g', 3);
    // Further out floats are too coarse to tell hairs apart.
    const glm::vec3 reach = glm::max(glm::abs(bounds.least), glm::abs(bounds.greatest));
    const float farthest = std::max({reach.x, reach.y, reach.z});
    if (!(farthest <= kFarthestM))
        return say(QT_TRANSLATE_NOOP("Files", "its head stands %1 m from the scene's origin, and 1 km is the most; "
                                              "move it there in a 3D program"))
            .arg(static_cast<double>(farthest), 0, 'g', 3);
    return std::nullopt;
}

void append(sim::HeadMesh& whole, const sim::HeadMesh& part)
{
    const auto first = static_cast<std::uint32_t>(whole.positionsHd.size());
    const auto add = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    add(whole.positionsHd, part.positionsHd);
    add(whole.normalsHd, part.normalsHd);
    add(whole.uvs, part.uvs);
    for (const glm::uvec3& triangle : part.triangles)
        whole.triangles.push_back(triangle + first);
}

/// A file may have them at any position. Those that lie on the skin stay as they are, bit for bit.
void takeToSkin(sim::HeadLandmarks& landmarks, const sim::Skin& skin)
{
    const float tolerance = 1e-3F * glm::length(sim::boundsOf(skin.mesh()).size());
    for (glm::vec3& landmark : landmarks.positionsHd) {
        const glm::vec3 onSkin = skin.nearest(landmark).positionHd;
        if (glm::distance(onSkin, landmark) > tolerance)
            landmark = onSkin;
    }
}

/// Which part of a foreign head's skin corresponds to the built-in one's scalp.
double scalpFractionOf(const Head& head)
{
    constexpr std::size_t kMostFaces = 5000; // A percent of error is as good as none.
    const heads::HeadRow& row = *heads::headRows().front();
    const sim::Skin& known = *defaultHead()->skin;
    const sim::HeadWarp warp(*head.landmarks, row.landmarks);
    const std::size_t faces = head.skin->mesh().triangles.size();
    const std::size_t stride = faces / kMostFaces + 1;
    double scalpM2 = 0.0;
    double allM2 = 0.0;
    for (std::size_t face = 0; face < faces; face += stride) {
        const auto index = static_cast<std::uint32_t>(face);
        const auto areaM2 = static_cast<double>(head.skin->faceAreaM2(index));
        const glm::vec3 centre = head.skin->at(index, glm::vec3(1.0F / 3.0F)).positionHd;
        allM2 += areaM2;
        if (row.regions.scalpDistance(known.nearest(warp(centre)).positionHd) > 0.0F)
            scalpM2 += areaM2;
    }
    constexpr double kLeast = 0.01; // Below this fraction the scalp counts as not found.
    return scalpM2 > kLeast * allM2 ? scalpM2 / allM2 : 1.0;
}

} // namespace

std::shared_ptr<const Head> defaultHead()
{
    return loaded(*heads::headRows().front());
}

Checked<std::shared_ptr<const Head>> builtInHead(const QString& name)
{
    if (const heads::HeadRow* row = heads::findHeadRow(name.toStdString()))
        return loaded(*row);
    return refuse(say(QT_TRANSLATE_NOOP("Files", "its head '%1' is not known to this one")).arg(shownPath(name)),
                  Clause::Cure::NewerProgram);
}

std::vector<sim::Ellipsoid> builtInEllipsoids(const QString& name)
{
    const heads::HeadRow* named = heads::findHeadRow(name.toStdString());
    const heads::HeadRow* row = named != nullptr ? named : heads::headRows().front();
    return {row->colliders.begin(), row->colliders.end()};
}

std::vector<NamedHead> builtInHeads()
{
    std::vector<NamedHead> named;
    for (const heads::HeadRow* row : heads::headRows())
        named.push_back(
            {.name = QString::fromUtf8(row->name), .title = QCoreApplication::translate("Heads", row->title)});
    return named;
}

std::shared_ptr<const Head> withLandmarks(const Head& head, const sim::HeadLandmarks& landmarks)
{
    auto changed = std::make_shared<Head>(head);
    changed->landmarks = landmarks;
    takeToSkin(*changed->landmarks, *changed->skin);
    changed->scalpFraction = scalpFractionOf(*changed);
    changed->naturalDirection = naturalDirectionOf(*changed);
    return changed;
}

Checked<std::shared_ptr<const Head>> headFromGlb(const QString& name, const QByteArray& sourceGlb, float unitScale,
                                                 UpAxis upAxis, const std::function<bool()>& goesOn,
                                                 const std::optional<sim::HeadLandmarks>& landmarks)
{
    Checked<sim::HeadMesh> source = meshFromGlb(sourceGlb);
    if (!source)
        return tl::unexpected(source.error());
    if (const Checked<HeadSkeleton> skeleton = skeletonFromGlb(sourceGlb); !skeleton)
        return tl::unexpected(skeleton.error());
    Checked<GlbParts> parts = partsFromGlb(sourceGlb);
    if (!parts)
        return tl::unexpected(parts.error());
    sim::HeadMesh mesh = std::move(*source);
    const auto toHd = [&](sim::HeadMesh& own) {
        for (glm::vec3& p : own.positionsHd)
            p = turned(p, upAxis) * unitScale;
        for (glm::vec3& n : own.normalsHd)
            n = turned(n, upAxis);
    };
    toHd(mesh);
    sim::HeadMesh touched = mesh; // What hair collides with.
    for (HeadPart& part : parts->parts) {
        auto own = std::make_shared<sim::HeadMesh>(*part.mesh);
        toHd(*own);
        append(touched, *own);
        part.mesh = std::move(own);
    }
    if (const std::optional<QString> problem = problemOf(sim::boundsOf(mesh)))
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
    head->parts = std::move(parts->parts);
    head->texture = std::move(parts->first.texture);
    head->distances = sim::DistanceGrid::make(touched, [&goesOn](double) { return !goesOn || goesOn(); });
    const Head& known = *defaultHead();
    head->landmarks = landmarks ? landmarks
                                : sim::findLandmarks(*head->skin, *known.skin, *known.landmarks,
                                                     [&goesOn](double) { return !goesOn || goesOn(); });
    if (goesOn && !goesOn())
        return std::shared_ptr<const Head>();
    if (head->landmarks) {
        takeToSkin(*head->landmarks, *head->skin);
        head->scalpFraction = scalpFractionOf(*head);
    }
    head->naturalDirection = naturalDirectionOf(*head, goesOn);
    if (goesOn && !goesOn())
        return std::shared_ptr<const Head>();
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

Checked<HeadSkeleton> skeletonOf(const Head& head)
{
    if (head.sourceGlb.isEmpty())
        return HeadSkeleton{};
    Checked<HeadSkeleton> skeleton = skeletonFromGlb(head.sourceGlb);
    if (!skeleton || skeleton->empty())
        return skeleton;
    for (HeadJoint& joint : skeleton->joints)
        joint.translation *= head.unitScale;
    HeadJoint& root = skeleton->joints.front();
    root.translation = turned(root.translation, head.upAxis);
    const float half = std::sqrt(0.5F);
    if (head.upAxis == UpAxis::Z)
        root.rotation = glm::quat(half, -half, 0.0F, 0.0F) * root.rotation;
    return skeleton;
}

UvTiles tilesOf(const std::shared_ptr<const Head>& head)
{
    return head && !head->sourceGlb.isEmpty() ? tilesFromGlb(head->sourceGlb) : UvTiles();
}

} // namespace hairpaint::model
