// The hair's shadow on the skin, at a fraction of the picture's resolution.
#pragma once

#include "view/rendering/frame_constants.h"
#include "view/rendering/gl/gl_objects.h"

namespace hairpaint::rendering {

class SkinShade
{
public:
    [[nodiscard]] static tl::expected<SkinShade, std::string> create();

    /// With the frame's constants bound to uniform buffer 0, the head's depth to texture unit 1 and the opacity grids
    /// to 2 and 3: fills the texture.
    void draw(const Target& target);
    void bind(unsigned unit) const { m_shade.bind(unit); }
    [[nodiscard]] int cell() const { return m_cell; } ///< Pixels of the picture across a texel.

private:
    Program m_program;
    Texture m_shade;
    int m_cell = 1;
};

} // namespace hairpaint::rendering
