// The table of hair types.
#include "model/project/hair_types.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace hairpaint::model {

namespace {

using sim::CurlSettings;

constexpr float kNever = 1.0F; ///< A distance, m, from the scalp that no hair reaches.

/// Straight length, m, before a coil: hair that curls at its root would stand off the head.
constexpr float kStraightM = 0.004F;

/// Diameters in mm, distances from the scalp in cm, switchbacks in 10 cm.
constexpr CurlSettings curl(float diameterMm, float pitchPerDiameter, float flatness, float inStepCm, float switchbacks,
                            float skips, float uncoil, float gather)
{
    return {.diameterM = diameterMm * 1e-3F,
            .pitchM = diameterMm * 1e-3F * pitchPerDiameter,
            .flatness = flatness,
            .inStepFromM = inStepCm * 1e-2F,
            .switchbacksPerM = switchbacks * 10.0F,
            .skips = skips,
            .uncoil = uncoil,
            .gather = gather,
            .straightM = flatness > 0.5F ? 0.0F : kStraightM};
}

/// Locks about as far apart as their coils are wide, so that each is seen.
constexpr std::array kTypes{
    HairType{"1A", {.diameterM = 0.0F, .pitchM = 1.0F, .skips = 0.01F}, 0.0F, 1.2F},
    HairType{
        "1B", {.diameterM = 0.006F, .pitchM = 0.3F, .flatness = 1.0F, .skips = 0.01F, .gather = 0.05F}, 0.0F, 1.3F},
    // An S whose bends have a diameter of 200 mm.
    HairType{"1C", {.diameterM = 0.02F, .pitchM = 0.2F, .flatness = 1.0F, .skips = 0.01F, .gather = 0.1F}, 0.02F, 1.4F},
    HairType{"2A", curl(60.0F, 6.0F, 1.0F, 1.0F, 0.0F, 0.03F, 0.1F, 0.3F), 0.025F, 1.3F},
    HairType{"2B", curl(45.0F, 5.0F, 1.0F, 1.0F, 0.0F, 0.03F, 0.1F, 0.45F), 0.022F, 1.3F},
    HairType{"2C", curl(30.0F, 4.0F, 0.9F, 1.0F, 0.0F, 0.03F, 0.1F, 0.6F), 0.018F, 1.3F},
    HairType{"3A", curl(25.0F, 3.0F, 0.0F, 1.0F, 0.3F, 0.05F, 0.15F, 0.8F), 0.02F, 1.6F},
    HairType{"3B", curl(15.0F, 2.6F, 0.0F, 1.5F, 0.5F, 0.06F, 0.15F, 0.85F), 0.014F, 1.6F},
    HairType{"3C", curl(9.0F, 2.0F, 0.0F, 2.0F, 1.0F, 0.08F, 0.1F, 0.8F), 0.009F, 1.6F},
    HairType{"4A", curl(6.0F, 1.5F, 0.0F, 2.0F, 2.0F, 0.10F, 0.05F, 0.7F), 0.006F, 1.9F},
    HairType{"4B", curl(4.0F, 1.1F, 0.6F, 3.0F, 4.0F, 0.15F, 0.0F, 0.5F), 0.005F, 1.9F},
    HairType{"4C", curl(2.5F, 0.8F, 0.0F, kNever * 100.0F, 6.0F, 0.25F, 0.0F, 0.3F), 0.005F, 1.9F},
};

} // namespace

std::span<const HairType> hairTypes()
{
    return kTypes;
}

const HairType& hairType(std::string_view name)
{
    const auto* found = std::ranges::find_if(kTypes, [&](const HairType& type) { return name == type.name; });
    assert(found != kTypes.end());
    return *found;
}

std::optional<std::size_t> hairTypeOf(const sim::GroupSettings& settings)
{
    const auto* found = std::ranges::find_if(kTypes, [&](const HairType& type) {
        return type.curl == settings.curl && type.lockSizeM == settings.locks.sizeM;
    });
    if (settings.turnsMode != sim::TurnsMode::Coils || found == kTypes.end())
        return std::nullopt;
    return static_cast<std::size_t>(found - kTypes.begin());
}

void setHairType(sim::GroupSettings& settings, const HairType& type)
{
    settings.turnsMode = sim::TurnsMode::Coils;
    settings.curl = type.curl;
    settings.locks.sizeM = type.lockSizeM;
    settings.material.sectionAxes = type.sectionAxes;
}

} // namespace hairpaint::model
