// The table of a hair group's settings.
#include "model/project/group_schema.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hairpaint::model {

namespace {

using sim::CurlSettings;
using sim::GroupSettings;
using sim::HairlineSettings;
using sim::LockSettings;
using sim::PhysicsSettings;
using sim::StrandMaterial;
using sim::VariationSettings;

constexpr auto kShape = SettingSection::Shape;
constexpr auto kCurl = SettingSection::Curl;
constexpr auto kLocks = SettingSection::Locks;
constexpr auto kChance = SettingSection::Variation;
constexpr auto kBraid = SettingSection::Braid;
constexpr auto kMotion = SettingSection::Physics;
constexpr auto kLook = SettingSection::Look;

constexpr double kLeastNodes = sim::kLeastNodes;
constexpr double kMostNodes = sim::kMostNodes;
constexpr double kBasisHairs = 4096.0;  ///< On the scalp, of a new group.
constexpr double kMostBasisHairs = 1e6; ///< On the scalp.

constexpr SettingChoice kTurnsModes[] = {{"per_hair", QT_TRANSLATE_NOOP("GroupSchema", "Turns per hair")},
                                         {"per_length", QT_TRANSLATE_NOOP("GroupSchema", "Turns per length")},
                                         {"coils", QT_TRANSLATE_NOOP("GroupSchema", "Coils measured in mm")}};

/// In each section the ones first that most people reach for.
constexpr GroupSetting kSettings[] = {
    {"greatest_length_m", &GroupSettings::greatestLengthM, kShape, QT_TRANSLATE_NOOP("GroupSchema", "Greatest length"),
     QT_TRANSLATE_NOOP("GroupSchema", "Length where the length map is brightest"),
     QT_TRANSLATE_NOOP("GroupSchema", "cm"), 100.0, 0.001, 2.0, 0.1, 200.0, 1, 2.0F},
    {"greatest_density_per_m2", &GroupSettings::greatestDensityPerM2, kShape,
     QT_TRANSLATE_NOOP("GroupSchema", "Greatest density"),
     QT_TRANSLATE_NOOP("GroupSchema", "Hairs where the density map is brightest"),
     QT_TRANSLATE_NOOP("GroupSchema", "hairs/cm²"), 1e-4, 1e4, 4e6, 1.0, 400.0, 0, 2.0F},
    {"hair_width_m", &StrandMaterial::widthM, kShape, QT_TRANSLATE_NOOP("GroupSchema", "Hair width"),
     QT_TRANSLATE_NOOP("GroupSchema", "Diameter of one hair"), QT_TRANSLATE_NOOP("GroupSchema", "µm"), 1e6, 1e-5, 1e-3,
     10.0, 1000.0, 0, 2.0F},
    {"greatest_curl_radius_m", &GroupSettings::greatestCurlRadiusM, kShape,
     QT_TRANSLATE_NOOP("GroupSchema", "Curl radius"), QT_TRANSLATE_NOOP("GroupSchema", "Greatest radius of a curl"),
     QT_TRANSLATE_NOOP("GroupSchema", "mm"), 1000.0, 0.0, 0.2, 0.0, 60.0, 1, 1.5F},
    {.key = "turns_mode",
     .member = &GroupSettings::turnsMode,
     .section = kShape,
     .label = QT_TRANSLATE_NOOP("GroupSchema", "Turns mode"),
     .hint = QT_TRANSLATE_NOOP("GroupSchema", "What the turns of a curl are counted by"),
     .unit = "",
     .shownPerSi = 1.0,
     .least = 0.0,
     .greatest = 2.0,
     .sliderLeast = 0.0,
     .sliderGreatest = 2.0,
     .choices = kTurnsModes},
    {"turns_per_length_m", &GroupSettings::turnsPerLengthM, kShape, QT_TRANSLATE_NOOP("GroupSchema", "Turns are for"),
     QT_TRANSLATE_NOOP("GroupSchema", "The length that the turns of a curl are for"),
     QT_TRANSLATE_NOOP("GroupSchema", "cm"), 100.0, 0.001, 10.0, 1.0, 100.0, 1, 2.0F},
    {"stepped_turns", &GroupSettings::steppedTurns, kShape, QT_TRANSLATE_NOOP("GroupSchema", "Curl levels"),
     QT_TRANSLATE_NOOP("GroupSchema", "Whole curl levels only"), "", 1.0, 0.0, 1.0, 0.0, 1.0},
    {"shortest_length_m", &GroupSettings::shortestLengthM, kShape, QT_TRANSLATE_NOOP("GroupSchema", "Shortest length"),
     QT_TRANSLATE_NOOP("GroupSchema", "Length where the length map is 0"), QT_TRANSLATE_NOOP("GroupSchema", "cm"),
     100.0, 0.0, 2.0, 0.0, 50.0, 1, 2.0F},
    {"nodes_per_hair", &GroupSettings::nodesPerHair, kShape, QT_TRANSLATE_NOOP("GroupSchema", "Nodes per hair"),
     QT_TRANSLATE_NOOP("GroupSchema", "More bend more finely and cost more"), "", 1.0, kLeastNodes, kMostNodes,
     kLeastNodes, kMostNodes},
    {.key = "basis_hairs",
     .member = &GroupSettings::basisHairs,
     .section = kShape,
     .label = QT_TRANSLATE_NOOP("GroupSchema", "Simulated hairs"),
     .hint = QT_TRANSLATE_NOOP("GroupSchema", "Of the whole scalp; the others follow the nearest of them"),
     .unit = "",
     .shownPerSi = 1.0,
     .least = 256.0,
     .greatest = 1e7,
     .sliderLeast = 256.0,
     .sliderGreatest = kMostBasisHairs,
     .exponent = 4.0F,
     .countsOnScalp = true},
    {"curl.diameter_m", &CurlSettings::diameterM, kCurl, QT_TRANSLATE_NOOP("GroupSchema", "Coil diameter"),
     QT_TRANSLATE_NOOP("GroupSchema", "Of a coil where no curl size is painted; an S is as wide"),
     QT_TRANSLATE_NOOP("GroupSchema", "mm"), 1000.0, 0.0, 0.2, 0.0, 80.0, 1, 2.0F},
    {"curl.pitch_m", &CurlSettings::pitchM, kCurl, QT_TRANSLATE_NOOP("GroupSchema", "Coil pitch"),
     QT_TRANSLATE_NOOP("GroupSchema", "From turn to turn along the hair where the curl map is brightest"),
     QT_TRANSLATE_NOOP("GroupSchema", "mm"), 1000.0, 0.0005, 1.0, 1.0, 400.0, 1, 2.5F},
    {"curl.flatness", &CurlSettings::flatness, kCurl, QT_TRANSLATE_NOOP("GroupSchema", "Flatness"),
     QT_TRANSLATE_NOOP("GroupSchema", "0 is a coil, 100 % a wave in the shape of an S"), "%", 100.0, 0.0, 1.0, 0.0,
     100.0},
    {"curl.in_step_from_m", &CurlSettings::inStepFromM, kCurl, QT_TRANSLATE_NOOP("GroupSchema", "In step from"),
     QT_TRANSLATE_NOOP("GroupSchema", "How far from the scalp the hairs of a lock curl together; before it each alone"),
     QT_TRANSLATE_NOOP("GroupSchema", "cm"), 100.0, 0.0, 1.0, 0.0, 100.0, 1, 3.0F},
    {"curl.switchbacks_per_m", &CurlSettings::switchbacksPerM, kCurl, QT_TRANSLATE_NOOP("GroupSchema", "Switchbacks"),
     QT_TRANSLATE_NOOP("GroupSchema", "How often a coil turns the other way and leaves a kink"),
     QT_TRANSLATE_NOOP("GroupSchema", "per 10 cm"), 0.1, 0.0, 200.0, 0.0, 20.0, 1, 2.0F},
    {"curl.skips", &CurlSettings::skips, kCurl, QT_TRANSLATE_NOOP("GroupSchema", "Skipped turns"),
     QT_TRANSLATE_NOOP("GroupSchema", "How many turns single hairs leap over"), "%", 100.0, 0.0, 1.0, 0.0, 100.0, 0,
     2.0F},
    {"curl.uncoil", &CurlSettings::uncoil, kCurl, QT_TRANSLATE_NOOP("GroupSchema", "Drawn by weight"),
     QT_TRANSLATE_NOOP("GroupSchema", "How much looser long curls are at the root than on the whole"), "%", 100.0, 0.0,
     0.8, 0.0, 80.0},
    {.key = "curl.length_as_cut",
     .member = &GroupSettings::lengthAsCut,
     .section = kCurl,
     .label = QT_TRANSLATE_NOOP("GroupSchema", "Curls shorten"),
     .hint = QT_TRANSLATE_NOOP("GroupSchema", "Curls shorten hair: lengths are as cut"),
     .unit = "",
     .shownPerSi = 1.0,
     .least = 0.0,
     .greatest = 1.0,
     .sliderLeast = 0.0,
     .sliderGreatest = 1.0},
    {"curl.gather", &CurlSettings::gather, kCurl, QT_TRANSLATE_NOOP("GroupSchema", "Curls gather"),
     QT_TRANSLATE_NOOP("GroupSchema", "How closely curled hair gathers in locks where no clump is painted"), "%", 100.0,
     0.0, 1.0, 0.0, 100.0},
    {"curl.straight_m", &CurlSettings::straightM, kCurl, QT_TRANSLATE_NOOP("GroupSchema", "Straight at the root"),
     QT_TRANSLATE_NOOP("GroupSchema", "How far from the scalp hair begins to curl"),
     QT_TRANSLATE_NOOP("GroupSchema", "mm"), 1000.0, 0.0, 0.2, 0.0, 50.0, 1, 2.0F},
    {"locks.size_m", &LockSettings::sizeM, kLocks, QT_TRANSLATE_NOOP("GroupSchema", "Lock size"),
     QT_TRANSLATE_NOOP("GroupSchema", "Distance of locks; at 0 each simulated hair has its own"),
     QT_TRANSLATE_NOOP("GroupSchema", "mm"), 1000.0, 0.0, 0.1, 0.0, 60.0, 1, 1.5F},
    {"locks.small", &LockSettings::small, kLocks, QT_TRANSLATE_NOOP("GroupSchema", "Small locks"),
     QT_TRANSLATE_NOOP("GroupSchema", "How far each lock is made of small ones, a simulated hair each"), "%", 100.0,
     0.0, 1.0, 0.0, 100.0},
    {"locks.flatness", &LockSettings::flatness, kLocks, QT_TRANSLATE_NOOP("GroupSchema", "Flat locks"),
     QT_TRANSLATE_NOOP("GroupSchema", "0 is round, 100 % a ribbon along the skin"), "%", 100.0, 0.0, 1.0, 0.0, 100.0},
    {"locks.twists_per_m", &LockSettings::twistsPerM, kLocks, QT_TRANSLATE_NOOP("GroupSchema", "Twisted locks"),
     QT_TRANSLATE_NOOP("GroupSchema", "How often a lock turns about itself"),
     QT_TRANSLATE_NOOP("GroupSchema", "per 10 cm"), 0.1, 0.0, 50.0, 0.0, 5.0, 1, 2.0F},
    {"locks.ragged", &LockSettings::ragged, kLocks, QT_TRANSLATE_NOOP("GroupSchema", "Ragged edges"),
     QT_TRANSLATE_NOOP("GroupSchema", "How many hairs at the edge of a lock belong to the next"), "%", 100.0, 0.0, 1.0,
     0.0, 100.0},
    {"locks.parting", &LockSettings::parting, kLocks, QT_TRANSLATE_NOOP("GroupSchema", "Open tips"),
     QT_TRANSLATE_NOOP("GroupSchema", "How far hairs leave their lock near the tip"), "%", 100.0, 0.0, 1.0, 0.0, 100.0},
    {"variation.length", &VariationSettings::length, kChance, QT_TRANSLATE_NOOP("GroupSchema", "Uneven lengths"),
     QT_TRANSLATE_NOOP("GroupSchema", "How much shorter than the map single hairs are"), "%", 100.0, 0.0, 1.0, 0.0,
     100.0, 0, 2.0F},
    {"variation.crossing_rad", &VariationSettings::crossing, kChance,
     QT_TRANSLATE_NOOP("GroupSchema", "Crossing hairs"),
     QT_TRANSLATE_NOOP("GroupSchema", "How far hairs lie across their neighbours"), "°", 180.0 / std::numbers::pi, 0.0,
     0.5, 0.0, 25.0, 1, 2.0F},
    {"variation.flyaways", &VariationSettings::flyaways, kChance, QT_TRANSLATE_NOOP("GroupSchema", "Flyaways"),
     QT_TRANSLATE_NOOP("GroupSchema", "Hairs that keep to no lock and stand off the others"), "%", 100.0, 0.0, 0.2, 0.0,
     20.0, 1, 2.0F},
    {"variation.curl", &VariationSettings::curl, kChance, QT_TRANSLATE_NOOP("GroupSchema", "Uneven curls"),
     QT_TRANSLATE_NOOP("GroupSchema", "How much turns and radius of curls differ"), "%", 100.0, 0.0, 1.0, 0.0, 100.0},
    {"variation.width", &VariationSettings::width, kChance, QT_TRANSLATE_NOOP("GroupSchema", "Uneven widths"),
     QT_TRANSLATE_NOOP("GroupSchema", "How much the diameters of hairs differ"), "%", 100.0, 0.0, 1.0, 0.0, 100.0},
    {"variation.grey", &VariationSettings::grey, kChance, QT_TRANSLATE_NOOP("GroupSchema", "Grey hairs"),
     QT_TRANSLATE_NOOP("GroupSchema", "How many of the hairs are grey"), "%", 100.0, 0.0, 1.0, 0.0, 100.0},
    {"variation.parting_m", &VariationSettings::parting, kChance, QT_TRANSLATE_NOOP("GroupSchema", "Loose parting"),
     QT_TRANSLATE_NOOP("GroupSchema", "How far from a parting hairs still cross it"),
     QT_TRANSLATE_NOOP("GroupSchema", "mm"), 1000.0, 0.0, 0.01, 0.0, 10.0, 1},
    {"variation.most_shorter_m", &VariationSettings::mostShorterM, kChance,
     QT_TRANSLATE_NOOP("GroupSchema", "Uneven by at most"),
     QT_TRANSLATE_NOOP("GroupSchema", "How much shorter single hairs are at most; at 0 there is no limit"),
     QT_TRANSLATE_NOOP("GroupSchema", "cm"), 100.0, 0.0, 0.2, 0.0, 10.0, 1, 2.0F},
    {"variation.part_gap_m", &VariationSettings::partGapM, kChance, QT_TRANSLATE_NOOP("GroupSchema", "Bare parting"),
     QT_TRANSLATE_NOOP("GroupSchema", "Width of the line of skin that a parting bares"),
     QT_TRANSLATE_NOOP("GroupSchema", "mm"), 1000.0, 0.0, 0.01, 0.0, 10.0, 1},
    {"variation.patches", &VariationSettings::patches, kChance, QT_TRANSLATE_NOOP("GroupSchema", "Uneven patches"),
     QT_TRANSLATE_NOOP("GroupSchema", "How far density and length differ in soft patches"), "%", 100.0, 0.0, 1.0, 0.0,
     100.0},
    {"hairline.soften_m", &HairlineSettings::softenM, kChance, QT_TRANSLATE_NOOP("GroupSchema", "Soft hairline"),
     QT_TRANSLATE_NOOP("GroupSchema", "Width over which hair grows thinner, shorter and finer towards bare skin"),
     QT_TRANSLATE_NOOP("GroupSchema", "mm"), 1000.0, 0.0, 0.03, 0.0, 20.0, 1},
    {"hairline.baby", &HairlineSettings::baby, kChance, QT_TRANSLATE_NOOP("GroupSchema", "Baby hairs"),
     QT_TRANSLATE_NOOP("GroupSchema", "How many hairs of a soft hairline are short, fine and curl a little"), "%",
     100.0, 0.0, 1.0, 0.0, 100.0},
    {"hairline.uneven", &HairlineSettings::uneven, kChance, QT_TRANSLATE_NOOP("GroupSchema", "Uneven hairline"),
     QT_TRANSLATE_NOOP("GroupSchema", "How far a soft hairline wavers"), "%", 100.0, 0.0, 1.0, 0.0, 100.0},
    {"greatest_frizz_m", &GroupSettings::greatestFrizzM, kShape, QT_TRANSLATE_NOOP("GroupSchema", "Greatest frizz"),
     QT_TRANSLATE_NOOP("GroupSchema", "How far hair strays from its course where the frizz map is brightest"),
     QT_TRANSLATE_NOOP("GroupSchema", "mm"), 1000.0, 0.0, 0.05, 0.0, 20.0, 1, 2.0F},
    {"braid_spacing_m", &GroupSettings::braidSpacingM, kBraid, QT_TRANSLATE_NOOP("GroupSchema", "Spacing"),
     QT_TRANSLATE_NOOP("GroupSchema", "Distance between braids in one painted patch"),
     QT_TRANSLATE_NOOP("GroupSchema", "cm"), 100.0, 0.005, 2.0, 0.5, 60.0, 1, 2.0F},
    {"braid_radius_m", &GroupSettings::braidRadiusM, kBraid, QT_TRANSLATE_NOOP("GroupSchema", "Radius"),
     QT_TRANSLATE_NOOP("GroupSchema", "Thickness of a braid; one of few hairs is thinner"),
     QT_TRANSLATE_NOOP("GroupSchema", "mm"), 1000.0, 0.0005, 0.2, 1.0, 50.0, 1, 1.5F},
    {"braid_knot", &GroupSettings::braidKnot, kBraid, QT_TRANSLATE_NOOP("GroupSchema", "Knot length"),
     QT_TRANSLATE_NOOP("GroupSchema", "How long the turns of a braid are; at 100 % its wisps fit each other"), "%",
     100.0, 0.5, 3.0, 50.0, 300.0},
    {"braid_tightness", &GroupSettings::braidTightness, kBraid, QT_TRANSLATE_NOOP("GroupSchema", "Tightness"),
     QT_TRANSLATE_NOOP("GroupSchema", "How tight braids are laced: loose ones are full, and hairs leave them"), "%",
     100.0, 0.0, 1.0, 0.0, 100.0},
    {"braid_taper", &GroupSettings::braidTaper, kBraid, QT_TRANSLATE_NOOP("GroupSchema", "Taper"),
     QT_TRANSLATE_NOOP("GroupSchema", "How much thinner a braid is at its end"), "%", 100.0, 0.0, 0.9, 0.0, 90.0},
    {"braid_tie", &GroupSettings::braidTie, kBraid, QT_TRANSLATE_NOOP("GroupSchema", "Tie"),
     QT_TRANSLATE_NOOP("GroupSchema", "How far a braid is drawn together before its loose end"), "%", 100.0, 0.0, 1.0,
     0.0, 100.0},
    {"physics.volume_m", &PhysicsSettings::volumeM, kMotion, QT_TRANSLATE_NOOP("GroupSchema", "Volume"),
     QT_TRANSLATE_NOOP("GroupSchema", "Thickness of the whole coat of hair"), QT_TRANSLATE_NOOP("GroupSchema", "mm"),
     1000.0, 0.0, 0.05, 0.0, 50.0, 1, 1.5F},
    {"physics.volume_rise_m", &PhysicsSettings::volumeRiseM, kMotion,
     QT_TRANSLATE_NOOP("GroupSchema", "Volume rises over"),
     QT_TRANSLATE_NOOP("GroupSchema", "How far from its roots hair reaches its height in the coat"),
     QT_TRANSLATE_NOOP("GroupSchema", "cm"), 100.0, 0.0, 0.2, 0.0, 15.0, 1},
    {"physics.coat_body", &PhysicsSettings::body, kMotion, QT_TRANSLATE_NOOP("GroupSchema", "Body"),
     QT_TRANSLATE_NOOP("GroupSchema", "How strongly hair keeps out of hair and moves along with it"), "%", 100.0, 0.0,
     1.0, 0.0, 100.0},
    {"physics.loft", &PhysicsSettings::loft, kMotion, QT_TRANSLATE_NOOP("GroupSchema", "Loft"),
     QT_TRANSLATE_NOOP("GroupSchema", "How well the coat keeps its height under its weight"), "%", 100.0, 0.0, 1.0, 0.0,
     100.0},
    {"physics.stiffness_m", &PhysicsSettings::stiffnessM, kMotion, QT_TRANSLATE_NOOP("GroupSchema", "Stands up to"),
     QT_TRANSLATE_NOOP("GroupSchema", "A hair so long nearly carries itself; shorter hair stands, longer hair hangs"),
     QT_TRANSLATE_NOOP("GroupSchema", "cm"), 100.0, 0.0, 0.3, 0.0, 20.0, 1, 2.0F},
    {"physics.gravity_scale", &PhysicsSettings::gravityScale, kMotion, QT_TRANSLATE_NOOP("GroupSchema", "Gravity"),
     QT_TRANSLATE_NOOP("GroupSchema", "100 % is as on earth"), "%", 100.0, 0.0, 2.0, 0.0, 200.0},
    {"physics.wind_scale", &PhysicsSettings::windScale, kMotion, QT_TRANSLATE_NOOP("GroupSchema", "Moved by wind"),
     QT_TRANSLATE_NOOP("GroupSchema", "How strongly the wind takes this hair"), "%", 100.0, 0.0, 4.0, 0.0, 400.0, 0,
     2.0F},
    {"physics.damping_per_s", &PhysicsSettings::damping, kMotion, QT_TRANSLATE_NOOP("GroupSchema", "Damping"),
     QT_TRANSLATE_NOOP("GroupSchema", "How soon motion dies down"), QT_TRANSLATE_NOOP("GroupSchema", "per s"), 1.0, 0.0,
     20.0, 0.0, 20.0, 1, 2.0F},
    {"physics.friction", &PhysicsSettings::friction, kMotion, QT_TRANSLATE_NOOP("GroupSchema", "Friction"),
     QT_TRANSLATE_NOOP("GroupSchema", "How much hair sticks to the head"), "%", 100.0, 0.0, 1.0, 0.0, 100.0},
    {"material.shine", &StrandMaterial::shine, kLook, QT_TRANSLATE_NOOP("GroupSchema", "Shine"),
     QT_TRANSLATE_NOOP("GroupSchema", "Strength of the highlights"), "%", 100.0, 0.0, 1.0, 0.0, 100.0},
    {"material.roughness", &StrandMaterial::roughness, kLook, QT_TRANSLATE_NOOP("GroupSchema", "Roughness"),
     QT_TRANSLATE_NOOP("GroupSchema", "Width of the highlights"), "%", 100.0, 0.05, 1.0, 5.0, 100.0},
    {"material.colour_variation", &StrandMaterial::colourVariation, kLook,
     QT_TRANSLATE_NOOP("GroupSchema", "Colour variation"),
     QT_TRANSLATE_NOOP("GroupSchema", "Difference between neighbouring hairs"), "%", 100.0, 0.0, 1.0, 0.0, 100.0},
    {"material.scalp_tint", &StrandMaterial::scalpTint, kLook, QT_TRANSLATE_NOOP("GroupSchema", "Scalp tint"),
     QT_TRANSLATE_NOOP("GroupSchema", "How much the roots darken the skin where they are dense"), "%", 100.0, 0.0, 1.0,
     0.0, 100.0},
    {"material.tip_alpha", &StrandMaterial::tipAlpha, kLook, QT_TRANSLATE_NOOP("GroupSchema", "Opacity at the tip"),
     QT_TRANSLATE_NOOP("GroupSchema", "Less makes hair thin out"), "%", 100.0, 0.0, 1.0, 0.0, 100.0},
    {"material.taper_m", &StrandMaterial::taperM, kLook, QT_TRANSLATE_NOOP("GroupSchema", "Taper"),
     QT_TRANSLATE_NOOP("GroupSchema", "Length over which a hair thins out to its tip; at 0 it does over all of it"),
     QT_TRANSLATE_NOOP("GroupSchema", "mm"), 1000.0, 0.0, 0.5, 0.0, 100.0, 0, 2.0F},
    {"material.tip_from", &StrandMaterial::tipFrom, kLook, QT_TRANSLATE_NOOP("GroupSchema", "Tip colour from"),
     QT_TRANSLATE_NOOP("GroupSchema", "How far from the root the tip colour begins, of the length"), "%", 100.0, 0.0,
     1.0, 0.0, 100.0},
    {"material.tip_over", &StrandMaterial::tipOver, kLook, QT_TRANSLATE_NOOP("GroupSchema", "Tip colour over"),
     QT_TRANSLATE_NOOP("GroupSchema", "How softly it begins: at 0 % in a line, at 100 % all the way to the tip"), "%",
     100.0, 0.0, 1.0, 0.0, 100.0},
    {"material.section_axes", &StrandMaterial::sectionAxes, kLook, QT_TRANSLATE_NOOP("GroupSchema", "Flat fibres"),
     QT_TRANSLATE_NOOP("GroupSchema", "Longest over shortest diameter of a hair: round is 1, coily hair nearly 2"), "",
     1.0, 1.0, 3.0, 1.0, 3.0, 1},
    {"material.root_alpha", &StrandMaterial::rootAlpha, kLook, QT_TRANSLATE_NOOP("GroupSchema", "Opacity at the root"),
     QT_TRANSLATE_NOOP("GroupSchema", "Less lets the skin show through"), "%", 100.0, 0.0, 1.0, 0.0, 100.0},
};

/// The part of the settings that a member belongs to.
template<typename Settings, typename T>
auto& memberOf(Settings& settings, T GroupSettings::*member)
{
    return settings.*member;
}
template<typename Settings>
auto& memberOf(Settings& settings, float CurlSettings::*member)
{
    return settings.curl.*member;
}
template<typename Settings>
auto& memberOf(Settings& settings, float LockSettings::*member)
{
    return settings.locks.*member;
}
template<typename Settings>
auto& memberOf(Settings& settings, float VariationSettings::*member)
{
    return settings.variation.*member;
}
template<typename Settings>
auto& memberOf(Settings& settings, float HairlineSettings::*member)
{
    return settings.hairline.*member;
}
template<typename Settings>
auto& memberOf(Settings& settings, float PhysicsSettings::*member)
{
    return settings.physics.*member;
}
template<typename Settings>
auto& memberOf(Settings& settings, float StrandMaterial::*member)
{
    return settings.material.*member;
}

} // namespace

