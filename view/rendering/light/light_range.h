// How bright the light is that pictures hold.
#pragma once

namespace hairpaint::rendering {

inline constexpr float kMostLight = 4.0F; ///< What samples hold at most; a white wall in full light is 1.

} // namespace hairpaint::rendering
