// The figures of Hernandez and Rudomin 2004, measured anew: frames a second (counter fps) of 1/60 s of motion, without
// drawing. README.md beside this file has them beside the paper's.
//
// paper_table_2/hairs:H/springs:S: H straight hairs of 5 nodes, all solved; S 1: by damped springs and Euler's method.
// paper_table_3/hairs:H/basis:B/one:O: H straight hairs of which B are solved, positioned around three basis hairs; O
// 1: by algorithm 3 as published, each after the displacement of one. paper_table_4/hairs:H/basis:B/curl:C: the same,
// and with curl 4 the points of its curves.
#include "bench_scene.h"

#include "sim/base/parallel.h"
#include "sim/groom/strand_curve.h"
#include "sim/motion/simulation.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace {

using namespace hairpaint;

constexpr int kPaperNodes = 5;
constexpr double kFrameSeconds = 1.0 / 60.0;
const sim::Wind kPaperWind{true, glm::vec3(3.0F, 0.0F, 1.0F), 0.5F, 0.3F};

sim::GroomInput paperScene(int hairs, int basis, std::uint16_t curl)
{
    sim::GroomInput input = bench::sceneOf(hairs, kPaperNodes, false);
    sim::GroomInput::Group& group = input.groups.front();
    group.settings.basisHairs = basis;
    const int size = group.maps[sim::MapSlot::Curl]->size();
    group.maps[sim::MapSlot::Curl] = std::make_shared<const sim::TiledRaster>(size, 1, sim::Texel{curl});
    return input;
}

void countFrames(benchmark::State& state)
{
    state.counters["fps"] = benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

/// The paper's first version: nodes are particles, held together by damped springs, and move by Euler's method.
class SpringHair
{
public:
    explicit SpringHair(int hairs)
    {
        m_nodes.resize(static_cast<std::size_t>(hairs) * kPaperNodes);
        for (int i = 0; i < hairs; ++i) {
            const float turn = 2.399963F * static_cast<float>(i); // The golden angle: even over the upper half.
            const float y = 1.0F - (static_cast<float>(i) + 0.5F) / static_cast<float>(hairs);
            const float across = std::sqrt(1.0F - y * y);
            const glm::vec3 out(across * std::cos(turn), y, across * std::sin(turn));
            for (int node = 0; node < kPaperNodes; ++node)
                m_nodes[static_cast<std::size_t>(i) * kPaperNodes + static_cast<std::size_t>(node)].position =
                    out * (kHeadM + kRestM * static_cast<float>(node));
        }
    }

    void step()
    {
        const std::size_t hairs = m_nodes.size() / kPaperNodes;
        sim::parallelFor(hairs, 256, [&](std::size_t begin, std::size_t end) {
            for (std::size_t hair = begin; hair < end; ++hair)
                for (int substep = 0; substep < kSubsteps; ++substep)
                    stepHair(m_nodes.data() + hair * kPaperNodes);
        });
    }

    [[nodiscard]] float furthestM() const
    {
        float furthest = 0.0F;
        for (const Node& node : m_nodes)
            furthest = std::max(furthest, glm::length(node.position));
        return furthest;
    }

private:
    struct Node
    {
        glm::vec3 position{0.0F};
        glm::vec3 velocity{0.0F};
    };

    static constexpr float kHeadM = 0.1F;
    static constexpr float kRestM = 0.06F;
    /// As stiff as stretches the segment at the root by 5 % under what hangs from it, and as many steps as keep Euler's
    /// method from blowing up then.
    static constexpr float kSpring = static_cast<float>(kPaperNodes - 1) * 9.81F / (0.05F * kRestM); ///< 1/s2
    static constexpr float kDamping = 60.0F;                                                         ///< 1/s
    static constexpr float kDrag = 2.0F; ///< 1/s, as PhysicsSettings::damping.
    static constexpr int kSubsteps = 4;

    static void stepHair(Node* nodes)
    {
        constexpr auto kStep = static_cast<float>(kFrameSeconds / kSubsteps);
        const glm::vec3 air(3.0F, 0.0F, 1.0F);
        std::array<glm::vec3, kPaperNodes> force;
        for (int i = 1; i < kPaperNodes; ++i)
            force[static_cast<std::size_t>(i)] =
                glm::vec3(0.0F, -9.81F, 0.0F) + (air - nodes[i].velocity) - kDrag * nodes[i].velocity;
        force[0] = glm::vec3(0.0F);
        for (int i = 1; i < kPaperNodes; ++i) {
            const glm::vec3 edge = nodes[i].position - nodes[i - 1].position;
            const float length = std::sqrt(std::max(glm::dot(edge, edge), 1e-12F));
            const glm::vec3 along = edge / length;
            const float speed = glm::dot(nodes[i].velocity - nodes[i - 1].velocity, along);
            const glm::vec3 pull = along * (kSpring * (length - kRestM) + kDamping * speed);
            force[static_cast<std::size_t>(i)] -= pull;
            force[static_cast<std::size_t>(i - 1)] += pull;
        }
        for (int i = 1; i < kPaperNodes; ++i) {
            // Velocities first: the other order of Euler's method blows up at any number of substeps worth counting.
            nodes[i].velocity += force[static_cast<std::size_t>(i)] * kStep;
            nodes[i].position += nodes[i].velocity * kStep;
            for (const float y : {0.0F, -0.08F, -0.2F}) { // The head's ellipsoids, as spheres.
                const glm::vec3 from = nodes[i].position - glm::vec3(0.0F, y, 0.0F);
                const float square = glm::dot(from, from);
                if (square < kHeadM * kHeadM)
                    nodes[i].position += from * (kHeadM / std::sqrt(std::max(square, 1e-12F)) - 1.0F);
            }
        }
    }

    std::vector<Node> m_nodes;
};

void paperTable2(benchmark::State& state)
{
    const auto hairs = static_cast<int>(state.range(0));
    if (state.range(1) != 0) {
        SpringHair hair(hairs);
        for (int i = 0; i < 30; ++i)
            hair.step();
        for ([[maybe_unused]] auto frame : state)
            hair.step();
        if (!(hair.furthestM() < 1.0F))
            state.SkipWithError("The springs blew up");
    } else {
        sim::Simulation simulation;
        simulation.setInput(paperScene(hairs, hairs, 0));
        simulation.setWind(kPaperWind);
        simulation.settle(0.5);
        for ([[maybe_unused]] auto frame : state)
            simulation.advance(kFrameSeconds);
    }
    countFrames(state);
}

/// Algorithm 3 as published: `now` of each dependent hair goes along with the displacement of one basis hair.
void followOne(const sim::StrandFrame& before, const sim::StrandFrame& now, std::vector<float>& dependents)
{
    const std::vector<float>& from = before.groups.front().positions;
    const std::vector<float>& to = now.groups.front().positions;
    sim::parallelFor(dependents.size() / to.size() + 1, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t part = begin; part < end; ++part)
            for (std::size_t i = part * to.size(); i < std::min((part + 1) * to.size(), dependents.size()); ++i)
                dependents[i] += to[i - part * to.size()] - from[i - part * to.size()];
    });
}

