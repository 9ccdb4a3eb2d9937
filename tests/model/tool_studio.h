// A document with tools, driven as the window drives them.
#pragma once

#include "model/tools/tool_list.h"
#include "tests/model/fixtures.h"

#include <algorithm>

namespace hairpaint::test {

using namespace hairpaint::model;

/// A document and its tools.
struct Studio
{
    Document document;
    std::vector<std::unique_ptr<Tool>> tools = makeTools();
    ToolSettings settings;
    Selection selection;
    bool mirror = false;
    MapKind map = MapKind::Length;

    explicit Studio(Project project = patchProject()) : document(std::move(project))
    {
        settings.secondValue(MapKind::Length).scalar = 0.25F;
    }
    ToolContext context()
    {
        return {.document = document,
                .target = firstLayer(document, map),
                .settings = settings,
                .selection = selection,
                .mirror = mirror};
    }
    Tool& tool(const QString& id)
    {
        return **std::ranges::find_if(tools, [&](const auto& one) { return id == QLatin1String(one->name()); });
    }
    Tool& tool(ToolId id)
    {
        return **std::ranges::find(tools, id, [](const auto& one) { return one->id(); });
    }
    void press(const QString& id, float u, float v, float pressure = 1.0F, Qt::KeyboardModifiers modifiers = {})
    {
        ToolContext now = context();
        tool(id).press(paintEvent(document, u, v, pressure, modifiers), now);
    }
    void move(const QString& id, float u, float v, float pressure = 1.0F, Qt::KeyboardModifiers modifiers = {})
    {
        ToolContext now = context();
        tool(id).move(paintEvent(document, u, v, pressure, modifiers), now);
    }
    void release(const QString& id, float u, float v, Qt::KeyboardModifiers modifiers = {})
    {
        ToolContext now = context();
        tool(id).release(paintEvent(document, u, v, 0.0F, modifiers), now);
    }
    std::shared_ptr<const sim::TiledRaster> shown() { return document.resolved(context().target.group, map); }
    const sim::TiledRaster& layer()
    {
        const LayerAddress at = context().target;
        return document.project().layer(at.group, at.map, at.layer)->raster;
    }
};

inline const QString kBrush = QStringLiteral("brush");

} // namespace hairpaint::test
