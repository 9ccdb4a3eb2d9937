// Differences along x pack to a third of what the distances would.
#include "distance_writer.h"

#include <zlib.h>

#include <array>
#include <bit>
#include <cstring>
#include <fstream>
#include <vector>

namespace hairpaint::heads {

bool writeDistances(const sim::DistanceGrid& grid, const std::filesystem::path& path)
{
    static_assert(std::endian::native == std::endian::little, "numbers are written as they lie in memory");
    const std::size_t count = grid.layout().nodeCount();
    std::vector<std::uint8_t> differences(count);
    std::int8_t before = 0;
    for (std::size_t i = 0; i < count; ++i) {
        differences[i] = static_cast<std::uint8_t>(grid.pairs()[i].value - before);
        before = grid.pairs()[i].value;
    }
    auto packedSize = compressBound(static_cast<uLong>(count));
    std::vector<std::uint8_t> packed(packedSize);
    if (compress2(packed.data(), &packedSize, differences.data(), static_cast<uLong>(count), Z_BEST_COMPRESSION) !=
        Z_OK)
        return false;
    const sim::GridLayout& layout = grid.layout();
    const std::array<float, 4> header = {layout.originHd.x, layout.originHd.y, layout.originHd.z, layout.cellM};
    const std::array<std::int32_t, 3> size = {layout.size.x, layout.size.y, layout.size.z};
    const auto length = static_cast<std::uint32_t>(count);
    const std::array<std::uint8_t, 4> lengthBytes = {
        static_cast<std::uint8_t>(length >> 24U), static_cast<std::uint8_t>(length >> 16U),
        static_cast<std::uint8_t>(length >> 8U), static_cast<std::uint8_t>(length)};
    std::ofstream file(path, std::ios::binary);
    const auto put = [&file](const void* bytes, std::size_t number) {
        file.write(static_cast<const char*>(bytes), static_cast<std::streamsize>(number));
    };
    put(header.data(), sizeof(header));
    put(size.data(), sizeof(size));
    put(lengthBytes.data(), lengthBytes.size());
    put(packed.data(), packedSize);
    return static_cast<bool>(file.flush());
}

} // namespace hairpaint::heads
