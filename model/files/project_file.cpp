// Projects to files and back.
#include "model/files/project_file.h"

#include "model/files/group_json.h"
#include "model/files/head_entry.h"
#include "model/files/head_file.h"
#include "model/files/layer_files.h"
#include "model/files/own_mesh_file.h"
#include "model/files/project_json.h"
#include "model/project/worn_on_ties.h"

#include <QCoreApplication>

#include <algorithm>
#include <map>
#include <utility>

namespace hairpaint::model {

namespace {

const QByteArray kProjectMimetype = QByteArrayLiteral("application/x-hairpaint");
Result<Project> read(const QString& path, EncodedLayers& cache, const Progress& progress)
{
    const Result<OpenedArchive> opened = openArchive(path, kProjectMimetype);
    if (!opened)
        return tl::unexpected(opened.error());
    Checked<ProjectManifest> manifest = projectFromJson(opened->json);
    if (!manifest)
        return cannotOpen(path, manifest.error());
    double done = 0.0;
    const Checked<bool> layers = readLayers(opened->archive, manifest->project.groups, cache, [&](double fraction) {
        done = fraction;
        return !progress || progress(fraction);
    });
    if (!layers)
        return cannotOpen(path, layers.error());
    if (!*layers)
        return cancelled(path);
    Checked<std::shared_ptr<const Head>> head =
        readHead(opened->archive, manifest->head, [&] { return !progress || progress(done); });
    if (!head)
        return cannotOpen(path, head.error());
    if (*head == nullptr)
        return cancelled(path);
    manifest->project.head = std::move(*head);
    if (Checked<void> meshes = readOwnMeshes(manifest->project.worn, opened->archive); !meshes)
        return cannotOpen(path, meshes.error());
    if (!paintFormerCombing(manifest->project, manifest->formerCombing, [&] { return !progress || progress(done); }))
        return cancelled(path);
    return std::move(manifest->project);
}

Result<void> write(const Project& project, const QString& path, const QImage& thumbnail, EncodedLayers& cache,
                   const Progress& progress)
{
    const Checked<QByteArray> json = projectToJson(project);
    if (!json)
        return cannotWrite(path, json.error());
    ArchiveWriter archive;
    addMimetype(archive, kProjectMimetype);
    archive.add("project.json", *json, ArchiveWriter::Method::Deflated);
    addHead(archive, project.head);
    addOwnMeshes(archive, project.worn);
    double done = 0.0;
    const Checked<bool> added = addLayers(archive, project.groups, cache, [&](double fraction) {
        done = fraction;
        return !progress || progress(fraction);
    });
    if (!added)
        return cannotWrite(path, added.error());
    if (!*added)
        return cancelled(path);
    addThumbnail(archive, thumbnail);
    const Checked<bool> written = archive.writeTo(path, [&] { return !progress || progress(done); });
    if (!written)
        return cannotWrite(path, written.error());
    if (!*written)
        return cancelled(path);
    return {};
}

} // namespace

Result<Project> loadProject(const QString& path, EncodedLayers* cache, const Progress& progress)
{
    EncodedLayers ownCache;
    return withinMemory(path, cannotOpen, [&] { return read(path, cache != nullptr ? *cache : ownCache, progress); });
}

Result<void> saveProject(const Project& project, const QString& path, const QImage& thumbnail, EncodedLayers* cache,
                         const Progress& progress)
{
    EncodedLayers ownCache;
    EncodedLayers& encoded = cache != nullptr ? *cache : ownCache;
    return withinMemory(path, cannotWrite, [&] {
        if (idsFit(project.groups, project.nextId))
            return write(project, path, thumbnail, encoded, progress);
        Project renumbered = project;
        renumber(renumbered.groups, renumbered.nextId);
        std::map<Id, Id> ids;
        for (Worn& one : renumbered.worn) {
            const Id id = renumbered.takeId();
            ids.emplace(std::exchange(one.id, id), id);
            const auto group = std::ranges::find(project.groups, one.group, &HairGroup::id);
            one.group = group == project.groups.end()
                            ? 0
                            : renumbered.groups[static_cast<std::size_t>(group - project.groups.begin())].id;
        }
        renameTies(renumbered.worn, ids);
        return write(renumbered, path, thumbnail, encoded, progress);
    });
}

Project newProject()
{
    Project project;
    project.maxHairs = kMostHairs; // A file that does not say has a smaller limit.
    project.head = defaultHead();
    project.groups.push_back(makeGroup(project, QStringLiteral("Scalp")));
    project.setShapesOfHead(builtInEllipsoids());
    return project;
}

} // namespace hairpaint::model
