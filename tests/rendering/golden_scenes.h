// Scenes of which small pictures are kept beside the tests.
#pragma once

#include "view/rendering/scene.h"

#include <functional>
#include <span>

namespace hairpaint::testing {

using MakeScene = std::function<rendering::Scene()>;

struct GoldenScene
{
    const char* name;
    MakeScene make;
};

[[nodiscard]] std::span<const GoldenScene> goldenScenes();

} // namespace hairpaint::testing
