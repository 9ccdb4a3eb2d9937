// Places the head's vertices, sorts its triangles into bands of rows and draws these side by side.
#include "view/rendering/software/head_picture.h"

#include "sim/base/parallel.h"
#include "sim/skin/mesh_openings.h"
#include "view/rendering/frame_lights.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::rendering {
namespace {

constexpr int kBandRows = 32;
constexpr float kNearestHeadM = 0.01F;

glm::vec3 turnedBy(glm::vec4 q, glm::vec3 p)
{
    const glm::vec3 axis(q);
    return p + 2.0F * glm::cross(axis, glm::cross(axis, p) + q.w * p);
}

} // namespace

void HeadPicture::update(const std::shared_ptr<const sim::HeadMesh>& head,
                         const std::shared_ptr<const sim::HeadMesh>& inMotion,
                         const std::shared_ptr<const CardSet>& cards, const FrameConstants& constants)
{
    const FrameConstants part = withoutHair(constants);
    const bool same = head == m_head && cards == m_cards && part == m_drawnWith && m_width > 0;
    if (same && !m_isCoarse)
        return;
    m_width = 0; // Where memory runs out half-way, there is no picture.
    const bool coarse = !same && inMotion && head;
    const auto width = static_cast<int>(constants.target.x);
    const auto height = static_cast<int>(constants.target.y);
    const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    m_samples.resize(count + kTileSp); // Resolving reads whole rows of a tile, also at the picture's edge.
    m_distancesM.resize(count);
    m_rowHasHead.assign(static_cast<std::size_t>(height), 0);
    Mesh& mesh = coarse ? m_coarse : m_fine;
    const std::shared_ptr<const sim::HeadMesh>& shown = coarse ? inMotion : head;
    if (mesh.source != shown) {
        mesh.source = shown;
        mesh.closed = shown && sim::openEdges(*shown).empty();
    }
    const auto bands = static_cast<std::size_t>((height + kBandRows - 1) / kBandRows);
    m_bandBegin.assign(bands + 1, 0);
    m_bandTriangles.clear();
    HeadBand whole;
    if (shown) {
        place(*shown, constants);
        m_height = height;
        sortIntoBands(*shown, mesh.closed);
        whole.triangles = shown->triangles;
    }
    whole.vertices = m_vertices;
    whole.width = width;
    whole.samplesPerM = constants.gridSize.z;
    whole.samples = m_samples.data();
    whole.distancesM = m_distancesM.data();
    whole.lighting = {.woFromHd = glm::mat3(constants.woFromHd),
                      .eyeWo = glm::vec3(constants.eyeWo),
                      .key = keyLight(constants),
                      .fill = fillLight(constants),
                      .rim = rimLight(constants),
                      .around = irradianceIn(constants),
                      .colour = glm::vec3(constants.skin[0]),
                      .lips = glm::vec3(constants.skin[1]),
                      .lids = glm::vec3(constants.skin[2]),
                      .scatter = constants.skin[0].w,
                      .grain = constants.skin[1].w,
                      .sheen = constants.skin[2].w};
    if (cards)
        m_cardPicture.place(*cards, constants);
    sim::parallelFor(bands, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b) {
            HeadBand band = whole;
            band.numbers = std::span(m_bandTriangles).subspan(m_bandBegin[b], m_bandBegin[b + 1] - m_bandBegin[b]);
            band.firstRow = static_cast<int>(b) * kBandRows;
            band.endRow = std::min(band.firstRow + kBandRows, height);
            drawHeadBand(band);
            const bool any = cards && m_cardPicture.drawBand({.width = width,
                                                              .firstRow = band.firstRow,
                                                              .endRow = band.endRow,
                                                              .samples = m_samples.data(),
                                                              .distancesM = m_distancesM.data()});
            std::fill(m_rowHasHead.begin() + band.firstRow, m_rowHasHead.begin() + band.endRow,
                      band.numbers.empty() && !any ? std::uint8_t{0} : std::uint8_t{1});
        }
    });
    m_head = head;
    m_cards = cards;
    m_drawnWith = part;
    m_isCoarse = coarse;
    m_width = width;
    m_height = height;
}

