// Settings of a type, and the curl map where it is as good as empty.
#include "model/document/hair_type_command.h"

#include "model/document/edit_command.h"
#include "model/document/group_commands.h"
#include <algorithm>

namespace hairpaint::model {

namespace {

constexpr std::uint16_t kFullCurl = 65535; ///< Full curl, and full coverage.
/// Least curl at which hair shows coils; below it, hair looks straight or nearly so.
constexpr std::uint16_t kLeastCurl = kFullCurl / 4;

bool showsCurl(const sim::TiledRaster& curl)
{
    for (int index = 0; index < curl.tileCount(); ++index) {
        const sim::RasterTile& tile = *curl.tile(index);
        if (tile.isUniform()
                ? tile.uniform[0] >= kLeastCurl
                : std::ranges::any_of(tile.pixels, [](std::uint16_t value) { return value >= kLeastCurl; }))
            return true;
    }
    return false;
}

void fillCurl(Project& project, MapStack& stack, const QString& newName)
{
    const sim::TiledRaster all(stack.size, mapSpec(stack.kind).layerChannels(), {kFullCurl, kFullCurl});
    if (!stack.layers.empty()) {
        Layer& top = stack.layers.back();
        if (top.visible && !top.locked && top.blend == BlendMode::Normal && top.opacity >= 1.0F) {
            top.raster = all;
            return;
        }
    }
    stack.layers.push_back({.id = project.takeId(), .name = newName, .raster = all});
}

} // namespace

CommandPtr setHairTypeCommand(Document& document, Id group, const HairType& type, const QString& text)
{
    document.endEdit();
    const HairGroup* found = document.committed().group(group);
    if (found == nullptr)
        return nullptr;
    sim::GroupSettings settings = found->settings;
    setHairType(settings, type);
    const std::shared_ptr<const sim::TiledRaster> curl = document.resolvedNow(group, MapKind::Curl);
    if (type.curl.diameterM <= 0.0F || curl == nullptr || showsCurl(*curl))
        return setSettingsCommand(document, group, settings, text);
    return editCommand(document, {.aspect = Change::Aspect::GroupList, .group = group}, text,
                       [group, settings, name = QString::fromLatin1(type.name)](Project& project) {
                           if (HairGroup* one = project.group(group)) {
                               one->settings = settings;
                               fillCurl(project, one->map(MapKind::Curl), name);
                           }
                       });
}

} // namespace hairpaint::model
