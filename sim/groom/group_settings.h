// What a hair group's maps are measured in and how its hairs behave and look.
#pragma once

#include <cstdint>
#include <variant>

namespace hairpaint::sim {

enum class TurnsMode : std::uint8_t
{
    PerHair,
    PerLength,
    Coils ///< Turns are CurlSettings::pitchM apart.
};

/// How the hairs of a group move. All gains are those of a step of 1/60 s and are rescaled to the real step.
struct PhysicsSettings
{
    float damping = 2.0F;      ///< 1/s, 0..20: velocity decays by exp(-damping t).
    float gravityScale = 1.0F; ///< 0..2, of 9.81 m/s2.
    float windScale = 1.0F;    ///< 0..4.
    /// 0..0.3 m: the elasto-gravity length (E I / (rho A g))^(1/3) of a hair, which a third of stands as it grows and
    /// twice of hangs. A straight Asian hair of 80 um has 5 cm.
    float stiffnessM = 0.05F;
    float friction = 0.4F;  ///< 0..1 on the head: fraction of the tangential motion lost in a step of contact.
    float volumeM = 0.008F; ///< m, 0..0.05: thickness of the whole coat; each hair lies at its own height in it.
    /// m, 0..0.2: the length of hair from the root along which the coat gains its thickness, so that a parting is no
    /// groove; hair that is short gains it sooner, a coat too thick for that later. At 0 as steeply as hair bends.
    float volumeRiseM = 0.0F;
    float body = 0.0F; ///< 0..1: how strongly hair keeps out of hair and moves along with it; 0: it does neither.
    float loft = 0.0F; ///< 0..1: how far roots resist being pressed flat, so that the coat keeps its height at rest.
    friend bool operator==(const PhysicsSettings&, const PhysicsSettings&) = default;
};

/// How the hairs of a group look.
struct StrandMaterial
{
    float widthM = 80e-6F;         ///< Diameter of a hair, 10e-6..1e-3.
    float shine = 0.5F;            ///< 0..1: strength of the highlights.
    float roughness = 0.35F;       ///< 0.05..1: width of the highlights.
    float rootAlpha = 1.0F;        ///< 0..1.
    float tipAlpha = 0.35F;        ///< 0..1: strands thin out to the tip.
    float colourVariation = 0.12F; ///< 0..1: difference in lightness between neighbouring hairs.
    float scalpTint = 0.0F;        ///< 0..1: how much its roots, where they are dense, colour the skin.
    float taperM = 0.0F;      ///< m, 0..0.5: last length over which a hair thins out to its tip; 0: over all of it.
    float tipFrom = 0.0F;     ///< Fraction of the length, 0..1, up to which a hair has its root's colour;
    float tipOver = 1.0F;     ///< fraction of the rest, 0..1, over which that turns to its tip's.
    float sectionAxes = 1.0F; ///< 1..3: longest over shortest diameter of a hair's section; 1 is round.
    friend bool operator==(const StrandMaterial&, const StrandMaterial&) = default;
};

/// By how much the hairs of a group differ from each other. At 0 each is exactly what the maps say.
struct VariationSettings
{
    float length = 0.0F;   ///< 0..1: greatest fraction by which a hair is shorter than the map says.
    float curl = 0.0F;     ///< 0..1: greatest fraction by which turns and radius differ.
    float width = 0.0F;    ///< 0..1: greatest fraction by which the diameter differs.
    float crossing = 0.0F; ///< rad, 0..0.5: greatest angle by which a hair lies across its neighbours.
    float flyaways = 0.0F; ///< 0..0.2: fraction of the hairs that keep to no lock and stand off the coat.
    float grey = 0.0F;     ///< 0..1: fraction of the hairs that are grey.
    /// m, 0..0.01: greatest distance from the line of a parting, or from the middle of a whorl, at which a hair lies to
    /// the other side; the line itself wavers by two fifths of it.
    float parting = 0.0F;
    float mostShorterM = 0.0F; ///< m, 0..0.2: greatest length by which a hair is shorter; 0: as `length` says.
    float partGapM = 0.0F;     ///< m, 0..0.01: width of the uneven line of skin that a parting bares.
    float patches = 0.0F;      ///< 0..1: how far density and length differ in soft patches, a thumb wide.
    friend bool operator==(const VariationSettings&, const VariationSettings&) = default;
};

/// Curls by the measures of real hair. All but `gather` counts with TurnsMode::Coils alone.
struct CurlSettings
{
    float diameterM = 0.015F;     ///< m, 0..0.2: a coil's diameter where curl size has its default.
    float pitchM = 0.039F;        ///< m, 0.0005..1: length of a turn along the hair as seen, where curl is 1.
    float flatness = 0.0F;        ///< 0..1: from a coil to an S that lies on the skin.
    float inStepFromM = 0.0F;     ///< m, 0..1: distance from the scalp where the hairs of a lock have come into step.
    float switchbacksPerM = 0.0F; ///< 1/m, 0..200: how often a coil changes its hand.
    float skips = 0.0F;           ///< 0..1: fraction of its turns that a hair leaps over.
    float uncoil = 0.0F;          ///< 0..0.8: fraction by which the turns at the root of long hair are fewer.
    float gather = 0.0F;          ///< 0..1: clump of curled hair where none is painted.
    float straightM = 0.0F;       ///< m, 0..0.2: a hair is straight over that much from its root.
    friend bool operator==(const CurlSettings&, const CurlSettings&) = default;
};

/// The locks that clump draws hair to.
struct LockSettings
{
    float sizeM = 0.0F;    ///< m, 0..0.1: distance of locks, no less than the solved hairs' distance; 0: that distance.
    float small = 0.0F;    ///< 0..1: clump of the small locks, a solved hair each, that a lock is made of.
    float flatness = 0.0F; ///< 0..1: from a round lock to a ribbon that lies on the skin.
    float twistsPerM = 0.0F; ///< 1/m, 0..50: turns of a lock about itself.
    float ragged = 0.0F;     ///< 0..1: how far hairs at a lock's edge belong to the next.
    float parting = 0.0F;    ///< 0..1: how far hairs leave their lock over its last third.
    friend bool operator==(const LockSettings&, const LockSettings&) = default;
};

/// The edge of the hair towards bare skin.
struct HairlineSettings
{
    float softenM = 0.0F; ///< m, 0..0.03: width over which hair grows thinner, shorter and finer towards it.
    float baby = 0.0F;    ///< 0..1: fraction of the hairs at the very edge that are short, fine and a little curled.
    float uneven = 0.0F;  ///< 0..1: how far the edge wavers, of some millimetres.
    friend bool operator==(const HairlineSettings&, const HairlineSettings&) = default;
};

/// Nodes of a skeleton, root and tip included.
inline constexpr int kLeastNodes = 4;
inline constexpr int kMostNodes = 32;

/// SI units. A map value of 1 means the `greatest...` of its kind.
struct GroupSettings
{
    float greatestDensityPerM2 = 1.5e6F; ///< 1e4..4e6.
    float greatestLengthM = 0.30F;       ///< 0.001..2.
    float shortestLengthM = 0.0F;        ///< The length where the map is 0.
    int nodesPerHair = 8;                ///< kLeastNodes..kMostNodes.
    int basisHairs = 4096;               ///< Number of candidates all over the skin that are solved; 256..10,000,000.
    TurnsMode turnsMode = TurnsMode::PerHair;
    bool steppedTurns = false;          ///< Table 1's levels only.
    float turnsPerLengthM = 0.10F;      ///< With PerLength: the length that table 1's turns are for.
    float greatestCurlRadiusM = 0.012F; ///< A curl-size value of 1.
    float greatestFrizzM = 0.004F;      ///< 0..0.05: how far a hair strays, at most, where the frizz map is 1.
    float braidSpacingM = 0.30F;        ///< Distance of braid centres within one painted region.
    float braidRadiusM = 0.014F;        ///< Radius r of equation 3; less where a braid has too few hairs to fill it.
    float braidKnot = 1.0F;             ///< 0.5..3: length of a braid's turns, in that at which its wisps fit.
    float braidTightness = 0.5F;        ///< 0..1: at 0 wisps are full and hairs leave them, at 1 they are drawn tight.
    float braidTaper = 0.0F;            ///< 0..0.9: fraction by which a braid is thinner at its end.
    float braidTie = 1.0F;              ///< 0..1: how far it is drawn together before its tuft.
    bool lengthAsCut = false;           ///< With Coils: the length map is the fibre's, which its curl shortens.
    CurlSettings curl;
    LockSettings locks;
    VariationSettings variation;
    HairlineSettings hairline;
    PhysicsSettings physics;
    StrandMaterial material;
    friend bool operator==(const GroupSettings&, const GroupSettings&) = default;
};

/// What changing a setting makes anew; more than one for some.
enum class Affects : std::uint8_t
{
    Roots = 1,  ///< Where hairs stand, and which are solved.
    Hairs = 2,  ///< The strands themselves: each is evaluated again.
    Motion = 4, ///< The solver's constants.
    Look = 8    ///< How they are drawn; no strand is touched.
};
[[nodiscard]] constexpr Affects operator|(Affects a, Affects b)
{
    return static_cast<Affects>(static_cast<std::uint8_t>(a) | static_cast<std::uint8_t>(b));
}
[[nodiscard]] constexpr bool affectsAny(Affects what, Affects asked)
{
    return (static_cast<std::uint8_t>(what) & static_cast<std::uint8_t>(asked)) != 0;
}

using SettingMember =
    std::variant<float GroupSettings::*, int GroupSettings::*, bool GroupSettings::*, TurnsMode GroupSettings::*,
                 float CurlSettings::*, float LockSettings::*, float VariationSettings::*, float PhysicsSettings::*,
                 float StrandMaterial::*, float HairlineSettings::*>;

/// What a setting affects. Each has a row in group_settings.cpp.
[[nodiscard]] Affects affectsOf(const SettingMember& setting);
/// Whether the settings that affect any of `asked` are the same.
[[nodiscard]] bool sameFor(Affects asked, const GroupSettings& a, const GroupSettings& b);

} // namespace hairpaint::sim
