// The list of styles, and what several of them do.
#include "styles.h"

#include "model/project/group_schema.h"

namespace hairpaint::presets {

sim::GroupSettings settingsOf(float greatestLengthM, float stiffnessM, float volumeM)
{
    sim::GroupSettings settings;
    settings.basisHairs = 16384; // Some 3,700 on the scalp, 4 mm apart.
    settings.greatestLengthM = greatestLengthM;
    model::makeNatural(settings);
    settings.physics.stiffnessM = stiffnessM;
    settings.physics.volumeM = volumeM;
    return settings;
}

std::vector<Style> builtInStyles()
{
    return {longStraight(),  bob(),        ringlets(),        afro(),        twoPlaits(), mohawk(),
            splitDye(),      buzzCut(),    slickedUndercut(), quiff(),       sidePart(),  frenchCrop(),
            curtainLayers(), beachWaves(), jawBob(),          hime(),        headband(),  wolfCut(),
            shag(),          curlyBob(),   highPonytail(),    lowPonytail(), twinTails(), halfUp(),
            lowBun(),        crownBraid(), fishtail(),        boxBraids(),   locs(),      cornrows(),
            bantuKnots(),    twistOut(),   waves360(),        pixie(),       topKnot(),   curlyTop(),
            highTop(),       lineUp(),     libertySpikes(),   stubble(),     goatee(),    fullBeard(),
            brows()};
}

const model::HairGroup& GrownHair::of(const Style& style)
{
    const auto found = m_groups.find(style.kind);
    return found != m_groups.end()
               ? found->second
               : m_groups.emplace(style.kind, grownHair(QLatin1StringView(style.kind))).first->second;
}

model::Preset played(const Style& style, GrownHair& grown)
{
    Recording user(grown.of(style), style.settings);
    style.record(user);
    model::Preset preset = user.preset(QString::fromLatin1(style.name));
    preset.tags = style.tags;
    return preset;
}

} // namespace hairpaint::presets
