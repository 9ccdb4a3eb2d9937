// The compute passes: opacity grids, points along the strands, their light, their samples.
#include "view/rendering/hair_pass.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>

namespace hairpaint::rendering {
namespace {

constexpr unsigned kWorkgroup = 64;
constexpr float kVoxelUnitM2 = 1e-9F;            ///< Hair's area that one unit of a voxel stands for.
constexpr std::uint32_t kSplattedStrands = 8192; ///< About as many are enough for a smooth grid.

constexpr std::uint32_t kPatientPoints = 1U << 15U; ///< A piece that software draws in a fraction of a second.

constexpr float kLeastWidth = 0.35F;    ///< Samples: what the thinnest hair covers.
constexpr float kGreatestWidth = 24.0F; ///< Samples: wider strands would look like straw.

/// No more than 65535 workgroups are promised in one direction; batches keep below.
void dispatch(std::size_t invocations, unsigned rows = 1)
{
    glDispatchCompute(static_cast<unsigned>((invocations + kWorkgroup - 1) / kWorkgroup), rows, 1);
}

} // namespace

tl::expected<std::unique_ptr<HairPass>, std::string> HairPass::create()
{
    std::unique_ptr<HairPass> pass(new HairPass);
    const std::pair<Program HairPass::*, const char*> programs[] = {{&HairPass::m_splat, "grid_splat.comp"},
                                                                    {&HairPass::m_sum, "grid_sum.comp"},
                                                                    {&HairPass::m_expand, "strand_expand.comp"},
                                                                    {&HairPass::m_shade, "strand_shade.comp"},
                                                                    {&HairPass::m_raster, "strand_raster.comp"}};
    for (const auto& [member, file] : programs) {
        auto program = Program::compute(file);
        if (!program)
            return tl::unexpected(program.error());
        (*pass).*member = std::move(*program);
    }
    const std::vector<std::uint32_t> empty(2U * kGridSide * kGridSide * kGridSide, 0U);
    pass->m_voxels.assign(empty.data(), empty.size() * sizeof(std::uint32_t));
    for (Texture& opacity : pass->m_opacity)
        opacity.resize3D(GL_R32F, kGridSide);
    return pass;
}

HairPass::Report HairPass::upload(const std::shared_ptr<const sim::StrandFrame>& frame, float detail,
                                  int smoothSegments)
{
    Report report;
    m_visible.clear();
    if (!frame) {
        m_groups.clear();
        return report;
    }
    std::erase_if(m_groups, [&](const auto& entry) {
        return std::none_of(frame->groups.begin(), frame->groups.end(), [&](const sim::GroupFrame& group) {
            return group.groom && group.groom->groupId == entry.first;
        });
    });
    for (const sim::GroupFrame& group : frame->groups) {
        if (!group.groom || !group.groom->visible || group.groom->packedChunks == 0) {
            if (group.groom)
                m_groups[group.groom->groupId].release();
            continue;
        }
        HairBuffers& held = m_groups[group.groom->groupId];
        report.uploadedBytes += held.upload(frame, group, detail, smoothSegments);
        if (!held.ready() || held.list().strandCount() == 0)
            continue;
        m_visible.push_back(group.groom->groupId);
        report.hairs += held.list().strandCount();
        report.segments += held.list().segmentCount();
    }
    return report;
}

bool HairPass::draw(const FrameConstants& constants, float detail, const Buffer& samples,
                    const std::function<bool(double)>& progress)
{
    if (m_visible.empty())
        return true;
    fillGrid(constants, detail);
    double allPoints = 0.0;
    for (const int id : m_visible)
        for (const StrandBatch& batch : m_groups.at(id).list().batches())
            allPoints += batch.pointCount;
    double drawnPoints = 0.0;
    const auto pieceDone = [&](std::uint32_t points) {
        if (!progress)
            return true;
        glFinish();
        drawnPoints += points;
        return progress(drawnPoints / allPoints);
    };
    const std::uint32_t piecePoints = progress ? kPatientPoints : HairList::kBatchPoints;
    for (const int id : m_visible)
        if (!drawGroup(m_groups.at(id), constants, detail, samples, piecePoints, pieceDone))
            return false;
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    return true;
}

void HairPass::bindOpacity(unsigned lightUnit, unsigned eyeUnit) const
{
    m_opacity[0].bind(lightUnit);
    m_opacity[1].bind(eyeUnit);
}

void HairPass::fillGrid(const FrameConstants& constants, float detail)
{
    m_voxels.bindStorage(3);
    m_splat.use();
    m_splat.set("gridSide", kGridSide);
    for (const int id : m_visible) {
        const HairBuffers& group = m_groups.at(id);
        group.bind();
        const auto strands = static_cast<std::uint32_t>(group.list().strandCount());
        const std::uint32_t step = std::max(1U, strands / kSplattedStrands);
        m_splat.set("strandCount", strands);
        m_splat.set("strandStep", step);
        m_splat.set("nodes", group.groom().nodes);
        m_splat.set("weight",
                    group.groom().settings.material.widthM * static_cast<float>(step) / (detail * kVoxelUnitM2));
        dispatch((strands + step - 1) / step);
    }
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    m_sum.use();
    m_sum.set("gridSide", kGridSide);
    for (int grid = 0; grid < 2; ++grid) {
        m_sum.set("firstLayer", grid * kGridSide);
        m_sum.set("unit", kVoxelUnitM2 / constants.gridSize[grid]);
        glBindImageTexture(0, m_opacity.at(static_cast<std::size_t>(grid)).id(), 0, GL_TRUE, 0, GL_WRITE_ONLY, GL_R32F);
        dispatch(static_cast<std::size_t>(kGridSide) * kGridSide);
    }
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
}

bool HairPass::drawGroup(const HairBuffers& group, const FrameConstants& constants, float detail, const Buffer& samples,
                         std::uint32_t piecePoints, const std::function<bool(std::uint32_t)>& pieceDone)
{
    const sim::GroupSettings& settings = group.groom().settings;
    std::uint32_t mostPoints = 0;
    for (const StrandBatch& batch : group.list().batches())
        mostPoints = std::max(mostPoints, batch.pointCount);
    m_points.reserve(mostPoints * sizeof(glm::vec4));
    m_projected.reserve(mostPoints * sizeof(glm::uvec4));
    bindOpacity(0, 1);

    const float thickest =
        std::max(settings.material.widthM * constants.gridSize.z / constants.depthRange.x, kLeastWidth) / detail *
        std::max(settings.material.rootAlpha, settings.material.tipAlpha);
    const auto rows = static_cast<unsigned>(std::min(thickest, kGreatestWidth) * 1.42F) + 1U;

    const std::vector<DrawnStrand>& strands = group.list().strands();
    for (const StrandBatch& batch : group.list().batches()) {
        const std::uint32_t end = batch.firstStrand + batch.strandCount;
        StrandBatch piece{.firstStrand = batch.firstStrand, .strandCount = 0, .pointCount = 0};
        while (piece.firstStrand < end) {
            const std::uint32_t first = strands[piece.firstStrand].firstPoint;
            std::uint32_t next = end;
            if (strands[end].firstPoint - first > piecePoints)
                for (next = piece.firstStrand + 1; strands[next + 1].firstPoint - first <= piecePoints;)
                    ++next;
            piece.strandCount = next - piece.firstStrand;
            piece.pointCount = strands[next].firstPoint - first;
            drawPiece(piece, group, detail, samples, rows);
            if (!pieceDone(piece.pointCount))
                return false;
            piece.firstStrand = next;
        }
    }
    return true;
}

void HairPass::drawPiece(const StrandBatch& piece, const HairBuffers& group, float detail, const Buffer& samples,
                         unsigned rows)
{
    const sim::GroupSettings& settings = group.groom().settings;
    group.bind();
    m_points.bindStorage(3);
    m_expand.use();
    m_expand.set("firstStrand", piece.firstStrand);
    m_expand.set("strandCount", piece.strandCount);
    m_expand.set("nodes", group.groom().nodes);
    dispatch(piece.strandCount);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);

    m_points.bindStorage(2);
    m_projected.bindStorage(3);
    m_shade.use();
    m_shade.set("firstStrand", piece.firstStrand);
    m_shade.set("pointCount", piece.pointCount);
    m_shade.set("widening", 1.0F / detail);
    m_shade.set("leastWidth", kLeastWidth);
    m_shade.set("greatestWidth", kGreatestWidth);
    m_shade.set("material", glm::vec4(settings.material.shine, settings.material.roughness, settings.material.rootAlpha,
                                      settings.material.tipAlpha));
    m_shade.set("groupWidthM", settings.material.widthM);
    m_shade.set("variationScale", settings.material.colourVariation);
    dispatch(piece.pointCount);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);

    m_projected.bindStorage(0);
    samples.bindStorage(1);
    m_raster.use();
    m_raster.set("pointCount", piece.pointCount);
    dispatch(piece.pointCount, rows);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

} // namespace hairpaint::rendering
