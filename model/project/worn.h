// What is worn on the head and is not hair, and the one table of its kinds: menus, handles, undo, files, contact and
// pictures read it.
#pragma once

#include "model/project/change.h"
#include "sim/skin/ellipsoid.h"
#include "sim/skin/head_mesh.h"
#include "sim/skin/skin.h"

#include <QColor>
#include <QLatin1StringView>
#include <QString>

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace hairpaint::model {

enum class WornKind : std::uint8_t
{
    Ellipsoid, ///< Stands for a part of the head in collisions.
    Ball       ///< A bead.
};

/// The point of the head's skin that a thing hangs on. Its offset from there and its rotation in the skin's frame
/// follow from its shape.
struct WornAnchor
{
    std::uint32_t face = 0;
    glm::vec3 barycentric{1.0F, 0.0F, 0.0F};
    friend bool operator==(const WornAnchor&, const WornAnchor&) = default;
};

struct Worn
{
    Id id = 0;
    WornKind kind = WornKind::Ellipsoid;
    sim::Ellipsoid shape = {};             ///< Where it is on the present head, how it is turned, how large it is.
    QRgb colour = 0;                       ///< Of a kind that is drawn; 0 otherwise.
    float sheen = 0.0F;                    ///< Of a kind that is drawn, 0..1: see WornSpec::sheen; 0 otherwise.
    Id group = 0;                          ///< Whose hair it is worn in: goes when that goes. 0: of none.
    std::optional<WornAnchor> anchor = {}; ///< None: the nearest point of the skin.
    friend bool operator==(const Worn&, const Worn&) = default;
};

/// What a pull on an end of an axis sizes.
enum class WornHandles : std::uint8_t
{
    Axes,  ///< That axis; with Shift all.
    Radius ///< All.
};

/// A kind. Texts are in context "Worn" (wornText).
struct WornSpec
{
    WornKind kind;
    const char* id;       ///< In files.
    const char* ownArray; ///< Of project.json, with those of this kind; null: they lie in `worn`, and tell their kind.

    const char* title;
    const char* action;      ///< Ends the ids of the menus' actions: hair.add..., hair.remove...
    const char* addTitle;    ///< In menus, with a mnemonic.
    const char* addHint;     ///< %1: the limit.
    const char* removeTitle; ///< In menus, with a mnemonic.
    const char* addStep;     ///< For undo, as the next four.
    const char* removeStep;
    const char* moveStep;
    const char* sizeStep;
    const char* lookStep; ///< Of a kind that is drawn; else null.

    std::size_t limit; ///< In a project.
    float radiusM;     ///< Of a new one,
    float liftRadii;   ///< how far its centre lies above the skin, in radii,
    QRgb colour;       ///< its colour,
    float sheen;       ///< and, 0..1, how much light it reflects without taking that colour.
    float leastRadiusM;
    float greatestRadiusM;
    WornHandles handles;
    bool ofHead;   ///< The head brings its own: another head takes them away.
    bool collides; ///< Hair does not enter its shape.
    /// Drawn as a lit body: a closed mesh that fits the unit ball, which the shape scales, turns and moves. Null: never
    /// drawn, and in reach only while colliders are shown.
    std::shared_ptr<const sim::HeadMesh> (*mesh)();

    [[nodiscard]] bool drawn() const { return mesh != nullptr; }
};

[[nodiscard]] std::span<const WornSpec> wornSpecs();
[[nodiscard]] const WornSpec& wornSpec(WornKind kind);
[[nodiscard]] const WornSpec* findWornSpec(const QString& id); ///< Null where there is none.
[[nodiscard]] QString wornText(const char* text);

/// A new one on the skin, without an id.
[[nodiscard]] Worn makeWorn(const WornSpec& spec, const sim::SurfacePoint& point, Id group = 0);
/// As it is worn once its shape has been moved: from then on it hangs on the nearest point of the skin.
void anchorWorn(Worn& worn, const sim::Skin* skin);

/// Things lie in the order of the table and, of one kind, in that of their coming: as files give them back.
void insertWorn(std::vector<Worn>& all, const Worn& one);
[[nodiscard]] std::size_t countOf(const std::vector<Worn>& all, WornKind kind);
/// What hair does not enter.
[[nodiscard]] std::vector<sim::Ellipsoid> contactShapes(const std::vector<Worn>& all);
/// Of kinds that a head brings.
[[nodiscard]] std::vector<sim::Ellipsoid> shapesOfHead(const std::vector<Worn>& all);

} // namespace hairpaint::model
