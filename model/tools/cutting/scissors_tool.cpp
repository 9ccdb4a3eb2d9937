// Scissors: hair is cut where a line over the picture of the 3D area crosses it, or inside a lasso.
#include "model/tools/cutting/cut_lengths.h"
#include "model/tools/cutting/cut_pieces.h"
#include "model/tools/cutting/cut_tips.h"
#include "model/tools/cutting/strand_lengths.h"
#include "model/tools/live_edit.h"
#include "model/tools/picker_tool.h"
#include "model/tools/strokes/mirrored_roots.h"
#include "model/tools/strokes/seen_hair.h"
#include "model/tools/tool_list.h"
#include "sim/base/deterministic.h"
#include "sim/base/parallel.h"

#include <QLineF>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace hairpaint::model {

namespace {

constexpr const char* kCutStep = QT_TRANSLATE_NOOP("Tool", "Cut hair");
constexpr std::array kCutKinds{
    ToolChoice::Item{
        .icon = "cut-line", .title = QT_TRANSLATE_NOOP("ToolOptions", "Cut along a straight line"), .step = kCutStep},
    ToolChoice::Item{.icon = "cut-freehand",
                     .title = QT_TRANSLATE_NOOP("ToolOptions", "Cut along the line as it is drawn"),
                     .step = kCutStep},
    ToolChoice::Item{.icon = "cut-lasso",
                     .title = QT_TRANSLATE_NOOP("ToolOptions", "Cut off what is inside"),
                     .step = kCutStep,
                     .hint = QT_TRANSLATE_NOOP(
                         "Tool", "Draw around hair in the 3D area: what is inside falls; Esc leaves no trace")},
};
constexpr ToolOption kCutKind{
    .key = "cut",
    .kind = ToolChoice{.entries = kCutKinds,
                       .read = [](const ToolSettings& settings) { return static_cast<int>(settings.cut); },
                       .write = [](ToolSettings& settings, int index) { settings.cut = static_cast<CutKind>(index); }}};
constexpr ToolOption kCutThrough{.key = "cut_through",
                                 .label = QT_TRANSLATE_NOOP("ToolOptions", "Also behind the head"),
                                 .hint = QT_TRANSLATE_NOOP("ToolOptions", "Cut what the head hides from here, too"),
                                 .kind = ToolSwitch{.field = &ToolSettings::cutThrough, .icon = "cut-through"}};
constexpr ToolOption kCutFraction{
    .key = "cut_fraction",
    .label = QT_TRANSLATE_NOOP("ToolOptions", "Hairs cut"),
    .hint = QT_TRANSLATE_NOOP("ToolOptions", "Of the hairs that are crossed; fewer thin the ends out"),
    .kind = ToolNumber{.field = &ToolSettings::cutFraction, .least = 1.0, .standard = 100.0}};
constexpr ToolOption kCutRagged{
    .key = "cut_ragged",
    .label = QT_TRANSLATE_NOOP("ToolOptions", "Ragged"),
    .hint = QT_TRANSLATE_NOOP("ToolOptions", "How far above or below the line each hair is cut"),
    .kind = ToolNumber{
        .field = &ToolSettings::cutRaggedM, .unit = ToolNumber::Unit::Millimetres, .greatest = 50.0, .exponent = 2.0}};
constexpr std::array kScissorsOptions{&kCutKind, &kCutFraction, &kCutRagged, &kCutThrough};

constexpr std::uint64_t kTakenKey = 0x7468696EU; ///< Apart from other uses of the seed.
constexpr std::uint64_t kRaggedKey = 0x72616767U;
constexpr float kSameM = 1e-4F;           ///< Less is not cut off.
constexpr std::size_t kMostPieces = 1500; ///< That are seen to fall.
constexpr double kStepPx = 3.0;           ///< Between points of a line that is drawn.
constexpr double kClickPx = 4.0;          ///< A press that moves less cuts nothing.

constexpr ToolTraits kScissors{
    .id = ToolId::Scissors,
    .name = "scissors",
    .title = QT_TRANSLATE_NOOP("Tool", "Scissors"),
    .purpose = QT_TRANSLATE_NOOP("Tool", "Cuts the hair that a line over the 3D area crosses."),
    .hint =
        QT_TRANSLATE_NOOP("Tool", "Drag a line over the hair in the 3D area; Shift keeps it level, upright or aslant"),
    .key = Qt::Key_K,
    .options = kScissorsOptions,
    .map = MapKind::Length,
    .demo = &kScissorsDemo};

/// The end of a line of 0, 45 or 90 degrees, as near as can be.
QPointF constrained(QPointF from, QPointF to)
{
    const QPointF line = to - from;
    constexpr double kStep = std::numbers::pi / 4.0;
    const double angle = std::round(std::atan2(line.y(), line.x()) / kStep) * kStep;
    const QPointF unit(std::cos(angle), std::sin(angle));
    return from + unit * QPointF::dotProduct(line, unit);
}

/// The hair is cut as it was seen when the line began, wherever it moves meanwhile.
class ScissorsTool : public Tool, private PictureHandler
{
public:
    [[nodiscard]] const ToolTraits& traits() const override { return kScissors; }
    [[nodiscard]] PictureHandler* pictureHandler() override { return this; }

