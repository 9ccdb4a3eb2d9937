// Takes strands from their frame, sixteen at a time, through curve, light and tiles.
#include "view/rendering/software/hair_segments.h"

#include "sim/base/per_thread.h"
#include "view/rendering/drawn_fraction.h"
#include "view/rendering/frame_lights.h"
#include "view/rendering/software/strand_kernel.h"

#include <algorithm>
#include <hwy/cache_control.h>
#include <limits>
#include <numeric>

namespace hairpaint::rendering {
namespace {

constexpr std::size_t kWantedBatches = 128;
constexpr std::size_t kLeastBatch = 256; ///< Least number of strands in a batch.
constexpr std::size_t kMostBatch = 4096;

constexpr DepthOfCoat kFineDepth{
    .undrawnCoverings = 8.0F, .inEveryColumn = true, .widest = 0.55F, .leastFraction = 0.45F};
constexpr DepthOfCoat kMovingDepth{
    .undrawnCoverings = 4.5F, .inEveryColumn = false, .widest = 1.67F, .leastFraction = 0.3F};

/// Memory that a thread keeps from block to block.
struct BlockScratch
{
    StrandBlock block;
    StrandPoints points;
    SegmentScratch segments;
};

BlockScratch& blockScratch()
{
    static auto& scratch = *new sim::PerThread<BlockScratch>; // Never destroyed: threads may still draw at the end.
    return scratch.here();
}

/// False where surely nothing of the block lies in the rows of tiles that are drawn.
bool mayTouchRows(const StrandBlock& block, const StrandView& view, const TileGrid& tiles)
{
    constexpr float kOvershoot = 0.25F;   ///< How far curves may lie beyond the nodes, over the nodes' extent.
    constexpr float kMostRadii = 2.5F;    ///< Greatest width of a curl or a braid on each side, in its radii.
    constexpr float kNearestSeenM = 0.1F; ///< Blocks with a node that is nearer are always drawn.
    if (tiles.rows() == tiles.up)
        return true;
    float lowest = std::numeric_limits<float>::max();
    float highest = std::numeric_limits<float>::lowest();
    float nearestM = lowest;
    float radiusM = 0.0F;
    for (std::size_t lane = 0; lane < kBlockLanes; ++lane) {
        radiusM = std::max({radiusM, block.curlRadiusM[lane] + block.frizzM[lane],
                            block.braid[lane] > 0.0F ? block.braidRadiusM[lane] + block.frizzM[lane] : 0.0F});
        for (std::size_t node = 0; node < static_cast<std::size_t>(block.nodes); ++node) {
            const float* at = block.nodesWo.data() + node * 3 * kBlockLanes + lane;
            const glm::vec4 clip = view.projectionFromWo * glm::vec4(at[0], at[kBlockLanes], at[2 * kBlockLanes], 1.0F);
            const float up = (clip.y / clip.w * 0.5F + 0.5F) * view.sizeSp.y;
            nearestM = std::min(nearestM, clip.w);
            lowest = std::min(lowest, up);
            highest = std::max(highest, up);
        }
    }
    if (!(nearestM > kNearestSeenM))
        return true;
    const float reach = 2.0F + (highest - lowest) * kOvershoot + kMostRadii * radiusM * view.samplesPerM / nearestM;
    return highest + reach > static_cast<float>(tiles.firstUp * kTileSp) &&
           lowest - reach < static_cast<float>(tiles.endUp * kTileSp);
}

} // namespace

void HairSegments::begin(const std::shared_ptr<const sim::StrandFrame>& frame, const FrameConstants& constants,
                         float detail, bool fine, const HeadOcclusion& head)
{
    m_frame = frame;
    m_groups.clear();
    m_pieces.clear();
    m_batchCount = 0;
    m_hairs = 0;
    m_detail = 1.0F; // Without hair: the first that comes is drawn whole.
    for (SegmentBatch& batch : m_batches)
        batch.clear();
    m_usedBytes = 0;
    m_turnWoFromHd = glm::mat3(constants.woFromHd);
    const DepthOfCoat& depth = fine ? kFineDepth : kMovingDepth;
    m_depth = depth;
    // Depths reach as far as the shaders' 4095 keys.
    constexpr float kKeys = 4095.0F;
    constexpr float kDepths = 65535.0F;
    m_nearestM = constants.depthRange.x;
    m_depthsPerM = constants.depthRange.y * (kDepths / kKeys);
    // As far as a cell is across: what leans less is sorted well enough by its middle.
    const float cellM = static_cast<float>(kCellSp) / samplesPerM(constants);
    m_tiles =
        TileGrid(static_cast<int>(constants.target.x), static_cast<int>(constants.target.y), cellM * m_depthsPerM);
    constexpr std::size_t kSampleBytes = 8;
    const std::size_t sampleBytes =
        static_cast<std::size_t>(m_tiles.width) * static_cast<std::size_t>(m_tiles.height) * kSampleBytes;
    m_mostBatchBytes = std::max(m_mostBytes - std::min(sampleBytes, m_mostBytes), m_mostBytes / 5);
    if (!frame) {
        m_lists.clear();
        m_batches.clear();
        return;
    }
    std::erase_if(m_lists, [&](const auto& entry) {
        return std::none_of(frame->groups.begin(), frame->groups.end(), [&](const sim::GroupFrame& group) {
            return group.groom && group.groom->visible && group.groom->groupId == entry.first;
        });
    });
    float detailThatTells = 0.0F;
    std::vector<OpacityGrids::Source> sources;
    for (const sim::GroupFrame& group : frame->groups) {
        if (!group.groom || !group.groom->visible || group.groom->packedChunks == 0)
            continue;
        StrandList& list = m_lists[group.groom->groupId];
        const float widthSp = hairWidthSp(group.groom->settings.material, constants);
        const float told = fine ? detail : std::min(detail, fractionThatTells(widthSp));
        detailThatTells = std::max(detailThatTells, listedDetail(told));
        // Only those that have positions in the frame can be drawn.
        const float fraction = group.detail < 1.0F ? std::min(told, group.detail / (1.0F + kFadingPart)) : told;
        list.update(group.groom, std::min(listedDetail(fraction), group.detail));
        if (list.slots().empty())
            continue;
        m_groups.push_back({.frame = &group, .list = &list, .view = {}, .fraction = fraction, .widthSp = widthSp});
        sources.push_back({.group = &group, .slots = list.slots(), .detail = list.detail()});
        m_hairs += list.slots().size();
    }
    if (m_groups.empty()) {
        m_batches.clear();
        return;
    }
    m_detail = detailThatTells;
    m_grids.fill(sources, constants, fine);
    const std::size_t wanted = m_hairs / kWantedBatches / kBlockLanes * kBlockLanes;
    const std::size_t batchStrands = std::clamp(wanted, kLeastBatch, kMostBatch);
    for (std::size_t g = 0; g < m_groups.size(); ++g) {
        Group& group = m_groups[g];
        const sim::StrandMaterial& material = group.frame->groom->settings.material;
        group.view = {.projectionFromWo = constants.projectionFromWo,
                      .gridFromWo = constants.gridFromWo[0],
                      .eyeGrid = m_grids.eyeGrid(),
                      .coatAxes = coatAxes(constants),
                      .opacity = {m_grids.grid(0), m_grids.grid(1)},
                      .gridSide = kGridSide,
                      .sizeSp = glm::vec2(constants.target),
                      .samplesPerM = constants.gridSize.z,
                      .groupWidthM = material.widthM,
                      .fraction = group.fraction,
                      .rootAlpha = material.rootAlpha,
                      .tipAlpha = material.tipAlpha,
                      .tapers = material.taperM > 0.0F,
                      .variationScale = material.colourVariation,
                      .sectionAxes = material.sectionAxes,
                      .nearestM = m_nearestM,
                      .depthsPerM = m_depthsPerM,
                      .toleranceSp = fine ? kFineToleranceSp : kMovingToleranceSp,
                      .undrawnCoverings = depth.undrawnCoverings,
                      .inEveryColumn = depth.inEveryColumn,
                      .deepFraction = deepFraction(depth, group.widthSp, group.fraction),
                      .head = head.cells(),
                      .lighting = hairLighting(constants, material)};
        const std::size_t count = group.list->slots().size();
        for (std::size_t first = 0; first < count; first += batchStrands)
            m_pieces.push_back({.group = g, .first = first, .end = std::min(first + batchStrands, count)});
    }
    m_batchCount = m_pieces.size();
    if (m_batches.size() < m_batchCount)
        m_batches.resize(m_batchCount);
    m_batchSegments.assign(m_batchCount, 0);
}

void HairSegments::drawBatch(std::size_t number)
{
    if (isTooMuch())
        return;
    const Piece& piece = m_pieces[number];
    const Group& group = m_groups[piece.group];
    SegmentBatch& batch = m_batches[number];
    BlockScratch& scratch = blockScratch();
    scratch.segments.foundCount = 0; // An earlier batch may have been left in the middle for want of memory.
    std::size_t all = 0;
    for (std::size_t first = piece.first; first < piece.end; first += kBlockLanes) {
        const std::size_t lanes = std::min(kBlockLanes, piece.end - first);
        fillBlock(scratch.block, *group.frame, group.list->slots().subspan(first, lanes), m_turnWoFromHd);
        if (!mayTouchRows(scratch.block, group.view, m_tiles))
            continue;
        const SpanSegments segments = segmentsFor(group.view, scratch.block);
        drawnPoints(group.view, scratch.block, segments, scratch.points);
        batch.add(m_tiles, scratch.points, segments.total, scratch.segments);
        all += static_cast<std::size_t>(segments.total) * lanes;
    }
    batch.sort(m_tiles, scratch.segments);
    m_batchSegments[number] = all;
    m_usedBytes += batch.usedBytes();
}

void HairSegments::collect(std::size_t tile, TileSamples& samples) const
{
    // Little of it is in the caches, so it is fetched a pass ahead.
    std::size_t count = 0;
    for (std::size_t b = 0; b < m_batchCount; ++b) {
        const TileEntry* first = m_batches[b].begin(tile);
        hwy::Prefetch(first);
        count += static_cast<std::size_t>(m_batches[b].end(tile) - first);
    }
    samples.entries.resize(count);
    samples.segments.resize(count);
    auto to = samples.entries.begin();
    for (std::size_t b = 0; b < m_batchCount; ++b) {
        const SegmentBatch& batch = m_batches[b];
        for (const TileEntry* entry = batch.begin(tile); entry != batch.end(tile); ++entry, ++to) {
            *to = *entry;
            hwy::Prefetch(batch.segments() + entry->piece.segment());
        }
    }
    std::uint32_t number = 0;
    for (std::size_t b = 0; b < m_batchCount; ++b) {
        const SegmentBatch& batch = m_batches[b];
        const auto end = number + static_cast<std::uint32_t>(batch.end(tile) - batch.begin(tile));
        for (; number < end; ++number) {
            SegmentPiece& piece = samples.entries[number].piece;
            samples.segments[number] = batch.segments()[piece.segment()];
            piece = piece.renumbered(number);
        }
    }
}

void HairSegments::setRows(int firstUp, int endUp)
{
    m_tiles.firstUp = firstUp;
    m_tiles.endUp = endUp;
    if (m_usedBytes > m_mostBatchBytes) // Fewer will be needed.
        m_batches = std::vector<SegmentBatch>(m_batchCount);
    for (SegmentBatch& batch : m_batches)
        batch.clear();
    m_usedBytes = 0;
}

std::size_t HairSegments::segmentCount() const
{
    return std::accumulate(m_batchSegments.begin(), m_batchSegments.end(), std::size_t{0});
}

} // namespace hairpaint::rendering
