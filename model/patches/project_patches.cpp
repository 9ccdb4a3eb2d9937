// Patches matched with things by points and by texels.
#include "model/patches/project_patches.h"

#include "model/patches/patch_shape.h"
#include "model/project/worn_on_ties.h"

#include <algorithm>
#include <set>

namespace hairpaint::model {

namespace {

constexpr std::uint32_t kFewestTexels = 6; ///< Slivers that an eraser leaves are nothing.
constexpr std::size_t kNoPatch = static_cast<std::size_t>(-1);

std::optional<glm::vec2> uvOf(const WornAnchor& anchor, const sim::Skin& skin)
{
    const sim::HeadMesh& mesh = skin.mesh();
    if (anchor.face >= mesh.triangles.size())
        return std::nullopt;
    const glm::uvec3& face = mesh.triangles[anchor.face];
    const glm::vec3& weights = anchor.barycentric;
    const float sum = weights.x + weights.y + weights.z;
    if (!(sum > 0.0F))
        return std::nullopt;
    return (mesh.uvs[face.x] * weights.x + mesh.uvs[face.y] * weights.y + mesh.uvs[face.z] * weights.z) / sum;
}

const WornSpec* kindOf(const sim::Patch& patch)
{
    return patch.texels < kFewestTexels ? nullptr : wornOfPalette(patch.kind);
}

/// Index of the patch that the thing's point is in, and which is of its kind.
std::size_t patchHolding(const sim::PatchLabels& labels, const Worn& worn, const sim::Skin& skin)
{
    const std::optional<glm::vec2> uv = uvOf(worn.patch->at, skin);
    const std::optional<std::size_t> patch = uv ? labels.at(*uv) : std::nullopt;
    if (!patch)
        return kNoPatch;
    const WornSpec* spec = kindOf(labels.patches()[*patch]);
    return spec != nullptr && spec->kind == worn.kind ? *patch : kNoPatch;
}

/// Among the patches of the thing's kind that are not taken, the one that covers most of the thing's former patch.
std::size_t patchOverlapping(const sim::PatchLabels& labels, const std::vector<const Worn*>& taken, const Worn& worn,
                             const ProjectPatches::Group& before)
{
    const auto own = std::ranges::find(before.things, worn.id);
    std::size_t best = kNoPatch;
    std::uint32_t most = 0;
    if (own == before.things.end())
        return best;
    const auto was = static_cast<std::size_t>(own - before.things.begin());
    for (std::size_t patch = 0; patch < taken.size(); ++patch) {
        const WornSpec* spec = kindOf(labels.patches()[patch]);
        if (taken[patch] != nullptr || spec == nullptr || spec->kind != worn.kind)
            continue;
        const std::uint32_t texels = sim::texelsInBoth(before.labels, was, labels, patch);
        if (texels > most) {
            most = texels;
            best = patch;
        }
    }
    return best;
}

std::uint16_t freeNumber(const std::vector<Worn>& all)
{
    std::set<std::uint16_t> taken;
    for (const Worn& one : all)
        if (one.patch)
            taken.insert(one.patch->number);
    std::uint16_t number = 1;
    while (taken.contains(number))
        ++number;
    return number;
}

/// One group's things by its patches.
class Following
{
public:
    Following(Project& project, Id group, const sim::PatchLabels& labels, const ProjectPatches::Group* before)
        : m_project(project), m_skin(*project.head->skin), m_group(group), m_labels(labels), m_before(before),
          m_taken(labels.patches().size(), nullptr)
    {}

    bool run()
    {
        const std::vector<Worn> was = m_project.worn;
        match(was);
        std::vector<Worn>& worn = m_project.worn;
        std::erase_if(worn, [this](const Worn& one) {
            return one.patch && one.group == m_group &&
                   std::ranges::none_of(m_taken, [&one](const Worn* of) { return of != nullptr && of->id == one.id; });
        });
        for (std::size_t patch = 0; patch < m_taken.size(); ++patch)
            if (m_taken[patch] == nullptr)
                add(patch);
            else
                keep(patch, *m_project.wornThing(m_taken[patch]->id));
        return worn != was;
    }

private:
    void match(const std::vector<Worn>& all)
    {
        std::vector<const Worn*> loose;
        std::vector<const Worn*> own;
        for (const Worn& one : all)
            if (one.patch && one.group == m_group)
                own.push_back(&one);
        std::ranges::sort(own, {}, &Worn::id);
        for (const Worn* one : own) {
            const std::size_t patch = patchHolding(m_labels, *one, m_skin);
            if (patch == kNoPatch)
                loose.push_back(one);
            else if (m_taken[patch] == nullptr)
                m_taken[patch] = one;
        }
        if (m_before == nullptr)
            return;
        for (const Worn* one : loose)
            if (const std::size_t patch = patchOverlapping(m_labels, m_taken, *one, *m_before); patch != kNoPatch)
                m_taken[patch] = one;
    }

