// Draws head and hair with OpenGL 4.3 or later into its own targets.
#pragma once

#include "view/rendering/backend.h"

#include <tl/expected.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace hairpaint::rendering {

/// Every call needs the same OpenGL context current. Made anew when the context is lost. Uploads are lazy and cover
/// only what differs from the frame before: styles by chunk, skeletons and the list of strands by blocks.
class GlRenderer final : public Backend
{
public:
    /// Fails with one sentence where the context is too old or a shader does not compile.
    [[nodiscard]] static tl::expected<std::unique_ptr<GlRenderer>, std::string> create();
    ~GlRenderer() override;

    /// Draws into the renderer's own target of width x height pixels; waits for nothing.
    void draw(const Scene& scene, const Quality& quality, int width, int height) override;
    /// Begins the same picture, for step() to draw: uploads, draws the head, and waits for nothing. An unfinished one
    /// is dropped, as it is by draw().
    void begin(const Scene& scene, const Quality& quality, int width, int height) override;
    /// Draws pieces of the unfinished picture until `budgetMs` are used up, one at least, and waits for them; between
    /// steps the context is anybody's. True where nothing is left to draw: only then is it the last picture.
    [[nodiscard]] bool step(double budgetMs) override;
    [[nodiscard]] bool drawPatiently(const Scene& scene, const Quality& quality, int width, int height,
                                     const Progress& progress) override;
    /// Copies the last finished picture to the framebuffer object bound by the caller.
    void blitTo(unsigned framebuffer, int width, int height);
    void read(std::vector<std::uint8_t>& pixels) override;
    /// Statistics of the last finished picture. The milliseconds of a picture drawn at once run to the end of the first
    /// read(). Where it was not read they are the GPU's time for the newest such picture that it has reported, or the
    /// time that handing over the commands took where that is longer. The milliseconds of a picture drawn in steps are
    /// the sum of its steps', which count for no other picture.
    [[nodiscard]] const FrameStatistics& statistics() const override;
    /// Whether the driver has reset itself, and what was drawn into this context is gone. Where the context was not
    /// asked to tell, never.
    [[nodiscard]] bool contextLost() const;
    [[nodiscard]] Capabilities capabilities() const override; ///< llvmpipe, softpipe or the like: no graphics card.
    [[nodiscard]] const std::string& description() const override; ///< GL_RENDERER.

private:
    GlRenderer();
    struct Picture;
    struct State;
    [[nodiscard]] Picture prepare(const Scene& scene, const Quality& quality, int width, int height,
                                  std::uint32_t piecePoints);
    [[nodiscard]] bool drawPiece(Picture& picture, int rows);
    void resolve(const Picture& picture);
    std::unique_ptr<State> m_state;
};

} // namespace hairpaint::rendering
