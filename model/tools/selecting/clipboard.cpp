// Copying texels out of a layer and pasting them into one.
#include "model/tools/selecting/clipboard.h"

#include "model/document/paint_command.h"
#include "model/document/range_change.h"
#include "model/maps/texel_ops.h"
#include "model/maps/tile_paint.h"
#include "model/tools/live_edit.h"
#include "model/tools/row_number.h"
#include "model/values/texel_math.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace hairpaint::model {

namespace {

class Clipboard
{
    Q_DECLARE_TR_FUNCTIONS(Clipboard)
};

const Layer* paintable(Document& document, const LayerAddress& address)
{
    document.endEdit();
    const Layer* layer = document.committed().layer(address.group, address.map, address.layer);
    return layer != nullptr && layer->visible && !layer->locked ? layer : nullptr;
}

/// A layer's texels of one map as those of another. What both measure alike passes as it is, all else through the
/// colours.
std::vector<sim::Texel> converted(const std::vector<sim::Texel>& from, const MapSpec& source, const MapSpec& target)
{
    const auto coverageOf = [](const sim::Texel& texel, const MapSpec& spec) {
        return texel[static_cast<std::size_t>(spec.valueChannels)];
    };
    if (source.kind == target.kind || (source.texel == target.texel && source.palette.empty()))
        return from;
    std::vector<std::uint16_t> colours(from.size() * 3);
    texelOps(source).toColours(source, false, from.front().data(), sim::Texel().size(), from.size(), colours.data());
    std::vector<sim::Texel> to(from.size());
    for (std::size_t i = 0; i < to.size(); ++i)
        to[i] = {colours[3 * i], colours[3 * i + 1], colours[3 * i + 2], coverageOf(from[i], source)};
    texelOps(target).fromColours(target, to);
    return to;
}

/// The tiles of `raster` that are not `before`'s, made compact.
std::vector<std::pair<int, sim::RasterTilePtr>> differences(sim::TiledRaster& raster, const sim::TiledRaster& before)
{
    std::vector<std::pair<int, sim::RasterTilePtr>> tiles;
    for (int index = 0; index < raster.tileCount(); ++index) {
        if (raster.tile(index) == before.tile(index))
            continue;
        raster.compact(index);
        if (!sim::sameTexels(*raster.tile(index), *before.tile(index)))
            tiles.emplace_back(index, raster.tile(index));
    }
    return tiles;
}

} // namespace

Clip copyClip(const Document& document, const LayerAddress& address, const Selection& selection)
{
    Clip clip{.map = address.map, .uvRect = {}, .texels = {}};
    const Layer* layer = document.committed().layer(address.group, address.map, address.layer);
    if (layer == nullptr)
        return clip;
    const int size = layer->raster.size();
    const std::vector<sim::TexelRect> selected = selectedTexels(selection, size);
    if (selected.empty())
        return clip;
    sim::TexelRect rect = selected.front();
    for (const sim::TexelRect& other : selected)
        rect = {std::min(rect.x0, other.x0), std::min(rect.y0, other.y0), std::max(rect.x1, other.x1),
                std::max(rect.y1, other.y1)};
    const MapSpec& spec = mapSpec(address.map);
    clip.settings = document.committed().group(address.group)->settings;
    clip.width = rect.x1 - rect.x0;
    clip.height = rect.y1 - rect.y0;
    const double scale = 1.0 / size;
    clip.uvRect = {rect.x0 * scale, 1.0 - rect.y1 * scale, clip.width * scale, clip.height * scale};
    clip.texels.reserve(static_cast<std::size_t>(clip.width) * static_cast<std::size_t>(clip.height));
    for (int y = rect.y0; y < rect.y1; ++y)
        for (int x = rect.x0; x < rect.x1; ++x)
            clip.texels.push_back(contains(selected, x, y) ? layer->raster.texel(x, y) : spec.defaultValue);
    return clip;
}

