// Layers' images in an archive, and the budget of a whole file.
#include "model/files/layer_files.h"

#include "model/files/group_json.h"
#include "model/files/png_codec.h"

#include <QBuffer>
#include <QImageReader>

#include <algorithm>
#include <map>
#include <set>

namespace hairpaint::model {

namespace {

// Budgets of a whole file.
constexpr qint64 kMostDistinctTexels = qint64{1} << 29;
constexpr qint64 kMostTexels = qint64{1} << 32;
constexpr std::size_t kMostHeldBytes = std::size_t{1} << 30U;

/// A layer of the project together with where its image lies.
struct Place
{
    MapStack* stack = nullptr;
    Layer* layer = nullptr;
    QString entry;
};

std::vector<Place> placesOf(std::vector<HairGroup>& groups)
{
    std::vector<Place> places;
    for (HairGroup& group : groups)
        for (MapStack& stack : group.maps)
            for (Layer& layer : stack.layers)
                places.push_back({.stack = &stack, .layer = &layer, .entry = layerEntryName(group, stack, layer)});
    return places;
}

tl::unexpected<Clause> tooMuch()
{
    return refuse(say(QT_TRANSLATE_NOOP("Files", "its maps are larger than this program can hold; use fewer layers or "
                                                 "smaller maps")));
}

Checked<void> checkBudget(const ArchiveReader& archive, const std::vector<Place>& places)
{
    qint64 texels = 0;
    qint64 distinctTexels = 0;
    std::set<std::pair<quint32, int>> seen;
    for (const Place& place : places) {
        if (!archive.contains(place.entry))
            continue;
        const qint64 count = qint64{place.stack->size} * place.stack->size;
        texels += count;
        if (seen.emplace(archive.checksum(place.entry), place.stack->size).second)
            distinctTexels += count;
    }
    if (texels > kMostTexels || distinctTexels > kMostDistinctTexels)
        return tooMuch();
    return {};
}

/// Decoded images by their bytes, so that the many equal ones (empty layers) are decoded once.
class ImagePool
{
public:
    Checked<sim::TiledRaster> take(const QByteArray& png, const MapSpec& spec, int size, EncodedLayers& cache)
    {
        const Key key{png, spec.texel};
        const auto known = m_rasters.find(key);
        if (known != m_rasters.end())
            return known->second;
        Checked<DecodedLayer> layer = decodeLayer(png, spec, size);
        if (!layer)
            return tl::unexpected(layer.error());
        m_heldBytes += layer->raster.byteCount();
        if (m_heldBytes > kMostHeldBytes)
            return tooMuch();
        if (layer->ours)
            cache.insert(layer->raster, png);
        return m_rasters.emplace(key, layer->raster).first->second;
    }

private:
    using Key = std::pair<QByteArray, TexelKind>;
    std::map<Key, sim::TiledRaster> m_rasters;
    std::size_t m_heldBytes = 0;
};

} // namespace

void addMimetype(ArchiveWriter& archive, const QByteArray& mimetype)
{
    archive.add("mimetype", mimetype, ArchiveWriter::Method::Stored);
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

Checked<bool> addLayers(ArchiveWriter& archive, const std::vector<HairGroup>& groups, EncodedLayers& cache,
                        const Progress& progress)
{
    std::vector<HairGroup> copies = groups; // shares every tile
    const std::vector<Place> places = placesOf(copies);
    std::size_t heldBytes = 0;
    qint64 texels = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (progress && !progress(static_cast<double>(i) / static_cast<double>(places.size())))
            return false;
        const sim::TiledRaster& raster = places[i].layer->raster;
        std::optional<QByteArray> bytes = cache.find(raster);
        if (!bytes) {
            bytes = encodeLayer(raster);
            if (bytes->isEmpty())
                return refuse(say(QT_TRANSLATE_NOOP("Files", "there is not enough memory to encode its maps")));
            cache.insert(raster, *bytes);
        }
        heldBytes += raster.byteCount();
        texels += qint64{raster.size()} * raster.size();
        if (texels > kMostTexels || heldBytes > kMostHeldBytes)
            return tooMuch();
        archive.add(places[i].entry.toLatin1(), *bytes, ArchiveWriter::Method::Stored);
    }
    cache.dropUnused();
    return true;
}

Checked<bool> readLayers(const ArchiveReader& archive, std::vector<HairGroup>& groups, EncodedLayers& cache,
                         const Progress& progress)
{
    const std::vector<Place> places = placesOf(groups);
    if (Checked<void> budget = checkBudget(archive, places); !budget)
        return tl::unexpected(budget.error());
    ImagePool pool;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (progress && !progress(static_cast<double>(i) / static_cast<double>(places.size())))
            return false;
        const Place& place = places[i];
        if (place.layer->raster.size() == place.stack->size)
            continue; // stands for a map that the file lacks
        const Checked<QByteArray> png = archive.read(place.entry, mostLayerBytes(place.stack->size));
        if (!png)
            return tl::unexpected(png.error());
        Checked<sim::TiledRaster> raster = pool.take(*png, mapSpec(place.stack->kind), place.stack->size, cache);
        if (!raster)
            return tl::unexpected(raster.error());
        place.layer->raster = std::move(*raster);
    }
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
    Checked<QByteArray> bytes = archive.read(QStringLiteral("thumbnail.png"), kMostThumbnailBytes);
    if (!bytes)
        return {};
    QBuffer buffer(&*bytes);
    QImageReader reader(&buffer, "png");
    const QSize size = reader.size();
    if (!size.isValid() || std::max(size.width(), size.height()) > kLargestThumbnail)
        return {};
    return reader.read();
}

} // namespace hairpaint::model
