// The head's own picture and depth, one texel a sample, drawn anew only when something about it differs.
#pragma once

#include "view/rendering/frame_constants.h"
#include "view/rendering/gl_objects.h"

#include <memory>
#include <string>

namespace hairpaint::rendering {

class HeadLayer
{
public:
    [[nodiscard]] static tl::expected<std::unique_ptr<HeadLayer>, std::string> create();

    /// Draws `head` (may be null) with the constants bound to uniform buffer 0. False where the last picture still
    /// holds.
    bool draw(const std::shared_ptr<const sim::HeadMesh>& head, const FrameConstants& constants);
    /// Binds colour and depth to two texture units.
    void bind(unsigned colourUnit, unsigned depthUnit) const;

private:
    HeadLayer() = default;
    void upload(const sim::HeadMesh& head);

    Program m_program;
    VertexArray m_vertexArray;
    Buffer m_vertices;
    Buffer m_indices;
    int m_indexCount = 0;
    bool m_closed = false; ///< The inside is never seen.
    Framebuffer m_framebuffer;
    Texture m_colour;
    Texture m_depth;
    std::shared_ptr<const sim::HeadMesh> m_head;
    FrameConstants m_drawnWith{};
};

} // namespace hairpaint::rendering
