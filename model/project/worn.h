// What is worn on the head and is not hair, and the one table of its kinds: menus, handles, undo, files, contact and
// pictures read it.
#pragma once

#include "model/project/change.h"
#include "sim/groom/tie.h"
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
    Ball,      ///< A bead.
    Ponytail,  ///< A tie that hair goes through, as the next.
    Bun,       ///< Hair behind it is wound up.
    Headband,
    Bow,
    Hairpin,
    Flower,
    Comb
};

/// The point of the head's skin that a thing hangs on. Its offset from there and its rotation in the skin's frame
/// follow from its shape.
struct WornAnchor
{
    std::uint32_t face = 0;
    glm::vec3 barycentric{1.0F, 0.0F, 0.0F};
    friend bool operator==(const WornAnchor&, const WornAnchor&) = default;
};
[[nodiscard]] WornAnchor anchorAt(const sim::SurfacePoint& point);

/// The patch of the accessory map that a thing is painted as.
struct WornPatch
{
    std::uint16_t number = 0; ///< 1..65535, another for each patch of the project: the one by which hair knows its tie.
    WornAnchor at;            ///< A point of the skin in the patch, by which it is found again.
    bool placedByHand = false; ///< Else where the thing is, and how it is turned, follows from the patch.
    friend bool operator==(const WornPatch&, const WornPatch&) = default;
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
    std::uint8_t make = 0;                 ///< Of WornSpec::makes; 0 of a kind that has none.
    float tightness = 0.0F;                ///< Of a tie, 0..1: as in sim::Tie; 0 otherwise.
    float coilRadiusM = 0.0F;              ///< Of a bun: how far hair is wound about its tie; 0 otherwise.
    std::optional<WornPatch> patch = {};   ///< None: put on by hand.
    friend bool operator==(const Worn&, const Worn&) = default;
};

/// What a pull on an end of an axis sizes.
enum class WornHandles : std::uint8_t
{
    Axes,  ///< That axis; with Shift all.
    Radius ///< All.
};

/// What a thing is made of.
struct WornMake
{
    const char* id;                                 ///< In files.
    const char* title;                              ///< To be translated in context "Worn".
    float sheen;                                    ///< Of a new one.
    std::shared_ptr<const sim::HeadMesh> (*mesh)(); ///< See WornSpec::mesh.
};

/// A kind. Texts are in context "Worn" (wornText).
struct WornSpec
{
    WornKind kind;
    const char* id;       ///< In files.
    const char* ownArray; ///< Of project.json, with those of this kind; null: they lie in `worn`, and tell their kind.

    const char* title;
    const char* action;      ///< Ends the id of the menus' action: hair.add...
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
    /// Instead, for a kind that follows the head: the mesh for that shape on that skin.
    std::shared_ptr<const sim::HeadMesh> (*fitted)(const sim::Ellipsoid& shape, const sim::Skin& skin) = nullptr;
    std::span<const WornMake> makes = {}; ///< To choose from; the first is a new one's, and its mesh is `mesh`.
    glm::vec3 proportions{1.0F};          ///< Semi-axes of a new one, in radii.
    int sizedAxis = 0;                    ///< Whose semi-axis panels call its size.
    const char* sizeTitle = nullptr;      ///< What they call it; null: "Radius".
    /// Stands on the skin: moved over it, turned with it, its own z away from it.
    bool stands = false;
    bool alongPatch = false; ///< As its patch it lies along it, and is half as long; others are as large as it.
    std::optional<sim::TieForm> tie = {}; ///< Gathers the hair of its patch; its own z is where hair leaves.
    float reach = 1.0F;                   ///< `mesh` lies within so many of the unit ball's radii.
    float tieHole = 0.0F;                 ///< Inner radius of a tie, in radii.
    float coilRadiusM = 0.0F;             ///< Of a new bun.
    const char* patchStep = nullptr;      ///< For undo, of one that is put on with a patch of its own; else null.

    [[nodiscard]] bool drawn() const { return mesh != nullptr; }
};

[[nodiscard]] std::span<const WornSpec> wornSpecs();
[[nodiscard]] const WornSpec& wornSpec(WornKind kind);
[[nodiscard]] const WornSpec* findWornSpec(const QString& id); ///< Null where there is none.
[[nodiscard]] QString wornText(const char* text);

/// The kind that an entry of the accessory map's palette stands for; null for "none".
[[nodiscard]] const WornSpec* wornOfPalette(int index);
/// What is drawn, in the space of the unit ball (rendering::Solid): made once, but of a kind that follows the head anew
/// at each call. Without a skin as if it followed none. Null for what is not drawn.
[[nodiscard]] std::shared_ptr<const sim::HeadMesh> wornMesh(const Worn& worn, const sim::Skin* skin);
/// What gathers hair as the groom knows it; none where it gathers none.
[[nodiscard]] std::optional<sim::Tie> tieOf(const Worn& worn);

/// A new one on the skin, without an id.
[[nodiscard]] Worn makeWorn(const WornSpec& spec, const sim::SurfacePoint& point, Id group = 0);
/// As makeWorn() puts it there, but as large as it is.
void standOn(Worn& worn, const sim::SurfacePoint& point);
/// The point of the skin that it hangs on.
[[nodiscard]] sim::SurfacePoint anchorPoint(const Worn& worn, const sim::Skin& skin);
/// Moved over the skin by hand, from its point to another: it keeps its offset and its rotation there.
void carryTo(Worn& worn, const sim::SurfacePoint& from, const sim::SurfacePoint& to);
/// Sized by hand: of what its patch sizes, where it lies follows the patch no more.
void holdSize(Worn& worn);
/// As it is worn once its shape has been moved: from then on it hangs on the nearest point of the skin.
void anchorWorn(Worn& worn, const sim::Skin* skin);

/// Things lie in the order of the table and, of one kind, in that of their coming: as files give them back.
void insertWorn(std::vector<Worn>& all, const Worn& one);
[[nodiscard]] std::size_t countOf(const std::vector<Worn>& all, WornKind kind);
/// What hair does not enter.
[[nodiscard]] std::vector<sim::Ellipsoid> contactShapes(const std::vector<Worn>& all);
/// Of kinds that a head brings.
[[nodiscard]] std::vector<sim::Ellipsoid> shapesOfHead(const std::vector<Worn>& all);
/// Of things that are worn in that group's hair, by rising number.
[[nodiscard]] std::vector<sim::Tie> tiesIn(const std::vector<Worn>& all, Id group);

} // namespace hairpaint::model