    void keep(std::size_t patch, Worn& worn)
    {
        const bool isHeld = patchHolding(m_labels, worn, m_skin) == patch;
        if (m_before == nullptr && isHeld)
            return;
        if (m_before != nullptr) {
            const auto was = std::ranges::find(m_before->things, worn.id);
            if (isHeld && was != m_before->things.end() &&
                sim::samePatch(m_before->labels, static_cast<std::size_t>(was - m_before->things.begin()), m_labels,
                               patch))
                return;
        }
        const std::optional<PatchShape> shape =
            isHeld && worn.patch->placedByHand ? std::nullopt : shapeOf(m_labels, patch);
        if (!shape)
            return;
        if (!isHeld)
            worn.patch->at = anchorAt(pointNearest(*shape, shape->middleHd));
        if (!worn.patch->placedByHand)
            wearOnPatch(worn, *shape, m_skin);
    }

    void add(std::size_t patch)
    {
        const WornSpec* spec = kindOf(m_labels.patches()[patch]);
        if (spec == nullptr || countOf(m_project.worn, spec->kind) >= spec->limit)
            return;
        const std::optional<PatchShape> shape = shapeOf(m_labels, patch);
        if (!shape)
            return;
        const sim::SurfacePoint& middle = pointNearest(*shape, shape->middleHd);
        Worn worn = makeWorn(*spec, middle, m_group);
        worn.patch = WornPatch{.number = freeNumber(m_project.worn), .at = anchorAt(middle)};
        wearOnPatch(worn, *shape, m_skin);
        worn.id = m_project.takeId();
        insertWorn(m_project.worn, worn);
    }

