// Runs the shaders of the tiles.
#include "view/rendering/gl/tile_pass.h"

#include <epoxy/gl.h>

#include <algorithm>

namespace hairpaint::rendering {
namespace {

constexpr int kTileSp = 8; ///< As strand_tile.comp has it.
constexpr std::size_t kBinWorkgroup = 64;
constexpr std::size_t kMostWorkgroups = 65535; ///< Greatest number in one direction that OpenGL guarantees.
constexpr std::size_t kEntryBytes = 2 * sizeof(std::uint32_t);
constexpr float kMovingOpaque = 0.06F; ///< A sample counts as opaque where less than this is left to see through.
constexpr float kFineOpaque = 0.015F;  ///< The same in pictures with several samples a pixel.

} // namespace

tl::expected<TilePass, std::string> TilePass::create()
{
    TilePass pass;
    const std::pair<Program TilePass::*, const char*> programs[] = {{&TilePass::m_bin, "strand_bin.comp"},
                                                                    {&TilePass::m_scan, "tile_scan.comp"},
                                                                    {&TilePass::m_lay, "strand_tile.comp"}};
    for (const auto& [member, file] : programs) {
        auto program = Program::compute(file);
        if (!program)
            return tl::unexpected(program.error());
        pass.*member = std::move(*program);
    }
    return pass;
}

void TilePass::count(const Buffer& projected, std::size_t points, std::uint32_t capacity)
{
    projected.bindStorage(0);
    m_bin.use();
    m_bin.set("pointCount", static_cast<std::uint32_t>(points));
    m_bin.set("tiles", m_tiles);
    m_bin.set("tileSp", static_cast<float>(kTileSp));
    m_bin.set("capacity", capacity);
    constexpr std::size_t kRun = kMostWorkgroups * kBinWorkgroup;
    for (std::size_t first = 0; first < points; first += kRun) {
        m_bin.set("firstPoint", static_cast<std::uint32_t>(first));
        const std::size_t run = std::min(points - first, kRun);
        glDispatchCompute(static_cast<unsigned>((run + kBinWorkgroup - 1) / kBinWorkgroup), 1, 1);
    }
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

bool TilePass::bin(const FrameConstants& constants, const Buffer& projected, std::size_t points)
{
    const glm::ivec2 size(constants.target);
    m_tiles = (size + kTileSp - 1) / kTileSp;
    m_nextRow = 0;
    m_opaque = constants.target.z > 1.0F ? kFineOpaque : kMovingOpaque;
    m_light.resize2D(GL_RGBA16F, size.x, size.y);
    const std::size_t tiles = static_cast<std::size_t>(m_tiles.x) * static_cast<std::size_t>(m_tiles.y);
    m_counts.reserve(tiles * sizeof(std::uint32_t));
    m_begins.reserve((tiles + 1) * sizeof(std::uint32_t));
    m_counts.clear();
    m_counts.bindStorage(1);
    m_begins.bindStorage(2);
    count(projected, points, 0);
    m_scan.use();
    m_scan.set("tileCount", static_cast<std::uint32_t>(tiles));
    glDispatchCompute(1, 1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
    std::uint32_t entries = 0;
    m_begins.read(&entries, sizeof(entries));
    const std::size_t room = std::min(std::size_t{entries} * kEntryBytes, mostBytesOfABuffer());
    m_entries.reserve(room);
    m_sorted.reserve(room);
    m_capacity = static_cast<std::uint32_t>(std::min({m_entries.capacity(), m_sorted.capacity(), room}) / kEntryBytes);
    if (m_capacity == 0)
        return entries == 0;
    m_entries.bindStorage(3);
    count(projected, points, m_capacity);
    return m_capacity >= entries;
}

bool TilePass::layRows(const Buffer& projected, const Texture& headDepth, const Texture& worn, int rows)
{
    if (m_nextRow == m_tiles.y)
        return false;
    rows = std::min(rows, m_tiles.y - m_nextRow);
    projected.bindStorage(0);
    m_counts.bindStorage(1);
    m_begins.bindStorage(2);
    m_entries.bindStorage(3);
    m_sorted.bindStorage(4);
    headDepth.bind(2);
    worn.bind(3);
    glBindImageTexture(0, m_light.id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA16F);
    m_lay.use();
    m_lay.set("tiles", m_tiles);
    m_lay.set("firstRow", m_nextRow);
    m_lay.set("capacity", m_capacity);
    m_lay.set("opaque", m_opaque);
    glDispatchCompute(static_cast<unsigned>(m_tiles.x), static_cast<unsigned>(rows), 1);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
    m_nextRow += rows;
    return true;
}

double TilePass::progress() const
{
    return m_tiles.y > 0 ? static_cast<double>(m_nextRow) / static_cast<double>(m_tiles.y) : 0.0;
}

} // namespace hairpaint::rendering
