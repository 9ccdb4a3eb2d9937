// Archive, JSON, layers, head: each as far as it goes.
#include "model/repair/project_repair.h"

#include "model/files/glb.h"
#include "model/files/group_json.h"
#include "model/files/head_file.h"
#include "model/files/layer_files.h"
#include "model/files/own_mesh_file.h"
#include "model/files/png_codec.h"
#include "model/files/png_reader.h"
#include "model/files/project_file.h"
#include "model/files/project_json.h"
#include "model/project/content_budget.h"
#include "model/repair/orphaned_layers.h"
#include "model/repair/salvaged_archive.h"

#include <QFileInfo>
#include <QJsonDocument>

#include <bit>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace hairpaint::model {

namespace {

constexpr qint64 kMostSalvagedHeadBytes = 256 << 20;

tl::unexpected<Clause> nothingLeft()
{
    return refuse(say(QT_TRANSLATE_NOOP("Files", "nothing of a project could be found in it; try an earlier copy of "
                                                 "it")),
                  Clause::Cure::OtherFile);
}

/// How far a repair is, and whether it goes on: once stopped, never again.
class RepairProgress
{
public:
    /// Fractions of the whole repair that are done once the file was tried for damage, its entries are found and its
    /// layers are read.
    static constexpr double kTried = 0.4;
    static constexpr double kFound = 0.5;
    static constexpr double kLayers = 0.9;

    explicit RepairProgress(const Progress& progress) : m_progress(progress) {}
    [[nodiscard]] bool advance(double done)
    {
        m_done = done;
        return goesOn();
    }
    [[nodiscard]] bool goesOn()
    {
        m_isStopped = m_isStopped || (m_progress && !m_progress(m_done));
        return !m_isStopped;
    }

private:
    const Progress& m_progress;
    double m_done = 0.0;
    bool m_isStopped = false;
};

class Repair
{
public:
    Repair(SalvagedArchive archive, RepairProgress& progress) : m_archive(std::move(archive)), m_progress(progress) {}

    /// None where it was stopped.
    Checked<std::optional<RepairedProject>> run()
    {
        if (Checked<void> kind = checkKind(); !kind)
            return tl::unexpected(kind.error());
        Checked<ProjectManifest> manifest = readManifest();
        if (!manifest)
            return tl::unexpected(manifest.error());
        Project& project = manifest->project;
        if (Checked<void> layers = readLayers(project.groups); !layers)
            return tl::unexpected(layers.error());
        if (Checked<void> head = readHead(*manifest); !head)
            return tl::unexpected(head.error());
        readMeshes(project);
        const auto goesOn = [this] { return m_progress.goesOn(); };
        if (!goesOn() || project.head == nullptr || !paintFormerCombing(project, manifest->formerCombing, goesOn))
            return std::nullopt;
        if (m_isEmpty && m_json.root.isEmpty())
            return nothingLeft();
        return RepairedProject{.project = std::move(project), .losses = m_losses.sentences()};
    }

private:
    [[nodiscard]] Checked<void> checkKind()
    {
        const std::optional<SalvagedArchive::Content> type =
            m_archive.read(QStringLiteral("mimetype"), kMostMimetypeBytes);
        if (type && type->whole && type->bytes != "application/x-hairpaint")
            return refuse(say(QT_TRANSLATE_NOOP("Files", "it is a file of another kind (%1); choose another"))
                              .arg(shownPath(QString::fromLatin1(type->bytes.left(60)))),
                          Clause::Cure::OtherFile);
        return {};
    }

    [[nodiscard]] Checked<ProjectManifest> readManifest()
    {
        const std::optional<SalvagedArchive::Content> json =
            m_archive.read(QStringLiteral("project.json"), kMostJsonBytes);
        if (json) {
            m_json = jsonAsFarAsItGoes(json->bytes);
            Checked<ProjectManifest> manifest = projectFromJson(json->bytes);
            if (json->whole && (manifest || manifest.error().cure == Clause::Cure::NewerProgram))
                return manifest;
            if (!json->whole && !m_json.root.isEmpty())
                m_losses.unproven();
        }
        const SizeOfLayer sizeOfLayer = [this](Id group, const QString& map, Id layer) {
            return sizeOf(group, map, layer);
        };
        QJsonObject root = mendedJson(m_json, sizeOfLayer, m_losses);
        if (!json || !json->whole)
            adoptOrphans(root, m_archive.names(), sizeOfLayer, m_losses);
        if (root.value(QLatin1StringView("groups")).toArray().isEmpty())
            return nothingLeft();
        m_headIsNamed = root.value(QLatin1StringView("head")) == m_json.root.value(QLatin1StringView("head"));
        return projectFromJson(QJsonDocument(root).toJson());
    }

