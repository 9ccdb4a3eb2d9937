// Makes grooms, frames and balls without the simulation.
#include "tests/rendering/hand_made_hair.h"

#include "sim/base/deterministic.h"
#include "sim/base/rounded.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hairpaint::testing {

std::shared_ptr<sim::StrandFrame> makeFrame(const std::vector<HandMadeStrand>& strands,
                                            const sim::GroupSettings& settings, int groupId)
{
    auto groom = std::make_shared<sim::Groom>();
    auto roots = std::make_shared<sim::RootSet>();
    sim::GroupFrame group;
    groom->groupId = groupId;
    groom->settings = settings;
    groom->nodes = strands.empty() ? 8 : static_cast<int>(strands.front().nodesWo.size());
    const std::size_t chunks = (strands.size() + sim::kChunkSlots - 1) / sim::kChunkSlots;
    const auto nodes = static_cast<std::size_t>(groom->nodes);
    group.positions.resize(chunks * sim::kChunkSlots * nodes * 3);
    for (std::size_t c = 0; c < chunks; ++c) {
        auto chunk = std::make_shared<sim::StrandChunk>();
        chunk->styles.resize(sim::kChunkSlots);
        chunk->braidCentre.assign(sim::kChunkSlots, sim::kNoCentre);
        for (std::size_t slot = 0; slot < sim::kChunkSlots && c * sim::kChunkSlots + slot < strands.size(); ++slot) {
            const std::size_t i = c * sim::kChunkSlots + slot;
            const HandMadeStrand& strand = strands[i];
            sim::StrandStyle style = strand.style;
            for (std::size_t n = 1; n < nodes; ++n)
                style.lengthM += glm::distance(strand.nodesWo[n - 1], strand.nodesWo[n]);
            if (style.detail > 1.0F) // In an order that spreads over the strands.
                style.detail =
                    (static_cast<float>((i * 7919) % strands.size()) + 0.5F) / static_cast<float>(strands.size());
            chunk->styles[slot] = style;
            chunk->hairs.set(slot);
            chunk->drawn.set(slot);
            groom->blocks().write(group.positions, i, strand.nodesWo);
        }
        const auto first = group.positions.begin() + static_cast<std::ptrdiff_t>(c * sim::kChunkSlots * nodes * 3);
        chunk->restPositions.assign(first, first + static_cast<std::ptrdiff_t>(sim::kChunkSlots * nodes * 3));
        groom->chunks.push_back(chunk);
        groom->packedChunk.push_back(static_cast<std::int32_t>(c));
    }
    for (const HandMadeStrand& strand : strands) {
        roots->tangentHd.push_back(strand.tangentHd);
        roots->positionHd.push_back(strand.nodesWo.front());
        roots->normalHd.emplace_back(0.0F, 1.0F, 0.0F);
    }
    groom->packedChunks = static_cast<std::int32_t>(chunks);
    groom->roots = std::move(roots);
    groom->hairCount = strands.size();
    groom->drawnCount = strands.size();
    group.groom = std::move(groom);
    auto frame = std::make_shared<sim::StrandFrame>();
    frame->hairCount = strands.size();
    frame->groups.push_back(std::move(group));
    return frame;
}

HandMadeStrand straightStrand(glm::vec3 fromWo, glm::vec3 toWo, std::uint32_t colour, int nodes)
{
    HandMadeStrand strand;
    strand.style.rootColour = colour;
    strand.style.tipColour = colour;
    for (int n = 0; n < nodes; ++n)
        strand.nodesWo.push_back(glm::mix(fromWo, toWo, static_cast<float>(n) / static_cast<float>(nodes - 1)));
    return strand;
}

std::shared_ptr<const sim::HeadMesh> makeBall(glm::vec3 semiAxesM, int rings)
{
    auto mesh = std::make_shared<sim::HeadMesh>();
    const int columns = rings * 2;
    for (int ring = 0; ring <= rings; ++ring)
        for (int column = 0; column <= columns; ++column) {
            const float u = static_cast<float>(column) / static_cast<float>(columns);
            const float v = static_cast<float>(ring) / static_cast<float>(rings);
            const float theta = v * std::numbers::pi_v<float>;
            const float phi = u * 2.0F * std::numbers::pi_v<float>;
            const glm::vec3 unit(sim::sinRounded(theta) * sim::sinRounded(phi), -sim::cosRounded(theta),
                                 sim::sinRounded(theta) * sim::cosRounded(phi));
            mesh->positionsHd.push_back(unit * semiAxesM);
            mesh->normalsHd.push_back(glm::normalize(unit / semiAxesM));
            mesh->uvs.emplace_back(u, v);
        }
    const auto at = [&](int ring, int column) { return static_cast<unsigned>(ring * (columns + 1) + column); };
    for (int ring = 0; ring < rings; ++ring)
        for (int column = 0; column < columns; ++column) {
            mesh->triangles.emplace_back(at(ring, column), at(ring, column + 1), at(ring + 1, column + 1));
            mesh->triangles.emplace_back(at(ring, column), at(ring + 1, column + 1), at(ring + 1, column));
        }
    return mesh;
}

