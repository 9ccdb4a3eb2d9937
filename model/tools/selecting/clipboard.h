// Cut, copy, fill and paste of the selected texels, inside a map and between maps.
#pragma once

#include "model/document/command_ptr.h"
#include "model/document/document.h"
#include "model/maps/image_reading.h"
#include "model/tools/strokes/selection.h"

#include <QImage>

#include <optional>

namespace hairpaint::model {

/// A copied rectangle of one layer.
struct Clip
{
    MapKind map = MapKind::Density;
    QRectF uvRect;
    int width = 0, height = 0;
    std::vector<sim::Texel> texels = {};             ///< Row by row from the top; value channels, then coverage.
    std::optional<sim::GroupSettings> settings = {}; ///< Settings of the group it was copied from.
};

/// The active layer's texels inside the selection (the whole map where nothing is selected); between several selected
/// rectangles the clip covers nothing.
[[nodiscard]] Clip copyClip(const Document& document, const LayerAddress& address, const Selection& selection);
/// The clip as an image for other programs: in the colours of the map's scale, with coverage as alpha. Null where the
/// clip is empty or too large.
[[nodiscard]] QImage imageFromClip(const Clip& clip);
/// How a map can read another program's image.
[[nodiscard]] ImageReading readingOf(const QImage& image, const MapSpec& spec);
/// An image as a clip for a map of `size` texels a side, fitted into `area` (uv); read by the map's colours, or where
/// `grey` by its grey as the value.
[[nodiscard]] Clip clipFromImage(const QImage& image, MapKind map, bool grey, int size, const QRectF& area);
/// Makes the selected texels `texel`, coverage and all. "Fill Length". Null where the layer is hidden, locked or gone.
[[nodiscard]] CommandPtr fillCommand(Document& document, const LayerAddress& address, const Selection& selection,
                                     const sim::Texel& texel, const QString& text);
/// Clears the selected texels' coverage. "Cut Length", "Clear Length".
[[nodiscard]] CommandPtr clearCommand(Document& document, const LayerAddress& address, const Selection& selection,
                                      const QString& text);
/// Lays the clip over what is there, as a brush does: at its own position, or centred in the selection and only inside
/// it. On a map of its kind amounts stay (15 cm), whatever range that one has. Between maps: scalar to scalar keeps the
/// value; other pairs go through the colours that the images have.
[[nodiscard]] CommandPtr pasteCommand(Document& document, const LayerAddress& address, const Clip& clip,
                                      const Selection& selection);

} // namespace hairpaint::model
