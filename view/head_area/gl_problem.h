// What keeps the renderer from drawing, in the user's language.
#pragma once

#include <QString>

#include <string>

namespace hairpaint::view {

/// The renderer is free of Qt and gives its reasons in English; this translates them. What a driver says of a shader
/// stays as it is.
[[nodiscard]] QString glProblem(const std::string& english);

} // namespace hairpaint::view
