// A small project with an editor, for tests of the areas.
#pragma once

#include "model/document/document.h"
#include "tests/support/test_heads.h"
#include "view/editing/editor_state.h"

#include <memory>

namespace hairpaint::test {

inline model::Project makeProject(sim::HeadMesh mesh, int mapSize = 256)
{
    model::Project project;
    auto head = std::make_shared<model::Head>();
    head->name = QStringLiteral("test");
    head->builtIn = false;
    head->skin = std::make_shared<sim::Skin>(std::move(mesh));
    project.head = std::move(head);
    project.groups.push_back(model::makeGroup(project, QStringLiteral("Scalp"), mapSize));
    return project;
}

/// Mirror painting is off; the brush is hard and paints 1 on the density map.
struct Editor
{
    explicit Editor(model::Project project) : document(std::move(project)), state(document)
    {
        state.options().setMirror(false);
        state.target().setMap(model::MapKind::Density);
        model::ToolSettings settings = state.tools().settings();
        settings.hardness = 1.0F;
        settings.brushSizeM = 0.02F;
        settings.value(model::MapKind::Density).scalar = 1.0F;
        state.tools().setSettings(settings);
    }

    [[nodiscard]] float density(glm::vec2 uv) const
    {
        return static_cast<float>(
                   document.resolved(state.target().group(), model::MapKind::Density)->sampleNearest(uv)[0]) /
               65535.0F;
    }

    model::Document document;
    view::EditorState state;
};

} // namespace hairpaint::test
