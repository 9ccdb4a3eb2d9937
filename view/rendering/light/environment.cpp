// Surroundings as sums of soft lamps before a dome.
#include "view/rendering/light/environment.h"

#include "sim/base/deterministic.h"

#include <array>
#include <span>

namespace hairpaint::rendering {
namespace {

/// A round lamp with a soft edge.
struct SoftLamp
{
    glm::vec3 directionWo;
    glm::vec3 colour; ///< Irradiance over pi that it casts at right angles.
    float spreadRad;  ///< Standard deviation of its brightness.
};

struct Surrounding
{
    glm::vec3 above, below; ///< Radiance of the dome, which fades between them.
    std::span<const SoftLamp> lamps;
};

/// A lobe max(0, cos) is 1/4 + 1/2 P1 + 5/16 P2 up to the second band; a Gaussian spread lessens each band.
void addLamp(Irradiance& e, const SoftLamp& lamp)
{
    const glm::vec3 d = glm::normalize(lamp.directionWo);
    const float variance = lamp.spreadRad * lamp.spreadRad;
    const float first = 0.5F * sim::expDet(-variance);
    const float second = 0.3125F * sim::expDet(-3.0F * variance);
    const std::array<float, 9> factors{0.25F,
                                       first * d.y,
                                       first * d.z,
                                       first * d.x,
                                       3.0F * second * d.x * d.y,
                                       3.0F * second * d.y * d.z,
                                       0.25F * second * (3.0F * d.z * d.z - 1.0F),
                                       3.0F * second * d.x * d.z,
                                       0.75F * second * (d.x * d.x - d.y * d.y)};
    for (std::size_t i = 0; i < e.size(); ++i)
        e[i] += lamp.colour * factors[i];
}

Irradiance irradianceFrom(const Surrounding& surrounding)
{
    Irradiance e{};
    e[0] = 0.5F * (surrounding.above + surrounding.below);
    e[1] = (surrounding.above - surrounding.below) / 3.0F;
    for (const SoftLamp& lamp : surrounding.lamps)
        addLamp(e, lamp);
    const float mean = glm::dot(e[0], glm::vec3(0.2126F, 0.7152F, 0.0722F));
    for (glm::vec3& band : e)
        band /= mean;
    return e;
}

constexpr std::array<SoftLamp, 4> kStudioLamps{{{{-0.8F, 0.35F, 0.5F}, {1.1F, 1.12F, 1.16F}, 0.35F},
                                                {{0.9F, 0.5F, 0.1F}, {0.9F, 0.88F, 0.85F}, 0.35F},
                                                {{0.0F, 1.0F, 0.1F}, {1.2F, 1.2F, 1.2F}, 0.45F},
                                                {{0.1F, 0.3F, -1.0F}, {0.8F, 0.82F, 0.86F}, 0.4F}}};
constexpr std::array<SoftLamp, 1> kDaylightLamps{{{{0.5F, 0.7F, 0.5F}, {0.5F, 0.47F, 0.42F}, 0.6F}}};
constexpr std::array<SoftLamp, 2> kSunsetLamps{
    {{{0.9F, 0.12F, -0.3F}, {2.6F, 1.1F, 0.35F}, 0.4F}, {{-0.8F, 0.4F, 0.4F}, {0.25F, 0.3F, 0.6F}, 0.7F}}};
constexpr std::array<SoftLamp, 3> kClubLamps{{{{-1.0F, 0.2F, 0.2F}, {1.9F, 0.12F, 1.5F}, 0.35F},
                                              {{1.0F, 0.2F, -0.1F}, {0.06F, 0.9F, 1.7F}, 0.35F},
                                              {{0.0F, 0.8F, -0.7F}, {0.5F, 0.1F, 0.9F}, 0.4F}}};

std::array<Irradiance, kEnvironmentCount> allEnvironments()
{
    return {irradianceFrom({{0.55F, 0.55F, 0.56F}, {0.3F, 0.29F, 0.28F}, kStudioLamps}),
            irradianceFrom({{0.75F, 0.95F, 1.25F}, {0.42F, 0.38F, 0.3F}, kDaylightLamps}),
            irradianceFrom({{0.35F, 0.36F, 0.55F}, {0.3F, 0.2F, 0.15F}, kSunsetLamps}),
            irradianceFrom({{0.12F, 0.08F, 0.2F}, {0.06F, 0.04F, 0.1F}, kClubLamps}),
            irradianceFrom({{1.0F, 1.0F, 1.0F}, {0.7F, 0.7F, 0.7F}, {}})};
}

} // namespace

const Irradiance& irradianceOf(EnvironmentKind surroundings)
{
    static const std::array<Irradiance, kEnvironmentCount> all = allEnvironments();
    return all.at(static_cast<std::size_t>(surroundings));
}

} // namespace hairpaint::rendering
