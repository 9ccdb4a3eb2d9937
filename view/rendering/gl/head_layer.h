// The picture and depth of the head, of what is worn on it and of cards that stand for its hair, one texel a sample,
// drawn anew only when something about it differs.
#pragma once

#include "view/rendering/frame_constants.h"
#include "view/rendering/gl/card_layer.h"
#include "view/rendering/gl/gl_objects.h"
#include "view/rendering/scalp_tint.h"

#include <memory>
#include <string>
#include <vector>

namespace hairpaint::rendering {

class HeadLayer
{
public:
    [[nodiscard]] static tl::expected<std::unique_ptr<HeadLayer>, std::string> create();

    /// Draws the scene's head, solids and cards with the constants bound to uniform buffer 0. `coarse`: where the view
    /// differs from the call before, headInMotion is drawn instead of the head, unless null, and the head in the first
    /// call that does not differ. False where the last picture still holds.
    bool draw(const Scene& scene, bool coarse, const FrameConstants& constants);
    /// Binds colour and depth to two texture units.
    void bind(unsigned colourUnit, unsigned depthUnit) const;
    [[nodiscard]] const Texture& depth() const { return m_depth; }
    [[nodiscard]] const Texture& worn() const { return m_worn; } ///< 1 where a solid is seen.

private:
    explicit HeadLayer(CardLayer cards) : m_cardLayer(std::move(cards)) {}
    struct Mesh
    {
        std::shared_ptr<const sim::HeadMesh> source;
        VertexArray vertexArray;
        Buffer vertices;
        Buffer indices;
        int indexCount = 0;
        bool closed = false; ///< The inside is never seen.
        ScalpTint tint;
        Buffer tints; ///< [vertices] ScalpTint::Texel.
        std::shared_ptr<const sim::MeshTexture> shown;
        Texture texture; ///< `shown`.
        /// `open`: the mesh is known to be open.
        void upload(const std::shared_ptr<const sim::HeadMesh>& head, bool open = false);
        void uploadTexture(const std::shared_ptr<const sim::MeshTexture>& picture);
        void bindTexture(const Program& program, float leastAlpha) const; ///< `shown`, for the program in use.
        void uploadTint(const ScalpTintSources& sources);
        void draw() const; ///< Draws with the program in use.
    };

    void drawSolids();

    Program m_program;
    Program m_solidProgram;
    CardLayer m_cardLayer;
    Mesh m_fine;
    Mesh m_coarse;
    std::vector<Mesh> m_solidMeshes; ///< The meshes of m_solids, each once.
    Framebuffer m_framebuffer;
    Texture m_colour;
    Texture m_depth;
    Texture m_worn;
    std::shared_ptr<const sim::HeadMesh> m_head;
    std::shared_ptr<const CardSet> m_cards;
    std::vector<Solid> m_solids;
    ScalpTintSources m_tintSources;
    FrameConstants m_drawnWith{};
    bool m_isCoarse = false; ///< The picture shows the coarse head.
};

} // namespace hairpaint::rendering