std::vector<HandMadeStrand> hairOnBall(glm::vec3 semiAxesM, const BallHair& hair)
{
    std::vector<HandMadeStrand> strands;
    for (int i = 0; i < hair.hairs; ++i) {
        const auto random = [&](std::uint64_t what) {
            return sim::unitFloat(sim::hash64(what, static_cast<std::uint64_t>(i)));
        };
        // A golden spiral over the upper part of a unit ball, thinned by nothing: even by area.
        const float y = 1.0F - 1.05F * (static_cast<float>(i) + 0.5F) / static_cast<float>(hair.hairs);
        const float phi = static_cast<float>(i) * 2.399963F;
        const float r = std::sqrt(1.0F - y * y);
        const glm::vec3 unit(r * sim::sinRounded(phi), y, r * sim::cosRounded(phi));
        const glm::vec3 normal = glm::normalize(unit / semiAxesM);
        HandMadeStrand strand;
        strand.tangentHd = glm::normalize(glm::cross(glm::vec3(0.1F, 1.0F, 0.03F), normal));
        strand.style.rootColour = hair.rootColour;
        strand.style.tipColour = hair.tipColour;
        strand.style.turns = hair.turns;
        strand.style.curlRadiusM = hair.curlRadiusM;
        strand.style.phase = random(1) * 6.28F;
        strand.style.variation = random(2) * 2.0F - 1.0F;
        const float lift = 1.0F + 0.10F * random(3);
        const float step = hair.lengthM * (0.85F + 0.15F * random(4)) / static_cast<float>(hair.nodes - 1);
        glm::vec3 p = unit * semiAxesM;
        glm::vec3 direction = normal;
        strand.nodesWo.push_back(p);
        for (int n = 1; n < hair.nodes; ++n) {
            const glm::vec3 wander(random(10) - 0.5F, 0.0F, random(11) - 0.5F);
            direction =
                glm::normalize(direction + (1.0F - hair.stiffness) * glm::vec3(0.0F, -0.6F, 0.0F) + 0.08F * wander);
            p += direction * step;
            // Kept outside the ball, at this hair's height in the coat.
            const glm::vec3 q = p / (semiAxesM * lift);
            if (glm::dot(q, q) < 1.0F)
                p = glm::normalize(q) * semiAxesM * lift;
            direction = glm::normalize(p - strand.nodesWo.back());
            p = strand.nodesWo.back() + direction * step;
            strand.nodesWo.push_back(p);
        }
        strands.push_back(std::move(strand));
    }
    return strands;
}

rendering::Scene emptyScene()
{
    rendering::Scene scene;
    scene.camera.targetWo = glm::vec3(0.0F);
    scene.camera.elevationRad = 0.0F;
    return scene;
}

std::vector<HandMadeStrand> comb(std::uint32_t colour, int count, float halfWidthM, float widthM)
{
    std::vector<HandMadeStrand> strands;
    for (int i = 0; i < count; ++i) {
        const float x = halfWidthM * (2.0F * (static_cast<float>(i) + 0.5F) / static_cast<float>(count) - 1.0F);
        strands.push_back(straightStrand(glm::vec3(x, 0.1F, 0.0F), glm::vec3(x, -0.1F, 0.0F), colour));
        strands.back().style.width = widthM / sim::StrandMaterial{}.widthM;
    }
    return strands;
}

sim::GroupSettings plainSettings()
{
    sim::GroupSettings settings;
    settings.material = {
        .shine = 0.0F, .roughness = 0.5F, .rootAlpha = 1.0F, .tipAlpha = 1.0F, .colourVariation = 0.0F};
    return settings;
}

} // namespace hairpaint::testing
