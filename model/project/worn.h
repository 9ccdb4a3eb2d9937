// What is worn on the head and is not hair, and the one table of its kinds: menus, handles, undo, files, contact and
// pictures read it.
#pragma once

#include "model/bodies/hanging_part.h"
#include "model/project/change.h"
#include "model/project/own_mesh.h"
#include "sim/groom/tie.h"
#include "sim/skin/ellipsoid.h"
#include "sim/skin/head_mesh.h"
#include "sim/skin/skin.h"

#include <QColor>
#include <QLatin1StringView>
#include <QString>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace hairpaint::model {

enum class WornKind : std::uint8_t
{
    Ellipsoid, ///< Stands for a part of the head in collisions.
    Ball,      ///< A bead.
    Ponytail,  ///< A tie that hair goes through.
    Bun,       ///< A tie behind which hair is wound up.
    Headband,
    Bow,
    Hairpin,
    Flower,
    Comb,
    Mesh ///< What a user brought.
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
    std::uint16_t number = 0;  ///< 1..65535, unique in the project; hair finds its tie by it.
    WornAnchor at;             ///< A point of the skin in the patch, by which it is found again.
    bool placedByHand = false; ///< Whether position and rotation were set by hand; else they follow from the patch.
    friend bool operator==(const WornPatch&, const WornPatch&) = default;
};

struct Worn
{
    Id id = 0;
    WornKind kind = WornKind::Ellipsoid;
    sim::Ellipsoid shape = {}; ///< Position on the present head, rotation and size.
    QRgb colour = 0;           ///< Colour of a kind that is drawn; 0 for other kinds.
    float sheen = 0.0F;        ///< As WornSpec::sheen, 0..1; 0 for kinds that are not drawn.
    Id group = 0;              ///< The group in whose hair it is worn, and with which it is removed; 0: none.
    std::optional<WornAnchor> anchor = {}; ///< The point of the skin that it hangs on; none: the nearest one.
    Id tie = 0;                            ///< The tie that it sits on and goes with; 0: none.
    std::uint8_t make = 0;                 ///< Index into WornSpec::makes; 0 for kinds without makes.
    float tightness = 0.0F;                ///< As sim::Tie has it, 0..1; 0 for kinds that are no ties.
    float coilRadiusM = 0.0F;              ///< How far hair is wound about the tie of a bun; 0 for other kinds.
    std::optional<WornPatch> patch = {};   ///< The patch that it is painted as; none where it was put on by hand.
    SharedOwnMesh ownMesh = {};            ///< Of WornKind::Mesh, what is drawn; none: WornSpec::mesh.
    bool mirrored = false;                 ///< Whether that is drawn with its x the other way round.
    bool passable = false;                 ///< Whether hair goes through it although its kind collides.
    friend bool operator==(const Worn&, const Worn&) = default;
};

/// What a pull on the end of an axis resizes.
enum class WornHandles : std::uint8_t
{
    Axes,  ///< That axis; all axes with Shift.
    Radius ///< All axes.
};

/// What a thing is made of.
struct WornMake
{
    const char* id;                                      ///< Name of the make in files.
    const char* title;                                   ///< To be translated in context "Worn".
    float sheen;                                         ///< Worn::sheen of a new thing of this make.
    std::shared_ptr<const sim::HeadMesh> (*mesh)();      ///< See WornSpec::mesh.
    std::span<const HangingPart> (*hanging)() = nullptr; ///< See WornSpec::hanging.
};

/// How a thing sits on a tie. The seat's y points from the tie's axis to the thing, its z where the hair leaves.
struct TieSeat
{
    float ringRadii;         ///< How far its middle is from the tie's, in outer radii of the ring,
    float ownRadii = 0.0F;   ///< and besides in its own radii.
    bool aroundHair = false; ///< Whether it is on the side where it was put on, and at a bun outside the coil, whose
                             ///< radius then counts as the ring's; else where the knot of a ribbon is.
    glm::quat turn{1.0F, 0.0F, 0.0F, 0.0F}; ///< Its rotation in the seat's frame.
};

/// A kind. Texts are in context "Worn" (wornText).
struct WornSpec
{
    WornKind kind;
    const char* id;       ///< Name of the kind in files.
    const char* ownArray; ///< Array of project.json that holds this kind; null: the array `worn`, with the kind's id.

    const char* title;
    const char* action;      ///< End of the id of the menus' action: hair.add...
    const char* addTitle;    ///< Title of the action that adds one, with a mnemonic.
    const char* addHint;     ///< Hint of that action; %1 is the limit.
    const char* removeTitle; ///< Title of the action that removes one, with a mnemonic.
    const char* addStep;     ///< Text of the undo step, as are the next four.
    const char* removeStep;
    const char* moveStep;
    const char* sizeStep;
    const char* lookStep; ///< Null for a kind that is not drawn.