QImage imageFromClip(const Clip& clip)
{
    constexpr std::size_t kMostPixels = std::size_t{4096} * 4096;
    if (clip.texels.empty() || clip.texels.size() > kMostPixels)
        return {};
    const MapSpec& spec = mapSpec(clip.map);
    QImage image(clip.width, clip.height, QImage::Format_ARGB32);
    if (image.isNull())
        return {};
    std::vector<std::uint16_t> colours(static_cast<std::size_t>(clip.width) * 3);
    for (int y = 0; y < clip.height; ++y) {
        const sim::Texel* row = clip.texels.data() + std::ptrdiff_t{y} * clip.width;
        texelOps(spec).toColours(spec, false, row->data(), sim::Texel().size(), static_cast<std::size_t>(clip.width),
                                 colours.data());
        auto* const pixels = reinterpret_cast<QRgb*>(image.scanLine(y));
        for (std::size_t x = 0; x < static_cast<std::size_t>(clip.width); ++x)
            pixels[x] = qRgba(narrowed(colours[3 * x]), narrowed(colours[3 * x + 1]), narrowed(colours[3 * x + 2]),
                              narrowed(row[x][static_cast<std::size_t>(spec.valueChannels)]));
    }
    return image;
}

ImageReading readingOf(const QImage& image, const MapSpec& spec)
{
    if (image.format() == QImage::Format_Grayscale8 || image.format() == QImage::Format_Grayscale16)
        return readingOf(std::span<const std::uint16_t>(), 1, spec);
    // What its pixels are is seen in a smaller one.
    constexpr int kEnough = 512;
    const bool isLarge = image.width() > kEnough || image.height() > kEnough;
    const QImage seen =
        (isLarge ? image.scaled(kEnough, kEnough, Qt::KeepAspectRatio) : image).convertToFormat(QImage::Format_RGBA64);
    std::vector<std::uint16_t> samples;
    samples.reserve(static_cast<std::size_t>(seen.width()) * static_cast<std::size_t>(seen.height()) * 4);
    for (int y = 0; y < seen.height(); ++y) {
        const auto* const pixels = reinterpret_cast<const QRgba64*>(seen.constScanLine(y));
        for (int x = 0; x < seen.width(); ++x)
            samples.insert(samples.end(), {pixels[x].red(), pixels[x].green(), pixels[x].blue(), pixels[x].alpha()});
    }
    return readingOf(samples, 4, spec);
}

Clip clipFromImage(const QImage& image, MapKind map, bool grey, int size, const QRectF& area)
{
    Clip clip{.map = map, .uvRect = {}, .texels = {}};
    const MapSpec& spec = mapSpec(map);
    const QSize room(std::max(1, qRound(area.width() * size)), std::max(1, qRound(area.height() * size)));
    const QImage fitted = image.convertToFormat(QImage::Format_RGBA64)
                              .scaled(room, Qt::KeepAspectRatio,
                                      texelOps(spec).continuous ? Qt::SmoothTransformation : Qt::FastTransformation)
                              .convertToFormat(QImage::Format_RGBA64);
    if (fitted.isNull())
        return clip;
    clip.width = fitted.width();
    clip.height = fitted.height();
    const QSizeF extent(static_cast<double>(clip.width) / size, static_cast<double>(clip.height) / size);
    clip.uvRect = QRectF(area.center() - QPointF(0.5 * extent.width(), 0.5 * extent.height()), extent);
    clip.texels.reserve(static_cast<std::size_t>(clip.width) * static_cast<std::size_t>(clip.height));
    for (int y = 0; y < clip.height; ++y) {
        const auto* const pixels = reinterpret_cast<const QRgba64*>(fitted.constScanLine(y));
        for (int x = 0; x < clip.width; ++x)
            clip.texels.push_back({pixels[x].red(), pixels[x].green(), pixels[x].blue(), pixels[x].alpha()});
    }
    grey ? texelOps(spec).fromGreys(spec, clip.texels) : texelOps(spec).fromColours(spec, clip.texels);
    return clip;
}

CommandPtr fillCommand(Document& document, const LayerAddress& address, const Selection& selection,
                       const sim::Texel& texel, const QString& text)
{
    const Layer* layer = paintable(document, address);
    if (layer == nullptr)
        return nullptr;
    sim::TiledRaster raster = layer->raster;
    const std::vector<sim::TexelRect> selected = selectedTexels(selection, raster.size());
    for (const int index : tilesIn(raster, selected))
        for (const sim::TexelRect& clip : selected) {
            const sim::TexelRect tile = raster.tileRect(index);
            const sim::TexelRect part = shared(tile, clip);
            if (part == tile) {
                raster.setUniform(index, texel);
                break;
            }
            for (int y = part.y0; y < part.y1; ++y)
                for (int x = part.x0; x < part.x1; ++x)
                    raster.setTexel(x, y, texel);
        }
    return paintCommand(document, address, differences(raster, layer->raster), text);
}

