// Drawing: 10,000 and 100,000 hairs of 8 segments off-screen, and beside it what the segments of 10,000 cost as bare
// lines of OpenGL; draw_frames: up to a million at the sizes of the 3D area, of a window and of a large screen.
#include "sim/base/deterministic.h"
#include "sim/motion/strand_frame.h"
#include "view/rendering/gl/gl_renderer.h"
#include "view/rendering/gl/offscreen_context.h"
#include "view/rendering/software/software_renderer.h"

#include <benchmark/benchmark.h>
#include <epoxy/gl.h>

#include <cmath>
#include <ctime>
#include <memory>
#include <vector>

namespace hairpaint {

namespace {

constexpr int kWidth = 1024;
constexpr int kHeight = 768;
constexpr std::size_t kFewHairs = 10000;
constexpr std::size_t kNodes = 9;

/// Hairs of about 20 cm that hang from a cap.
std::shared_ptr<const sim::StrandFrame> hangingHair(std::size_t hairs)
{
    auto groom = std::make_shared<sim::Groom>();
    auto roots = std::make_shared<sim::RootSet>();
    sim::GroupFrame group;
    groom->groupId = 1;
    groom->nodes = kNodes;
    const std::size_t chunks = (hairs + sim::kChunkSlots - 1) / sim::kChunkSlots;
    group.positions.resize(chunks * sim::kChunkSlots * kNodes * 3);
    roots->tangentHd.assign(chunks * sim::kChunkSlots, glm::vec3(1.0F, 0.0F, 0.0F));
    for (std::size_t c = 0; c < chunks; ++c) {
        auto chunk = std::make_shared<sim::StrandChunk>();
        chunk->styles.resize(sim::kChunkSlots);
        chunk->braidCentre.assign(sim::kChunkSlots, sim::kNoCentre);
        for (std::size_t slot = 0; slot < sim::kChunkSlots && c * sim::kChunkSlots + slot < hairs; ++slot) {
            const std::size_t i = c * sim::kChunkSlots + slot;
            sim::StrandStyle& style = chunk->styles[slot];
            style.rootColour = 0xFF203A50U;
            style.tipColour = 0xFF406A90U;
            style.detail = std::fmod(static_cast<float>(i) * 0.7548777F, 1.0F); // Evenly, as a groom's.
            chunk->hairs.set(slot);
            chunk->drawn.set(slot);
            const float y = 1.0F - static_cast<float>(i) / static_cast<float>(hairs);
            const float angle = static_cast<float>(i) * 2.399963F;
            const float r = std::sqrt(1.0F - y * y);
            const glm::vec3 root(0.08F * r * std::sin(angle), 0.11F * y, 0.1F * r * std::cos(angle));
            const float lift = 1.0F + 0.2F * sim::unitFloat(sim::hash64(1, i));
            for (std::size_t n = 0; n < kNodes; ++n) {
                const float s = static_cast<float>(n) / static_cast<float>(kNodes - 1);
                const float out = lift * (1.0F + 0.3F * s);
                const glm::vec3 packed(root.x * out, root.y + 0.03F * s - 0.22F * s * s, root.z * out);
                sim::StrandBlocks(kNodes).setNode(group.positions, i, n, packed);
            }
        }
        groom->chunks.push_back(chunk);
        groom->packedChunk.push_back(static_cast<std::int32_t>(c));
    }
    groom->packedChunks = static_cast<std::int32_t>(chunks);
    groom->roots = std::move(roots);
    groom->hairCount = hairs;
    groom->drawnCount = hairs;
    group.groom = std::move(groom);
    auto frame = std::make_shared<sim::StrandFrame>();
    frame->groups.push_back(std::move(group));
    return frame;
}

/// A current context and what failed, if anything.
std::unique_ptr<rendering::OffscreenContext> currentContext(benchmark::State& state)
{
    auto context = rendering::OffscreenContext::create();
    if (!context || !(*context)->makeCurrent()) {
        state.SkipWithError("no OpenGL context");
        return nullptr;
    }
    return std::move(*context);
}

/// Adds the counter cpu_ms: processor time of all threads for one frame, which other programs disturb less.
class CpuMeter
{
public:
    explicit CpuMeter(benchmark::State& state) : m_state(state), m_begin(std::clock()) {}
    CpuMeter(const CpuMeter&) = delete;
    CpuMeter& operator=(const CpuMeter&) = delete;
    ~CpuMeter()
    {
        const double milliseconds = 1e3 * static_cast<double>(std::clock() - m_begin) / CLOCKS_PER_SEC;
        m_state.counters["cpu_ms"] = milliseconds / static_cast<double>(m_state.iterations());
    }

private:
    benchmark::State& m_state;
    std::clock_t m_begin;
};

/// Positions are new in every frame, as when the hair moves.
void drawWith(benchmark::State& state, rendering::Backend& backend, int samples)
{
    const auto still = hangingHair(static_cast<std::size_t>(state.range(0)));
    const auto moved = std::make_shared<const sim::StrandFrame>(*still);
    rendering::Scene scene;
    const rendering::Quality quality{.detail = 1.0F, .samples = samples};
    for (const auto& frame : {still, moved}) {
        scene.hair = frame;
        backend.draw(scene, quality, kWidth, kHeight);
    }
    bool odd = false;
    const CpuMeter meter(state);
    for ([[maybe_unused]] auto _ : state) {
        odd = !odd;
        scene.hair = odd ? still : moved;
        backend.draw(scene, quality, kWidth, kHeight);
    }
    state.SetLabel(backend.description() + ", " + std::to_string(samples) + " samples");
    state.counters["segments"] = static_cast<double>(backend.statistics().drawnSegments);
}

void drawHairs(benchmark::State& state, int samples)
{
    const auto context = currentContext(state);
    if (!context)
        return;
    auto renderer = rendering::GlRenderer::create();
    if (!renderer) {
        state.SkipWithError(renderer.error().c_str());
        return;
    }
    drawWith(state, **renderer, samples);
    renderer->reset();
    context->doneCurrent();
}

void drawHairsInSoftware(benchmark::State& state, int samples)
{
    rendering::SoftwareRenderer renderer;
    drawWith(state, renderer, samples);
}

/// Each frame is waited for. Counters: gpu_ms, what the renderer says that a frame takes; MB, handed over for one.
void drawFrames(benchmark::State& state)
{
    const auto context = currentContext(state);
    if (!context)
        return;
    auto renderer = rendering::GlRenderer::create();
    if (!renderer) {
        state.SkipWithError(renderer.error().c_str());
        return;
    }
    const auto still = hangingHair(static_cast<std::size_t>(state.range(0)));
    const auto moved = std::make_shared<const sim::StrandFrame>(*still);
    const auto width = static_cast<int>(state.range(1));
    const auto height = static_cast<int>(state.range(2));
    const rendering::Quality quality{.detail = 1.0F, .samples = static_cast<int>(state.range(3))};
    rendering::Scene scene;
    for (const auto& frame : {still, moved}) {
        scene.hair = frame;
        (*renderer)->draw(scene, quality, width, height);
        glFinish();
    }
    bool odd = false;
    for ([[maybe_unused]] auto _ : state) {
        odd = !odd;
        scene.hair = odd ? still : moved;
        (*renderer)->draw(scene, quality, width, height);
        glFinish();
    }
    const rendering::FrameStatistics& statistics = (*renderer)->statistics();
    state.SetLabel((*renderer)->description());
    state.counters["gpu_ms"] = statistics.milliseconds;
    state.counters["MB"] = static_cast<double>(statistics.uploadedBytes) * 1e-6;
    state.counters["complete"] = statistics.complete ? 1.0 : 0.0;
    renderer->reset();
    context->doneCurrent();
}

unsigned compiled(unsigned program, unsigned kind, const char* text)
{
    const unsigned shader = glCreateShader(kind);
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    glAttachShader(program, shader);
    glDeleteShader(shader);
    return program;
}

/// The limit that drawing by lines meets: no lighting, no thickness, no curve, one sample.
void drawBareLines(benchmark::State& state)
{
    const auto context = currentContext(state);
    if (!context)
        return;
    const auto frame = hangingHair(kFewHairs);
    std::vector<glm::vec3> points;
    for (std::size_t i = 0; i < kFewHairs; ++i)
        for (std::size_t n = 0; n + 1 < kNodes; ++n)
            for (const std::size_t node : {n, n + 1})
                points.push_back(sim::StrandBlocks(kNodes).node(frame->groups[0].positions, i, node));
    const unsigned program = glCreateProgram();
    compiled(program, GL_VERTEX_SHADER,
             "#version 430 core\nlayout(location = 0) in vec3 p; uniform mat4 m; void main() { gl_Position = m * "
             "vec4(p, 1.0); }");
    compiled(program, GL_FRAGMENT_SHADER,
             "#version 430 core\nout vec4 c; void main() { c = vec4(0.5, 0.4, 0.3, 1.0); }");
    glLinkProgram(program);
    unsigned names[5] = {};
    glGenTextures(2, names);
    const unsigned formats[] = {GL_RGBA8, GL_DEPTH_COMPONENT32F};
    for (int i = 0; i < 2; ++i) {
        glBindTexture(GL_TEXTURE_2D, names[i]);
        glTexStorage2D(GL_TEXTURE_2D, 1, formats[i], kWidth, kHeight);
    }
    glGenFramebuffers(1, &names[2]);
    glBindFramebuffer(GL_FRAMEBUFFER, names[2]);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, names[0], 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, names[1], 0);
    glGenVertexArrays(1, &names[3]);
    glBindVertexArray(names[3]);
    glGenBuffers(1, &names[4]);
    glBindBuffer(GL_ARRAY_BUFFER, names[4]);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(points.size() * sizeof(glm::vec3)), points.data(),
                 GL_STATIC_DRAW);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    glViewport(0, 0, kWidth, kHeight);
    glEnable(GL_DEPTH_TEST);
    glUseProgram(program);
    const rendering::Camera camera;
    const glm::mat4 matrix = camera.projection(static_cast<float>(kWidth) / kHeight) * camera.view();
    glUniformMatrix4fv(glGetUniformLocation(program, "m"), 1, GL_FALSE, &matrix[0][0]);
    const CpuMeter meter(state);
    for ([[maybe_unused]] auto _ : state) {
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glDrawArrays(GL_LINES, 0, static_cast<GLsizei>(points.size()));
        glFinish();
    }
    state.SetLabel(std::string(reinterpret_cast<const char*>(glGetString(GL_RENDERER))) + ", bare GL_LINES");
    glDeleteProgram(program);
    glDeleteBuffers(1, &names[4]);
    glDeleteVertexArrays(1, &names[3]);
    glDeleteFramebuffers(1, &names[2]);
    glDeleteTextures(2, names);
    context->doneCurrent();
}

void drawWithOpenGl(benchmark::State& state)
{
    drawHairs(state, static_cast<int>(state.range(1)));
}

void drawWithOurOwn(benchmark::State& state)
{
    drawHairsInSoftware(state, static_cast<int>(state.range(1)));
}

BENCHMARK(drawWithOpenGl)
    ->Name("draw")
    ->ArgNames({"hairs", "samples"})
    ->ArgsProduct({{10000, 100000}, {1, 4}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(drawWithOurOwn)
    ->Name("draw_software")
    ->ArgNames({"hairs", "samples"})
    ->ArgsProduct({{10000, 100000}, {1, 4}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(drawFrames)
    ->Name("draw_frames")
    ->ArgNames({"hairs", "width", "height", "samples"})
    ->ArgsProduct({{100000, 1000000}, {612}, {680}, {1, 4}})
    ->ArgsProduct({{100000, 1000000}, {1920}, {1080}, {1, 4}})
    ->ArgsProduct({{100000, 1000000}, {3840}, {2160}, {1, 4}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(drawBareLines)->Name("draw_limit/lines:80000")->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace

} // namespace hairpaint