double GroupSetting::read(const GroupSettings& settings) const
{
    return std::visit([&](auto one) { return static_cast<double>(memberOf(settings, one)); }, member);
}

void GroupSetting::write(GroupSettings& settings, double value) const
{
    std::visit(
        [&](auto one) {
            auto& field = memberOf(settings, one);
            using Field = std::remove_reference_t<decltype(field)>;
            if constexpr (std::is_same_v<Field, float>)
                field = static_cast<float>(value);
            else
                field = static_cast<Field>(std::lround(value));
        },
        member);
}

double GroupSetting::shown(const GroupSettings& settings, double scalpFraction) const
{
    return countsOnScalp ? std::floor(read(settings) * scalpFraction) : read(settings) * shownPerSi;
}

void GroupSetting::writeShown(GroupSettings& settings, double value, double scalpFraction) const
{
    write(settings, std::clamp(countsOnScalp ? std::ceil(value / scalpFraction) : value / shownPerSi, least, greatest));
}

void makeNatural(GroupSettings& settings)
{
    settings.variation = {.length = 0.08F,
                          .curl = 0.12F,
                          .width = 0.2F,
                          .crossing = 0.08F,
                          .flyaways = 0.012F,
                          .parting = 0.004F,
                          .mostShorterM = 0.015F,
                          .partGapM = 0.002F,
                          .patches = 0.3F};
    settings.hairline = {.softenM = 0.008F, .baby = 0.35F, .uneven = 0.8F};
    settings.physics.volumeRiseM = 0.05F;
    settings.physics.body = 0.5F;
    settings.physics.loft = 0.8F;
    settings.material.scalpTint = 0.9F;
    settings.material.sectionAxes = 1.3F;
    settings.material.taperM = 0.012F; // Cut hair ends: it thins out over its last centimetre alone.
}

GroupSettings newGroupSettings(double scalpFraction)
{
    GroupSettings settings;
    groupSetting(QLatin1StringView("basis_hairs")).writeShown(settings, kBasisHairs, scalpFraction);
    return settings;
}

std::span<const GroupSetting> groupSchema()
{
    return kSettings;
}

const GroupSetting& groupSetting(QLatin1StringView key)
{
    const auto* found =
        std::ranges::find_if(kSettings, [&](const GroupSetting& row) { return key == QLatin1StringView(row.key); });
    Q_ASSERT(found != std::end(kSettings));
    return *found;
}

QString schemaText(const char* text)
{
    return *text == '\0' ? QString() : QCoreApplication::translate("GroupSchema", text);
}

} // namespace hairpaint::model
