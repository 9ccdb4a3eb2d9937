// Layers' images in an archive, and the budget of a whole file.
#include "model/files/layer_files.h"

#include "model/files/group_json.h"
#include "model/files/png_codec.h"
#include "model/files/project_json.h"
#include "model/files/zip_records.h"
#include "sim/base/parallel.h"

#include <QBuffer>

#include <algorithm>
#include <atomic>
#include <functional>
#include <map>
#include <set>
#include <utility>

namespace hairpaint::model {

namespace {

/// Enough for content_budget.h's texels if they are noise.
constexpr quint64 kMostImageBytes = 3 * (quint64{1} << 29U);

/// A layer of the project together with where its image lies.
struct StoredLayer
{
    MapStack* stack = nullptr;
    Layer* layer = nullptr;
    QString entry;
};

std::vector<StoredLayer> storedLayersOf(std::vector<HairGroup>& groups)
{
    std::vector<StoredLayer> storedLayers;
    for (HairGroup& group : groups)
        for (SharedStack& map : group.maps) {
            MapStack& stack = map.write();
            for (Layer& layer : stack.layers)
                storedLayers.push_back(
                    {.stack = &stack, .layer = &layer, .entry = layerEntryName(group, stack, layer)});
        }
    return storedLayers;
}

tl::unexpected<Clause> tooMuch()
{
    return refuse(say(QT_TRANSLATE_NOOP("Files", "its maps are larger than this program can hold; use fewer layers or "
                                                 "smaller maps")),
                  Clause::Cure::OtherFile);
}

/// What images that differ come to, the same for writing and reading; checked before any of them is decoded.
class ImageBudget
{
public:
    /// False where it is too much. Bytes that are known already count no more, whatever they are texels of.
    [[nodiscard]] bool take(int size, const QByteArray& png)
    {
        if (m_known.emplace(size, png).second) {
            m_texels += qint64{size} * size;
            m_bytes += static_cast<quint64>(png.size());
        }
        return m_texels <= kMostDistinctTexels && m_bytes <= kMostImageBytes;
    }

private:
    std::set<std::pair<int, QByteArray>> m_known;
    qint64 m_texels = 0;
    quint64 m_bytes = 0;
};

bool tooManyTexels(const std::vector<StoredLayer>& storedLayers)
{
    qint64 texels = 0;
    for (const StoredLayer& stored : storedLayers)
        texels += qint64{stored.stack->size} * stored.stack->size;
    return texels > kMostTexels;
}

/// Runs `work` over all items, several at once, and asks `progress` between. False where cancelled.
template<typename Item>
bool inBatches(std::vector<Item>& items, const Progress& progress, const std::function<void(Item&)>& work)
{
    std::vector<int> sizes(items.size());
    std::ranges::transform(items, sizes.begin(), &Item::size);
    for (std::size_t done = 0; done < items.size();) {
        if (progress && !progress(static_cast<double>(done) / static_cast<double>(items.size())))
            return false;
        const std::size_t count = batchLength(std::span(sizes).subspan(done));
        sim::parallelFor(count, 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                work(items[done + i]);
        });
        done += count;
    }
    return true;
}

/// A raster that several layers may have, and its bytes.
struct Encoding
{
    sim::TiledRaster raster;
    int size = 0;
    PngFile png;
};

/// An image that several layers may have. Equal checksums alone don't make images equal.
struct Decoding
{
    QByteArray png;
    QString entry;
    quint32 checksum = 0; ///< That the archive says.
    const MapSpec* spec = nullptr;
    int size = 0;
    std::vector<Layer*> layers;
    Checked<DecodedLayer> result = refuse({});
};

/// Every image once, with the layers it is for.
Checked<std::vector<Decoding>> collectImages(const ArchiveReader& archive, const std::vector<StoredLayer>& storedLayers)
{
    if (tooManyTexels(storedLayers))
        return tooMuch();
    std::vector<Decoding> images;
    ImageBudget budget;
    std::multimap<quint32, std::size_t> byChecksum;
    for (const StoredLayer& stored : storedLayers) {
        const int size = stored.stack->size;
        if (stored.layer->raster.size() == size)
            continue; // stands for a map that the file lacks
        Checked<QByteArray> png = archive.read(stored.entry, mostLayerBytes(size), ArchiveReader::Check::ByCaller);
        if (!png)
            return tl::unexpected(png.error());
        const MapSpec& spec = mapSpec(stored.stack->kind);
        const quint32 checksum = archive.checksum(stored.entry);
        const auto [first, last] = byChecksum.equal_range(checksum);
        const auto known = std::find_if(first, last, [&](const auto& candidate) {
            const Decoding& image = images[candidate.second];
            return image.size == size && image.spec->texel == spec.texel && image.png == *png;
        });
        if (known != last) {
            images[known->second].layers.push_back(stored.layer);
            continue;
        }
        if (!budget.take(size, *png))
            return tooMuch();
        byChecksum.emplace(checksum, images.size());
        images.push_back({.png = std::move(*png),
                          .entry = stored.entry,
                          .checksum = checksum,
                          .spec = &spec,
                          .size = size,
                          .layers = {stored.layer}});
    }
    return images;
}

/// With the archive's checksum, which follows from the image's own.
Checked<DecodedLayer> decodeChecked(const Decoding& image)
{
    Checked<DecodedLayer> layer = decodeLayer(image.png, *image.spec, image.size);
    if ((layer ? layer->checksum : checksumOf(image.png)) != image.checksum)
        return brokenEntry(image.entry);
    return layer;
}

Checked<void> checkMimetype(const ArchiveReader& archive, const QByteArray& mimetype)
{
    const Checked<QByteArray> found = archive.read(QStringLiteral("mimetype"), kMostMimetypeBytes);
    if (!found)
        return refuse(say(QT_TRANSLATE_NOOP("Files", "it is not a file of Hair Paint; choose another")),
                      Clause::Cure::OtherFile);
    if (*found != mimetype)
        return refuse(say(QT_TRANSLATE_NOOP("Files", "it is a file of another kind (%1); choose another"))
                          .arg(shownPath(QString::fromLatin1(found->left(60)))),
                      Clause::Cure::OtherFile);
    return {};
}

} // namespace

