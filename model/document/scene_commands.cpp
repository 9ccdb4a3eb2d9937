// Wind, light, background, skin, what is worn and the head.
#include "model/document/scene_commands.h"

#include "model/document/command_texts.h"
#include "model/document/edit_command.h"
#include "model/document/paint_command.h"
#include "model/styles/worn_transfer.h"

namespace hairpaint::model {

namespace {

CommandPtr environmentCommand(Document& document, const QString& text, std::function<void(Project&)> edit)
{
    return editCommand(document, {.aspect = Change::Aspect::Environment}, text, std::move(edit));
}

/// Whether the committed content differs in that member from `value`. Ends what runs only where it matters: a wish for
/// what is there already must not end a stroke.
template<typename Member, typename Value>
bool differs(Document& document, Member member, const Value& value)
{
    if (document.committed().*member == value && document.project().*member == value)
        return false;
    document.endEdit();
    return !(document.committed().*member == value);
}

/// Where maps stay in the layout, points of patches do too.
void keepInLayout(std::vector<Worn>& carried, const std::vector<Worn>& before, const std::shared_ptr<const Head>& from,
                  const std::shared_ptr<const Head>& to)
{
    if (from == nullptr || from->skin == nullptr || to == nullptr || to->skin == nullptr)
        return;
    for (std::size_t i = 0; i < carried.size(); ++i) {
        if (!carried[i].patch)
            continue;
        const Worn marked{.anchor = before[i].patch->at};
        if (const auto point = to->skin->atUv(anchorPoint(marked, *from->skin).uv))
            carried[i].patch->at = anchorAt(*point);
    }
}

} // namespace

QString windStepText()
{
    return Commands::tr("Change wind");
}

QString lightStepText()
{
    return Commands::tr("Change light");
}

QString backgroundStepText()
{
    return Commands::tr("Change background");
}

CommandPtr setWindCommand(Document& document, const sim::Wind& wind)
{
    if (!differs(document, &Project::wind, blowingAs(document.committed().wind, wind)))
        return nullptr;
    return environmentCommand(document, windStepText(),
                              [wind](Project& project) { project.wind = blowingAs(project.wind, wind); });
}

CommandPtr setLightCommand(Document& document, const LightSettings& light)
{
    if (!differs(document, &Project::light, light))
        return nullptr;
    return environmentCommand(document, lightStepText(), [light](Project& project) { project.light = light; });
}

CommandPtr setBackgroundCommand(Document& document, QRgb background)
{
    if (!differs(document, &Project::background, background))
        return nullptr;
    return environmentCommand(document, backgroundStepText(),
                              [background](Project& project) { project.background = background; });
}

CommandPtr setSkinCommand(Document& document, SkinTone skin)
{
    if (!differs(document, &Project::skin, skin))
        return nullptr;
    return environmentCommand(document, Commands::tr("Change skin tone"),
                              [skin](Project& project) { project.skin = skin; });
}

CommandPtr addWornCommand(Document& document, Worn worn)
{
    const WornSpec& spec = wornSpec(worn.kind);
    document.endEdit();
    if (countOf(document.committed().worn, worn.kind) >= spec.limit)
        return nullptr;
    return environmentCommand(document, wornText(spec.addStep), [worn](Project& project) mutable {
        worn.id = project.takeId();
        insertWorn(project.worn, worn);
    });
}

CommandPtr removeWornCommand(Document& document, Id id)
{
    document.endEdit();
    const Worn* worn = document.committed().wornThing(id);
    if (worn == nullptr)
        return nullptr;
    const QString text = wornText(wornSpec(worn->kind).removeStep);
    if (worn->patch) {
        // It goes with its paint.
        std::vector<LayerEdit> layers;
        for (LayerPatchErasure& one : patchErased(document.committed(), document.patches(), *worn))
            layers.push_back({.address = one.address, .after = std::move(one.tiles)});
        return paintCommand(document, std::move(layers), text);
    }
    return environmentCommand(document, text, [id](Project& project) {
        std::erase_if(project.worn, [id](const Worn& one) { return one.id == id; });
    });
}

void putHead(Project& project, const std::shared_ptr<const Head>& head)
{
    const std::shared_ptr<const sim::MeshTexture> before = project.head ? project.head->texture : nullptr;
    const std::shared_ptr<const sim::MeshTexture> after = head ? head->texture : nullptr;
    if (after && after != before)
        project.skin = SkinTone::Own;
    else if (!after && project.skin == SkinTone::Own)
        project.skin = SkinTone::Clay;
    project.head = head;
}

CommandPtr setHeadCommand(Document& document, std::shared_ptr<const Head> head, std::vector<sim::Ellipsoid> ellipsoids,
                          std::optional<std::vector<HairGroup>> groups)
{
    if (document.committed().head == head)
        return nullptr;
    const auto setHead = [head = std::move(head), ellipsoids = std::move(ellipsoids),
                          mapsStay = !groups](Project& project) {
        const std::vector<Worn> before = project.worn;
        project.worn = carriedWorn(std::move(project.worn), project.head, head);
        if (mapsStay)
            keepInLayout(project.worn, before, project.head, head);
        putHead(project, head);
        project.setShapesOfHead(ellipsoids);
    };
    Change change;
    change.aspect = Change::Aspect::Head;
    std::vector<ShownPart> parts;
    parts.push_back({change, setHead});
    if (groups) {
        change.aspect = Change::Aspect::GroupList;
        parts.push_back({change, [groups = std::move(*groups)](Project& project) { project.groups = groups; }});
    }
    return shownEditCommand(document, parts, {}, Commands::tr("Change head"));
}

} // namespace hairpaint::model
