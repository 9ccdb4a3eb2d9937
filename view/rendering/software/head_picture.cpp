// Transforms the vertices of head and solids, sorts their triangles into bands of rows and draws these side by side.
#include "view/rendering/software/head_picture.h"

#include "sim/base/parallel.h"
#include "sim/skin/mesh_openings.h"
#include "view/rendering/frame_lights.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::rendering {
namespace {

constexpr int kBandRows = 32;
static_assert(kBandRows % kOcclusionCellSp == 0);
constexpr float kNearestHeadM = 0.01F;

glm::vec3 turnedBy(glm::vec4 q, glm::vec3 p)
{
    const glm::vec3 axis(q);
    return p + 2.0F * glm::cross(axis, glm::cross(axis, p) + q.w * p);
}

/// As head.vert does.
struct VertexTransform
{
    explicit VertexTransform(const FrameConstants& frame) : constants(frame), turn(frame.woFromHd) {}

    [[nodiscard]] HeadVertex at(glm::vec3 hd, glm::vec3 normalHd, sim::SkinMarks marks) const
    {
        // The shoulders stay while the head turns: back by what has turned too much.
        const float t = std::clamp((constants.neckPivotHd.w - hd.y) * constants.neckReach.x, 0.0F, 1.0F);
        const float below = t * t * (3.0F - 2.0F * t);
        const glm::vec4 mixed = glm::vec4(0.0F, 0.0F, 0.0F, 1.0F) * (1.0F - below) + constants.neckTurn * below;
        const glm::vec4 unit = mixed / std::sqrt(glm::dot(mixed, mixed));
        const glm::vec4 back(-glm::vec3(unit), unit.w);
        const glm::vec3 pivot(constants.neckPivotHd);
        const glm::vec4 wo = constants.woFromHd * glm::vec4(turnedBy(back, hd - pivot) + pivot, 1.0F);
        const glm::vec4 clip = constants.projectionFromWo * wo;
        constexpr float kByte = 1.0F / 255.0F;
        HeadVertex vertex;
        vertex.perDistance = clip.w > kNearestHeadM ? 1.0F / clip.w : 0.0F;
        vertex.x = (clip.x * vertex.perDistance * 0.5F + 0.5F) * constants.target.x;
        vertex.y = (clip.y * vertex.perDistance * 0.5F + 0.5F) * constants.target.y;
        vertex.positionWo = glm::vec3(wo);
        vertex.normalWo = turn * turnedBy(back, normalHd);
        vertex.positionHd = hd;
        vertex.sky = static_cast<float>(marks.sky) * kByte;
        vertex.lips = static_cast<float>(marks.lips) * kByte;
        vertex.lids = static_cast<float>(marks.lids) * kByte;
        vertex.blush = static_cast<float>(marks.blush) * kByte;
        return vertex;
    }

    const FrameConstants& constants;
    glm::mat3 turn;
};

/// Calls vertex(i) for all of a mesh.
template<typename Vertex>
void transformInto(std::vector<HeadVertex>& vertices, std::size_t count, const Vertex& vertex)
{
    vertices.resize(count);
    sim::parallelFor(count, 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            vertices[i] = vertex(i);
    });
}

SkinLighting lightingOf(const FrameConstants& constants, const SkinShading& skin)
{
    return {.woFromHd = glm::mat3(constants.woFromHd),
            .eyeWo = glm::vec3(constants.eyeWo),
            .key = keyLight(constants),
            .fill = fillLight(constants),
            .rim = rimLight(constants),
            .around = irradianceIn(constants),
            .colour = skin.colour,
            .lips = skin.lips,
            .lids = skin.lids,
            .scatter = skin.scatter,
            .grain = skin.grain,
            .sheen = skin.sheen};
}

} // namespace

