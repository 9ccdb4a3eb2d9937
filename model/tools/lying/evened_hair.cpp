// Eight neighbours around a point, and itself.
#include "model/tools/lying/evened_hair.h"

#include "sim/base/rounded.h"

namespace hairpaint::model {

namespace {

constexpr float kEveningReach = 0.2F; ///< Distance of the neighbours, as a fraction of the brush's radius.
constexpr int kNeighbours = 8;

glm::vec2 neighbour(glm::vec2 uv, glm::vec2 reachUv, int index)
{
    constexpr float kTurn = 6.2831853F / kNeighbours;
    const float angle = kTurn * static_cast<float>(index);
    return uv + reachUv * glm::vec2(sim::cosRounded(angle), sim::sinRounded(angle));
}

} // namespace

glm::vec2 eveningReachUv(const Dab& brush, int mapSize)
{
    return glm::vec2(kEveningReach) / (static_cast<float>(mapSize) * glm::sqrt(glm::vec2(brush.a, brush.c)));
}

glm::vec2 evenedDirection(SkinFrames& frames, FallenHair& before, glm::vec2 uv, glm::vec2 reachUv)
{
    const std::optional<sim::SkinFrame> own = frames.at(uv);
    const glm::vec2 was = before.at(uv);
    if (!own)
        return was;
    glm::vec3 sum = own->toHd(was);
    float lengths = glm::length(was);
    float count = 1.0F;
    for (int i = 0; i < kNeighbours; ++i) {
        const glm::vec2 there = neighbour(uv, reachUv, i);
        if (const std::optional<sim::SkinFrame> frame = frames.at(there)) {
            const glm::vec2 beside = before.at(there);
            sum += frame->toHd(beside);
            lengths += glm::length(beside);
            count += 1.0F;
        }
    }
    const glm::vec2 mean = own->fromHd(sum) / count;
    const float length = glm::length(mean);
    return length > 1e-4F ? mean * (lengths / (count * length)) : mean;
}

float evenedScalar(const sim::TiledRaster& map, const sim::TiledRaster& density, glm::vec2 uv, glm::vec2 reachUv)
{
    const float own = map.sampleScalar(uv);
    float sum = own;
    float count = 1.0F;
    for (int i = 0; i < kNeighbours; ++i) {
        const glm::vec2 there = neighbour(uv, reachUv, i);
        if (density.sampleNearest(there)[0] == 0)
            continue;
        sum += map.sampleScalar(there);
        count += 1.0F;
    }
    return sum / count;
}

} // namespace hairpaint::model
