// Head, hair and background in tiles.
#include "view/rendering/software/software_renderer.h"

#include "sim/base/parallel.h"
#include "sim/base/per_thread.h"
#include "view/rendering/skull_size.h"
#include "view/rendering/software/hair_segments.h"
#include "view/rendering/software/head_picture.h"
#include "view/rendering/software/resolve_kernel.h"
#include "view/rendering/software/ring_overlay.h"

#include <algorithm>
#include <chrono>
#include <new>
#include <optional>
#include <utility>

namespace hairpaint::rendering {
namespace {

constexpr int kMostSide = 8192;
constexpr std::size_t kBatchesAStep = 4;
constexpr std::size_t kTilesAStep = 64;
constexpr float kCoarseOpaque = 0.06F; ///< A sample counts as opaque where less than this is left to see through.
constexpr float kFineOpaque = 0.015F;
constexpr int kCoarseShadeCell = 4; ///< Pixels across a cell of the skin's shadow.
constexpr int kFineShadeCell = 2;   ///< The same in pictures with several samples a pixel.

using SoftwareClock = std::chrono::steady_clock;

double millisecondsFrom(SoftwareClock::time_point begin)
{
    return std::chrono::duration<double, std::milli>(SoftwareClock::now() - begin).count();
}

TileSamples& tileSamples()
{
    static auto& samples = *new sim::PerThread<TileSamples>; // Never destroyed: threads may still draw at the end.
    return samples.here();
}

} // namespace

struct SoftwareRenderer::State
{
    /// An unfinished picture: what is drawn, and how much of it is done.
    struct Picture
    {
        Target target;
        FrameConstants constants;
        std::size_t nextBatch = 0;
        std::size_t nextTile = 0;
        double spentMs = 0.0;
        bool transparent = false;
        bool complete = true;
    };

    std::string description = "Hair Paint's own, in software";
    FrameStatistics statistics;
    SkullSize skull;
    HeadPicture head;
    std::size_t mostBytes;
    HairSegments hair{mostBytes};
    std::vector<float> skinShade;
    std::vector<float> hiddenBehind; ///< In the cells of skinShade.
    glm::ivec2 shadeSize{0};
    int shadeCell = kCoarseShadeCell;
    std::vector<std::uint8_t> drawn;  ///< The unfinished picture.
    std::vector<std::uint8_t> pixels; ///< The last finished picture.
    std::vector<float> drawnLinear;   ///< The unfinished picture in linear light; empty where it is not wanted.
    std::vector<float> linear;
    std::optional<Picture> underWay;

    explicit State(std::size_t mostHeldBytes) : mostBytes(mostHeldBytes) {}
    void prepare(const Scene& scene, const Quality& quality, int width, int height);
    void drawBatches(std::size_t count);
    void drawRows(int firstUp, int rows);
    [[nodiscard]] double fraction() const;
    void drawTiles(std::size_t count);
    void drawTile(std::size_t tile);
    void shade();
    void finish(bool inSteps);
    [[nodiscard]] bool piece(std::size_t batches, std::size_t tiles);
};

void SoftwareRenderer::State::prepare(const Scene& scene, const Quality& quality, int width, int height)
{
    underWay.reset();
    Picture picture;
    picture.target.width = std::clamp(width, 1, kMostSide);
    picture.target.height = std::clamp(height, 1, kMostSide);
    picture.target.samples = glm::ivec2(quality.samples > 4 ? 4 : quality.samples > 1 ? 2 : 1);
    picture.transparent = scene.transparent;
    picture.constants = frameConstants(scene, picture.target, skull.radiusM(scene.head));
    const float detail = std::clamp(quality.detail, 1.0F / 1024.0F, 1.0F);
    head.update(scene, quality.coarseHead, picture.constants);
    hair.begin(scene.cards ? nullptr : scene.hair, picture.constants, detail, quality.samples > 1, head.occlusion());
    drawn.resize(static_cast<std::size_t>(picture.target.width) * static_cast<std::size_t>(picture.target.height) * 4);
    drawnLinear.resize(quality.linear ? drawn.size() : 0);
    underWay = picture;
}

void SoftwareRenderer::State::drawBatches(std::size_t count)
{
    const std::size_t first = underWay->nextBatch;
    sim::parallelFor(count, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            hair.drawBatch(first + i);
    });
    underWay->nextBatch += count;
}