CommandPtr clearCommand(Document& document, const LayerAddress& address, const Selection& selection,
                        const QString& text)
{
    return fillCommand(document, address, selection, mapSpec(address.map).defaultValue, text);
}

CommandPtr pasteCommand(Document& document, const LayerAddress& address, const Clip& clip, const Selection& selection)
{
    const Layer* layer = paintable(document, address);
    if (layer == nullptr || clip.texels.empty())
        return nullptr;
    const MapSpec& source = mapSpec(clip.map);
    const MapSpec& target = mapSpec(address.map);
    std::vector<sim::Texel> texels = converted(clip.texels, source, target);
    const HairGroup* group = document.committed().group(address.group);
    if (clip.settings && clip.map == address.map && group != nullptr)
        rescaleTexels(target, *clip.settings, group->settings, texels);
    sim::TiledRaster raster = layer->raster;
    const int size = raster.size();
    QPointF centre = clip.uvRect.center();
    if (const std::optional<QRectF> around = selection.rectangle())
        centre = around->center();
    const std::vector<sim::TexelRect> selected = selectedTexels(selection, size);
    // Maps of another size get the clip at its uv size, by the nearest texel.
    const int width = std::max(1, static_cast<int>(std::lround(clip.uvRect.width() * size)));
    const int height = std::max(1, static_cast<int>(std::lround(clip.uvRect.height() * size)));
    const int left = static_cast<int>(std::lround((centre.x() - 0.5 * clip.uvRect.width()) * size));
    const int top = static_cast<int>(std::lround((1.0 - centre.y() - 0.5 * clip.uvRect.height()) * size));
    const auto texelAt = [&](int x, int y) -> const sim::Texel& {
        const int column = (x - left) * clip.width / width;
        const int row = (y - top) * clip.height / height;
        return texels[static_cast<std::size_t>(row) * static_cast<std::size_t>(clip.width) +
                      static_cast<std::size_t>(column)];
    };
    if (target.kind == MapKind::Braid && group != nullptr)
        renumberRows(group->map(MapKind::Braid), texels, [&](std::size_t i) {
            const auto place = [](std::size_t at, int first, int to, int from) {
                return first + static_cast<int>((static_cast<std::int64_t>(at) * to + from / 2) / from);
            };
            const auto across = static_cast<std::size_t>(clip.width);
            const int x = place(i % across, left, width, clip.width);
            const int y = place(i / across, top, height, clip.height);
            const bool isInside = x >= 0 && y >= 0 && x < size && y < size;
            return !isInside || raster.texel(x, y)[0] == texels[i][0];
        });
    const sim::TexelRect room{std::max(0, left), std::max(0, top), std::min(size, left + width),
                              std::min(size, top + height)};
    const auto channels = static_cast<std::size_t>(target.valueChannels);
    MaskTile mask{};
    std::vector<std::uint16_t> values(sim::kTileTexels * channels);
    for (const int index : tilesIn(raster, std::vector{room})) {
        const sim::TexelRect tile = raster.tileRect(index);
        const sim::TexelRect part = shared(tile, room);
        mask.fill(0);
        for (int y = part.y0; y < part.y1; ++y)
            for (int x = part.x0; x < part.x1; ++x) {
                if (!contains(selected, x, y))
                    continue;
                const sim::Texel& texel = texelAt(x, y);
                const auto at = static_cast<std::size_t>((y - tile.y0) * sim::TiledRaster::kTileSize + x - tile.x0);
                mask[at] = texel[channels];
                std::copy_n(texel.begin(), channels, values.begin() + static_cast<std::ptrdiff_t>(at * channels));
            }
        raster.setTile(index, paintTile(target, raster.tile(index), mask, {.value = {}, .values = values.data()}));
    }
    return paintCommand(document, address, differences(raster, layer->raster),
                        Clipboard::tr("Paste into %1").arg(target.titleText()));
}

} // namespace hairpaint::model