    Project& m_project;
    const sim::Skin& m_skin;
    Id m_group;
    const sim::PatchLabels& m_labels;
    const ProjectPatches::Group* m_before;
    std::vector<const Worn*> m_taken; ///< By patch: the thing that has it, as it was before; null: none.
};

sim::RasterTilePtr gatheredTile(const sim::PatchTile& parts, const std::vector<std::uint16_t>& numbers)
{
    auto tile = std::make_shared<sim::RasterTile>();
    if (std::ranges::all_of(numbers, [](std::uint16_t number) { return number == 0; }))
        return tile;
    tile->pixels.resize(sim::kTileTexels);
    for (std::size_t texel = 0; texel < sim::kTileTexels; ++texel)
        tile->pixels[texel] = parts.parts[texel] == 0 ? std::uint16_t{0} : numbers[parts.parts[texel] - 1U];
    return std::make_shared<const sim::RasterTile>(sim::folded(std::move(*tile)));
}

void updateGathered(ProjectPatches::Group& group)
{
    if (std::ranges::all_of(group.numbers, [](std::uint16_t number) { return number == 0; })) {
        group.gathered.reset();
        group.made.clear();
        return;
    }
    const int size = group.labels.islands()->size();
    auto raster = group.gathered != nullptr && group.gathered->size() == size
                      ? std::make_shared<sim::TiledRaster>(*group.gathered)
                      : std::make_shared<sim::TiledRaster>(size, 1);
    bool differs = group.gathered == nullptr || group.gathered->size() != size;
    group.made.resize(static_cast<std::size_t>(raster->tileCount()));
    for (int index = 0; index < raster->tileCount(); ++index) {
        auto& made = group.made[static_cast<std::size_t>(index)];
        const std::shared_ptr<const sim::PatchTile>& parts = group.labels.tilePointer(index);
        std::vector<std::uint16_t> numbers;
        for (std::size_t part = 1; part <= parts->kinds.size(); ++part)
            numbers.push_back(group.numbers[group.labels.patchOf(index, static_cast<std::uint16_t>(part))]);
        if (made.first == parts && made.second == numbers)
            continue;
        const sim::RasterTilePtr tile = gatheredTile(*parts, numbers);
        if (!sim::sameTexels(*tile, *raster->tile(index))) {
            raster->setTile(index, tile);
            differs = true;
        }
        made = {parts, std::move(numbers)};
    }
    if (differs)
        group.gathered = std::move(raster);
}

} // namespace

const ProjectPatches::Group* ProjectPatches::group(Id id) const
{
    const auto found = m_groups.find(id);
    return found != m_groups.end() ? &found->second : nullptr;
}

sim::MapRaster ProjectPatches::gathered(Id group) const
{
    const Group* found = this->group(group);
    return found != nullptr ? found->gathered : nullptr;
}

void ProjectPatches::updateLabels(const Project& project)
{
    const std::shared_ptr<const sim::Skin> skin = project.head != nullptr ? project.head->skin : nullptr;
    std::erase_if(m_groups,
                  [&](const auto& entry) { return project.group(entry.first) == nullptr || skin == nullptr; });
    std::erase_if(m_islands, [&](const auto& entry) { return entry.first.first != skin.get(); });
    if (skin == nullptr)
        return;
    for (const HairGroup& group : project.groups) {
        const MapStack& stack = group.map(MapKind::Accessory);
        auto found = m_groups.find(group.id);
        if (found == m_groups.end())
            found = m_groups.emplace(group.id, Group{.map = ResolvedMap(stack)}).first;
        else
            found->second.map.update(stack);
        Group& one = found->second;
        const sim::MapRaster& map = one.map.result();
        if (const std::optional<sim::Texel> uniform = map->uniformValue(); uniform && (*uniform)[0] == 0) {
            one = Group{.map = std::move(one.map)};
            continue; // The usual case costs no islands.
        }
        std::shared_ptr<const sim::SkinIslands>& islands = m_islands[{skin.get(), map->size()}];
        if (islands == nullptr)
            islands = std::make_shared<const sim::SkinIslands>(skin, map->size());
        one.labels.update(map, islands);
    }
}

void ProjectPatches::findThings(const Project& project)
{
    for (auto& [id, group] : m_groups) {
        const std::size_t count = group.labels.patches().size();
        group.things.assign(count, 0);
        group.numbers.assign(count, 0);
        if (count == 0) {
            updateGathered(group);
            continue;
        }
        for (const Worn& one : project.worn) {
            if (!one.patch || one.group != id)
                continue;
            const std::size_t patch = patchHolding(group.labels, one, *project.head->skin);
            if (patch == kNoPatch || (group.things[patch] != 0 && group.things[patch] < one.id))
                continue;
            group.things[patch] = one.id;
            group.numbers[patch] = wornSpec(one.kind).tie ? one.patch->number : std::uint16_t{0};
        }
        updateGathered(group);
    }
}

void ProjectPatches::update(const Project& project)
{
    updateLabels(project);
    findThings(project);
}

bool ProjectPatches::follow(Project& project, const ProjectPatches* before)
{
    const std::vector<Worn> was = project.worn;
    bool changed = false;
    updateLabels(project);
    for (auto& [id, group] : m_groups)
        changed |= Following(project, id, group.labels, before != nullptr ? before->group(id) : nullptr).run();
    // Things whose group is gone, or whose head is.
    const std::size_t count = project.worn.size();
    std::erase_if(project.worn, [this](const Worn& one) { return one.patch && !m_groups.contains(one.group); });
    changed |= project.worn.size() != count;
    if (changed)
        followTies(project.worn, was);
    findThings(project);
    return changed;
}

std::vector<LayerPatchErasure> patchErased(const Project& project, const ProjectPatches& patches, const Worn& worn)
{
    std::vector<LayerPatchErasure> erased;
    const ProjectPatches::Group* found = patches.group(worn.group);
    if (!worn.patch || found == nullptr)
        return erased;
    const auto thing = std::ranges::find(found->things, worn.id);
    if (thing == found->things.end())
        return erased;
    const sim::Patch& patch = found->labels.patches()[static_cast<std::size_t>(thing - found->things.begin())];
    const MapStack& stack = project.group(worn.group)->map(MapKind::Accessory);
    for (const Layer& layer : stack.layers) {
        if (!layer.visible)
            continue;
        LayerPatchErasure& one =
            erased.emplace_back(LayerPatchErasure{.address = {worn.group, MapKind::Accessory, layer.id}, .tiles = {}});
        sim::TiledRaster raster = layer.raster;
        for (const auto& [index, part] : patch.parts) {
            const std::span<std::uint16_t> pixels = raster.writableTile(index);
            const std::vector<std::uint16_t>& parts = found->labels.tile(index).parts;
            for (std::size_t texel = 0; texel < sim::kTileTexels; ++texel)
                if (parts[texel] == part)
                    pixels[2 * texel] = pixels[2 * texel + 1] = 0;
        }
        for (const auto& [index, part] : patch.parts) {
            raster.compact(index);
            if (!sim::sameTexels(*raster.tile(index), *layer.raster.tile(index)) &&
                (one.tiles.empty() || one.tiles.back().first != index))
                one.tiles.emplace_back(index, raster.tile(index));
        }
    }
    return erased;
}

} // namespace hairpaint::model