    [[nodiscard]] int sizeOf(Id group, const QString& map, Id layer)
    {
        constexpr qint64 kHeaderBytes = 64;
        const std::optional<SalvagedArchive::Content> start =
            m_archive.read(QStringLiteral("groups/%1/%2/%3.png").arg(group).arg(map).arg(layer), kHeaderBytes);
        const std::optional<PngParts> header = start ? readPngHeader(start->bytes) : std::nullopt;
        const bool isSize = header && header->width >= static_cast<quint32>(sim::TiledRaster::kSmallestSize) &&
                            header->width <= static_cast<quint32>(sim::TiledRaster::kLargestSize) &&
                            std::has_single_bit(header->width);
        return isSize ? static_cast<int>(header->width) : 0;
    }

    [[nodiscard]] Checked<void> readLayers(std::vector<HairGroup>& groups)
    {
        qint64 texels = 0;
        for (const HairGroup& group : groups)
            for (const MapStack& stack : group.maps)
                texels += qint64{stack.size} * stack.size * static_cast<qint64>(stack.layers.size());
        qint64 read = 0;
        const auto doneWith = [&](const MapStack& stack) {
            read += qint64{stack.size} * stack.size;
            return std::lerp(RepairProgress::kFound, RepairProgress::kLayers,
                             static_cast<double>(read) / static_cast<double>(texels));
        };
        for (HairGroup& group : groups)
            for (SharedStack& map : group.maps)
                for (Layer& layer : map.write().layers) {
                    if (texels > kMostTexels || !readLayer(group, *map, layer))
                        return tooMuch();
                    if (!m_progress.advance(doneWith(*map)))
                        return {};
                }
        if (excessOf(groups) != ContentExcess::None)
            return tooMuch();
        return {};
    }

    [[nodiscard]] static tl::unexpected<Clause> tooMuch()
    {
        return refuse(say(QT_TRANSLATE_NOOP("Files", "its maps are larger than this program can hold; use fewer layers "
                                                     "or smaller maps")),
                      Clause::Cure::OtherFile);
    }

    /// False where it is too much.
    [[nodiscard]] bool readLayer(const HairGroup& group, const MapStack& stack, Layer& layer)
    {
        if (layer.raster.size() == stack.size)
            return true; // It stands for a map that the file lacks.
        const MapSpec& spec = mapSpec(stack.kind);
        const QString title = group.name.isEmpty() ? QString::number(group.id) : group.name;
        const std::optional<SalvagedArchive::Content> png =
            m_archive.read(layerEntryName(group, stack, layer), mostLayerBytes(stack.size));
        if (!png) {
            layer.raster = emptyRaster(spec, stack.size);
            m_losses.layer(title, spec, layer.name);
            return true;
        }
        const std::tuple key(stack.size, spec.texel, png->bytes);
        auto known = m_known.find(key);
        if (known == m_known.end()) {
            m_texels += qint64{stack.size} * stack.size;
            if (m_texels > kMostDistinctTexels)
                return false;
            known = m_known.emplace(key, decoded(png->bytes, spec, stack.size)).first;
            m_heldBytes += known->second.raster.byteCount();
            if (m_heldBytes > kMostHeldBytes)
                return false;
        }
        layer.raster = known->second.raster;
        m_isEmpty = m_isEmpty && known->second.rows == 0;
        if (known->second.rows == 0)
            m_losses.layer(title, spec, layer.name);
        else if (known->second.rows < stack.size)
            m_losses.layerRows(title, spec, layer.name, known->second.rows, stack.size);
        return true;
    }

    [[nodiscard]] static SalvagedLayer decoded(const QByteArray& png, const MapSpec& spec, int size)
    {
        // An image proves itself by checksums of its own.
        if (Checked<DecodedLayer> whole = decodeLayer(png, spec, size))
            return {.raster = std::move(whole->raster), .rows = size};
        return salvageLayer(png, spec, size);
    }

