// Leaves the caller's OpenGL state as it was.
#pragma once

namespace hairpaint::rendering {

/// Remembers the parts of the context's state that the renderer changes, and puts them back.
class StateGuard
{
public:
    StateGuard();
    ~StateGuard();
    StateGuard(const StateGuard&) = delete;
    StateGuard& operator=(const StateGuard&) = delete;

private:
    static constexpr int kTextureUnits = 4;
    int m_drawFramebuffer = 0;
    int m_readFramebuffer = 0;
    int m_program = 0;
    int m_vertexArray = 0;
    int m_activeTexture = 0;
    int m_textures[kTextureUnits] = {};
    int m_textures3D[kTextureUnits] = {};
    int m_scissorBox[4] = {};
    int m_blendSource[2] = {}; ///< For colour and for alpha.
    int m_blendTarget[2] = {};
    int m_viewport[4] = {};
    int m_packAlignment = 4;
    int m_depthFunction = 0;
    unsigned char m_depthMask = 1;
    unsigned char m_colourMask[4] = {};
    bool m_depthTest = false;
    bool m_blend = false;
    bool m_cull = false;
    bool m_scissor = false;
    bool m_stencil = false;
    bool m_multisample = false;
    bool m_srgb = false;
};

} // namespace hairpaint::rendering
