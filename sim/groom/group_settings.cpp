// The one table of what settings affect.
#include "sim/groom/group_settings.h"

#include <algorithm>
#include <cassert>
#include <iterator>

namespace hairpaint::sim {

namespace {

struct SettingEffect
{
    SettingMember setting;
    Affects affects;
};

constexpr SettingEffect kSettingEffects[] = {
    {&GroupSettings::greatestDensityPerM2, Affects::Roots},
    {&GroupSettings::basisHairs, Affects::Roots},
    {&GroupSettings::greatestLengthM, Affects::Hairs},
    {&GroupSettings::shortestLengthM, Affects::Hairs},
    {&GroupSettings::nodesPerHair, Affects::Hairs | Affects::Motion},
    {&GroupSettings::turnsMode, Affects::Hairs},
    {&GroupSettings::steppedTurns, Affects::Hairs},
    {&GroupSettings::turnsPerLengthM, Affects::Hairs},
    {&GroupSettings::greatestCurlRadiusM, Affects::Hairs},
    {&GroupSettings::greatestFrizzM, Affects::Hairs},
    {&GroupSettings::braidSpacingM, Affects::Hairs},
    {&GroupSettings::braidRadiusM, Affects::Hairs},
    {&GroupSettings::braidKnot, Affects::Hairs},
    {&GroupSettings::braidTightness, Affects::Hairs},
    {&GroupSettings::braidTaper, Affects::Hairs},
    {&GroupSettings::braidTie, Affects::Hairs},
    {&GroupSettings::lengthAsCut, Affects::Hairs},
    {&CurlSettings::diameterM, Affects::Hairs},
    {&CurlSettings::pitchM, Affects::Hairs},
    {&CurlSettings::flatness, Affects::Hairs},
    {&CurlSettings::inStepFromM, Affects::Hairs},
    {&CurlSettings::switchbacksPerM, Affects::Hairs},
    {&CurlSettings::skips, Affects::Hairs},
    {&CurlSettings::uncoil, Affects::Hairs},
    {&CurlSettings::gather, Affects::Hairs},
    {&CurlSettings::straightM, Affects::Hairs},
    {&LockSettings::sizeM, Affects::Hairs},
    {&LockSettings::small, Affects::Hairs},
    {&LockSettings::flatness, Affects::Hairs},
    {&LockSettings::twistsPerM, Affects::Hairs},
    {&LockSettings::ragged, Affects::Hairs},
    {&LockSettings::parting, Affects::Hairs},
    {&VariationSettings::length, Affects::Hairs},
    {&VariationSettings::curl, Affects::Hairs},
    {&VariationSettings::width, Affects::Hairs},
    {&VariationSettings::crossing, Affects::Hairs},
    {&VariationSettings::flyaways, Affects::Hairs},
    {&VariationSettings::grey, Affects::Hairs},
    {&VariationSettings::parting, Affects::Hairs},
    {&VariationSettings::mostShorterM, Affects::Hairs},
    {&VariationSettings::partGapM, Affects::Hairs},
    {&VariationSettings::patches, Affects::Hairs},
    {&HairlineSettings::softenM, Affects::Hairs},
    {&HairlineSettings::baby, Affects::Hairs},
    {&HairlineSettings::uneven, Affects::Hairs},
    // Hair is laid in the coat, and kept out of the ellipsoids by its height in it.
    {&PhysicsSettings::volumeM, Affects::Hairs | Affects::Motion},
    {&PhysicsSettings::volumeRiseM, Affects::Hairs},
    {&PhysicsSettings::damping, Affects::Motion},
    {&PhysicsSettings::gravityScale, Affects::Motion},
    {&PhysicsSettings::windScale, Affects::Motion},
    {&PhysicsSettings::stiffnessM, Affects::Motion},
    {&PhysicsSettings::friction, Affects::Motion},
    {&PhysicsSettings::body, Affects::Motion},
    {&PhysicsSettings::loft, Affects::Motion},
    {&StrandMaterial::widthM, Affects::Look},
    {&StrandMaterial::shine, Affects::Look},
    {&StrandMaterial::roughness, Affects::Look},
    {&StrandMaterial::rootAlpha, Affects::Look},
    {&StrandMaterial::tipAlpha, Affects::Look},
    {&StrandMaterial::colourVariation, Affects::Look},
    {&StrandMaterial::scalpTint, Affects::Look},
    {&StrandMaterial::taperM, Affects::Look},
    {&StrandMaterial::tipFrom, Affects::Look},
    {&StrandMaterial::tipOver, Affects::Look},
    {&StrandMaterial::sectionAxes, Affects::Look},
};

/// The part of the settings that a member belongs to.
template<typename T>
const GroupSettings& partOf(const GroupSettings& settings, T GroupSettings::* /*member*/)
{
    return settings;
}
const CurlSettings& partOf(const GroupSettings& settings, float CurlSettings::* /*member*/)
{
    return settings.curl;
}
const LockSettings& partOf(const GroupSettings& settings, float LockSettings::* /*member*/)
{
    return settings.locks;
}
const VariationSettings& partOf(const GroupSettings& settings, float VariationSettings::* /*member*/)
{
    return settings.variation;
}
const HairlineSettings& partOf(const GroupSettings& settings, float HairlineSettings::* /*member*/)
{
    return settings.hairline;
}
const PhysicsSettings& partOf(const GroupSettings& settings, float PhysicsSettings::* /*member*/)
{
    return settings.physics;
}
const StrandMaterial& partOf(const GroupSettings& settings, float StrandMaterial::* /*member*/)
{
    return settings.material;
}

bool sameSetting(const SettingMember& setting, const GroupSettings& a, const GroupSettings& b)
{
    return std::visit([&](auto member) { return partOf(a, member).*member == partOf(b, member).*member; }, setting);
}

} // namespace

Affects affectsOf(const SettingMember& setting)
{
    const auto* row = std::ranges::find(kSettingEffects, setting, &SettingEffect::setting);
    assert(row != std::end(kSettingEffects));
    return row->affects;
}

bool sameFor(Affects asked, const GroupSettings& a, const GroupSettings& b)
{
    return std::ranges::all_of(kSettingEffects, [&](const SettingEffect& row) {
        return !affectsAny(row.affects, asked) || sameSetting(row.setting, a, b);
    });
}

} // namespace hairpaint::sim
