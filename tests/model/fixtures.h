// Small projects, pointer events and comparisons for tests of the model.
#pragma once

#include "model/document/document.h"
#include "model/document/layer_commands.h"
#include "model/tools/strokes/selection.h"
#include "model/tools/tool.h"
#include "sim/skin/skin.h"
#include "tests/support/test_heads.h"

#include <cstring>
#include <memory>

namespace hairpaint::test {

inline std::shared_ptr<const model::Head> headOf(sim::HeadMesh mesh, bool builtIn = true)
{
    auto head = std::make_shared<model::Head>();
    head->name = QStringLiteral("test");
    head->builtIn = builtIn;
    head->skin = std::make_shared<const sim::Skin>(std::move(mesh));
    return head;
}

/// A patch of 20 cm that fills uv, and one empty group "Scalp" with maps of `mapSize`.
inline model::Project patchProject(int mapSize = 256)
{
    model::Project project;
    project.head = headOf(makePatchHead());
    project.groups.push_back(model::makeGroup(project, QStringLiteral("Scalp"), mapSize));
    return project;
}

/// The same with one value, fully covering, all over the first layer of a scalar map.
inline model::Project filledPatch(model::MapKind map, std::uint16_t value)
{
    model::Project project = patchProject();
    sim::TiledRaster& raster = project.groups.front().map(map).layers.front().raster;
    for (int index = 0; index < raster.tileCount(); ++index)
        raster.setUniform(index, {value, 65535, 0, 0});
    return project;
}

inline model::LayerAddress firstLayer(const model::Document& document, model::MapKind map)
{
    const model::HairGroup& group = document.project().groups.front();
    return {.group = group.id, .map = map, .layer = group.map(map).layers.front().id};
}

inline model::ToolEvent paintEvent(const model::Document& document, float u, float v, float pressure = 1.0F,
                                   Qt::KeyboardModifiers modifiers = {})
{
    model::ToolEvent event{
        .area = model::Area::Paint, .uv = {u, v}, .point = {}, .pressure = pressure, .modifiers = modifiers};
    if (const auto& head = document.project().head)
        event.point = head->skin->atUv(event.uv);
    return event;
}

inline bool sameLayers(const std::vector<model::Layer>& a, const std::vector<model::Layer>& b)
{
    return std::ranges::equal(a, b, [](const model::Layer& x, const model::Layer& y) {
        return x.id == y.id && model::propertiesOf(x) == model::propertiesOf(y) && x.raster == y.raster;
    });
}

/// By content, texel for texel.
inline bool sameProjects(const model::Project& a, const model::Project& b)
{
    const auto sameMaps = [](const model::MapStack& x, const model::MapStack& y) {
        return x.kind == y.kind && x.size == y.size && sameLayers(x.layers, y.layers);
    };
    const auto sameGroups = [&](const model::HairGroup& x, const model::HairGroup& y) {
        return x.id == y.id && x.name == y.name && x.visible == y.visible && x.settings == y.settings &&
               std::ranges::equal(x.maps, y.maps, sameMaps);
    };
    return a.nextId == b.nextId && a.seed == b.seed && a.maxHairs == b.maxHairs && a.head == b.head &&
           a.worn == b.worn && a.wind == b.wind && a.light == b.light && a.background == b.background &&
           std::ranges::equal(a.groups, b.groups, sameGroups);
}

} // namespace hairpaint::test