    std::size_t limit; ///< Limit on the number in a project.
    float radiusM;     ///< Radius of a new thing.
    float liftRadii;   ///< Height of a new thing's centre above the skin, in radii.
    QRgb colour;       ///< Colour of a new thing.
    float sheen;       ///< 0..1: how much light a new thing reflects without taking its colour.
    float leastRadiusM;
    float greatestRadiusM;
    WornHandles handles;
    bool ofHead;   ///< Whether a head brings things of this kind; another head replaces them.
    bool collides; ///< Whether hair is kept out of its shape.
    /// The closed mesh that is drawn, within the unit ball, which the shape scales, rotates and moves. Null: never
    /// drawn, and only to be picked while colliders are shown.
    std::shared_ptr<const sim::HeadMesh> (*mesh)();
    /// The parts of that mesh that hang; null: none.
    std::span<const HangingPart> (*hanging)() = nullptr;
    /// For a kind that fits the head, instead of `mesh`: the mesh for that shape on that skin.
    std::shared_ptr<const sim::HeadMesh> (*fitted)(const sim::Ellipsoid& shape, const sim::Skin& skin) = nullptr;
    std::span<const WornMake> makes = {}; ///< Makes to choose from; a new thing has the first, whose mesh is `mesh`.
    glm::vec3 proportions{1.0F};          ///< Semi-axes of a new thing, in radii.
    int sizedAxis = 0;                    ///< The axis whose semi-axis panels show as the size.
    const char* sizeTitle = nullptr;      ///< Title of the size in panels; null: "Radius".
    /// Whether it stands on the skin: it moves and turns with the skin, its z axis pointing away from it.
    bool stands = false;
    bool alongPatch = false; ///< Whether it lies along its patch, half as long; others are as large as the patch.
    /// How it gathers the hair of its patch, which leaves along its z axis; none if not.
    std::optional<sim::TieForm> tie = {};
    /// How one that is put on at a tie sits there and goes with it; none: it does not.
    std::optional<TieSeat> seat = {};
    bool ownMesh = false;            ///< Whether users bring its mesh; its proportions are the mesh's.
    float reach = 1.0F;              ///< Radius of the ball that holds `mesh`, in radii of the unit ball.
    float tieHole = 0.0F;            ///< Inner radius of a tie, in radii.
    float coilRadiusM = 0.0F;        ///< Worn::coilRadiusM of a new bun.
    const char* patchStep = nullptr; ///< Undo step that puts it on with a patch of its own; null: it has none.

    [[nodiscard]] bool drawn() const { return mesh != nullptr; }
};

[[nodiscard]] std::span<const WornSpec> wornSpecs();
[[nodiscard]] const WornSpec& wornSpec(WornKind kind);
[[nodiscard]] const WornSpec* findWornSpec(const QString& id); ///< Null where there is none.
[[nodiscard]] QString wornText(const char* text);

/// The kind that an entry of the accessory map's palette stands for; null for "none".
[[nodiscard]] const WornSpec* wornOfPalette(int index);
/// The other way round; the palette holds what is painted.
[[nodiscard]] std::uint16_t paletteIndexOf(const WornSpec& spec);
/// How many meshes are drawn of it: 0 for a kind that is not drawn, one but for an own mesh of several materials.
[[nodiscard]] std::size_t surfaceCount(const Worn& worn);
/// These, in the space of the unit ball (rendering::Solid), with colours that are multiplied by Worn::colour. Each mesh
/// is made once, but at each call for a kind that fits the head; without a skin it fits none.
[[nodiscard]] std::vector<HeadPart> wornSurfaces(const Worn& worn, const sim::Skin* skin);
/// The parts of the one mesh that hang from it and may swing, where a file is for a program that lets them.
[[nodiscard]] std::span<const HangingPart> hangingParts(const Worn& worn);
/// The tie that the groom has for the thing; none where it gathers no hair.
[[nodiscard]] std::optional<sim::Tie> tieOf(const Worn& worn);

/// A new thing on the skin, without an id.
[[nodiscard]] Worn makeWorn(const WornSpec& spec, const sim::SurfacePoint& point, Id group = 0);
/// A copy on the other side of the head, without id and patch.
[[nodiscard]] Worn mirroredWorn(const Worn& worn, const sim::Skin& skin);
/// Puts it at the point as makeWorn() does, but keeps its size.
void standOn(Worn& worn, const sim::SurfacePoint& point);
/// The point of the skin that it hangs on.
[[nodiscard]] sim::SurfacePoint anchorPoint(const Worn& worn, const sim::Skin& skin);
/// Moves it by hand from one point of the skin to another; its offset and rotation in the skin's frame stay.
void carryTo(Worn& worn, const sim::SurfacePoint& from, const sim::SurfacePoint& to);
/// After sizing by hand: where a thing's size comes from its patch, its position stops following the patch.
void holdSize(Worn& worn);
/// After its shape was moved: hangs it on the nearest point of the skin.
void anchorWorn(Worn& worn, const sim::Skin* skin);

/// Inserts a thing in the order of wornSpecs() and, among its kind, last: the order in which files are read back.
void insertWorn(std::vector<Worn>& all, const Worn& one);
[[nodiscard]] std::size_t countOf(const std::vector<Worn>& all, WornKind kind);
/// The shapes that hair is kept out of.
[[nodiscard]] std::vector<sim::Ellipsoid> contactShapes(const std::vector<Worn>& all);
/// The shapes of kinds that a head brings.
[[nodiscard]] std::vector<sim::Ellipsoid> shapesOfHead(const std::vector<Worn>& all);
/// The ties that are worn in the group's hair, by ascending patch number.
[[nodiscard]] std::vector<sim::Tie> tiesIn(const std::vector<Worn>& all, Id group);

} // namespace hairpaint::model
