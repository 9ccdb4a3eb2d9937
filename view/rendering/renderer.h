// Draws head and hair with OpenGL 4.3 or later into its own targets.
#pragma once

#include "view/rendering/scene.h"

#include <tl/expected.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace hairpaint::rendering {

/// How much is drawn.
struct Quality
{
    float detail = 1.0F;     ///< 0..1: fraction of the hairs; those drawn are widened so that coverage stays the same.
    int samples = 4;         ///< 1, 2, 4: multisampling of the renderer's own targets.
    int smoothSegments = 16; ///< Segments of a straight hair.
    bool coarseHead = false; ///< Whether a frame whose view differs from the one before may show Scene::headInMotion.
};

struct FrameStatistics
{
    std::size_t drawnHairs = 0;
    std::size_t drawnSegments = 0;
    std::size_t uploadedBytes = 0;
    double milliseconds = 0.0; ///< What a frame takes: see Renderer::statistics().
    bool inSteps = false;      ///< Drawn by step(): the milliseconds are no measure of frames while something moves.
    bool complete = true;      ///< False where OpenGL gave up on a part, as when memory is short.
};

/// Every call needs the same OpenGL context current. Made anew when the context is lost. Uploads are lazy and cover
/// only what differs from the frame before: styles by chunk, skeletons and the list of strands by blocks.
class Renderer
{
public:
    /// Fails with one sentence where the context is too old or a shader does not compile.
    [[nodiscard]] static tl::expected<std::unique_ptr<Renderer>, std::string> create();
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Draws into the renderer's own target of width x height pixels; waits for nothing.
    void draw(const Scene& scene, const Quality& quality, int width, int height);
    /// Begins the same picture, for step() to draw: uploads, draws the head, and waits for nothing. Whatever was under
    /// way is dropped, as it is by draw().
    void begin(const Scene& scene, const Quality& quality, int width, int height);
    /// Draws pieces of the picture under way until `budgetMs` are used up, one at least, and waits for them; between
    /// steps the context is anybody's. True where nothing is left to draw: only then is it the last picture.
    [[nodiscard]] bool step(double budgetMs);
    /// Called with 0..1 while a picture is drawn; false stops it.
    using Progress = std::function<bool(double)>;
    /// All the steps of a picture that may take seconds, without progress those of draw(). False where it was stopped.
    [[nodiscard]] bool drawPatiently(const Scene& scene, const Quality& quality, int width, int height,
                                     const Progress& progress);
    /// Copies the last finished picture to the framebuffer object bound by the caller.
    void blitTo(unsigned framebuffer, int width, int height);
    /// Reads the last finished picture: RGBA8, row 0 on top, sRGB as encoded. Reuses `pixels`. Waits for the picture.
    void read(std::vector<std::uint8_t>& pixels);
    /// Of the last finished picture. The milliseconds of one drawn at once run to the end of the first read(); where it
    /// was not read they are the GPU's own, of the newest such picture it has told of, or the time that handing over
    /// took where that is longer. Those of a picture drawn in steps are the steps' own, and no other's contain them.
    [[nodiscard]] const FrameStatistics& statistics() const;
    [[nodiscard]] bool software() const;                  ///< llvmpipe, softpipe or the like.
    [[nodiscard]] const std::string& description() const; ///< GL_RENDERER.

private:
    Renderer();
    struct Picture;
    struct State;
    [[nodiscard]] Picture prepare(const Scene& scene, const Quality& quality, int width, int height,
                                  std::uint32_t piecePoints);
    void resolve(const Picture& picture);
    std::unique_ptr<State> m_state;
};

/// The quality of pictures that are kept, and what a still picture is refined to.
[[nodiscard]] inline Quality pictureQuality()
{
    return {.detail = 1.0F, .samples = 4, .smoothSegments = 16};
}

} // namespace hairpaint::rendering
