// Runs the shader of the skin's shadow.
#include "view/rendering/gl/skin_shade.h"

#include <epoxy/gl.h>

namespace hairpaint::rendering {
namespace {

constexpr int kCoarseCell = 4;     ///< Pixels across a cell of the shadow.
constexpr int kFineCell = 2;       ///< The same in pictures with several samples a pixel.
constexpr int kShadeWorkgroup = 8; ///< Size of a workgroup in each direction.

unsigned groups(int cells)
{
    return static_cast<unsigned>((cells + kShadeWorkgroup - 1) / kShadeWorkgroup);
}

} // namespace

tl::expected<SkinShade, std::string> SkinShade::create()
{
    SkinShade shade;
    auto program = Program::compute("skin_shade.comp");
    if (!program)
        return tl::unexpected(program.error());
    shade.m_program = std::move(*program);
    return shade;
}

void SkinShade::draw(const Target& target)
{
    m_cell = target.samples.x > 1 ? kFineCell : kCoarseCell;
    const int across = (target.width + m_cell - 1) / m_cell;
    const int up = (target.height + m_cell - 1) / m_cell;
    m_shade.resize2D(GL_R8, across, up, true);
    m_program.use();
    m_program.set("shadeCell", m_cell);
    glBindImageTexture(0, m_shade.id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R8);
    glDispatchCompute(groups(across), groups(up), 1);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

} // namespace hairpaint::rendering
