// The table of a hair group's numbers.
#include "view/panels/hair_settings.h"

#include <QCoreApplication>

#include <cmath>

namespace hairpaint::view {

namespace {

using sim::GroupSettings;

/// Reads and writes one member, shown as `factor` times its SI value.
template<auto field, int factor>
constexpr auto kRead = [](const GroupSettings& settings) { return static_cast<double>(settings.*field) * factor; };
template<auto field, int factor>
constexpr auto kWrite =
    [](GroupSettings& settings, double shown) { settings.*field = static_cast<float>(shown / factor); };
template<auto part, auto field, int factor>
constexpr auto kReadIn =
    [](const GroupSettings& settings) { return static_cast<double>(settings.*part.*field) * factor; };
template<auto part, auto field, int factor>
constexpr auto kWriteIn =
    [](GroupSettings& settings, double shown) { settings.*part.*field = static_cast<float>(shown / factor); };
template<auto field>
constexpr auto kReadCount = [](const GroupSettings& settings) { return static_cast<double>(settings.*field); };
template<auto field>
constexpr auto kWriteCount =
    [](GroupSettings& settings, double shown) { settings.*field = static_cast<int>(std::lround(shown)); };

constexpr auto kBodies = &GroupSettings::physics;
constexpr auto kLooks = &GroupSettings::material;
using sim::PhysicsSettings;
using sim::StrandMaterial;
constexpr auto kShape = SettingSection::Shape;
constexpr auto kBraid = SettingSection::Braid;
constexpr auto kPhysics = SettingSection::Physics;
constexpr auto kLook = SettingSection::Look;

/// In each section the ones first that most people reach for.
constexpr SettingRow kRows[] = {
    {kShape, QT_TRANSLATE_NOOP("HairSettings", "Greatest length"),
     QT_TRANSLATE_NOOP("HairSettings", "Length where the length map is brightest"),
     QT_TRANSLATE_NOOP("HairSettings", "cm"), 0.1, 200.0, 1, 2.0, kRead<&GroupSettings::greatestLengthM, 100>,
     kWrite<&GroupSettings::greatestLengthM, 100>},
    {kShape, QT_TRANSLATE_NOOP("HairSettings", "Greatest density"),
     QT_TRANSLATE_NOOP("HairSettings", "Hairs where the density map is brightest"),
     QT_TRANSLATE_NOOP("HairSettings", "hairs/cm²"), 1.0, 400.0, 0, 2.0,
     [](const GroupSettings& settings) { return static_cast<double>(settings.greatestDensityPerM2) * 1e-4; },
     [](GroupSettings& settings, double shown) { settings.greatestDensityPerM2 = static_cast<float>(shown * 1e4); }},
    {kShape, QT_TRANSLATE_NOOP("HairSettings", "Hair width"), QT_TRANSLATE_NOOP("HairSettings", "Diameter of one hair"),
     QT_TRANSLATE_NOOP("HairSettings", "µm"), 10.0, 1000.0, 0, 2.0, kRead<&GroupSettings::hairWidthM, 1'000'000>,
     kWrite<&GroupSettings::hairWidthM, 1'000'000>},
    {kShape, QT_TRANSLATE_NOOP("HairSettings", "Curl radius"),
     QT_TRANSLATE_NOOP("HairSettings", "Greatest radius of a curl"), QT_TRANSLATE_NOOP("HairSettings", "mm"), 0.0, 60.0,
     1, 1.5, kRead<&GroupSettings::greatestCurlRadiusM, 1000>, kWrite<&GroupSettings::greatestCurlRadiusM, 1000>},
    {kShape, QT_TRANSLATE_NOOP("HairSettings", "Shortest length"),
     QT_TRANSLATE_NOOP("HairSettings", "Length where the length map is 0"), QT_TRANSLATE_NOOP("HairSettings", "cm"),
     0.0, 50.0, 1, 2.0, kRead<&GroupSettings::shortestLengthM, 100>, kWrite<&GroupSettings::shortestLengthM, 100>},
    {kShape, QT_TRANSLATE_NOOP("HairSettings", "Nodes per hair"),
     QT_TRANSLATE_NOOP("HairSettings", "More bend more finely and cost more"), "", 4.0, 32.0, 0, 1.0,
     kReadCount<&GroupSettings::nodesPerHair>, kWriteCount<&GroupSettings::nodesPerHair>},
    {kShape, QT_TRANSLATE_NOOP("HairSettings", "Basis hairs"),
     QT_TRANSLATE_NOOP("HairSettings", "Hairs that are simulated; the others follow them"), "", 256.0, 20000.0, 0, 2.0,
     kReadCount<&GroupSettings::basisHairs>, kWriteCount<&GroupSettings::basisHairs>},
    {kBraid, QT_TRANSLATE_NOOP("HairSettings", "Spacing"),
     QT_TRANSLATE_NOOP("HairSettings", "Distance between braids in one painted patch"),
     QT_TRANSLATE_NOOP("HairSettings", "cm"), 0.5, 60.0, 1, 2.0, kRead<&GroupSettings::braidSpacingM, 100>,
     kWrite<&GroupSettings::braidSpacingM, 100>},
    {kBraid, QT_TRANSLATE_NOOP("HairSettings", "Radius"), QT_TRANSLATE_NOOP("HairSettings", "Thickness of a braid"),
     QT_TRANSLATE_NOOP("HairSettings", "mm"), 1.0, 50.0, 1, 1.5, kRead<&GroupSettings::braidRadiusM, 1000>,
     kWrite<&GroupSettings::braidRadiusM, 1000>},
    {kPhysics, QT_TRANSLATE_NOOP("HairSettings", "Volume"),
     QT_TRANSLATE_NOOP("HairSettings", "Thickness of the whole coat of hair"), QT_TRANSLATE_NOOP("HairSettings", "mm"),
     0.0, 50.0, 1, 1.5, kReadIn<kBodies, &PhysicsSettings::volumeM, 1000>,
     kWriteIn<kBodies, &PhysicsSettings::volumeM, 1000>},
    {kPhysics, QT_TRANSLATE_NOOP("HairSettings", "Parting"),
     QT_TRANSLATE_NOOP("HairSettings", "How far long hair is combed to either side of the middle"), "%", 0.0, 100.0, 0,
     1.0, kReadIn<kBodies, &PhysicsSettings::parting, 100>, kWriteIn<kBodies, &PhysicsSettings::parting, 100>},
    {kPhysics, QT_TRANSLATE_NOOP("HairSettings", "Sweep back"),
     QT_TRANSLATE_NOOP("HairSettings", "How far long hair is combed away from the face"), "%", 0.0, 100.0, 0, 1.0,
     kReadIn<kBodies, &PhysicsSettings::sweepBack, 100>, kWriteIn<kBodies, &PhysicsSettings::sweepBack, 100>},
    {kPhysics, QT_TRANSLATE_NOOP("HairSettings", "Body"),
     QT_TRANSLATE_NOOP("HairSettings", "How firmly hair keeps its shape near the root"), "%", 0.0, 100.0, 0, 1.0,
     kReadIn<kBodies, &PhysicsSettings::body, 100>, kWriteIn<kBodies, &PhysicsSettings::body, 100>},
    {kPhysics, QT_TRANSLATE_NOOP("HairSettings", "Gravity"), QT_TRANSLATE_NOOP("HairSettings", "100 % is as on earth"),
     "%", 0.0, 200.0, 0, 1.0, kReadIn<kBodies, &PhysicsSettings::gravityScale, 100>,
     kWriteIn<kBodies, &PhysicsSettings::gravityScale, 100>},
    {kPhysics, QT_TRANSLATE_NOOP("HairSettings", "Wind"),
     QT_TRANSLATE_NOOP("HairSettings", "How strongly the wind takes this hair"), "%", 0.0, 400.0, 0, 2.0,
     kReadIn<kBodies, &PhysicsSettings::windScale, 100>, kWriteIn<kBodies, &PhysicsSettings::windScale, 100>},
    {kPhysics, QT_TRANSLATE_NOOP("HairSettings", "Damping"),
     QT_TRANSLATE_NOOP("HairSettings", "How soon motion dies down"), QT_TRANSLATE_NOOP("HairSettings", "per s"), 0.0,
     20.0, 1, 2.0, kReadIn<kBodies, &PhysicsSettings::damping, 1>, kWriteIn<kBodies, &PhysicsSettings::damping, 1>},
    {kPhysics, QT_TRANSLATE_NOOP("HairSettings", "Friction"),
     QT_TRANSLATE_NOOP("HairSettings", "How much hair sticks to the head"), "%", 0.0, 100.0, 0, 1.0,
     kReadIn<kBodies, &PhysicsSettings::friction, 100>, kWriteIn<kBodies, &PhysicsSettings::friction, 100>},
    {kLook, QT_TRANSLATE_NOOP("HairSettings", "Shine"), QT_TRANSLATE_NOOP("HairSettings", "Strength of the highlights"),
     "%", 0.0, 100.0, 0, 1.0, kReadIn<kLooks, &StrandMaterial::shine, 100>,
     kWriteIn<kLooks, &StrandMaterial::shine, 100>},
    {kLook, QT_TRANSLATE_NOOP("HairSettings", "Roughness"),
     QT_TRANSLATE_NOOP("HairSettings", "Width of the highlights"), "%", 5.0, 100.0, 0, 1.0,
     kReadIn<kLooks, &StrandMaterial::roughness, 100>, kWriteIn<kLooks, &StrandMaterial::roughness, 100>},
    {kLook, QT_TRANSLATE_NOOP("HairSettings", "Colour variation"),
     QT_TRANSLATE_NOOP("HairSettings", "Difference between neighbouring hairs"), "%", 0.0, 100.0, 0, 1.0,
     kReadIn<kLooks, &StrandMaterial::colourVariation, 100>, kWriteIn<kLooks, &StrandMaterial::colourVariation, 100>},
    {kLook, QT_TRANSLATE_NOOP("HairSettings", "Opacity at the tip"),
     QT_TRANSLATE_NOOP("HairSettings", "Less makes hair thin out"), "%", 0.0, 100.0, 0, 1.0,
     kReadIn<kLooks, &StrandMaterial::tipAlpha, 100>, kWriteIn<kLooks, &StrandMaterial::tipAlpha, 100>},
    {kLook, QT_TRANSLATE_NOOP("HairSettings", "Opacity at the root"),
     QT_TRANSLATE_NOOP("HairSettings", "Less lets the skin show through"), "%", 0.0, 100.0, 0, 1.0,
     kReadIn<kLooks, &StrandMaterial::rootAlpha, 100>, kWriteIn<kLooks, &StrandMaterial::rootAlpha, 100>},
};

} // namespace

std::span<const SettingRow> settingRows()
{
    return kRows;
}

QString settingText(const char* text)
{
    return QCoreApplication::translate("HairSettings", text);
}

} // namespace hairpaint::view
