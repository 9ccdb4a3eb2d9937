// Reads the state that the renderer changes, sets its own, and puts it back.
#include "view/rendering/gl/state_guard.h"

#include <epoxy/gl.h>

namespace hairpaint::rendering {

namespace {

void enable(unsigned what, bool on)
{
    if (on)
        glEnable(what);
    else
        glDisable(what);
}

} // namespace

StateGuard::StateGuard()
{
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &m_drawFramebuffer);
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &m_readFramebuffer);
    glGetIntegerv(GL_CURRENT_PROGRAM, &m_program);
    glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &m_vertexArray);
    glGetIntegerv(GL_ACTIVE_TEXTURE, &m_activeTexture);
    for (int unit = 0; unit < kTextureUnits; ++unit) {
        glActiveTexture(GL_TEXTURE0 + static_cast<unsigned>(unit));
        glGetIntegerv(GL_TEXTURE_BINDING_2D, &m_textures[unit]);
        glGetIntegerv(GL_TEXTURE_BINDING_3D, &m_textures3D[unit]);
    }
    glGetIntegerv(GL_VIEWPORT, m_viewport);
    glGetIntegerv(GL_SCISSOR_BOX, m_scissorBox);
    glGetIntegerv(GL_BLEND_SRC_RGB, &m_blendSource[0]);
    glGetIntegerv(GL_BLEND_SRC_ALPHA, &m_blendSource[1]);
    glGetIntegerv(GL_BLEND_DST_RGB, &m_blendTarget[0]);
    glGetIntegerv(GL_BLEND_DST_ALPHA, &m_blendTarget[1]);
    glGetIntegerv(GL_PACK_ALIGNMENT, &m_packAlignment);
    glGetIntegerv(GL_DEPTH_FUNC, &m_depthFunction);
    glGetBooleanv(GL_DEPTH_WRITEMASK, &m_depthMask);
    glGetBooleanv(GL_COLOR_WRITEMASK, m_colourMask);
    m_depthTest = glIsEnabled(GL_DEPTH_TEST) != 0;
    m_blend = glIsEnabled(GL_BLEND) != 0;
    m_cull = glIsEnabled(GL_CULL_FACE) != 0;
    m_scissor = glIsEnabled(GL_SCISSOR_TEST) != 0;
    m_stencil = glIsEnabled(GL_STENCIL_TEST) != 0;
    m_multisample = glIsEnabled(GL_MULTISAMPLE) != 0;
    m_srgb = glIsEnabled(GL_FRAMEBUFFER_SRGB) != 0;
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_MULTISAMPLE);
    glDisable(GL_FRAMEBUFFER_SRGB);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
}

StateGuard::~StateGuard()
{
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<unsigned>(m_drawFramebuffer));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<unsigned>(m_readFramebuffer));
    glUseProgram(static_cast<unsigned>(m_program));
    glBindVertexArray(static_cast<unsigned>(m_vertexArray));
    for (int unit = 0; unit < kTextureUnits; ++unit) {
        glActiveTexture(GL_TEXTURE0 + static_cast<unsigned>(unit));
        glBindTexture(GL_TEXTURE_2D, static_cast<unsigned>(m_textures[unit]));
        glBindTexture(GL_TEXTURE_3D, static_cast<unsigned>(m_textures3D[unit]));
    }
    glActiveTexture(static_cast<unsigned>(m_activeTexture));
    glViewport(m_viewport[0], m_viewport[1], m_viewport[2], m_viewport[3]);
    glScissor(m_scissorBox[0], m_scissorBox[1], m_scissorBox[2], m_scissorBox[3]);
    glBlendFuncSeparate(static_cast<unsigned>(m_blendSource[0]), static_cast<unsigned>(m_blendTarget[0]),
                        static_cast<unsigned>(m_blendSource[1]), static_cast<unsigned>(m_blendTarget[1]));
    glPixelStorei(GL_PACK_ALIGNMENT, m_packAlignment);
    glDepthFunc(static_cast<unsigned>(m_depthFunction));
    glDepthMask(m_depthMask);
    glColorMask(m_colourMask[0], m_colourMask[1], m_colourMask[2], m_colourMask[3]);
    enable(GL_DEPTH_TEST, m_depthTest);
    enable(GL_BLEND, m_blend);
    enable(GL_CULL_FACE, m_cull);
    enable(GL_SCISSOR_TEST, m_scissor);
    enable(GL_STENCIL_TEST, m_stencil);
    enable(GL_MULTISAMPLE, m_multisample);
    enable(GL_FRAMEBUFFER_SRGB, m_srgb);
}

} // namespace hairpaint::rendering
