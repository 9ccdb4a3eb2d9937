// Styles applied to projects, group by group.
#include "model/styles/style_use.h"

#include "model/maps/compositor.h"
#include "model/project/group_schema.h"
#include "model/project/worn_on_ties.h"
#include "model/styles/hair_kinds.h"
#include "model/styles/style_mix.h"
#include "model/styles/style_transfer.h"
#include "model/styles/worn_transfer.h"
#include "model/values/names.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace hairpaint::model {

namespace {

constexpr QLatin1StringView kScalp("Scalp"); ///< A HairKind's name.
constexpr double kHalf = 0.5;                ///< From this fraction on a style brings what can't be mixed.

constexpr std::array kColourMaps{MapKind::Colour, MapKind::TipColour, MapKind::TipStart};
constexpr std::array kColourSettings{"material.colour_variation", "variation.grey", "material.tip_from",
                                     "material.tip_over"};
constexpr std::array kCutMaps{MapKind::Density, MapKind::Length, MapKind::Direction};
constexpr std::array kCutSettings{"greatest_length_m", "shortest_length_m",   "greatest_density_per_m2",
                                  "variation.length",  "material.taper_m",    "hairline.soften_m",
                                  "hairline.baby",     "hairline.uneven",     "variation.most_shorter_m",
                                  "variation.patches", "variation.parting_m", "variation.part_gap_m"};
constexpr std::array kCurlMaps{MapKind::Curl, MapKind::CurlSize, MapKind::Clump, MapKind::Frizz};
constexpr std::array kCurlSettings{"greatest_curl_radius_m",
                                   "turns_mode",
                                   "turns_per_length_m",
                                   "stepped_turns",
                                   "variation.curl",
                                   "greatest_frizz_m",
                                   "curl.diameter_m",
                                   "curl.pitch_m",
                                   "curl.flatness",
                                   "curl.in_step_from_m",
                                   "curl.switchbacks_per_m",
                                   "curl.skips",
                                   "curl.uncoil",
                                   "curl.length_as_cut",
                                   "curl.gather",
                                   "locks.size_m",
                                   "locks.small",
                                   "locks.flatness",
                                   "locks.twists_per_m",
                                   "locks.ragged",
                                   "locks.parting",
                                   "material.section_axes",
                                   "curl.straight_m"};

constexpr std::array kTieMaps{MapKind::Braid, MapKind::Accessory};
constexpr std::array kTieSettings{"braid_spacing_m", "braid_radius_m", "braid_tightness",
                                  "braid_taper",     "braid_tie",      "braid_knot"};

constexpr std::array kParts{
    StylePartSpec{.part = StylePart::All,
                  .title = QT_TRANSLATE_NOOP("StyleParts", "All of it"),
                  .step = QT_TRANSLATE_NOOP("StyleParts", "Apply style \"%1\"")},
    StylePartSpec{.part = StylePart::Colour,
                  .title = QT_TRANSLATE_NOOP("StyleParts", "Only its colour"),
                  .step = QT_TRANSLATE_NOOP("StyleParts", "Style \"%1\" (colour only)"),
                  .maps = kColourMaps,
                  .settings = kColourSettings},
    StylePartSpec{.part = StylePart::Cut,
                  .title = QT_TRANSLATE_NOOP("StyleParts", "Only its cut"),
                  .step = QT_TRANSLATE_NOOP("StyleParts", "Style \"%1\" (cut only)"),
                  .maps = kCutMaps,
                  .settings = kCutSettings},
    StylePartSpec{.part = StylePart::Curl,
                  .title = QT_TRANSLATE_NOOP("StyleParts", "Only its curl"),
                  .step = QT_TRANSLATE_NOOP("StyleParts", "Style \"%1\" (curl only)"),
                  .maps = kCurlMaps,
                  .settings = kCurlSettings},
    StylePartSpec{.part = StylePart::Ties,
                  .title = QT_TRANSLATE_NOOP("StyleParts", "Only its ties"),
                  .step = QT_TRANSLATE_NOOP("StyleParts", "Style \"%1\" (ties only)"),
                  .maps = kTieMaps,
                  .settings = kTieSettings,
                  .worn = true},
};

/// A group of a style, and the project's own of that name.
struct Counterpart
{
    std::size_t style = 0;
    std::optional<std::size_t> own;
};

std::vector<Counterpart> counterparts(const Project& project, const Preset& preset)
{
    const bool isBald = std::ranges::none_of(preset.groups, growsHair);
    std::vector<Counterpart> all;
    std::vector<bool> isTaken(project.groups.size(), false);
    for (std::size_t style = 0; style < preset.groups.size(); ++style) {
        if (!isBald && !growsHair(preset.groups[style]))
            continue;
        Counterpart& one = all.emplace_back(Counterpart{.style = style, .own = std::nullopt});
        for (std::size_t own = 0; own < project.groups.size() && !one.own; ++own)
            if (!isTaken[own] && project.groups[own].name == preset.groups[style].name)
                one.own = own; // A name that occurs twice matches one group each time.
        if (one.own)
            isTaken[*one.own] = true;
    }
    return all;
}

/// A region that hair grows in, other than those users name themselves.
bool isKnownKind(const QString& name)
{
    return !name.isEmpty() &&
           std::ranges::any_of(hairKinds(), [&](const HairKind& kind) { return name == QLatin1StringView(kind.name); });
}

MapStack wornStack(Project& project, const HairGroup& style, const MapSpec& spec, const QString& layerName)
{
    const auto found = std::ranges::find_if(style.maps, [&](const MapStack& stack) { return stack.kind == spec.kind; });
    if (found == style.maps.end() || (*found)->layers.empty()) {
        MapStack stack{.kind = spec.kind, .layers = {}};
        if (found != style.maps.end())
            stack.size = (*found)->size;
        stack.layers.push_back(makeLayer(project, spec, stack.size, layerName));
        return stack;
    }
    Layer layer = (*found)->layers.front();
    layer.id = project.takeId();
    layer.name = layerName;
    return {.kind = spec.kind, .size = (*found)->size, .layers = {std::move(layer)}};
}

void putOnWhole(Project& project, const HairGroup& style, HairGroup& group, const QString& layerName)
{
    group.name = style.name;
    group.visible = style.visible;
    group.settings = style.settings;
    group.maps.clear();
    for (const MapSpec& spec : mapSpecs())
        group.maps.emplace_back(wornStack(project, style, spec, layerName));
}

void putOnPart(Project& project, const HairGroup& style, HairGroup& group, const StylePartSpec& part,
               const QString& layerName)
{
    for (const char* key : part.settings) {
        const GroupSetting& row = groupSetting(QLatin1StringView(key));
        row.write(group.settings, row.read(style.settings));
    }
    for (const MapKind kind : part.maps)
        group.map(kind) = wornStack(project, style, mapSpec(kind), layerName);
}

} // namespace

