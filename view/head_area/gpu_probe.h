// Whether a graphics card draws OpenGL here.
#pragma once

namespace hairpaint::view {

/// Makes a context of its own and lets it go; waits for that. False where OpenGL is missing, too old or drawn in
/// software: our own renderer does that better.
[[nodiscard]] bool hasGpu();

} // namespace hairpaint::view
