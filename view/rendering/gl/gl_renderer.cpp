// Head, hair and background, put together into one picture.
#include "view/rendering/gl/gl_renderer.h"

#include "view/rendering/gl/frame_timer.h"
#include "view/rendering/gl/gl_objects.h"
#include "view/rendering/gl/hair_pass.h"
#include "view/rendering/gl/head_layer.h"
#include "view/rendering/gl/offscreen_context.h"
#include "view/rendering/gl/ring_pass.h"
#include "view/rendering/gl/skin_shade.h"
#include "view/rendering/gl/state_guard.h"
#include "view/rendering/gl/tile_pass.h"
#include "view/rendering/skull_size.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstring>
#include <optional>
#include <utility>

namespace hairpaint::rendering {

namespace {

/// Whether OpenGL has complained since the last call.
bool takeErrors()
{
    constexpr int kMostErrors = 16; // A lost context may never run out of them.
    int errors = 0;
    while (errors < kMostErrors && glGetError() != GL_NO_ERROR)
        ++errors;
    return errors > 0;
}

constexpr int kAllRows = 1 << 16;
constexpr int kRowsAStep = 4; ///< Rows of tiles that a step draws.

/// Waits until all commands handed over are drawn; no longer than a second, should the driver hang.
void awaitDrawing()
{
    constexpr GLuint64 kMostNs = 1'000'000'000;
    GLsync done = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    glClientWaitSync(done, GL_SYNC_FLUSH_COMMANDS_BIT, kMostNs);
    glDeleteSync(done);
}

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point begin)
{
    return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

} // namespace

/// The state of a picture that is being drawn, besides the passes' own.
struct GlRenderer::Picture
{
    Target target;
    FrameConstants constants;
    HairPass::Report report;
    bool binned = false;  ///< Its segments are sorted into tiles.
    double spentMs = 0.0; ///< Sum of its steps' times.
    bool complete = true; ///< No part was given up so far.
};

struct GlRenderer::State
{
    std::string description;
    bool software = false;
    bool tellsOfResets = false;
    FrameStatistics statistics;
    SkullSize skull;
    std::unique_ptr<HeadLayer> head;
    std::unique_ptr<HairPass> hair;
    TilePass tiles;
    SkinShade shade;
    RingPass rings;
    std::array<Program, 3> resolve; ///< For 1, 2 and 4 samples a pixel.
    Program smooth;                 ///< Smooths edges instead of more samples.
    VertexArray noVertices;
    Buffer constants;
    Framebuffer framebuffer;
    Texture rough; ///< The picture of one sample a pixel, not smoothed yet.
    Texture picture;
    glm::ivec2 size{0};              ///< Size of the last finished picture, in pixels.
    std::optional<Picture> underWay; ///< The picture that was begun and is not finished.
    FrameTimer timer;                ///< Times the pictures drawn at once.
    bool readCounts = false;         ///< Whether the last picture's time ends with the next read().
};

GlRenderer::GlRenderer() : m_state(std::make_unique<State>()) {}

GlRenderer::~GlRenderer() = default;

tl::expected<std::unique_ptr<GlRenderer>, std::string> GlRenderer::create()
{
    adoptCurrentContext();
    if (epoxy_gl_version() < 43 || !epoxy_is_desktop_gl())
        return tl::unexpected("OpenGL 4.3 is needed; this driver has " +
                              std::string(reinterpret_cast<const char*>(glGetString(GL_VERSION))) + ".");
    std::unique_ptr<GlRenderer> renderer(new GlRenderer);
    State& state = *renderer->m_state;
    state.description = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    for (const char* name : {"llvmpipe", "softpipe", "SwiftShader", "Microsoft Basic"})
        state.software = state.software || state.description.find(name) != std::string::npos;

    state.tellsOfResets = epoxy_has_gl_extension("GL_ARB_robustness");

    auto head = HeadLayer::create();
    if (!head)
        return tl::unexpected(head.error());
    state.head = std::move(*head);
    auto hair = HairPass::create();
    if (!hair)
        return tl::unexpected(hair.error());
    state.hair = std::move(*hair);
    auto tiles = TilePass::create();
    if (!tiles)
        return tl::unexpected(tiles.error());
    state.tiles = std::move(*tiles);
    auto shade = SkinShade::create();
    if (!shade)
        return tl::unexpected(shade.error());
    state.shade = std::move(*shade);
    auto rings = RingPass::create();
    if (!rings)
        return tl::unexpected(rings.error());
    state.rings = std::move(*rings);
    for (std::size_t i = 0; i < kSampleDefines.size(); ++i) {
        auto resolve = Program::graphics("screen.vert", "resolve.frag", kSampleDefines.at(i));
        if (!resolve)
            return tl::unexpected(resolve.error());
        state.resolve[i] = std::move(*resolve);
    }
    auto smooth = Program::graphics("screen.vert", "smooth.frag");
    if (!smooth)
        return tl::unexpected(smooth.error());
    state.smooth = std::move(*smooth);
    state.noVertices = makeVertexArray();
    state.framebuffer = makeFramebuffer();
    return renderer;
}

void GlRenderer::draw(const Scene& scene, const Quality& quality, int width, int height)
{
    State& state = *m_state;
    state.timer.begin();
    const StateGuard guard;
    Picture picture = prepare(scene, quality, width, height, HairList::kBatchPoints);
    while (drawPiece(picture, kAllRows)) {
    }
    resolve(picture);
    state.timer.end();
    state.statistics.milliseconds = state.timer.milliseconds();
    state.readCounts = true;
}

void GlRenderer::begin(const Scene& scene, const Quality& quality, int width, int height)
{
    const Clock::time_point began = Clock::now();
    const StateGuard guard;
    Picture picture = prepare(scene, quality, width, height, HairPass::kSmallPiecePoints);
    picture.complete = !takeErrors();
    picture.spentMs = millisecondsSince(began);
    m_state->underWay = picture;
    m_state->readCounts = false;
}

bool GlRenderer::step(double budgetMs)
{
    State& state = *m_state;
    if (!state.underWay)
        return true;
    const Clock::time_point began = Clock::now();
    takeErrors(); // Drops the errors of other users of the context.
    const StateGuard guard;
    state.constants.bindUniform(0);
    Picture& picture = *state.underWay;
    bool finished = false;
    double spentMs = 0.0;
    do {
        finished = !drawPiece(picture, kRowsAStep);
        if (finished)
            resolve(picture);
        awaitDrawing();
        spentMs = millisecondsSince(began);
    } while (!finished && spentMs < budgetMs);
    picture.spentMs += spentMs;
    if (finished) {
        state.statistics.milliseconds = picture.spentMs;
        state.statistics.inSteps = true;
        state.underWay.reset();
    } else {
        picture.complete = !takeErrors() && picture.complete;
    }
    return finished;
}

bool GlRenderer::drawPatiently(const Scene& scene, const Quality& quality, int width, int height,
                               const Progress& progress)
{
    if (!progress) {
        draw(scene, quality, width, height);
        return true;
    }
    begin(scene, quality, width, height);
    while (!step(0.0))
        if (!progress(0.5 *
                      (m_state->hair->progress() + (m_state->underWay->binned ? m_state->tiles.progress() : 0.0))))
            return false;
    return true;
}

/// Draws the next piece of the hair; false where none is left.
bool GlRenderer::drawPiece(Picture& picture, int rows)
{
    State& state = *m_state;
    if (picture.report.hairs == 0)
        return false;
    if (state.hair->projectPiece())
        return true;
    if (!std::exchange(picture.binned, true)) {
        picture.complete = state.tiles.bin(picture.constants, state.hair->projected(), state.hair->projectedPoints()) &&
                           picture.complete;
        return true;
    }
    return state.tiles.layRows(state.hair->projected(), state.head->depth(), state.head->worn(), rows);
}

/// Draws the head and prepares the hair's pieces, of `piecePoints` at most.
GlRenderer::Picture GlRenderer::prepare(const Scene& scene, const Quality& quality, int width, int height,
                                        std::uint32_t piecePoints)
{
    State& state = *m_state;
    state.underWay.reset();
    takeErrors(); // Drops the errors of other users of the context.
    Picture picture;
    picture.target.width = std::clamp(width, 1, 8192);
    picture.target.height = std::clamp(height, 1, 8192);
    picture.target.samples = quality.samples >= 4 ? glm::ivec2(2, 2) : glm::ivec2(quality.samples >= 2 ? 2 : 1, 1);
    const Target& target = picture.target;
    const float detail = std::clamp(quality.detail, 1.0F / 1024.0F, 1.0F);
    picture.constants = frameConstants(scene, target, state.skull.radiusM(scene.head));
    const FrameConstants& constants = picture.constants;
    state.constants.assign(&constants, sizeof(constants));
    state.constants.bindUniform(0);

    picture.report =
        state.hair->upload(scene.cards ? nullptr : scene.hair, constants, detail, picture.target.samples.x > 1);
    state.head->draw(scene, quality.coarseHead, constants);
    state.hair->begin(constants, piecePoints);
    return picture;
}

/// Puts head and hair together and makes the result the last finished picture.
void GlRenderer::resolve(const Picture& picture)
{
    State& state = *m_state;
    const auto& [target, constants, report, binned, spentMs, complete] = picture;
    if (report.hairs > 0) {
        state.head->bind(0, 1);
        state.hair->bindOpacity(2, 3);
        state.shade.draw(target);
    }
    const bool smoothed = target.samples == glm::ivec2(1);
    state.size = glm::ivec2(target.width, target.height);
    state.picture.resize2D(GL_RGBA8, target.width, target.height);
    if (smoothed)
        state.rough.resize2D(GL_RGBA8, target.width, target.height, true);
    glBindFramebuffer(GL_FRAMEBUFFER, state.framebuffer.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                           smoothed ? state.rough.id() : state.picture.id(), 0);
    glViewport(0, 0, target.width, target.height);
    state.head->bind(0, 1);
    if (report.hairs > 0) {
        state.shade.bind(2);
        state.tiles.bindLight(3);
    }
    const Program& resolve = state.resolve.at(static_cast<std::size_t>(target.samples.x * target.samples.y / 2));
    resolve.use();
    resolve.set("shadeCell", report.hairs > 0 ? state.shade.cell() : 0);
    resolve.set("opaque", state.tiles.opaque());
    glBindVertexArray(state.noVertices.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    if (smoothed) {
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, state.picture.id(), 0);
        state.rough.bind(0);
        state.smooth.use();
        state.smooth.set("anyHair", report.hairs > 0 ? 1 : 0);
        glDrawArrays(GL_TRIANGLES, 0, 3);
        state.head->bind(0, 1);
    }
    state.rings.draw(constants);
    state.statistics = {.drawnHairs = report.hairs,
                        .detail = report.detail,
                        .drawnSegments = report.segments,
                        .uploadedBytes = report.uploadedBytes,
                        .complete = !takeErrors() && complete};
}

void GlRenderer::blitTo(unsigned framebuffer, int width, int height)
{
    const glm::ivec2 size = m_state->size;
    if (size.x == 0)
        return;
    const StateGuard guard;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, m_state->framebuffer.id());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    glBlitFramebuffer(0, 0, size.x, size.y, 0, 0, width, height, GL_COLOR_BUFFER_BIT,
                      size == glm::ivec2(width, height) ? GL_NEAREST : GL_LINEAR);
}

