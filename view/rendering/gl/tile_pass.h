// Lays the projected strands over the picture: sorts their segments into tiles, and there by depth.
#pragma once

#include "view/rendering/frame_constants.h"
#include "view/rendering/gl/gl_objects.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace hairpaint::rendering {

/// As the software renderer does it, but that each sample of a tile has an invocation of its own.
class TilePass
{
public:
    [[nodiscard]] static tl::expected<TilePass, std::string> create();

    /// Sorts `points` projected points (see projected_point.glsl) into tiles; waits until the GPU has counted them.
    /// With the frame's constants bound to uniform buffer 0. False where OpenGL has no memory for them: some are left
    /// out.
    [[nodiscard]] bool bin(const FrameConstants& constants, const Buffer& projected, std::size_t points);
    /// After bin(): lays the next `rows` rows of tiles. False where none was left.
    [[nodiscard]] bool layRows(const Buffer& projected, const Texture& headDepth, const Texture& worn, int rows);
    /// 0..1: how much of the rows is laid.
    [[nodiscard]] double progress() const;
    /// Light of the hair in the samples, and what is left to see through; less than opaque() is nothing.
    void bindLight(unsigned unit) const { m_light.bind(unit); }
    [[nodiscard]] float opaque() const { return m_opaque; }

private:
    void count(const Buffer& projected, std::size_t points, std::uint32_t capacity);

    Program m_bin;
    Program m_scan;
    Program m_lay;
    Buffer m_counts;
    Buffer m_begins;
    Buffer m_entries;
    Buffer m_sorted;
    Texture m_light;
    glm::ivec2 m_tiles{0};
    int m_nextRow = 0;
    std::uint32_t m_capacity = 0; ///< Entries that there is room for.
    float m_opaque = 0.0F;
};

} // namespace hairpaint::rendering
