// A head with hair on it and the part tool.
#pragma once

#include "model/tools/tool_list.h"
#include "sim/groom/direction_texel.h"
#include "sim/skin/skin_frame.h"
#include "tests/model/fixtures.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::test {

inline constexpr float kPartedBallM = 0.1F;

/// A head with hair all over, or where z is less than `bareFromZ`, and the tool.
struct Parter
{
    model::Document document;
    std::vector<std::unique_ptr<model::Tool>> tools = model::makeTools();
    model::Tool& tool = **std::ranges::find(tools, model::ToolId::Part, [](const auto& one) { return one->id(); });
    model::ToolSettings settings;
    model::Selection selection;
    bool mirror = false;
    double seconds = 0.0;

    explicit Parter(sim::HeadMesh mesh = makePatchHead(), int mapSize = 512, bool builtIn = true,
                    float bareFromZ = 1.0F)
        : document([&] {
              model::Project project = patchProject(mapSize);
              project.head = headOf(std::move(mesh), builtIn);
              sim::TiledRaster& density = project.groups.front().map(model::MapKind::Density).layers.front().raster;
              for (int index = 0; index < density.tileCount(); ++index)
                  density.setUniform(index, {60000, 65535, 0, 0});
              for (int texel = 0; bareFromZ < 1.0F && texel < mapSize * mapSize; ++texel) {
                  const glm::ivec2 at(texel % mapSize, texel / mapSize);
                  const glm::vec2 uv = (glm::vec2(at) + 0.5F) / static_cast<float>(mapSize);
                  const auto place = project.head->skin->atUv({uv.x, 1.0F - uv.y});
                  if (place && place->positionHd.z >= bareFromZ)
                      density.setTexel(at.x, at.y, {0, 65535, 0, 0});
              }
              return project;
          }())
    {
        settings.partReachM = 0.04F;
    }
    [[nodiscard]] const sim::Skin& skin() { return *document.project().head->skin; }
    model::ToolContext context()
    {
        return {.document = document,
                .target = firstLayer(document, model::MapKind::Direction),
                .settings = settings,
                .selection = selection,
                .mirror = mirror};
    }
    [[nodiscard]] model::ToolEvent eventAt(glm::vec3 placeHd)
    {
        const sim::SurfacePoint point = skin().nearest(placeHd);
        return {.area = model::Area::Head, .uv = point.uv, .point = point, .seconds = seconds};
    }
    void press(glm::vec3 placeHd)
    {
        model::ToolContext now = context();
        tool.press(eventAt(placeHd), now);
    }
    void move(glm::vec3 placeHd)
    {
        model::ToolContext now = context();
        tool.move(eventAt(placeHd), now);
    }
    void release(glm::vec3 placeHd)
    {
        model::ToolContext now = context();
        tool.release(eventAt(placeHd), now);
    }
    /// Not one that makes a double click with the last one.
    void click(glm::vec3 placeHd)
    {
        seconds += 10.0;
        press(placeHd);
        release(placeHd);
    }
    void drag(glm::vec3 fromHd, glm::vec3 toHd)
    {
        seconds += 10.0;
        press(fromHd);
        for (int i = 1; i <= 20; ++i)
            move(fromHd + (toHd - fromHd) * (static_cast<float>(i) / 20.0F));
        release(toHd);
    }
    bool key(Qt::Key key)
    {
        model::ToolContext now = context();
        return tool.key(key, {}, now);
    }
    void commit()
    {
        model::ToolContext now = context();
        tool.commit(now);
    }
    void cancel()
    {
        model::ToolContext now = context();
        tool.cancel(now);
    }
    /// Up the patch, through its middle.
    void partPatch()
    {
        for (const float y : {-0.05F, 0.0F, 0.05F})
            click({0.0F, y, 0.0F});
    }
    [[nodiscard]] const sim::TiledRaster& layer(model::MapKind map)
    {
        const model::LayerAddress at = firstLayer(document, map);
        return document.project().layer(at.group, at.map, at.layer)->raster;
    }
    [[nodiscard]] sim::Texel texelAt(model::MapKind map, glm::vec3 placeHd)
    {
        return layer(map).sampleNearest(skin().nearest(placeHd).uv);
    }
    [[nodiscard]] float coverageAt(glm::vec3 placeHd)
    {
        return static_cast<float>(texelAt(model::MapKind::Direction, placeHd)[2]) / 65535.0F;
    }
    /// As it is shown, of what was there before.
    [[nodiscard]] float densityAt(glm::vec3 placeHd)
    {
        const auto shown =
            document.resolved(firstLayer(document, model::MapKind::Density).group, model::MapKind::Density);
        return static_cast<float>(shown->sampleNearest(skin().nearest(placeHd).uv)[0]) / 60000.0F;
    }
    [[nodiscard]] glm::vec3 directionAt(glm::vec3 placeHd)
    {
        const sim::SurfacePoint point = skin().nearest(placeHd);
        return sim::SkinFrame::at(point).toHd(
            sim::directionOf(layer(model::MapKind::Direction).sampleNearest(point.uv)));
    }
    [[nodiscard]] QPolygonF handles()
    {
        QPolygonF all;
        for (const model::OverlayShape& shape : tool.overlay())
            all += shape.uvHandles;
        return all;
    }
};

inline glm::vec3 onPartedBall(float longitude, float latitude)
{
    return kPartedBallM * glm::vec3(std::cos(latitude) * std::sin(longitude), std::sin(latitude),
                                    std::cos(latitude) * std::cos(longitude));
}

/// Over the top, from the face back.
inline glm::vec3 overTop(float angle)
{
    return kPartedBallM * glm::vec3(0.0F, std::cos(angle), std::sin(angle));
}

} // namespace hairpaint::test
