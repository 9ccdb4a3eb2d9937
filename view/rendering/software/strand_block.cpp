// Strands from their frame, lane by lane.
#include "view/rendering/software/strand_block.h"

#include "sim/groom/strand_curve.h"
#include "sim/motion/strand_frame.h"

#include <algorithm>

namespace hairpaint::rendering {

static_assert(kBlockLanes == sim::kLanes);

namespace {

float byteOf(std::uint32_t bits, unsigned shift)
{
    return static_cast<float>((bits >> shift) & 0xFFU) * (1.0F / 255.0F);
}

void setStyle(StrandBlock& block, std::size_t lane, const sim::StrandStyle& style, const sim::StrandMaterial& material)
{
    const bool curled = style.turns > 0.0F && style.curlRadiusM > 0.0F;
    const bool braided = style.braid != sim::BraidKind::None && style.braidStart < 1.0F;
    block.turns[lane] = style.turns;
    block.curlRadiusM[lane] = curled ? style.curlRadiusM : 0.0F;
    block.phase[lane] = style.phase;
    block.lengthM[lane] = style.lengthM;
    block.width[lane] = style.width;
    block.variation[lane] = style.variation;
    block.order[lane] = style.detail;
    for (unsigned c = 0; c < 3; ++c) {
        block.rootColour[c][lane] = byteOf(style.rootColour, 8 * c);
        block.tipColour[c][lane] = byteOf(style.tipColour, 8 * c);
    }
    const sim::TipMix tipMix = sim::tipMixOf(material, style.tipStart);
    block.tipScale[lane] = tipMix.scale;
    block.tipOffset[lane] = tipMix.offset;
    block.anyTipStart = block.anyTipStart || style.tipStart > 0.0F;
    block.braid[lane] = braided ? static_cast<float>(style.braid) : 0.0F;
    block.wisp[lane] = static_cast<float>(style.wispNumber());
    block.taut[lane] = style.isTaut() ? 1.0F : 0.0F;
    block.braidRadiusM[lane] = style.braidRadiusM;
    block.braidStart[lane] = style.braidStart;
    block.braidTurns[lane] = style.braidTurns;
    block.braidTaper[lane] = static_cast<float>(style.braidTaper) / 255.0F;
    block.braidTied[lane] = static_cast<float>(style.braidTied) / 255.0F;
    block.wispX[lane] = style.wispOffset.x;
    block.wispY[lane] = style.wispOffset.y;
    const sim::FrizzOfStyle frizz = sim::frizzOf(style);
    block.frizzM[lane] = frizz.radiusM;
    block.frizzRad[lane] = frizz.waveRad;
    block.anyFrizz = block.anyFrizz || style.frizzM > 0.0F;
    const sim::Gloss gloss = sim::glossOf(style.gloss);
    block.shine[lane] = gloss.shine;
    block.sharpness[lane] = gloss.sharpness;
    block.perTaper[lane] = sim::perTaperOf(material, style.lengthM);
    block.anyTaut = block.anyTaut || style.isTaut();
    block.anyCurl = block.anyCurl || curled;
    block.anyBraid = block.anyBraid || braided;
}

} // namespace

void fillBlock(StrandBlock& block, const sim::GroupFrame& group, std::span<const std::uint32_t> slots,
               const glm::mat3& turnWoFromHd)
{
    const sim::Groom& groom = *group.groom;
    block.nodes = groom.nodes;
    block.coils = sim::coilsOf(groom.settings);
    block.anyBraid = false;
    block.anyTaut = false;
    block.anyCurl = false;
    block.anyFrizz = false;
    block.anyTipStart = false;
    const auto nodes = static_cast<std::size_t>(groom.nodes);
    block.nodesWo.resize(nodes * 3 * kBlockLanes);
    const sim::StrandBlocks layout = groom.blocks();
    for (std::size_t lane = 0; lane < kBlockLanes; ++lane) {
        // Lanes without a strand are the last one again, of no width.
        const std::uint32_t slot = slots[std::min(lane, slots.size() - 1)];
        setStyle(block, lane, groom.style(slot), groom.settings.material);
        if (lane >= slots.size())
            block.width[lane] = 0.0F;

        const float* from = group.positions.data() + layout.index(groom.frameStrand(slot), 0);
        float* to = block.nodesWo.data() + lane;
        for (std::size_t row = 0; row < nodes * 3; ++row)
            to[row * kBlockLanes] = from[row * kBlockLanes];
    }
    block.anyFrame = block.anyCurl || block.anyBraid || block.anyFrizz;
    if (!block.anyFrame)
        return;
    for (std::size_t lane = 0; lane < kBlockLanes; ++lane) {
        const glm::vec3 wo = turnWoFromHd * sim::frameTangentHd(groom, slots[std::min(lane, slots.size() - 1)]);
        for (int axis = 0; axis < 3; ++axis)
            block.tangentWo[static_cast<std::size_t>(axis) * kBlockLanes + lane] = wo[axis];
    }
}

void StrandPoints::resize(std::size_t points)
{
    if (fraction.size() >= points)
        return;
    pointsWo.resize(points * 3 * kBlockLanes);
    for (std::vector<float>* row : {&x, &y, &depth, &width})
        row->resize(points * kBlockLanes);
    colour.resize(points * kBlockLanes);
    fraction.resize(points);
    mayBeSeen.resize(points, (1U << kBlockLanes) - 1);
}

} // namespace hairpaint::rendering
