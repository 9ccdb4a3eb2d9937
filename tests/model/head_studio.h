// Tools driven over the skin of a head.
#pragma once

#include "sim/groom/direction_texel.h"
#include "sim/skin/skin_frame.h"
#include "tests/model/tool_studio.h"

namespace hairpaint::test {

/// A studio for what is painted on the direction map. Points are Hd, and brought to the skin.
struct HeadStudio : Studio
{
    explicit HeadStudio(Project project) : Studio(std::move(project)) { map = MapKind::Direction; }
    /// Bare, with a group of hair.
    static Project onMesh(sim::HeadMesh mesh, bool builtIn, int mapSize = 512)
    {
        Project project = patchProject(mapSize);
        project.head = headOf(std::move(mesh), builtIn);
        return project;
    }
    [[nodiscard]] const sim::Skin& skin() { return *document.project().head->skin; }
    [[nodiscard]] ToolEvent eventAt(glm::vec3 positionHd, float pressure = 1.0F)
    {
        const sim::SurfacePoint point = skin().nearest(positionHd);
        return {.area = Area::Head, .uv = point.uv, .point = point, .pressure = pressure};
    }
    using Studio::layer;
    [[nodiscard]] const sim::TiledRaster& layer(MapKind kind)
    {
        const LayerAddress at = firstLayer(document, kind);
        return document.project().layer(at.group, at.map, at.layer)->raster;
    }
    [[nodiscard]] sim::Texel texelAt(glm::vec3 positionHd, MapKind kind = MapKind::Direction)
    {
        return layer(kind).sampleNearest(skin().nearest(positionHd).uv);
    }
    /// Hd.
    [[nodiscard]] glm::vec3 directionAt(glm::vec3 positionHd)
    {
        const sim::SurfacePoint point = skin().nearest(positionHd);
        return sim::SkinFrame::at(point).toHd(sim::directionOf(layer(MapKind::Direction).sampleNearest(point.uv)));
    }
};

} // namespace hairpaint::test