QString StylePartSpec::titleText() const
{
    return QCoreApplication::translate("StyleParts", title);
}

std::span<const StylePartSpec> styleParts()
{
    return kParts;
}

const StylePartSpec& stylePart(StylePart part)
{
    return kParts.at(static_cast<std::size_t>(part));
}

bool growsHair(const HairGroup& group)
{
    const auto isBare = [](const sim::RasterTile& tile) {
        return tile.isUniform() ? tile.uniform[0] == 0
                                : std::ranges::all_of(tile.pixels, [](std::uint16_t value) { return value == 0; });
    };
    const auto density =
        std::ranges::find_if(group.maps, [](const MapStack& stack) { return stack.kind == MapKind::Density; });
    if (density == group.maps.end())
        return false;
    const sim::TiledRaster resolved = resolveStack(*density);
    for (int index = 0; index < resolved.tileCount(); ++index)
        if (!isBare(*resolved.tile(index)))
            return true;
    return false;
}

std::vector<Id> groupsReplaced(const Project& project, const Preset& preset)
{
    std::vector<Id> replaced;
    for (const Counterpart& one : counterparts(project, preset))
        if (one.own)
            replaced.push_back(project.groups[*one.own].id);
    return replaced;
}

std::vector<Id> groupsContested(const Project& project, const Preset& preset)
{
    const std::vector<Counterpart> all = counterparts(project, preset);
    std::vector<Id> contested;
    for (const Counterpart& one : all) {
        if (!one.own)
            continue;
        const HairGroup& own = project.groups[*one.own];
        const bool isItsPurpose = own.name == kScalp || (all.size() == 1 && isKnownKind(own.name));
        if (!isItsPurpose && growsHair(own))
            contested.push_back(own.id);
    }
    return contested;
}