/// As head.vert does.
void HeadPicture::place(const sim::HeadMesh& mesh, const FrameConstants& constants)
{
    m_vertices.resize(mesh.positionsHd.size());
    const glm::mat3 turn(constants.woFromHd);
    sim::parallelFor(m_vertices.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const glm::vec3 hd = mesh.positionsHd[i];
            // The shoulders stay while the head turns: back by what has turned too much.
            const float t = std::clamp((constants.neckPivotHd.w - hd.y) * constants.neckReach.x, 0.0F, 1.0F);
            const float below = t * t * (3.0F - 2.0F * t);
            const glm::vec4 mixed = glm::vec4(0.0F, 0.0F, 0.0F, 1.0F) * (1.0F - below) + constants.neckTurn * below;
            const glm::vec4 unit = mixed / std::sqrt(glm::dot(mixed, mixed));
            const glm::vec4 back(-glm::vec3(unit), unit.w);
            const glm::vec3 pivot(constants.neckPivotHd);
            const glm::vec4 wo = constants.woFromHd * glm::vec4(turnedBy(back, hd - pivot) + pivot, 1.0F);
            const glm::vec4 clip = constants.projectionFromWo * wo;
            HeadVertex& vertex = m_vertices[i];
            vertex.perDistance = clip.w > kNearestHeadM ? 1.0F / clip.w : 0.0F;
            vertex.x = (clip.x * vertex.perDistance * 0.5F + 0.5F) * constants.target.x;
            vertex.y = (clip.y * vertex.perDistance * 0.5F + 0.5F) * constants.target.y;
            vertex.placeWo = glm::vec3(wo);
            vertex.normalWo = turn * turnedBy(back, mesh.normalsHd[i]);
            vertex.placeHd = hd;
            constexpr float kByte = 1.0F / 255.0F;
            const sim::SkinMarks marks = mesh.marks.empty() ? sim::SkinMarks{} : mesh.marks[i];
            vertex.sky = static_cast<float>(marks.sky) * kByte;
            vertex.lips = static_cast<float>(marks.lips) * kByte;
            vertex.lids = static_cast<float>(marks.lids) * kByte;
            vertex.blush = static_cast<float>(marks.blush) * kByte;
        }
    });
}

void HeadPicture::sortIntoBands(const sim::HeadMesh& mesh, bool closed)
{
    const auto most = static_cast<float>(m_height - 1);
    const auto bandsOf = [&](const glm::uvec3& corners, std::size_t& first, std::size_t& last) {
        const HeadVertex& a = m_vertices[corners.x];
        const HeadVertex& b = m_vertices[corners.y];
        const HeadVertex& c = m_vertices[corners.z];
        if (a.perDistance <= 0.0F || b.perDistance <= 0.0F || c.perDistance <= 0.0F)
            return false;
        if (closed && (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y) <= 0.0F)
            return false;
        const float low = std::min({a.y, b.y, c.y});
        const float high = std::max({a.y, b.y, c.y});
        if (!(high >= 0.0F && low <= most + 1.0F))
            return false;
        first = static_cast<std::size_t>(std::clamp(low, 0.0F, most)) / kBandRows;
        last = static_cast<std::size_t>(std::clamp(high, 0.0F, most)) / kBandRows;
        return true;
    };
    std::size_t first = 0;
    std::size_t last = 0;
    for (const glm::uvec3& corners : mesh.triangles)
        if (bandsOf(corners, first, last))
            for (std::size_t band = first; band <= last; ++band)
                ++m_bandBegin[band + 1];
    for (std::size_t band = 1; band < m_bandBegin.size(); ++band)
        m_bandBegin[band] += m_bandBegin[band - 1];
    m_bandTriangles.resize(m_bandBegin.back());
    std::vector<std::uint32_t> next(m_bandBegin.begin(), m_bandBegin.end() - 1);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        if (bandsOf(mesh.triangles[i], first, last))
            for (std::size_t band = first; band <= last; ++band)
                m_bandTriangles[next[band]++] = static_cast<std::uint32_t>(i);
}

bool HeadPicture::isIn(int x0, int y0, int across, int up) const
{
    for (int y = y0; y < y0 + up; ++y) {
        if (m_rowHasHead[static_cast<std::size_t>(y)] == 0)
            continue;
        const float* row = m_distancesM.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(m_width) + x0;
        if (*std::min_element(row, row + across) < kNoHeadM)
            return true;
    }
    return false;
}

} // namespace hairpaint::rendering
