// The compute passes: opacity grids, points along the strands, their light.
#include "view/rendering/gl/hair_pass.h"

#include "sim/groom/strand_curve.h"
#include "sim/groom/strand_look.h"
#include "view/rendering/coat_axis.h"
#include "view/rendering/drawn_fraction.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>

namespace hairpaint::rendering {
namespace {

constexpr unsigned kWorkgroup = 64;
constexpr float kVoxelUnitM2 = 1e-9F; ///< Hair's area that one unit of a voxel stands for.

// The shaders stop at what is opaque, so that more of what lies deep is drawn than in software.
constexpr DepthOfCoat kFineDepth{
    .undrawnCoverings = 10.0F, .inEveryColumn = true, .widest = 0.55F, .leastFraction = 0.45F};
constexpr DepthOfCoat kMovingDepth{
    .undrawnCoverings = 8.0F, .inEveryColumn = false, .widest = 1.67F, .leastFraction = 0.3F};

/// No more than 65535 workgroups are promised in one direction; batches keep below.
void dispatch(std::size_t invocations)
{
    glDispatchCompute(static_cast<unsigned>((invocations + kWorkgroup - 1) / kWorkgroup), 1, 1);
}

} // namespace

tl::expected<std::unique_ptr<HairPass>, std::string> HairPass::create()
{
    std::unique_ptr<HairPass> pass(new HairPass);
    const std::pair<Program HairPass::*, const char*> programs[] = {{&HairPass::m_splat, "grid_splat.comp"},
                                                                    {&HairPass::m_sum, "grid_sum.comp"},
                                                                    {&HairPass::m_expand, "strand_expand.comp"},
                                                                    {&HairPass::m_shade, "strand_shade.comp"}};
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

HairPass::Report HairPass::upload(const std::shared_ptr<const sim::StrandFrame>& frame, const FrameConstants& constants,
                                  float detail, bool fine)
{
    constexpr int kMostTries = 4;
    Report report = uploadGroups(frame, constants, detail, fine);
    const std::size_t mostPoints = mostBytesOfABuffer() / sizeof(glm::uvec4);
    for (int tries = 0; tries < kMostTries && report.segments + report.hairs > mostPoints; ++tries) {
        // Fewer and wider hairs, as many as one buffer holds.
        const auto points = static_cast<float>(report.segments + report.hairs);
        detail = std::min(detail, report.detail) * 0.9F * static_cast<float>(mostPoints) / points;
        const std::size_t sent = report.uploadedBytes;
        report = uploadGroups(frame, constants, detail, fine);
        report.uploadedBytes += sent;
    }
    return report;
}

HairPass::Report HairPass::uploadGroups(const std::shared_ptr<const sim::StrandFrame>& frame,
                                        const FrameConstants& constants, float detail, bool fine)
{
    Report report;
    m_visible.clear();
    m_fractions.clear();
    m_pieces.clear();
    m_nextPiece = 0;
    m_pointCount = 0;
    if (!frame) {
        m_groups.clear();
        return report;
    }
    m_fine = fine;
    m_depth = fine ? kFineDepth : kMovingDepth;
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
        const float widthSp = hairWidthSp(group.groom->settings.material, constants);
        float fraction = fine ? detail : std::min(detail, fractionThatTells(widthSp));
        report.detail = m_visible.empty() ? listedDetail(fraction) : std::max(report.detail, listedDetail(fraction));
        // Only those that have positions in the frame can be drawn.
        if (group.detail < 1.0F)
            fraction = std::min(fraction, group.detail / (1.0F + kFadingPart));
        SegmentsWanted segments = segmentsWanted(group, constants, fine ? kFineToleranceSp : kMovingToleranceSp);
        if (sim::tipMixOf(group.groom->settings.material).bendsWithin(0.0F, 1.0F)) // Colours are known at points alone.
            segments.ofStraightHair = std::max(segments.ofStraightHair, kSegmentsOfDyedHair);
        report.uploadedBytes += held.upload(frame, group, std::min(listedDetail(fraction), group.detail), segments);
        if (!held.ready() || held.list().strandCount() == 0)
            continue;
        m_visible.push_back(group.groom->groupId);
        m_fractions[group.groom->groupId] = {.fraction = fraction, .deep = deepFraction(m_depth, widthSp, fraction)};
        report.hairs += held.list().strandCount();
        report.segments += held.list().segmentCount();
    }
    return report;
}

void HairPass::begin(const FrameConstants& constants, std::uint32_t piecePoints)
{
    if (m_visible.empty())
        return;
    fillGrid(constants);
    for (const int id : m_visible)
        addPieces(id, piecePoints);
    std::uint32_t mostPoints = 0;
    for (const Piece& piece : m_pieces)
        mostPoints = std::max(mostPoints, piece.strands.pointCount);
    m_points.reserve(mostPoints * sizeof(glm::vec4));
    m_projected.reserve(m_pointCount * sizeof(glm::uvec4));
}

double HairPass::progress() const
{
    return m_pieces.empty() ? 1.0 : static_cast<double>(m_nextPiece) / static_cast<double>(m_pieces.size());
}

void HairPass::bindOpacity(unsigned lightUnit, unsigned eyeUnit) const
{
    m_opacity[0].bind(lightUnit);
    m_opacity[1].bind(eyeUnit);
}

void HairPass::fillGrid(const FrameConstants& constants)
{
    const auto wanted = static_cast<std::uint32_t>(hairsForGrids(constants, m_fine));
    m_voxels.bindStorage(3);
    m_splat.use();
    m_splat.set("gridSide", kGridSide);
    for (const int id : m_visible) {
        const HairBuffers& group = m_groups.at(id);
        group.bind();
        const auto strands = static_cast<std::uint32_t>(group.list().strandCount());
        const std::uint32_t step = std::max(1U, (strands + wanted / 2) / wanted);
        m_splat.set("strandCount", strands);
        m_splat.set("strandStep", step);
        m_splat.set("nodes", group.groom().nodes);
        m_splat.set("weight", group.groom().settings.material.widthM * static_cast<float>(step) /
                                  (m_fractions.at(id).fraction * kVoxelUnitM2));
        dispatch((strands + step - 1) / step);
    }
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    m_sum.use();
    m_sum.set("gridSide", kGridSide);
    for (int grid = 0; grid < 2; ++grid) {
        m_sum.set("firstLayer", grid * kGridSide);
        const float middleM = constants.eyeGrid[1].w;
        m_sum.set("unit",
                  kVoxelUnitM2 / (grid == 0 ? constants.gridSize.x : constants.eyeGrid[0].w * middleM * middleM));
        glBindImageTexture(0, m_opacity.at(static_cast<std::size_t>(grid)).id(), 0, GL_TRUE, 0, GL_WRITE_ONLY, GL_R32F);
        dispatch(static_cast<std::size_t>(kGridSide) * kGridSide);
    }
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
    m_shade.use();
    m_shade.set("outOfCoatVoxels", kOutOfCoatVoxels);
    const std::array<CoatAxis, 2> axes = coatAxes(constants);
    m_shade.set("lightCoatMiddle", glm::vec4(axes[0].middle, 1.0F));
    m_shade.set("lightCoatDown", glm::vec4(axes[0].down, 0.0F));
    m_shade.set("lightCoatPerDown", glm::vec4(axes[0].perDown, 0.0F));
    m_shade.set("eyeCoatMiddle", glm::vec4(axes[1].middle, 1.0F));
    m_shade.set("eyeCoatDown", glm::vec4(axes[1].down, 0.0F));
    m_shade.set("eyeCoatPerDown", glm::vec4(axes[1].perDown, 0.0F));
}

void HairPass::addPieces(int groupId, std::uint32_t piecePoints)
{
    const HairList& list = m_groups.at(groupId).list();
    const std::vector<DrawnStrand>& strands = list.strands();
    for (const StrandBatch& batch : list.batches()) {
        const std::uint32_t end = batch.firstStrand + batch.strandCount;
        for (std::uint32_t at = batch.firstStrand; at < end;) {
            const std::uint32_t first = strands[at].firstPoint;
            std::uint32_t next = end;
            if (strands[end].firstPoint - first > piecePoints)
                for (next = at + 1; strands[next + 1].firstPoint - first <= piecePoints;)
                    ++next;
            m_pieces.push_back({.group = groupId,
                                .strands = {.firstStrand = at,
                                            .strandCount = next - at,
                                            .pointCount = strands[next].firstPoint - first},
                                .firstProjected = static_cast<std::uint32_t>(m_pointCount)});
            m_pointCount += strands[next].firstPoint - first;
            at = next;
        }
    }
}

bool HairPass::projectPiece()
{
    if (m_nextPiece == m_pieces.size())
        return false;
    const auto& [groupId, piece, firstProjected] = m_pieces[m_nextPiece++];
    const HairBuffers& group = m_groups.at(groupId);
    const sim::GroupSettings& settings = group.groom().settings;
    bindOpacity(0, 1);
    group.bind();
    m_points.bindStorage(3);
    m_expand.use();
    m_expand.set("firstStrand", piece.firstStrand);
    m_expand.set("strandCount", piece.strandCount);
    m_expand.set("nodes", group.groom().nodes);
    const sim::CurlSettings& curl = settings.curl;
    m_expand.set("isCoiled", sim::coilsOf(settings) != nullptr ? 1 : 0);
    m_expand.set("coil", glm::vec4(curl.inStepFromM, curl.switchbacksPerM, curl.skips, curl.flatness));
    m_expand.set("uncoil", glm::vec2(curl.uncoil, curl.straightM));
    m_expand.set("taperM", settings.material.taperM);
    dispatch(piece.strandCount);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);

    m_points.bindStorage(2);
    m_projected.bindStorage(3);
    m_shade.use();
    m_shade.set("firstStrand", piece.firstStrand);
    m_shade.set("pointCount", piece.pointCount);
    m_shade.set("firstProjected", firstProjected);
    m_shade.set("fraction", m_fractions.at(groupId).fraction);
    m_shade.set("deepFraction", m_fractions.at(groupId).deep);
    m_shade.set("undrawnCoverings", m_depth.undrawnCoverings);
    m_shade.set("inEveryColumn", m_depth.inEveryColumn ? 1 : 0);
    m_shade.set("material", glm::vec4(settings.material.shine, settings.material.roughness, settings.material.rootAlpha,
                                      settings.material.tipAlpha));
    m_shade.set("taperM", settings.material.taperM);
    m_shade.set("tipFromOver", glm::vec2(settings.material.tipFrom, settings.material.tipOver));
    m_shade.set("groupWidthM", settings.material.widthM);
    m_shade.set("variationScale", settings.material.colourVariation);
    m_shade.set("sectionAxes", settings.material.sectionAxes);
    dispatch(piece.pointCount);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    return true;
}

} // namespace hairpaint::rendering
