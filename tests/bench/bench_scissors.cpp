// A stroke of the scissors over a tenth of the hair: what each move of the pointer costs once the strands that it
// crosses are known.
#include "model/document/document.h"
#include "model/files/preset_file.h"
#include "model/files/project_file.h"
#include "model/styles/style_use.h"
#include "model/tools/strokes/seen_hair.h"
#include "model/tools/strokes/selection.h"
#include "model/tools/tool_list.h"
#include "sim/motion/simulation.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <numeric>

namespace {

using namespace hairpaint;

/// The hairs whose roots are furthest forward, crossed at a fraction that moves with the line.
class Front : public model::SeenHair
{
public:
    explicit Front(std::shared_ptr<const sim::StrandFrame> frame) : m_frame(std::move(frame))
    {
        const sim::GroupFrame& group = m_frame->groups.front();
        for (std::uint32_t slot = 0; slot < group.groom->roots->count(); ++slot)
            if (group.isPositioned(slot))
                m_met.push_back({.lengthM = 1.0F, .slot = slot});
        positioned = m_met.size();
        const std::vector<glm::vec3>& roots = group.groom->roots->positionHd;
        std::ranges::sort(m_met, std::greater(), [&](const model::SeenStrand& one) { return roots[one.slot].z; });
        m_met.resize(positioned / 10);
    }
    [[nodiscard]] std::vector<model::SeenStrand> under(QPointF /*centre*/, double /*radiusPx*/) const override
    {
        return {};
    }
    [[nodiscard]] std::vector<model::SeenStrand> passed(QPointF /*from*/, QPointF /*to*/,
                                                        double /*radiusPx*/) const override
    {
        return {};
    }
    [[nodiscard]] std::vector<model::SeenStrand> crossing(std::span<const QPointF> line,
                                                          bool /*throughSkin*/) const override
    {
        std::vector<model::SeenStrand> met = m_met;
        const auto roots = static_cast<float>(hair()->groom->roots->count());
        for (model::SeenStrand& one : met)
            one.fraction =
                0.3F + 0.001F * static_cast<float>(line.back().y()) + 0.2F * static_cast<float>(one.slot) / roots;
        return met;
    }
    [[nodiscard]] std::vector<model::SeenStrand> inside(const QPolygonF& /*lasso*/, bool /*throughSkin*/) const override
    {
        return m_met;
    }
    [[nodiscard]] std::shared_ptr<const SeenHair> held() const override { return std::make_shared<Front>(*this); }
    [[nodiscard]] const sim::GroupFrame* hair() const override { return &m_frame->groups.front(); }

    std::size_t positioned = 0;

private:
    std::shared_ptr<const sim::StrandFrame> m_frame;
    std::vector<model::SeenStrand> m_met;
};

/// The counters `hairs` and `cut`.
void scissorsMove(benchmark::State& state)
{
    model::Project project = model::newProject();
    project.maxHairs = 1000000;
    if (const auto preset = model::loadPreset(QStringLiteral(":/presets/long-straight.hairpreset")))
        model::applyPreset(project, *preset);
    model::Document document(std::move(project));
    sim::Simulation simulation;
    simulation.setInput(document.groomInput());
    simulation.advance(1.0 / 60.0);
    auto frame = std::make_shared<sim::StrandFrame>();
    simulation.writeFrame(*frame);
    const Front front(frame);
    const model::HairGroup& group = document.project().groups.front();
    const model::LayerAddress target{group.id, model::MapKind::Length,
                                     group.map(model::MapKind::Length).layers.front().id};
    model::Selection selection;
    model::ToolSettings settings;
    model::ToolContext context{.document = document,
                               .target = target,
                               .settings = settings,
                               .selection = selection,
                               .mirror = state.range(0) != 0,
                               .seen = &front};
    const auto tools = model::makeTools();
    const auto scissors = std::ranges::find(tools, model::ToolId::Scissors, [](const auto& one) { return one->id(); });
    model::PictureHandler& hand = *(*scissors)->pictureHandler();
    hand.pressPicture({.position = {0.0, 0.0}}, context);
    double y = 0.0;
    for ([[maybe_unused]] auto step : state) {
        y = y < 200.0 ? y + 1.0 : 0.0;
        hand.movePicture({.position = {300.0, y}}, context);
    }
    (*scissors)->cancel(context);
    state.counters["hairs"] = static_cast<double>(front.positioned);
    state.counters["cut"] = static_cast<double>(front.positioned) / 10.0;
}

BENCHMARK(scissorsMove)
    ->Name("scissors_move")
    ->ArgName("mirror")
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

} // namespace