    /// Null where it was stopped.
    [[nodiscard]] Checked<void> readHead(ProjectManifest& manifest)
    {
        const std::optional<SalvagedArchive::Content> glb =
            m_archive.read(QStringLiteral("head.glb"), kMostSalvagedHeadBytes);
        HeadReference& reference = manifest.head;
        Checked<std::shared_ptr<const Head>> head = nothingLeft();
        if (!m_headIsNamed && glb) {
            if (const Checked<sim::HeadMesh> mesh = meshFromGlb(glb->bytes)) {
                RiggedMesh source(*mesh);
                source.skeleton = skeletonFromGlb(glb->bytes).value_or(HeadSkeleton{});
                const HeadGuess guess = guessHead(source);
                reference = {.name = QStringLiteral("head"),
                             .builtIn = false,
                             .unitScale = guess.unitScale,
                             .upAxis = guess.upAxis};
                m_losses.setting(QStringLiteral("head"));
            }
        }
        if (reference.builtIn && m_headIsNamed)
            head = builtInHead(reference.name);
        else if (!reference.builtIn && glb)
            head = headFromGlb(
                reference.name, glb->bytes, reference.unitScale, reference.upAxis,
                [this] { return m_progress.goesOn(); }, reference.landmarks);
        if (!head) {
            m_losses.head(m_headIsNamed ? reference.name : QString());
            manifest.project.setShapesOfHead(builtInEllipsoids());
            head = defaultHead();
        }
        manifest.project.head = std::move(*head);
        return {};
    }

    /// Takes away what was worn of meshes that are lost.
    void readMeshes(Project& project)
    {
        const auto bytesOf = [this](int number) -> Checked<QByteArray> {
            const std::optional<SalvagedArchive::Content> glb =
                m_archive.read(ownMeshEntryName(number), kMostOwnMeshBytes);
            return glb ? Checked<QByteArray>(glb->bytes) : nothingLeft();
        };
        std::vector<Worn> found;
        for (const Worn& one : project.worn) {
            std::vector<Worn> alone{one};
            if (readOwnMeshes(alone, bytesOf))
                found.push_back(std::move(alone.front()));
            else
                m_losses.ownMesh(one.ownMesh.own->name);
        }
        project.worn = std::move(found);
    }

    SalvagedArchive m_archive;
    RepairProgress& m_progress;
    Losses m_losses;
    CutJson m_json;
    bool m_headIsNamed = true; ///< By the JSON.
    bool m_isEmpty = true;     ///< No layer had anything.
    std::map<std::tuple<int, TexelKind, QByteArray>, SalvagedLayer> m_known;
    qint64 m_texels = 0;
    std::size_t m_heldBytes = 0;
};

Result<RepairedProject> repaired(const QString& path, const Progress& progress)
{
    // What is whole has lost nothing, whatever the headers look like.
    RepairProgress repairProgress(progress);
    if (Result<Project> whole = loadProject(path, nullptr, [&repairProgress](double done) {
            return repairProgress.advance(RepairProgress::kTried * done);
        }))
        return RepairedProject{.project = std::move(*whole), .losses = {}};
    if (Result<void> readable = checkReadable(path, kMostFileBytes); !readable)
        return tl::unexpected(readable.error());
    if (!repairProgress.advance(RepairProgress::kTried))
        return cancelled(path);
    Checked<SalvagedArchive> archive =
        SalvagedArchive::open(path, [&repairProgress] { return repairProgress.goesOn(); });
    if (!archive)
        return cannotOpen(path, archive.error());
    if (!repairProgress.advance(RepairProgress::kFound))
        return cancelled(path);
    Checked<std::optional<RepairedProject>> project = Repair(std::move(*archive), repairProgress).run();
    if (!project)
        return cannotOpen(path, project.error());
    if (!*project)
        return cancelled(path);
    return std::move(**project);
}

} // namespace

Result<RepairedProject> repairProject(const QString& path, const Progress& progress)
{
    return withinMemory(path, cannotOpen, [&] { return repaired(path, progress); });
}

} // namespace hairpaint::model
