// The hair's shadow on the skin, at a fraction of the picture's resolution.
#pragma once

#include "view/rendering/gl_objects.h"

namespace hairpaint::rendering {

class SkinShade
{
public:
    [[nodiscard]] static tl::expected<SkinShade, std::string> create();

    /// With the frame's constants bound to uniform buffer 0, the head's depth to texture unit 1 and the opacity grids
    /// to 2 and 3: fills the texture for a picture of width x height pixels.
    void draw(int width, int height);
    void bind(unsigned unit) const { m_shade.bind(unit); }

private:
    Program m_program;
    Texture m_shade;
};

} // namespace hairpaint::rendering
