// A head with hair on it and the part tool.
#pragma once

#include "tests/model/head_studio.h"

#include <cmath>

namespace hairpaint::test {

inline constexpr float kPartedBallM = 0.1F;

/// A head with hair all over, or where z is less than `bareFromZ`, and the tool.
struct Parter : HeadStudio
{
    Tool& tool = Studio::tool(QStringLiteral("part"));
    double seconds = 0.0;

    explicit Parter(sim::HeadMesh mesh = makePatchHead(), int mapSize = 512, bool builtIn = true,
                    float bareFromZ = 1.0F)
        : HeadStudio(hairy(onMesh(std::move(mesh), builtIn, mapSize), bareFromZ))
    {
        settings = ToolSettings();
        settings.partReachM = 0.04F;
    }
    static Project hairy(Project project, float bareFromZ)
    {
        sim::TiledRaster& density = project.groups.front().map(MapKind::Density).layers.front().raster;
        for (int index = 0; index < density.tileCount(); ++index)
            density.setUniform(index, {60000, 65535, 0, 0});
        const int size = density.size();
        for (int texel = 0; bareFromZ < 1.0F && texel < size * size; ++texel) {
            const glm::ivec2 at(texel % size, texel / size);
            const glm::vec2 uv = (glm::vec2(at) + 0.5F) / static_cast<float>(size);
            const auto point = project.head->skin->atUv({uv.x, 1.0F - uv.y});
            if (point && point->positionHd.z >= bareFromZ)
                density.setTexel(at.x, at.y, {0, 65535, 0, 0});
        }
        return project;
    }
    [[nodiscard]] ToolEvent eventAt(glm::vec3 positionHd)
    {
        ToolEvent event = HeadStudio::eventAt(positionHd);
        event.seconds = seconds;
        return event;
    }
    void press(glm::vec3 positionHd)
    {
        ToolContext now = context();
        tool.press(eventAt(positionHd), now);
    }
    void move(glm::vec3 positionHd)
    {
        ToolContext now = context();
        tool.move(eventAt(positionHd), now);
    }
    void release(glm::vec3 positionHd)
    {
        ToolContext now = context();
        tool.release(eventAt(positionHd), now);
    }
    /// Not one that makes a double click with the last one.
    void click(glm::vec3 positionHd)
    {
        seconds += 10.0;
        press(positionHd);
        release(positionHd);
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
        ToolContext now = context();
        return tool.key(key, {}, now);
    }
    void commit()
    {
        ToolContext now = context();
        tool.commit(now);
    }
    void cancel()
    {
        ToolContext now = context();
        tool.cancel(now);
    }
    /// Up the patch, through its middle.
    void partPatch()
    {
        for (const float y : {-0.05F, 0.0F, 0.05F})
            click({0.0F, y, 0.0F});
    }
    [[nodiscard]] float coverageAt(glm::vec3 positionHd)
    {
        return static_cast<float>(texelAt(positionHd)[2]) / 65535.0F;
    }
    /// As it is shown, of what was there before.
    [[nodiscard]] float densityAt(glm::vec3 positionHd)
    {
        const auto shown = document.resolved(firstLayer(document, MapKind::Density).group, MapKind::Density);
        return static_cast<float>(shown->sampleNearest(skin().nearest(positionHd).uv)[0]) / 60000.0F;
    }
    [[nodiscard]] QPolygonF handles()
    {
        QPolygonF all;
        for (const OverlayShape& shape : tool.overlay())
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
