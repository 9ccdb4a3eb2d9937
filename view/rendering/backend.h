// The interface of the renderers of head and hair.
#pragma once

#include "view/rendering/scene.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace hairpaint::rendering {

/// How much is drawn.
struct Quality
{
    float detail = 1.0F;     ///< 0..1: fraction of the hairs; those drawn are widened so that coverage stays the same.
    int samples = 4;         ///< Samples a pixel: 1, 2, 4, 8 or 16, at most Capabilities::mostSamples.
    bool coarseHead = false; ///< Whether a frame whose view differs from the one before may show Scene::headInMotion.
    bool linear = false;     ///< Whether readLinear() or takeLinear() will be called.
};

struct FrameStatistics
{
    std::size_t drawnHairs = 0;
    float detail = 1.0F; ///< Hairs whose StrandStyle::detail is below were asked for, positioned by the frame or not.
    std::size_t drawnSegments = 0;
    std::size_t uploadedBytes = 0;
    double milliseconds = 0.0; ///< What a frame takes: see Backend::statistics().
    bool inSteps = false;      ///< Drawn by step(): the milliseconds are no measure of frames while something moves.
    bool complete = true;      ///< False where a part was given up, as when memory is short.
};

/// The optional abilities of a backend.
struct Capabilities
{
    bool graphicsCard = false; ///< Draws on a graphics card; else on the processor, maybe through a driver of OpenGL.
    int mostSamples = 4;       ///< Per pixel.
    bool linear = false;       ///< Pictures before they are encoded: Quality::linear.
    bool transparent = false;  ///< Scene::transparent.
};

/// One thread at a time; each backend's class says what else it needs.
class Backend
{
public:
    virtual ~Backend() = default;
    Backend(const Backend&) = delete;
    Backend& operator=(const Backend&) = delete;

    /// Draws a picture of width x height pixels.
    virtual void draw(const Scene& scene, const Quality& quality, int width, int height) = 0;
    /// Begins the same picture, for step() to draw. An unfinished one is dropped, as it is by draw().
    virtual void begin(const Scene& scene, const Quality& quality, int width, int height) = 0;
    /// Draws pieces of the unfinished picture until `budgetMs` are used up, one at least, and waits for them. True
    /// where nothing is left to draw: only then is it the last picture.
    [[nodiscard]] virtual bool step(double budgetMs) = 0;
    /// Called with 0..1 while a picture is drawn; false stops it.
    using Progress = std::function<bool(double)>;
    /// All the steps of a picture that may take seconds, without progress those of draw(). False where it was stopped.
    [[nodiscard]] virtual bool drawPatiently(const Scene& scene, const Quality& quality, int width, int height,
                                             const Progress& progress) = 0;
    /// Reads the last finished picture: RGBA8, row 0 on top, sRGB as encoded. Reuses `pixels`. Waits for the picture.
    virtual void read(std::vector<std::uint8_t>& pixels) = 0;
    /// The same in linear light before it is encoded: RGBA, colours times alpha, row 0 on top. Empty unless the picture
    /// was drawn with Quality::linear, and where the backend has none.
    virtual void readLinear(std::vector<float>& pixels) { pixels.clear(); }
    /// The pixels of read() and readLinear(), moved out: the backend may also free what it needed for drawing.
    [[nodiscard]] virtual std::vector<std::uint8_t> takePicture()
    {
        std::vector<std::uint8_t> pixels;
        read(pixels);
        return pixels;
    }
    [[nodiscard]] virtual std::vector<float> takeLinear()
    {
        std::vector<float> pixels;
        readLinear(pixels);
        return pixels;
    }
    /// Statistics of the last finished picture.
    [[nodiscard]] virtual const FrameStatistics& statistics() const = 0;
    [[nodiscard]] virtual Capabilities capabilities() const = 0;
    [[nodiscard]] virtual const std::string& description() const = 0; ///< Name of the renderer, to be shown.

protected:
    Backend() = default;
};

/// The quality of pictures that are kept, and what a still picture is refined to.
[[nodiscard]] inline Quality pictureQuality()
{
    return {.detail = 1.0F, .samples = 4};
}

} // namespace hairpaint::rendering