void HeadPicture::update(const Scene& scene, bool coarse, const FrameConstants& constants)
{
    const FrameConstants part = withoutHair(constants);
    const bool sameView = scene.head == m_head && scene.cards == m_cards && scene.solids == m_solids &&
                          scene.skinTexture == m_skinTexture && part == m_drawnWith && m_width > 0;
    ScalpTintSources tintSources = scalpTintSources(scene.hair.get());
    if (sameView && !m_isCoarse && tintSources == m_tintSources)
        return;
    m_width = 0; // Where memory runs out in between, there is no picture.
    m_isCoarse = !sameView && coarse && scene.headInMotion && scene.head;
    m_tintSources = std::move(tintSources);
    const auto width = static_cast<int>(constants.target.x);
    const auto height = static_cast<int>(constants.target.y);
    const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    m_samples.resize(count + kTileSp); // Resolving reads whole rows of a tile, also at the picture's edge.
    m_distancesM.resize(count);
    m_worn.assign(scene.solids.empty() ? 0 : count, 0);
    m_rowHasHead.assign(static_cast<std::size_t>(height), 0);
    m_occlusion.resize(width, height);
    Mesh& mesh = m_isCoarse ? m_coarse : m_fine;
    const std::shared_ptr<const sim::HeadMesh>& shown = m_isCoarse ? scene.headInMotion : scene.head;
    if (mesh.source != shown) {
        mesh.source = shown;
        mesh.closed = shown && sim::openEdges(*shown).empty();
    }
    m_solids = scene.solids;
    m_skinTexture = scene.skinTexture;
    mesh.tint.update(shown, m_tintSources);
    transformParts(mesh, constants, height);
    if (scene.cards)
        m_cardPicture.transform(*scene.cards, constants);
    HeadBand whole;
    whole.width = width;
    whole.samplesPerM = constants.gridSize.z;
    whole.samples = m_samples.data();
    whole.distancesM = m_distancesM.data();
    whole.worn = m_worn.empty() ? nullptr : m_worn.data();
    const auto bands = static_cast<std::size_t>((height + kBandRows - 1) / kBandRows);
    sim::parallelFor(bands, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b) {
            HeadBand band = whole;
            band.firstRow = static_cast<int>(b) * kBandRows;
            band.endRow = std::min(band.firstRow + kBandRows, height);
            const bool anyPart = drawParts(band, b);
            const bool anyCard = scene.cards && m_cardPicture.drawBand({.width = width,
                                                                        .firstRow = band.firstRow,
                                                                        .endRow = band.endRow,
                                                                        .samples = m_samples.data(),
                                                                        .distancesM = m_distancesM.data()});
            std::fill(m_rowHasHead.begin() + band.firstRow, m_rowHasHead.begin() + band.endRow,
                      anyPart || anyCard ? std::uint8_t{1} : std::uint8_t{0});
            m_occlusion.fillRows({.width = width,
                                  .height = height,
                                  .samples = m_samples.data(),
                                  .distancesM = m_distancesM.data(),
                                  .worn = whole.worn},
                                 band.firstRow, band.endRow, anyPart || anyCard);
        }
    });
    m_occlusion.combine();
    m_head = scene.head;
    m_cards = scene.cards;
    m_drawnWith = part;
    m_width = width;
    m_height = height;
}

