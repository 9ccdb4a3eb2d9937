// One triangle a ring, cut by the scissor.
#include "view/rendering/gl/ring_pass.h"

#include <epoxy/gl.h>

#include <cmath>

namespace hairpaint::rendering {

tl::expected<RingPass, std::string> RingPass::create()
{
    RingPass pass;
    for (std::size_t i = 0; i < pass.m_programs.size(); ++i) {
        auto program = Program::graphics("screen.vert", "ring.frag", kSampleDefines.at(i));
        if (!program)
            return tl::unexpected(program.error());
        pass.m_programs.at(i) = std::move(*program);
    }
    return pass;
}

void RingPass::draw(const FrameConstants& constants) const
{
    const glm::vec2 samples(constants.target.z, constants.target.w);
    const Program& program = m_programs.at(static_cast<std::size_t>(samples.x * samples.y) / 2);
    for (std::size_t ring = 0; ring < constants.ringWo.size(); ++ring) {
        const glm::vec4& ringWo = constants.ringWo.at(ring);
        const glm::vec4 clip = constants.projectionFromWo * glm::vec4(glm::vec3(ringWo), 1.0F);
        if (ringWo.w <= 0.0F || clip.w <= 0.01F)
            continue;
        const glm::vec2 centrePx =
            (glm::vec2(clip) / clip.w * 0.5F + 0.5F) * glm::vec2(constants.target.x, constants.target.y) / samples;
        // The skin bends toward the eye here and there; and the line has a width.
        const float reachPx = ringWo.w * constants.gridSize.z / clip.w / samples.y * 1.3F + 8.0F;
        const glm::ivec2 low(glm::floor(centrePx - reachPx));
        const auto side = static_cast<int>(std::ceil(2.0F * reachPx)) + 1;
        glEnable(GL_SCISSOR_TEST);
        glScissor(low.x, low.y, side, side);
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
        program.use();
        program.set("ring", static_cast<int>(ring));
        glDrawArrays(GL_TRIANGLES, 0, 3);
        glDisable(GL_BLEND);
        glDisable(GL_SCISSOR_TEST);
    }
}

} // namespace hairpaint::rendering