namespace {

std::uint16_t unusedPatch(const std::vector<Worn>& all)
{
    std::uint16_t number = 1;
    while (std::ranges::any_of(all, [number](const Worn& one) { return one.patch && one.patch->number == number; }))
        ++number;
    return number;
}

/// What a style brings replaces what was worn in the group's hair; a style that brings nothing leaves it on.
void wearWith(Project& project, const std::vector<Worn>& brought, Id styleGroup, Id group)
{
    const auto isOfStyle = [styleGroup](const Worn& one) { return one.group == styleGroup; };
    if (std::ranges::none_of(brought, isOfStyle))
        return;
    std::erase_if(project.worn, [group](const Worn& one) { return one.group == group; });
    std::map<Id, Id> ids;
    for (const Worn& one : brought)
        ids.emplace(one.id, 0);
    std::vector<Id> added;
    for (Worn one : brought) {
        if (!isOfStyle(one) || countOf(project.worn, one.kind) >= wornSpec(one.kind).limit)
            continue;
        one.group = group;
        const Id id = project.takeId();
        ids[std::exchange(one.id, id)] = id;
        added.push_back(id);
        if (one.patch)
            one.patch->number = unusedPatch(project.worn);
        insertWorn(project.worn, one);
    }
    for (const Id id : added) {
        Worn& one = *project.wornThing(id);
        one.tie = one.tie != 0 ? ids[one.tie] : 0;
    }
}

} // namespace

void applyPreset(Project& project, const Preset& preset, const StyleUse& use)
{
    if (use.fraction <= 0.0)
        return;
    const std::optional<std::vector<HairGroup>> styles = carriedGroups(preset.groups, preset.head, project.head);
    const std::vector<Worn> worn =
        canCarry(preset.head, project.head) ? carriedWorn(preset.worn, preset.head, project.head) : preset.worn;
    for (const Counterpart& one : counterparts(project, preset)) {
        const HairGroup& style = (*styles)[one.style];
        if (one.own && std::ranges::find(use.kept, project.groups[*one.own].id) != use.kept.end())
            continue;
        const bool takesTies = use.fraction >= kHalf;
        if (use.part != StylePart::All) {
            if (one.own) {
                const StylePartSpec& part = stylePart(use.part);
                HairGroup& own = project.groups[*one.own];
                const HairGroup before = own;
                putOnPart(project, style, own, part, preset.name);
                if (use.fraction < 1.0)
                    own = mixedGroup(before, std::move(own), use.fraction, project.head.get());
                if (part.worn && takesTies) {
                    std::erase_if(project.worn, [&own](const Worn& thing) { return thing.group == own.id; });
                    wearWith(project, worn, style.id, own.id);
                }
            }
            continue;
        }
        if (!one.own && !takesTies)
            continue;
        HairGroup group;
        group.id = one.own ? project.groups[*one.own].id : project.takeId();
        putOnWhole(project, style, group, preset.name);
        if (takesTies)
            wearWith(project, worn, style.id, group.id);
        if (!one.own)
            project.groups.push_back(std::move(group));
        else if (use.fraction < 1.0)
            project.groups[*one.own] =
                mixedGroup(project.groups[*one.own], std::move(group), use.fraction, project.head.get());
        else
            project.groups[*one.own] = std::move(group);
    }
}

QString applyPresetText(const Preset& preset, StylePart part, double fraction)
{
    const QString whole = QCoreApplication::translate("StyleParts", stylePart(part).step).arg(shownName(preset.name));
    return fraction < 1.0
               ? QCoreApplication::translate("StyleParts", "%1, %2%").arg(whole).arg(std::lround(fraction * 100.0))
               : whole;
}

} // namespace hairpaint::model
