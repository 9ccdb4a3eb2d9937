// Every change the user can make, as undo commands. They hold ids, never pointers into the project. Making one first
// ends the edit that runs, by its policy.
#pragma once

#include "model/document/document.h"
#include "model/styles/style_use.h"
#include "model/values/progress.h"

#include <QRectF>
#include <QUndoCommand>

#include <memory>

namespace hairpaint::model {

using CommandPtr = std::unique_ptr<QUndoCommand>;

/// Tiles of one layer and their new content.
struct LayerEdit
{
    LayerAddress address;
    LayerTiles after;
};
/// Swaps tiles. `text`: what undo says, "Brush on Length". Null where none differs.
[[nodiscard]] CommandPtr paintCommand(Document& document, std::vector<LayerEdit> layers, const QString& text);
[[nodiscard]] CommandPtr paintCommand(Document& document, const LayerAddress& address, LayerTiles after,
                                      const QString& text);

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

/// Every map empty.
[[nodiscard]] CommandPtr addGroupCommand(Document& document, const QString& name,
                                         const sim::GroupSettings& settings = {});
/// A copy with new ids.
[[nodiscard]] CommandPtr addGroupCommand(Document& document, HairGroup group);
/// Groups read from a file of that name (model/importing), with new ids. Null where there is none.
[[nodiscard]] CommandPtr importHairCommand(Document& document, std::vector<HairGroup> groups, const QString& fileName);
/// Eyebrows and eyelashes (model/growth/face_hair.h), with new ids; or those that are there are shown, or hidden. Null
/// where there is nothing to add.
[[nodiscard]] CommandPtr addFaceHairCommand(Document& document, std::vector<HairGroup> groups);
[[nodiscard]] CommandPtr showFaceHairCommand(Document& document, bool visible);
/// Null for the last group: a project has at least one.
[[nodiscard]] CommandPtr removeGroupCommand(Document& document, Id group);
[[nodiscard]] CommandPtr renameGroupCommand(Document& document, Id group, const QString& name);
/// Null if its index stays the same. `newPosition`: index, 0 first.
[[nodiscard]] CommandPtr moveGroupCommand(Document& document, Id group, int newPosition);
[[nodiscard]] CommandPtr showGroupCommand(Document& document, Id group, bool visible);
/// The group with another range (model/document/range_change.h), made of its committed content.
[[nodiscard]] CommandPtr setRangeCommand(Document& document, struct RangeChange change, const QString& text);
/// Ranges change as numbers do: the texels stay, so that all hair is scaled. Null where nothing differs; likewise the
/// next ones.
[[nodiscard]] CommandPtr setSettingsCommand(Document& document, Id group, const sim::GroupSettings& settings,
                                            const QString& text);
/// Whether the wind blows does not change; see Document::setWindOn.
[[nodiscard]] CommandPtr setWindCommand(Document& document, const sim::Wind& wind);
[[nodiscard]] CommandPtr setLightCommand(Document& document, const LightSettings& light);
[[nodiscard]] CommandPtr setBackgroundCommand(Document& document, QRgb background);
[[nodiscard]] CommandPtr setSkinCommand(Document& document, SkinTone skin);
/// With a new id, behind those of its kind. Null where the project holds as many as it may.
[[nodiscard]] CommandPtr addWornCommand(Document& document, Worn worn);
/// Gathers the group's hair that nothing gathers yet, inside what is selected (uv; empty: everywhere), into a thing of
/// that kind at the point; where hair there is gathered by one of the kind already, that goes there. Null where no hair
/// is left to gather, or no layer of the accessory map can be painted.
[[nodiscard]] CommandPtr gatherCommand(Document& document, Id group, const WornSpec& spec,
                                       const sim::SurfacePoint& point, const std::vector<QRectF>& selected);
/// With the patch that it is painted as. Null where there is none.
[[nodiscard]] CommandPtr removeWornCommand(Document& document, Id id);
/// Undo names of wind, light and background, for edits that are previewed before they are committed.
[[nodiscard]] QString windStepText();
[[nodiscard]] QString lightStepText();
[[nodiscard]] QString backgroundStepText();
/// With the ellipsoids that it brings, and the groups as they were carried to it (style_transfer.h), or the maps taken
/// as they lie.
[[nodiscard]] CommandPtr setHeadCommand(Document& document, std::shared_ptr<const Head> head,
                                        std::vector<sim::Ellipsoid> ellipsoids,
                                        std::optional<std::vector<HairGroup>> groups = {});
/// See applyPreset().
[[nodiscard]] CommandPtr applyPresetCommand(Document& document, const Preset& preset, const StyleUse& use = {});

} // namespace hairpaint::model
