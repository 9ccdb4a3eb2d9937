// Presets to files and back, and the library of them.
#include "model/files/preset_file.h"

#include "model/files/group_json.h"
#include "model/files/head_entry.h"
#include "model/files/layer_files.h"
#include "model/files/own_mesh_file.h"
#include "model/files/project_json.h"
#include "model/project/worn_on_ties.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <map>
#include <utility>

/// Resources of a static library are registered on request; the macro must stand outside every namespace.
static void initPresetResources() // NOLINT(misc-use-anonymous-namespace)
{
    Q_INIT_RESOURCE(presets);
}

namespace hairpaint::model {

namespace {

const QByteArray kPresetMimetype = QByteArrayLiteral("application/x-hairpaint-preset");
const QString kBuiltInFolder = QStringLiteral(":/presets");

/// The archive and its JSON, the maps unread.
struct OpenedPreset
{
    ArchiveReader archive;
    Preset preset;
    HeadReference head;
};

Result<OpenedPreset> openPreset(const QString& path)
{
    Result<OpenedArchive> opened = openArchive(path, kPresetMimetype);
    if (!opened)
        return tl::unexpected(opened.error());
    Checked<PresetManifest> manifest = presetFromJson(opened->json);
    if (!manifest)
        return cannotOpen(path, manifest.error());
    Preset& preset = manifest->preset;
    if (preset.name.isEmpty())
        preset.name = QFileInfo(path).completeBaseName();
    preset.folder = path.startsWith(QLatin1Char(':')) ? QString() : path;
    preset.picture = readThumbnail(opened->archive);
    return OpenedPreset{
        .archive = std::move(opened->archive), .preset = std::move(preset), .head = std::move(manifest->head)};
}

Result<Preset> read(const QString& path)
{
    Result<OpenedPreset> opened = openPreset(path);
    if (!opened)
        return tl::unexpected(opened.error());
    Checked<std::shared_ptr<const Head>> head = readHead(opened->archive, opened->head);
    if (!head)
        return cannotOpen(path, head.error());
    opened->preset.head = std::move(*head);
    if (Checked<void> meshes = readOwnMeshes(opened->preset.worn, opened->archive); !meshes)
        return cannotOpen(path, meshes.error());
    EncodedLayers cache;
    const Checked<bool> layers = readLayers(opened->archive, opened->preset.groups, cache, {});
    if (!layers)
        return cannotOpen(path, layers.error());
    return std::move(opened->preset);
}

Result<void> write(const Preset& preset, const QString& path, const Progress& progress)
{
    const Checked<QByteArray> json = presetToJson(preset);
    if (!json)
        return cannotWrite(path, json.error());
    ArchiveWriter archive;
    addMimetype(archive, kPresetMimetype);
    archive.add("project.json", *json, ArchiveWriter::Method::Deflated);
    addHead(archive, preset.head);
    addOwnMeshes(archive, preset.worn);
    EncodedLayers cache;
    if (Checked<bool> added = addLayers(archive, preset.groups, cache, {}); !added)
        return cannotWrite(path, added.error());
    addThumbnail(archive, preset.picture);
    const Checked<bool> written = archive.writeTo(path, [&progress] { return !progress || progress(1.0); });
    if (!written)
        return cannotWrite(path, written.error());
    return *written ? Result<void>() : cancelled(path);
}

} // namespace

QStringList builtInPresets()
{
    initPresetResources();
    const QDir folder(kBuiltInFolder);
    QStringList names = folder.entryList({QStringLiteral("*.hairpreset")}, QDir::Files, QDir::Name);
    QStringList ordered;
    QFile order(folder.filePath(QStringLiteral("order.txt")));
    if (order.open(QIODevice::ReadOnly))
        for (const QByteArray& line : order.readAll().split('\n')) {
            const QString name = QString::fromUtf8(line.trimmed()) + QStringLiteral(".hairpreset");
            if (names.removeOne(name))
                ordered.append(name);
        }
    ordered.append(names);
    for (QString& name : ordered)
        name = folder.filePath(name);
    return ordered;
}

Result<Preset> loadPreset(const QString& path)
{
    initPresetResources();
    return withinMemory(path, cannotOpen, [&path] { return read(path); });
}

Result<void> savePreset(const Preset& preset, const QString& path, const Progress& progress)
{
    return withinMemory(path, cannotWrite, [&] {
        Id nextId = 1;
        if (idsFit(preset.groups, nextId))
            return write(preset, path, progress);
        Preset renumbered = preset;
        renumber(renumbered.groups, nextId);
        std::map<Id, Id> ids;
        for (Worn& one : renumbered.worn) {
            const auto group = std::ranges::find(preset.groups, one.group, &HairGroup::id);
            one.group = renumbered.groups[static_cast<std::size_t>(group - preset.groups.begin())].id;
            const Id id = nextId++;
            ids.emplace(std::exchange(one.id, id), id);
        }
        renameTies(renumbered.worn, ids);
        return write(renumbered, path, progress);
    });
}

Result<PresetEntry> presetEntry(const QString& path)
{
    initPresetResources();
    return withinMemory(path, cannotOpen, [&path]() -> Result<PresetEntry> {
        const Result<OpenedPreset> opened = openPreset(path);
        if (!opened)
            return tl::unexpected(opened.error());
        const Preset& preset = opened->preset;
        return PresetEntry{.path = path,
                           .name = preset.name,
                           .tags = preset.tags,
                           .folder =
                               path.startsWith(QLatin1Char(':')) ? QStringLiteral("built-in") : QStringLiteral("own"),
                           .picture = preset.picture};
    });
}

std::vector<PresetEntry> listPresets(const QString& ownFolder, QStringList* problems)
{
    std::vector<PresetEntry> entries;
    const auto add = [&](const QString& path) {
        Result<PresetEntry> entry = presetEntry(path);
        if (entry)
            entries.push_back(std::move(*entry));
        else if (problems != nullptr)
            problems->append(entry.error().message);
    };
    for (const QString& path : builtInPresets())
        add(path);
    const auto firstOwn = static_cast<std::ptrdiff_t>(entries.size());
    const QDir own(ownFolder);
    if (!ownFolder.isEmpty())
        for (const QString& name : own.entryList({QStringLiteral("*.hairpreset")}, QDir::Files, QDir::Name))
            add(own.filePath(name));
    std::stable_sort(entries.begin() + firstOwn, entries.end(), [](const PresetEntry& a, const PresetEntry& b) {
        return a.name.compare(b.name, Qt::CaseInsensitive) < 0;
    });
    return entries;
}

} // namespace hairpaint::model
