// The document's content as plain values. Copies share maps and tiles, so they are cheap.
#pragma once

#include "model/project/change.h"
#include "model/project/head_part.h"
#include "model/project/light_settings.h"
#include "model/project/skin_tone.h"
#include "model/project/worn.h"
#include "sim/groom/group_settings.h"
#include "sim/motion/wind.h"
#include "sim/skin/distance_grid.h"
#include "sim/skin/head_landmarks.h"
#include "sim/skin/skin.h"

#include <QByteArray>
#include <QString>

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace hairpaint::model {

struct Layer
{
    Id id = 0;
    QString name;
    bool visible = true;
    float opacity = 1.0F; ///< 0..1
    BlendMode blend = BlendMode::Normal;
    bool locked = false;
    sim::TiledRaster raster; ///< Value channels, then coverage; unassociated.
    friend bool operator==(const Layer&, const Layer&) = default;
};

/// Resolving starts from the spec's default. `layers` from the bottom up. Every map of a group is present.
struct MapStack
{
    MapKind kind = MapKind::Density;
    int size = 1024; ///< Texels a side.
    std::vector<Layer> layers;
    friend bool operator==(const MapStack&, const MapStack&) = default;
};

/// A map that copies of a project share until one of them changes it: copying a project costs its groups, not its
/// tiles. Copies may be read on other threads while this one is written.
class SharedStack
{
public:
    SharedStack(MapStack stack) : m_stack(std::make_shared<MapStack>(std::move(stack))) {}
    operator const MapStack&() const { return *m_stack; }
    [[nodiscard]] const MapStack* operator->() const { return m_stack.get(); }
    [[nodiscard]] const MapStack& operator*() const { return *m_stack; }
    /// This copy's own stack, no longer shared.
    [[nodiscard]] MapStack& write();
    [[nodiscard]] bool sharesWith(const SharedStack& other) const { return m_stack == other.m_stack; }
    friend bool operator==(const SharedStack& a, const SharedStack& b)
    {
        return a.m_stack == b.m_stack || *a.m_stack == *b.m_stack;
    }

private:
    std::shared_ptr<MapStack> m_stack;
};

struct HairGroup
{
    Id id = 0;
    QString name;
    bool visible = true;
    sim::GroupSettings settings;
    std::vector<SharedStack> maps; ///< kMapKindCount, in the order of MapKind.
    /// The group's own map, to be changed; no longer shared with copies.
    [[nodiscard]] MapStack& map(MapKind kind) { return maps[static_cast<std::size_t>(kind)].write(); }
    [[nodiscard]] const MapStack& map(MapKind kind) const { return *maps[static_cast<std::size_t>(kind)]; }
    friend bool operator==(const HairGroup&, const HairGroup&) = default;
};

enum class UpAxis : std::uint8_t
{
    Y,
    Z
};

/// The head under the hair. Shared and immutable: replaced whole.
struct Head
{
    QString name; ///< A built-in head's, or the imported file's base name.
    bool builtIn = true;
    float unitScale = 1.0F; ///< Metres per unit of the source; 1 for a built-in head.
    UpAxis upAxis = UpAxis::Y;
    QByteArray sourceGlb;                  ///< Source positions, before scale and axis; empty for a built-in head.
    std::shared_ptr<const sim::Skin> skin; ///< Scale and axis applied.
    /// Distances from the skin, which keep hair out of it; null for bust-1, whose hair stays as in version 0.1.
    std::shared_ptr<const sim::DistanceGrid> distances;
    /// Fraction of the skin's area that the scalp covers, 0..1; 1 where the scalp is not known.
    double scalpFraction = 1.0;
    std::optional<sim::HeadLandmarks> landmarks;    ///< None where they are not known.
    std::shared_ptr<const sim::HeadMesh> shownMesh; ///< What is drawn; finer than the skin's for a built-in head.
    /// How hair streams over the head where nobody combed it, as a direction map has it; null where it is not known.
    sim::MapRaster naturalDirection = {};
    /// Parts of the character without hair of their own, Hd; they are drawn and hair collides with them.
    std::vector<HeadPart> parts = {};
    std::shared_ptr<const sim::MeshTexture> texture =
        {}; ///< The texture on the skin; null where the head's file has none.
};

inline constexpr int kMostHairs = 4'000'000; ///< Greatest value of Project::maxHairs.

struct Project
{
    Id nextId = 1;
    std::uint64_t seed = 1;
    int maxHairs = 1'000'000; ///< Limit on candidates, 1..kMostHairs.
    std::shared_ptr<const Head> head;
    std::vector<Worn> worn; ///< Worn things in the order of insertWorn().
    std::vector<HairGroup> groups;
    sim::Wind wind;
    LightSettings light;
    QRgb background = 0xFF2A2C30;
    SkinTone skin = SkinTone::Clay;

    /// Head::scalpFraction of the head; 1 without a head.
    [[nodiscard]] double scalpFraction() const { return head ? head->scalpFraction : 1.0; }
    [[nodiscard]] const HairGroup* group(Id id) const;
    [[nodiscard]] HairGroup* group(Id id);
    [[nodiscard]] const Layer* layer(Id groupId, MapKind kind, Id layerId) const;
    [[nodiscard]] Layer* layer(Id groupId, MapKind kind, Id layerId);
    [[nodiscard]] const Worn* wornThing(Id id) const;
    [[nodiscard]] Worn* wornThing(Id id);
    /// Replaces the shapes that the former head brought by `shapes`; nothing changes where they are the same.
    void setShapesOfHead(std::span<const sim::Ellipsoid> shapes);
    [[nodiscard]] Id takeId() { return nextId++; }
};

/// `wind`, switched on or off as `shown` is.
[[nodiscard]] inline sim::Wind blowingAs(const sim::Wind& shown, sim::Wind wind)
{
    wind.enabled = shown.enabled;
    return wind;
}

/// A group named `name` with every map present and empty (default values, one empty layer a map).
[[nodiscard]] HairGroup makeGroup(Project& project, const QString& name, int mapSize = 1024);
/// What a layer holds where nothing is painted.
[[nodiscard]] sim::Texel emptyTexel(const MapSpec& spec);
/// A layer without paint.
[[nodiscard]] sim::TiledRaster emptyRaster(const MapSpec& spec, int size);
[[nodiscard]] Layer makeLayer(Project& project, const MapSpec& spec, int size, const QString& name);

} // namespace hairpaint::model