    // On the skin, and in the paint area, there is nothing to cut.
    void press(const ToolEvent& event, ToolContext& context) override { (void)picksInstead(event, context); }
    void move(const ToolEvent& /*event*/, ToolContext& /*context*/) override {}
    void release(const ToolEvent& /*event*/, ToolContext& /*context*/) override {}

    void cancel(ToolContext& /*context*/) override
    {
        m_edit.cancel();
        drop();
    }
    void commit(ToolContext& context) override
    {
        if (active() && m_lengths)
            m_cutOff = cutPieces(*m_seen->hair(), context.hair ? context.hair->pose.rotation : sim::HeadPose{}.rotation,
                                 m_cuts, kMostPieces);
        m_edit.commit();
        drop();
    }
    [[nodiscard]] bool active() const override { return m_edit.active(); }

private:
    void pressPicture(const PictureEvent& event, ToolContext& context) override;
    void movePicture(const PictureEvent& event, ToolContext& context) override;
    void releasePicture(const PictureEvent& event, ToolContext& context) override
    {
        if (!active())
            return;
        movePicture(event, context);
        commit(context);
    }
    [[nodiscard]] PictureLine pictureLine() const override
    {
        return active() ? PictureLine{.line = m_line, .closed = m_kind == CutKind::Lasso} : PictureLine{};
    }
    [[nodiscard]] std::vector<CutPiece> takeCutOff() override { return std::exchange(m_cutOff, {}); }

    void draw(const PictureEvent& event);
    [[nodiscard]] std::vector<StrandCut> cuts(const ToolSettings& settings) const;
    void mirror(std::vector<StrandCut>& cuts) const;
    void takePresent(std::vector<StrandCut>& cuts);
    void show();
    void drop();

