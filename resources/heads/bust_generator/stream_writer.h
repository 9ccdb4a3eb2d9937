// How hair grows on the bust, as a file.
#pragma once

#include <filesystem>
#include <vector>

#include <glm/glm.hpp>

namespace hairpaint::heads {

// x, y, z of each vertex's direction as sim::naturalStream gives it: floats, little endian. All of their bits, so that
// styles recorded on a computed stream are the same on this one. False if it could not be written.
[[nodiscard]] bool writeStream(const std::vector<glm::vec3>& directionsHd, const std::filesystem::path& path);

} // namespace hairpaint::heads