std::size_t batchLength(std::span<const int> sizes)
{
    constexpr int kLargestTogether = 2048;
    const auto large = std::ranges::find_if(sizes, [](int size) { return size > kLargestTogether; });
    const auto before = static_cast<std::size_t>(large - sizes.begin());
    return std::clamp(before, std::size_t{1}, static_cast<std::size_t>(sim::threadCount()));
}

void addMimetype(ArchiveWriter& archive, const QByteArray& mimetype)
{
    archive.add("mimetype", mimetype, ArchiveWriter::Method::Stored);
}

Result<OpenedArchive> openArchive(const QString& path, const QByteArray& mimetype)
{
    if (Result<void> readable = checkReadable(path, kMostFileBytes); !readable)
        return tl::unexpected(readable.error());
    Checked<ArchiveReader> archive = ArchiveReader::open(path);
    if (!archive)
        return cannotOpen(path, archive.error());
    if (Checked<void> kind = checkMimetype(*archive, mimetype); !kind)
        return cannotOpen(path, kind.error());
    Checked<QByteArray> json = archive->read(QStringLiteral("project.json"), kMostJsonBytes);
    if (!json)
        return cannotOpen(path, json.error());
    return OpenedArchive{.archive = std::move(*archive), .json = std::move(*json)};
}

Checked<bool> addLayers(ArchiveWriter& archive, const std::vector<HairGroup>& groups, EncodedLayers& cache,
                        const Progress& progress)
{
    std::vector<HairGroup> copies = groups; // shares every tile
    const std::vector<StoredLayer> storedLayers = storedLayersOf(copies);
    std::vector<Encoding> missing;
    EncodedLayers seen;
    for (const StoredLayer& stored : storedLayers) {
        const sim::TiledRaster& raster = stored.layer->raster;
        if (cache.find(raster) || seen.find(raster))
            continue;
        seen.insert(raster, {});
        missing.push_back({.raster = raster, .size = raster.size(), .png = {}});
    }
    if (excessOf(groups) != ContentExcess::None)
        return tooMuch();
    if (!inBatches<Encoding>(missing, progress, [&cache](Encoding& one) {
            const std::optional<EncodedLayer> former = cache.nearest(one.raster);
            one.png = encodeLayer(one.raster, former ? &*former : nullptr);
        }))
        return false;
    for (const Encoding& one : missing)
        cache.insert(one.raster, one.png);
    ImageBudget budget;
    bool fits = true;
    for (const StoredLayer& stored : storedLayers) {
        const PngFile png = cache.find(stored.layer->raster).value_or(PngFile());
        fits = fits && budget.take(stored.stack->size, png.bytes);
        archive.add(stored.entry.toLatin1(), png.bytes, ArchiveWriter::Method::Stored, png.checksum);
    }
    cache.dropUnused();
    if (!fits)
        return tooMuch();
    return true;
}

Checked<bool> readLayers(const ArchiveReader& archive, std::vector<HairGroup>& groups, EncodedLayers& cache,
                         const Progress& progress)
{
    const std::vector<StoredLayer> storedLayers = storedLayersOf(groups);
    Checked<std::vector<Decoding>> images = collectImages(archive, storedLayers);
    if (!images)
        return tl::unexpected(images.error());
    std::atomic<std::size_t> heldBytes = 0;
    const bool finished = inBatches<Decoding>(*images, progress, [&heldBytes](Decoding& image) {
        image.result = heldBytes > kMostHeldBytes ? Checked<DecodedLayer>(tooMuch()) : decodeChecked(image);
        if (image.result && (heldBytes += image.result->raster.byteCount()) > kMostHeldBytes)
            image.result = Checked<DecodedLayer>(tooMuch());
    });
    if (!finished)
        return false;
    for (const Decoding& image : *images) {
        if (!image.result)
            return tl::unexpected(image.result.error());
        for (Layer* layer : image.layers)
            layer->raster = image.result->raster;
        if (image.result->ours)
            cache.insert(image.result->raster, {.bytes = image.png, .checksum = image.checksum, .stored = {}});
    }
    // Layers of one image, and those of maps that the file lacks, count as they do when it is edited and saved.
    if (excessOf(groups) != ContentExcess::None)
        return tooMuch();
    return true;
}

void addThumbnail(ArchiveWriter& archive, const QImage& picture)
{
    if (picture.isNull())
        return;
    QImage small = picture.convertToFormat(QImage::Format_ARGB32);
    if (std::max(small.width(), small.height()) > kLargestThumbnail)
        small = small.scaled(kLargestThumbnail, kLargestThumbnail, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    if (small.save(&buffer, "png"))
        archive.add("thumbnail.png", bytes, ArchiveWriter::Method::Stored);
}

QImage readThumbnail(const ArchiveReader& archive)
{
    const Checked<QByteArray> bytes = archive.read(QStringLiteral("thumbnail.png"), kMostThumbnailBytes);
    if (!bytes)
        return {};
    return decodePicture(*bytes, kLargestThumbnail);
}

} // namespace hairpaint::model