void GlRenderer::read(std::vector<std::uint8_t>& pixels)
{
    const glm::ivec2 size = m_state->size;
    const std::size_t row = static_cast<std::size_t>(size.x) * 4;
    pixels.resize(row * static_cast<std::size_t>(size.y));
    if (pixels.empty())
        return;
    const StateGuard guard;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, m_state->framebuffer.id());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    if (std::exchange(m_state->readCounts, false))
        m_state->statistics.milliseconds = m_state->timer.sinceBegin();
    // OpenGL's first row is at the bottom.
    std::vector<std::uint8_t> swap(row);
    for (int top = 0, bottom = size.y - 1; top < bottom; ++top, --bottom) {
        std::uint8_t* a = pixels.data() + static_cast<std::size_t>(top) * row;
        std::uint8_t* b = pixels.data() + static_cast<std::size_t>(bottom) * row;
        std::memcpy(swap.data(), a, row);
        std::memcpy(a, b, row);
        std::memcpy(b, swap.data(), row);
    }
}

const FrameStatistics& GlRenderer::statistics() const
{
    return m_state->statistics;
}

bool GlRenderer::contextLost() const
{
    return m_state->tellsOfResets && glGetGraphicsResetStatusARB() != GL_NO_ERROR;
}

Capabilities GlRenderer::capabilities() const
{
    return {.graphicsCard = !m_state->software, .mostSamples = 4, .linear = false, .transparent = false};
}

const std::string& GlRenderer::description() const
{
    return m_state->description;
}

} // namespace hairpaint::rendering
