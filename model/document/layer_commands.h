// Layers added, removed, moved and changed.
#pragma once

#include "model/document/command_ptr.h"
#include "model/document/document.h"
#include "model/values/progress.h"

namespace hairpaint::model {

[[nodiscard]] CommandPtr addLayerCommand(Document& document, Id group, MapKind map, const QString& name);
/// Adds a copy of `layer` (with a new id) above the topmost; image import and paste as layer use it.
[[nodiscard]] CommandPtr insertLayerCommand(Document& document, Id group, MapKind map, Layer layer, int position,
                                            const QString& text);
[[nodiscard]] CommandPtr removeLayerCommand(Document& document, const LayerAddress& address);
[[nodiscard]] CommandPtr moveLayerCommand(Document& document, const LayerAddress& address, int newPosition);

/// Every layer at another size (256 to 8192, a power of two): values bilinearly, weighted by coverage; indices by the
/// nearest texel. Null where it has that size, the content would become too large, or `run` was cancelled.
[[nodiscard]] CommandPtr resizeMapCommand(Document& document, Id group, MapKind map, int size,
                                          const RunLong& run = runHere);

struct LayerProperties
{
    QString name;
    bool visible = true;
    float opacity = 1.0F;
    BlendMode blend = BlendMode::Normal;
    bool locked = false;
    friend bool operator==(const LayerProperties&, const LayerProperties&) = default;
};
[[nodiscard]] LayerProperties propertiesOf(const Layer& layer);
/// Null where nothing differs. `text` names the change.
[[nodiscard]] CommandPtr setLayerPropertiesCommand(Document& document, const LayerAddress& address,
                                                   const LayerProperties& properties, const QString& text);

} // namespace hairpaint::model
