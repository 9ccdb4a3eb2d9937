// See the header.
#include "model/document/groom_input.h"

namespace hairpaint::model {

sim::GroomInput groomInputOf(const Project& shown, const ResolvedMaps& maps, const ProjectPatches& patches)
{
    sim::GroomInput input;
    if (shown.head != nullptr) {
        input.skin = shown.head->skin;
        input.distances = shown.head->distances;
        input.naturalDirection = shown.head->naturalDirection;
        if (shown.head->landmarks)
            input.neck = sim::neckOf(shown.head->landmarks, shown.head->skin->mesh());
    }
    input.colliders = contactShapes(shown.worn);
    input.seed = shown.seed;
    input.maxHairs = shown.maxHairs;
    for (const HairGroup& group : shown.groups) {
        if (maps.map(group.id, MapKind::Density) == nullptr)
            continue; // Its maps are still being resolved.
        sim::GroomInput::Group& one = input.groups.emplace_back();
        one.id = group.id;
        one.visible = group.visible;
        one.settings = group.settings;
        for (const MapSpec& spec : mapSpecs())
            one.maps[spec.kind] = maps.map(group.id, spec.kind);
        one.gathered = patches.gathered(group.id);
        if (one.gathered != nullptr)
            one.ties = tiesIn(shown.worn, group.id);
    }
    return input;
}

} // namespace hairpaint::model