void SoftwareRenderer::State::shade()
{
    const FrameConstants& constants = underWay->constants;
    const Target& target = underWay->target;
    shadeSize = glm::ivec2(0);
    if (hair.hairs() == 0)
        return;
    shadeCell = target.samples.x > 1 ? kFineShadeCell : kCoarseShadeCell;
    shadeSize = (glm::ivec2(target.width, target.height) + shadeCell - 1) / shadeCell;
    skinShade.resize(static_cast<std::size_t>(shadeSize.x) * static_cast<std::size_t>(shadeSize.y));
    hiddenBehind.resize(skinShade.size());
    const glm::vec4 far = constants.woFromProjection * glm::vec4(0.0F, 0.0F, 1.0F, 1.0F);
    const ShadeTask task{.woFromProjection = constants.woFromProjection,
                         .gridFromWo = constants.gridFromWo[0],
                         .eyeGrid = hair.grids().eyeGrid(),
                         .opacity = {hair.grids().grid(0), hair.grids().grid(1)},
                         .gridSide = kGridSide,
                         .eyeWo = glm::vec3(constants.eyeWo),
                         .lightWo = glm::vec3(constants.keyWo),
                         .headWo = glm::vec3(constants.headWo),
                         .sizeSp = glm::vec2(constants.target),
                         .cellSp = target.samples * shadeCell,
                         .across = shadeSize.x,
                         .width = head.width(),
                         .height = head.height(),
                         .distancesM = head.distancesM().data(),
                         .rowHasHead = head.rowHasHead().data(),
                         .viewAxisWo = glm::normalize(glm::vec3(far) / far.w - glm::vec3(constants.eyeWo)),
                         .keptUnderHair = constants.gridSize.w,
                         .undrawnCoverings = hair.depth().undrawnCoverings,
                         .inEveryColumn = hair.depth().inEveryColumn,
                         .shade = skinShade.data(),
                         .hidden = hiddenBehind.data()};
    sim::parallelFor(static_cast<std::size_t>(shadeSize.y), 8, [&](std::size_t begin, std::size_t end) {
        shadeSkin(task, static_cast<int>(begin), static_cast<int>(end));
    });
}

void SoftwareRenderer::State::drawTile(std::size_t tile)
{
    const TileGrid& tiles = hair.tiles();
    const Picture& picture = *underWay;
    TileSamples& samples = tileSamples();
    const auto across = static_cast<std::size_t>(tiles.across);
    TileTask task;
    task.x0 = static_cast<int>(tile % across) * kTileSp;
    task.y0 = (tiles.firstUp + static_cast<int>(tile / across)) * kTileSp;
    task.width = std::min(kTileSp, tiles.width - task.x0);
    task.height = std::min(kTileSp, tiles.height - task.y0);
    task.anyHead = head.isIn(task.x0, task.y0, task.width, task.height);
    task.headStride = static_cast<std::size_t>(head.width());
    const std::size_t corner = static_cast<std::size_t>(task.y0) * task.headStride + static_cast<std::size_t>(task.x0);
    task.headDistanceM = head.distancesM().data() + corner;
    task.worn = head.worn() != nullptr ? head.worn() + corner : nullptr;
    task.head = head.samples().data() + corner;
    task.opaque = picture.target.samples.x > 1 ? kFineOpaque : kCoarseOpaque;
    task.nearestM = hair.nearestM();
    task.depthsPerM = hair.depthsPerM();
    hair.collect(tile, samples);
    task.bare = samples.entries.empty() && !task.anyHead && drawnLinear.empty();
    if (!task.bare)
        layHair(task, samples);
    const ResolveTask resolve{.samplesX = picture.target.samples.x,
                              .samplesY = picture.target.samples.y,
                              .firstPixelX = task.x0 / picture.target.samples.x,
                              .firstPixelY = task.y0 / picture.target.samples.y,
                              .pictureWidth = picture.target.width,
                              .pictureHeight = picture.target.height,
                              .background = glm::vec3(picture.constants.background[0]),
                              .backgroundRise = glm::vec3(picture.constants.background[1]),
                              .transparent = picture.transparent,
                              .linear = drawnLinear.empty() ? nullptr : drawnLinear.data(),
                              .shade = shadeSize.x > 0 ? skinShade.data() : nullptr,
                              .hidden = shadeSize.x > 0 ? hiddenBehind.data() : nullptr,
                              .shadeAcross = shadeSize.x,
                              .shadeUp = shadeSize.y,
                              .shadeCell = shadeCell,
                              .shadeSpread = picture.constants.skin[0].w};
    resolveTile(task, resolve, samples, drawn.data());
}

void SoftwareRenderer::State::drawTiles(std::size_t count)
{
    const std::size_t first = underWay->nextTile;
    sim::parallelFor(count, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            drawTile(first + i);
    });
    underWay->nextTile += count;
}

/// Begins to draw `rows` rows of tiles from `firstUp` on.
void SoftwareRenderer::State::drawRows(int firstUp, int rows)
{
    hair.setRows(firstUp, std::min(firstUp + rows, hair.tiles().up));
    underWay->nextBatch = 0;
    underWay->nextTile = 0;
}

