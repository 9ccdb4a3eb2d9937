// The files of resources/shaders, compiled in by resources/shaders/embed.cmake.
#pragma once

#include <string_view>

namespace hairpaint::rendering {

/// The text of a shader file; empty where there is none of that name.
[[nodiscard]] std::string_view shaderSource(std::string_view name);

} // namespace hairpaint::rendering