void paperTable3(benchmark::State& state)
{
    const auto hairs = static_cast<int>(state.range(0));
    const auto basis = static_cast<int>(state.range(1));
    const bool one = state.range(2) != 0;
    sim::Simulation simulation;
    simulation.setInput(one ? paperScene(basis, basis, 0) : paperScene(hairs, basis, 0));
    simulation.setWind(kPaperWind);
    simulation.settle(0.5);
    sim::StrandFrame now;
    sim::StrandFrame before;
    simulation.writeFrame(now);
    std::vector<float> dependents(
        one ? sim::StrandBlocks(kPaperNodes).floatsFor(sim::blocksFor(static_cast<std::size_t>(hairs - basis))) : 0);
    for ([[maybe_unused]] auto frame : state) {
        std::swap(before, now);
        simulation.advance(kFrameSeconds);
        simulation.writeFrame(now);
        if (one)
            followOne(before, now, dependents);
        benchmark::DoNotOptimize(now.groups.front().positions.data());
        benchmark::DoNotOptimize(dependents.data());
    }
    countFrames(state);
}

void evaluateCurves(const sim::GroupFrame& frame, std::vector<float>& sums)
{
    const sim::Groom& groom = *frame.groom;
    sums.assign(groom.chunks.size(), 0.0F);
    sim::parallelFor(groom.chunks.size(), 1, [&](std::size_t begin, std::size_t end) {
        std::array<glm::vec3, sim::kMostNodes> nodes;
        const std::span<glm::vec3> skeleton = std::span(nodes).first(static_cast<std::size_t>(groom.nodes));
        std::vector<glm::vec3> points;
        for (std::size_t slot = begin * sim::kChunkSlots; slot < end * sim::kChunkSlots; ++slot) {
            if (!frame.isPositioned(slot))
                continue;
            groom.blocks().read(frame.positions, groom.frameStrand(slot), skeleton);
            const sim::StrandStyle& style = groom.style(slot);
            sim::evaluateStrand(skeleton, sim::frameTangentHd(groom, static_cast<std::uint32_t>(slot)), style,
                                sim::segmentsOf(style, groom.nodes), points);
            sums[slot / sim::kChunkSlots] += points.back().y;
        }
    });
}

void paperTable4(benchmark::State& state)
{
    constexpr std::uint16_t kLevel4 = 52428; // 0.8 of the red map: 8 turns.
    const bool curled = state.range(2) != 0;
    sim::Simulation simulation;
    simulation.setInput(
        paperScene(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)), curled ? kLevel4 : 0));
    simulation.setWind(kPaperWind);
    simulation.settle(0.5);
    sim::StrandFrame now;
    std::vector<float> sums;
    for ([[maybe_unused]] auto frame : state) {
        simulation.advance(kFrameSeconds);
        simulation.writeFrame(now);
        if (curled)
            evaluateCurves(now.groups.front(), sums);
        benchmark::DoNotOptimize(now.groups.front().positions.data());
        benchmark::DoNotOptimize(sums.data());
    }
    countFrames(state);
}

BENCHMARK(paperTable2)
    ->Name("paper_table_2")
    ->ArgNames({"hairs", "springs"})
    ->ArgsProduct({{1000, 5000, 10000, 20000, 1000000}, {1, 0}})
    ->Unit(benchmark::kMicrosecond)
    ->UseRealTime();
BENCHMARK(paperTable3)
    ->Name("paper_table_3")
    ->ArgNames({"hairs", "basis", "one"})
    ->ArgsProduct({{5000}, {5000, 2500, 500}, {1, 0}})
    ->ArgsProduct({{14000}, {14000, 7000, 1000}, {1, 0}})
    ->Unit(benchmark::kMicrosecond)
    ->UseRealTime();
BENCHMARK(paperTable4)
    ->Name("paper_table_4")
    ->ArgNames({"hairs", "basis", "curl"})
    ->ArgsProduct({{10000}, {10000, 5000, 1000}, {0, 4}})
    ->ArgsProduct({{30000}, {30000, 15000, 1000}, {0, 4}})
    ->ArgsProduct({{50000}, {50000, 25000, 1000}, {0, 4}})
    ->Unit(benchmark::kMicrosecond)
    ->UseRealTime();

} // namespace
