// Draws head and hair without OpenGL: our own, on any machine, the same bytes on every x86-64 and for any number of
// threads.
#pragma once

#include "view/rendering/backend.h"

#include <memory>

namespace hairpaint::rendering {

/// Strands are expanded, lit and sorted into tiles of the picture; in each tile hair is laid over the samples from the
/// nearest on with the coverage it has, until nothing can be seen through it. Loops run through sim::parallelFor.
/// Depth and light are floats, tone-mapped once. Two samples a pixel are drawn as four,
/// eight as sixteen.
class SoftwareRenderer final : public Backend
{
public:
    static constexpr std::size_t kMostBytes = 720U << 20U;

    /// `mostBytes`: a picture of more hair than takes about so much memory is drawn some rows at a time, with the same
    /// result.
    explicit SoftwareRenderer(std::size_t mostBytes = kMostBytes);
    ~SoftwareRenderer() override;

    void draw(const Scene& scene, const Quality& quality, int width, int height) override;
    void begin(const Scene& scene, const Quality& quality, int width, int height) override;
    [[nodiscard]] bool step(double budgetMs) override;
    [[nodiscard]] bool drawPatiently(const Scene& scene, const Quality& quality, int width, int height,
                                     const Progress& progress) override;
    /// In a transparent scene alpha is the fraction of the pixel that is covered, and the colour that of what covers
    /// it.
    void read(std::vector<std::uint8_t>& pixels) override;
    void readLinear(std::vector<float>& pixels) override;
    /// Also frees what drawing needed, which is more than a gigabyte for a large picture.
    [[nodiscard]] std::vector<std::uint8_t> takePicture() override;
    [[nodiscard]] std::vector<float> takeLinear() override;
    [[nodiscard]] const FrameStatistics& statistics() const override;
    [[nodiscard]] Capabilities capabilities() const override
    {
        return {.graphicsCard = false, .mostSamples = 16, .linear = true, .transparent = true};
    }
    [[nodiscard]] const std::string& description() const override;

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace hairpaint::rendering
