// The texels of groups in an archive: what projects and presets have in common.
// Errors: clauses for a sentence of sentences.h.
#pragma once

#include "model/files/archive.h"
#include "model/files/encoded_layers.h"
#include "model/files/project_file.h"

#include <span>

namespace hairpaint::model {

inline constexpr qint64 kMostFileBytes = (qint64{1} << 32) - 1;
inline constexpr qint64 kMostMimetypeBytes = 64;
inline constexpr qint64 kMostThumbnailBytes = 8 << 20;
inline constexpr int kLargestThumbnail = 1024;

/// Archives of this kind say so in their first entry.
void addMimetype(ArchiveWriter& archive, const QByteArray& mimetype);

/// An archive of the wanted kind and its project.json, the maps unread.
struct OpenedArchive
{
    ArchiveReader archive;
    QByteArray json;
};
[[nodiscard]] Result<OpenedArchive> openArchive(const QString& path, const QByteArray& mimetype);

/// How many images are worked on at once, from the first one on: large ones would take too much memory together.
/// `sizes`: texels a side, one or more.
[[nodiscard]] std::size_t batchLength(std::span<const int> sizes);

/// Adds every layer's image, encoding those that `cache` does not know. False where `progress` cancels.
[[nodiscard]] Checked<bool> addLayers(ArchiveWriter& archive, const std::vector<HairGroup>& groups,
                                      EncodedLayers& cache, const Progress& progress);
/// Reads the texels of groups from groupsFromJson. Checks the whole file's budget first. False where cancelled.
[[nodiscard]] Checked<bool> readLayers(const ArchiveReader& archive, std::vector<HairGroup>& groups,
                                       EncodedLayers& cache, const Progress& progress);

void addThumbnail(ArchiveWriter& archive, const QImage& picture);
/// Null where there is none or it is broken.
[[nodiscard]] QImage readThumbnail(const ArchiveReader& archive);

} // namespace hairpaint::model