    LiveEdit m_edit; ///< Edits the length layer.
    std::shared_ptr<const SeenHair> m_seen;
    std::optional<MirroredRoots> m_mirrored; ///< None where no other side is cut.
    std::optional<StrandLengths> m_present;  ///< Lengths of hair before this cut.
    std::vector<float> m_presentM; ///< By slot: the length that m_present gave; below 0 until it is asked for.
    std::optional<CutLengths> m_lengths;
    std::optional<CutTips> m_tips;
    std::vector<StrandCut> m_cuts; ///< Cuts of the hair in m_seen.
    std::vector<CutPiece> m_cutOff;
    CutKind m_kind = CutKind::Line;
    QPolygonF m_line;
};

void ScissorsTool::pressPicture(const PictureEvent& event, ToolContext& context)
{
    if (active() || context.target.map != MapKind::Length || context.seen == nullptr)
        return;
    sim::MapRaster length = context.document.resolvedNow(context.target.group, MapKind::Length);
    if (!m_edit.begin(context, title()))
        return;
    m_edit.setText(stepFor(context.settings));
    m_kind = context.settings.cut;
    m_line = {event.position};
    m_seen = context.seen->held();
    const sim::GroupFrame* hair = m_seen->hair();
    if (hair == nullptr)
        return;
    m_present.emplace(context.document, context.target.group, hair->groom->roots);
    m_presentM.assign(hair->groom->roots->count(), -1.0F);
    m_lengths.emplace(*hair, std::move(length), *m_present);
    m_tips = CutTips::in(m_edit, context);
    if (context.mirror)
        m_mirrored.emplace(*hair);
}

void ScissorsTool::movePicture(const PictureEvent& event, ToolContext& context)
{
    if (!active())
        return;
    draw(event);
    if (!m_lengths)
        return;
    std::vector<StrandCut> found = cuts(context.settings);
    if (m_mirrored)
        mirror(found);
    m_cuts = found;
    takePresent(found);
    m_lengths->cut(found, context.settings.cutFraction < 1.0F);
    show();
}

void ScissorsTool::draw(const PictureEvent& event)
{
    const bool isStraight = m_kind == CutKind::Line || event.modifiers.testFlag(Qt::ShiftModifier);
    if (m_kind != CutKind::Lasso && isStraight) {
        m_line = {m_line.front(), event.modifiers.testFlag(Qt::ShiftModifier)
                                      ? constrained(m_line.front(), event.position)
                                      : event.position};
        return;
    }
    // The last point follows the pointer; now and then it stays and another one follows.
    if (m_line.size() < 2 || QLineF(m_line[m_line.size() - 2], m_line.back()).length() > kStepPx)
        m_line.push_back(event.position);
    else
        m_line.back() = event.position;
}

std::vector<StrandCut> ScissorsTool::cuts(const ToolSettings& settings) const
{
    const QRectF bounds = m_line.boundingRect();
    if (m_line.size() < 2 || std::max(bounds.width(), bounds.height()) < kClickPx)
        return {};
    const std::vector<SeenStrand> met = m_kind == CutKind::Lasso ? m_seen->inside(m_line, settings.cutThrough)
                                                                 : m_seen->crossing(m_line, settings.cutThrough);
    const sim::RootSet& roots = *m_seen->hair()->groom->roots;
    std::vector<StrandCut> found;
    found.reserve(met.size());
    for (const SeenStrand& strand : met) {
        const std::uint32_t rank = roots.rankOfSlot[strand.slot];
        if (settings.cutFraction < 1.0F &&
            sim::unitFloat(sim::hash64(roots.seed ^ kTakenKey, rank)) >= settings.cutFraction)
            continue;
        float kept = strand.fraction;
        if (settings.cutRaggedM > 0.0F)
            kept += settings.cutRaggedM / strand.lengthM *
                    (2.0F * sim::unitFloat(sim::hash64(roots.seed ^ kRaggedKey, rank)) - 1.0F);
        if (kept < 1.0F)
            found.push_back({.slot = strand.slot, .kept = std::max(kept, 0.0F)});
    }
    return found;
}

/// Hair whose root mirrors one that is cut becomes no longer than that.
void ScissorsTool::mirror(std::vector<StrandCut>& cuts) const
{
    const sim::Groom& groom = *m_seen->hair()->groom;
    for (std::size_t i = 0, drawn = cuts.size(); i < drawn; ++i) {
        const float keptM = cuts[i].kept * groom.style(cuts[i].slot).lengthM;
        for (const std::uint32_t slot : m_mirrored->of(cuts[i].slot))
            if (const float lengthM = groom.style(slot).lengthM; keptM < lengthM)
                cuts.push_back({.slot = slot, .kept = keptM / lengthM});
    }
}

/// From fractions of the hair that was seen to such of the hair that the maps now tell: it may have been cut since.
void ScissorsTool::takePresent(std::vector<StrandCut>& cuts)
{
    constexpr std::size_t kCutsATask = 512;
    const sim::Groom& groom = *m_seen->hair()->groom;
    std::erase_if(cuts, [&](const StrandCut& one) {
        const sim::StrandStyle& seen = groom.style(one.slot);
        float& presentM = m_presentM[one.slot];
        if (presentM < 0.0F)
            presentM = seen.braid != sim::BraidKind::None ? seen.lengthM : m_present->at(one.slot);
        return one.kept * seen.lengthM > presentM - kSameM;
    });
    sim::parallelFor(cuts.size(), kCutsATask, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            StrandCut& one = cuts[i];
            const sim::StrandStyle& seen = groom.style(one.slot);
            const float keptM = one.kept * seen.lengthM;
            one.kept = seen.braid != sim::BraidKind::None ? keptM / std::max(m_presentM[one.slot], kSameM)
                                                          : m_present->keptFor(one.slot, keptM);
        }
    });
}

void ScissorsTool::show()
{
    m_edit.replace(m_lengths->tiles(), [this](int index, const sim::RasterTilePtr& before) {
        StrokeBuffer::MaskTile mask = m_lengths->mask(index);
        keepInside(m_edit.clips(), m_edit.before().tileRect(index), mask);
        return paintTile(m_edit.spec(), before, mask, {.values = m_lengths->values(index)});
    });
    if (m_tips)
        m_tips->show(m_edit, *m_lengths);
}

void ScissorsTool::drop()
{
    m_seen.reset();
    m_present.reset();
    m_lengths.reset();
    m_tips.reset();
    m_mirrored.reset();
    m_cuts.clear();
    m_line.clear();
}

} // namespace

std::unique_ptr<Tool> makeScissorsTool()
{
    return std::make_unique<ScissorsTool>();
}

} // namespace hairpaint::model