/// How much of the picture is done, 0..1.
double SoftwareRenderer::State::fraction() const
{
    const TileGrid& tiles = hair.tiles();
    const auto done = static_cast<double>(underWay->nextBatch + underWay->nextTile);
    const auto all = static_cast<double>(hair.batchCount() + tiles.count());
    return (tiles.firstUp + tiles.rows() * done / all) / tiles.up;
}

/// Draws at most so many batches, or where none is left so many tiles. False where nothing was left.
bool SoftwareRenderer::State::piece(std::size_t batches, std::size_t tiles)
{
    const std::size_t batchesLeft = hair.batchCount() - underWay->nextBatch;
    if (batchesLeft > 0) {
        drawBatches(std::min(batches, batchesLeft));
        if (hair.isTooMuch())
            drawRows(hair.tiles().firstUp, (hair.tiles().rows() + 1) / 2);
        return true;
    }
    const std::size_t tilesLeft = hair.tiles().count() - underWay->nextTile;
    if (tilesLeft == 0) {
        if (hair.tiles().endUp == hair.tiles().up)
            return false;
        drawRows(hair.tiles().endUp, hair.tiles().rows());
        return true;
    }
    if (underWay->nextTile == 0 && hair.tiles().firstUp == 0)
        shade();
    drawTiles(std::min(tiles, tilesLeft));
    return true;
}

/// Makes the unfinished picture the last finished one.
void SoftwareRenderer::State::finish(bool inSteps)
{
    const Picture& picture = *underWay;
    drawRings(picture.constants, head, drawn.data());
    std::swap(drawn, pixels);
    std::swap(drawnLinear, linear);
    statistics = {.drawnHairs = hair.hairs(),
                  .detail = hair.detail(),
                  .drawnSegments = hair.segmentCount(),
                  .uploadedBytes = 0,
                  .milliseconds = picture.spentMs,
                  .inSteps = inSteps,
                  .complete = picture.complete};
    underWay.reset();
}

SoftwareRenderer::SoftwareRenderer(std::size_t mostBytes) : m_state(std::make_unique<State>(mostBytes)) {}

SoftwareRenderer::~SoftwareRenderer() = default;

void SoftwareRenderer::draw(const Scene& scene, const Quality& quality, int width, int height)
{
    State& state = *m_state;
    const SoftwareClock::time_point began = SoftwareClock::now();
    state.prepare(scene, quality, width, height);
    while (state.piece(state.hair.batchCount(), state.hair.tiles().count())) {
    }
    state.underWay->spentMs = millisecondsFrom(began);
    state.finish(false);
}

void SoftwareRenderer::begin(const Scene& scene, const Quality& quality, int width, int height)
{
    const SoftwareClock::time_point began = SoftwareClock::now();
    m_state->prepare(scene, quality, width, height);
    m_state->underWay->spentMs = millisecondsFrom(began);
}

bool SoftwareRenderer::step(double budgetMs)
{
    State& state = *m_state;
    if (!state.underWay)
        return true;
    const SoftwareClock::time_point began = SoftwareClock::now();
    bool finished = false;
    double spentMs = 0.0;
    do {
        finished = !state.piece(kBatchesAStep, kTilesAStep);
        spentMs = millisecondsFrom(began);
    } while (!finished && spentMs < budgetMs);
    state.underWay->spentMs += spentMs;
    if (finished)
        state.finish(true);
    return finished;
}

bool SoftwareRenderer::drawPatiently(const Scene& scene, const Quality& quality, int width, int height,
                                     const Progress& progress)
{
    if (!progress) {
        draw(scene, quality, width, height);
        return true;
    }
    begin(scene, quality, width, height);
    while (!step(0.0)) {
        if (!progress(m_state->fraction()))
            return false;
    }
    return true;
}

void SoftwareRenderer::read(std::vector<std::uint8_t>& pixels)
{
    pixels = m_state->pixels;
}

void SoftwareRenderer::readLinear(std::vector<float>& pixels)
{
    pixels = m_state->linear;
}

std::vector<std::uint8_t> SoftwareRenderer::takePicture()
{
    std::vector<std::uint8_t> pixels = std::move(m_state->pixels);
    m_state = std::make_unique<State>(m_state->mostBytes);
    return pixels;
}

std::vector<float> SoftwareRenderer::takeLinear()
{
    std::vector<float> linear = std::move(m_state->linear);
    m_state = std::make_unique<State>(m_state->mostBytes);
    return linear;
}

const FrameStatistics& SoftwareRenderer::statistics() const
{
    return m_state->statistics;
}

const std::string& SoftwareRenderer::description() const
{
    return m_state->description;
}

} // namespace hairpaint::rendering
