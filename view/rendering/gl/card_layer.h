// Hair cards drawn with triangles into the head's picture.
#pragma once

#include "view/rendering/card_set.h"
#include "view/rendering/gl/gl_objects.h"

#include <memory>
#include <string>

namespace hairpaint::rendering {

class CardLayer
{
public:
    [[nodiscard]] static tl::expected<CardLayer, std::string> create();

    /// Into the bound framebuffer, behind what its depth says is nearer, with the constants bound to uniform buffer 0.
    void draw(const std::shared_ptr<const CardSet>& cards);

private:
    CardLayer() = default;
    void upload(const std::shared_ptr<const CardSet>& cards);

    Program m_program;
    std::shared_ptr<const CardSet> m_source;
    VertexArray m_vertexArray;
    Buffer m_corners;
    Buffer m_indices;
    GlName<deleteTexture> m_atlas;
};

} // namespace hairpaint::rendering
