#include "stream_writer.h"

#include <bit>
#include <fstream>

namespace hairpaint::heads {

bool writeStream(const std::vector<glm::vec3>& directionsHd, const std::filesystem::path& path)
{
    static_assert(std::endian::native == std::endian::little, "numbers are written as they lie in memory");
    static_assert(sizeof(glm::vec3) == 12);
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(directionsHd.data()),
               static_cast<std::streamsize>(directionsHd.size() * sizeof(glm::vec3)));
    return static_cast<bool>(file.flush());
}

} // namespace hairpaint::heads