void HeadPicture::transformParts(const Mesh& mesh, const FrameConstants& constants, int height)
{
    const VertexTransform transform(constants);
    const std::shared_ptr<const sim::HeadMesh>& head = mesh.source;
    m_parts.resize(std::size_t{head ? 1U : 0U} + m_solids.size());
    auto part = m_parts.begin();
    if (head) {
        const std::span<const ScalpTint::Texel> tints = mesh.tint.texels();
        part->isTinted = !tints.empty();
        part->texture = m_skinTexture.get();
        part->colour = glm::vec3(1.0F);
        transformInto(part->vertices, head->positionsHd.size(), [&](std::size_t i) {
            HeadVertex vertex = transform.at(head->positionsHd[i], head->normalsHd[i],
                                             head->marks.empty() ? sim::SkinMarks{} : head->marks[i]);
            if (part->isTinted)
                vertex.tint = glm::vec4(tints[i]) * (1.0F / 65535.0F);
            if (m_skinTexture)
                vertex.uv = head->uvs[i];
            return vertex;
        });
        part->isSolid = false;
        part->isMasked = false;
        part->triangles = head->triangles;
        part->lighting = lightingOf(constants, {.colour = glm::vec3(constants.skin[0]),
                                                .lips = glm::vec3(constants.skin[1]),
                                                .lids = glm::vec3(constants.skin[2]),
                                                .scatter = constants.skin[0].w,
                                                .grain = constants.skin[1].w,
                                                .sheen = constants.skin[2].w});
        part->sortIntoBands(mesh.closed, height);
        ++part;
    }
    for (const Solid& solid : m_solids) {
        const sim::HeadMesh& body = *solid.mesh;
        const glm::quat& q = solid.shape.rotation;
        const glm::vec4 rotation(q.x, q.y, q.z, q.w);
        transformInto(part->vertices, body.positionsHd.size(), [&](std::size_t i) {
            const glm::vec3 normal = body.normalsHd[i] / solid.shape.semiAxesM;
            HeadVertex vertex =
                transform.at(solid.shape.centreHd + turnedBy(rotation, body.positionsHd[i] * solid.shape.semiAxesM),
                             turnedBy(rotation, normal / std::sqrt(glm::dot(normal, normal))), sim::SkinMarks{});
            if (solid.texture)
                vertex.uv = body.uvs[i];
            return vertex;
        });
        part->triangles = body.triangles;
        part->isSolid = true;
        part->isTinted = false;
        part->texture = solid.texture.get();
        part->colour = solid.colour;
        part->isMasked = solid.masked && solid.texture;
        part->lighting = lightingOf(constants, skinOf(solid));
        part->sortIntoBands(!solid.open, height);
        ++part;
    }
}

bool HeadPicture::drawParts(HeadBand band, std::size_t number) const
{
    const std::size_t first = static_cast<std::size_t>(band.firstRow) * static_cast<std::size_t>(band.width);
    const std::size_t count =
        static_cast<std::size_t>(band.endRow - band.firstRow) * static_cast<std::size_t>(band.width);
    std::fill_n(band.distancesM + first, count, kNoHeadM);
    std::fill_n(band.samples + first, count, HeadSample{});
    bool any = false;
    std::uint8_t* const worn = band.worn;
    for (const Part& part : m_parts) {
        const std::uint32_t begin = part.bandBegin[number];
        const std::uint32_t end = part.bandBegin[number + 1];
        if (begin == end)
            continue;
        band.vertices = part.vertices;
        band.triangles = part.triangles;
        band.numbers = std::span(part.bandTriangles).subspan(begin, end - begin);
        band.lighting = part.lighting;
        band.isTinted = part.isTinted;
        band.texture = part.texture;
        band.textureColour = part.colour;
        band.isMasked = part.isMasked;
        band.worn = part.isSolid ? worn : nullptr;
        drawHeadBand(band);
        any = true;
    }
    return any;
}

void HeadPicture::Part::sortIntoBands(bool closed, int height)
{
    bandBegin.assign(static_cast<std::size_t>((height + kBandRows - 1) / kBandRows) + 1, 0);
    const auto most = static_cast<float>(height - 1);
    const auto bandsOf = [&](const glm::uvec3& corners, std::size_t& first, std::size_t& last) {
        const HeadVertex& a = vertices[corners.x];
        const HeadVertex& b = vertices[corners.y];
        const HeadVertex& c = vertices[corners.z];
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
    for (const glm::uvec3& corners : triangles)
        if (bandsOf(corners, first, last))
            for (std::size_t band = first; band <= last; ++band)
                ++bandBegin[band + 1];
    for (std::size_t band = 1; band < bandBegin.size(); ++band)
        bandBegin[band] += bandBegin[band - 1];
    bandTriangles.resize(bandBegin.back());
    std::vector<std::uint32_t> next(bandBegin.begin(), bandBegin.end() - 1);
    for (std::size_t i = 0; i < triangles.size(); ++i)
        if (bandsOf(triangles[i], first, last))
            for (std::size_t band = first; band <= last; ++band)
                bandTriangles[next[band]++] = static_cast<std::uint32_t>(i);
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
