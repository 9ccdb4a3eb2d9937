// The built-in styles.
#include "styles.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::presets {

namespace {

float smooth(float from, float to, float x)
{
    const float t = std::clamp((x - from) / (to - from), 0.0F, 1.0F);
    return t * t * (3.0F - 2.0F * t);
}

/// Thin at the hairline, as hair grows, and full within `rampM`.
ScalarField scalp(float value, float rampM = 0.006F)
{
    return [=](const SkinPoint& point) { return value * smooth(-0.001F, rampM, point.scalpM); };
}

ScalarField constant(float value)
{
    return [=](const SkinPoint&) { return value; };
}

ColourField plain(const QColor& colour)
{
    return [=](const SkinPoint&) { return colour; };
}

/// What a comb drawn in direction `wanted` leaves, lifted off the skin by what `flatness` says.
glm::vec3 alongSkin(const SkinPoint& point, glm::vec3 wanted, float flatness)
{
    const glm::vec3 along = wanted - point.normalHd * glm::dot(wanted, point.normalHd);
    return along * (flatness / std::max(std::sqrt(glm::dot(along, along)), 1e-6F));
}

DirectionField upright()
{
    return [](const SkinPoint&) { return std::optional(glm::vec3(0.0F)); };
}

/// Lengths (of a greatest `greatestM`) under which hair that falls over the head ends at height `endY`: the way down
/// from the root, and the way over the crown for hair that grows on top.
ScalarField endingAt(float endY, float greatestM, float shortestM)
{
    return [=](const SkinPoint& point) {
        const float down = point.positionHd.y - endY;
        const float over = 0.045F * smooth(0.3F, 1.0F, point.normalHd.y);
        return std::clamp((std::max(down, shortestM) + over) / greatestM, 0.0F, 1.0F);
    };
}

sim::GroupSettings settings(float greatestLengthM, float stiffnessM, float volumeM)
{
    sim::GroupSettings result;
    result.basisHairs = 16384; // Some 3,700 on the scalp, 4 mm apart.
    result.greatestLengthM = greatestLengthM;
    result.physics.stiffnessM = stiffnessM;
    result.physics.volumeM = volumeM;
    return result;
}

Style longStraight()
{
    Style style{.id = "long-straight",
                .name = QStringLiteral("Long straight"),
                .tags = {QStringLiteral("long"), QStringLiteral("straight")},
                .settings = settings(0.50F, 0.05F, 0.008F),
                .density = scalp(0.85F),
                .length = endingAt(-0.26F, 0.50F, 0.12F),
                .curl = constant(0.06F),
                .clump = constant(0.30F),
                .gel = constant(0.0F),
                .braid = {},
                .colour = plain(QColor(0x4E, 0x30, 0x1D))};
    // Its slight wave keeps its length where hair is cut short.
    style.settings.turnsMode = sim::TurnsMode::PerLength;
    style.settings.turnsPerLengthM = 0.40F;
    style.settings.greatestCurlRadiusM = 0.010F;
    style.settings.nodesPerHair = 12;
    style.settings.material.shine = 0.6F;
    return style;
}

Style bob()
{
    Style style{.id = "bob",
                .name = QStringLiteral("Bob"),
                .tags = {QStringLiteral("medium"), QStringLiteral("straight")},
                .settings = settings(0.25F, 0.055F, 0.010F),
                .density = {},
                .length = endingAt(-0.085F, 0.25F, 0.10F),
                .curl = constant(0.0F),
                .clump = constant(0.25F),
                .gel = constant(0.0F),
                .braid = {},
                .colour = plain(QColor(0x1E, 0x19, 0x1B))};
    // Shaved below, as in an undercut: hair from lower roots that ended at the line would be short enough to stand off.
    style.density = [](const SkinPoint& point) {
        return 0.9F * smooth(-0.001F, 0.006F, point.scalpM) * smooth(0.008F, 0.014F, point.positionHd.y);
    };
    style.settings.nodesPerHair = 10;
    style.settings.material.shine = 0.75F;
    style.settings.material.roughness = 0.28F;
    style.settings.material.tipAlpha = 0.7F;
    return style;
}

Style ringlets()
{
    Style style{.id = "ringlets",
                .name = QStringLiteral("Ringlets"),
                .tags = {QStringLiteral("medium"), QStringLiteral("curly")},
                .settings = settings(0.30F, 0.05F, 0.020F),
                .density = scalp(0.75F),
                .length = endingAt(-0.13F, 0.30F, 0.09F),
                .curl = constant(0.66F),
                .clump = constant(0.93F),
                .gel = constant(0.0F),
                .braid = {},
                .colour = plain(QColor(0x70, 0x30, 0x18))};
    style.settings.greatestCurlRadiusM = 0.018F;
    // One ringlet a basis hair.
    style.settings.basisHairs = 1800;
    return style;
}

Style afro()
{
    Style style{.id = "round-afro",
                .name = QStringLiteral("Round afro"),
                .tags = {QStringLiteral("short"), QStringLiteral("coily")},
                .settings = settings(0.12F, 0.10F, 0.0F),
                .density = scalp(0.8F),
                .length = {},
                .curl = constant(0.9F),
                .clump = constant(0.55F),
                .gel = constant(0.92F),
                .braid = {},
                .colour = plain(QColor(0x24, 0x17, 0x12))};
    // Cut to a ball around the head's middle, which lets the face free.
    style.length = [](const SkinPoint& point) {
        const glm::vec3 fromMiddle = point.positionHd - glm::vec3(0.0F, 0.045F, -0.030F);
        const float along = glm::dot(fromMiddle, point.normalHd);
        const float radiusM = 0.166F;
        const float inside = radiusM * radiusM - glm::dot(fromMiddle, fromMiddle) + along * along;
        const float lengthM = std::clamp(std::sqrt(std::max(inside, 0.0F)) - along, 0.012F, 0.1F);
        const float edge = 0.25F + 0.75F * smooth(0.0F, 0.045F, point.scalpM);
        return lengthM * edge / 0.12F;
    };
    style.direction = upright();
    style.settings.greatestCurlRadiusM = 0.012F;
    style.settings.basisHairs = 8000;
    style.settings.material.shine = 0.25F;
    return style;
}

Style twoPlaits()
{
    Style style{.id = "two-plaits",
                .name = QStringLiteral("Two plaits"),
                .tags = {QStringLiteral("long"), QStringLiteral("braided")},
                .settings = settings(0.40F, 0.04F, 0.006F),
                .density = scalp(0.7F),
                .length = constant(0.70F),
                .curl = constant(0.0F),
                .clump = constant(0.0F),
                .gel = constant(0.0F),
                .braid = {},
                .colour = plain(QColor(0x6A, 0x4C, 0x2E))};
    // The parting stays free, so that each side is a region of its own.
    style.braid = [](const SkinPoint& point) {
        return std::abs(point.positionHd.x) > 0.005F && point.scalpM > -0.005F ? 1.0F : 0.0F;
    };
    style.density = [](const SkinPoint& point) {
        return 0.7F * smooth(-0.001F, 0.006F, point.scalpM) * smooth(0.0058F, 0.0068F, std::abs(point.positionHd.x));
    };
    style.settings.braidSpacingM = 0.6F;
    style.settings.braidRadiusM = 0.011F;
    style.settings.nodesPerHair = 16;
    return style;
}

Style mohawk()
{
    Style style{.id = "gelled-mohawk",
                .name = QStringLiteral("Gelled mohawk"),
                .tags = {QStringLiteral("short"), QStringLiteral("gelled")},
                .settings = settings(0.15F, 0.10F, 0.0F),
                .density = scalp(0.8F),
                .length = {},
                .curl = constant(0.0F),
                .clump = constant(0.0F),
                .gel = constant(1.0F),
                .braid = {},
                .colour = {}};
    const auto crest = [](const SkinPoint& point) {
        return 1.0F - smooth(0.015F, 0.020F, std::abs(point.positionHd.x));
    };
    style.length = [crest](const SkinPoint& point) {
        const float high = 0.115F * (0.55F + 0.45F * smooth(-0.06F, 0.06F, point.positionHd.y));
        const float shaved = 0.003F;
        return (shaved + (high - shaved) * crest(point)) / 0.15F;
    };
    style.density = [crest](const SkinPoint& point) {
        return smooth(-0.001F, 0.005F, point.scalpM) * (0.55F + 0.4F * crest(point));
    };
    style.clump = [crest](const SkinPoint& point) { return 0.85F * crest(point); };
    style.direction = [crest](const SkinPoint& point) {
        return crest(point) > 0.0F ? std::optional(glm::vec3(0.0F)) : std::nullopt;
    };
    style.colour = [crest](const SkinPoint& point) {
        return crest(point) > 0.5F ? QColor(0x18, 0x6E, 0x66) : QColor(0x2A, 0x22, 0x1E);
    };
    style.settings.material.tipAlpha = 0.8F;
    return style;
}

Style splitDye()
{
    Style style{.id = "split-dye",
                .name = QStringLiteral("Split dye"),
                .tags = {QStringLiteral("medium"), QStringLiteral("wavy"), QStringLiteral("coloured")},
                .settings = settings(0.34F, 0.05F, 0.014F),
                .density = {},
                .length = endingAt(-0.155F, 0.34F, 0.09F),
                .curl = constant(0.36F),
                .clump = constant(0.8F),
                .gel = constant(0.0F),
                .braid = {},
                .colour = {}};
    // A clean parting, so that neither colour strays into the other.
    style.density = [](const SkinPoint& point) {
        return 0.85F * smooth(-0.001F, 0.006F, point.scalpM) * smooth(0.0018F, 0.0035F, std::abs(point.positionHd.x));
    };
    style.colour = [](const SkinPoint& point) {
        return point.positionHd.x > 0.0F ? QColor(0xA0, 0x24, 0x5C) : QColor(0x22, 0x1C, 0x22);
    };
    style.settings.greatestCurlRadiusM = 0.018F;
    style.settings.nodesPerHair = 10;
    style.settings.basisHairs = 8000;
    return style;
}

Style buzzCut()
{
    Style style{.id = "buzz-cut",
                .name = QStringLiteral("Buzz cut"),
                .tags = {QStringLiteral("short"), QStringLiteral("straight")},
                .settings = settings(0.03F, 0.06F, 0.0F),
                .density = scalp(0.95F, 0.012F),
                .length = {},
                .curl = constant(0.0F),
                .clump = constant(0.0F),
                .gel = constant(0.0F),
                .braid = {},
                .colour = plain(QColor(0x3A, 0x2B, 0x22))};
    // Faded toward the hairline, as clippers leave it.
    style.length = [](const SkinPoint& point) {
        return (0.003F + 0.006F * smooth(0.0F, 0.045F, point.scalpM)) / 0.03F;
    };
    style.settings.nodesPerHair = 4;
    style.settings.material.widthM = 100e-6F; // Stubble is thick against its length.
    style.settings.material.tipAlpha = 0.6F;
    style.settings.material.shine = 0.3F;
    return style;
}

/// 1 on top of the head, over the ridge where clippers stop.
float topOf(const SkinPoint& point)
{
    return smooth(0.047F, 0.058F, point.positionHd.y + 0.10F * std::max(0.0F, -point.positionHd.z - 0.06F));
}

/// A fade: `shortestM` at the hairline, `ridgeM` under the ridge, `topM` over it.
ScalarField faded(float shortestM, float ridgeM, const ScalarField& topM, float greatestM)
{
    return [=](const SkinPoint& point) {
        const float side = shortestM + (ridgeM - shortestM) * smooth(0.005F, 0.05F, point.scalpM);
        return (side + (topM(point) - side) * topOf(point)) / greatestM;
    };
}

Style slickedUndercut()
{
    Style style{.id = "slicked-undercut",
                .name = QStringLiteral("Slicked undercut"),
                .tags = {QStringLiteral("short"), QStringLiteral("gelled")},
                .settings = settings(0.15F, 0.05F, 0.004F),
                .density = scalp(0.95F, 0.010F),
                .length = faded(0.003F, 0.006F, constant(0.115F), 0.15F),
                .curl = constant(0.0F),
                .clump = {},
                .gel = [](const SkinPoint& point) { return 0.5F * topOf(point); },
                .braid = {},
                .colour = plain(QColor(0x2C, 0x1D, 0x14)),
                .direction = [](const SkinPoint& point) -> std::optional<glm::vec3> {
                    if (topOf(point) <= 0.0F)
                        return std::nullopt;
                    return alongSkin(point, {-0.6F * point.positionHd.x / 0.06F * 0.2F, -0.15F, -1.0F}, 0.95F);
                }};
    style.clump = [](const SkinPoint& point) { return 0.45F * topOf(point); };
    style.settings.nodesPerHair = 10;
    style.settings.material.shine = 0.8F;
    style.settings.material.roughness = 0.25F;
    style.settings.material.tipAlpha = 0.7F;
    return style;
}

Style quiff()
{
    const auto front = [](const SkinPoint& point) { return smooth(0.0F, 0.07F, point.positionHd.z); };
    Style style{.id = "quiff",
                .name = QStringLiteral("Quiff"),
                .tags = {QStringLiteral("short"), QStringLiteral("gelled")},
                .settings = settings(0.15F, 0.06F, 0.010F),
                .density = scalp(0.95F, 0.010F),
                .length = faded(
                    0.004F, 0.014F, [front](const SkinPoint& point) { return 0.045F + 0.030F * front(point); }, 0.15F),
                .curl = constant(0.0F),
                .clump = {},
                .gel = [front](const SkinPoint& point) { return topOf(point) * (0.35F + 0.35F * front(point)); },
                .braid = {},
                .colour = plain(QColor(0x5B, 0x3A, 0x22)),
                .direction = [front](const SkinPoint& point) -> std::optional<glm::vec3> {
                    if (topOf(point) <= 0.0F)
                        return std::nullopt;
                    // Up at the front, ever flatter behind it, and a little to one side.
                    const float flatness = 0.92F - 0.40F * front(point);
                    return alongSkin(point, {-0.25F, 0.0F, -1.0F}, flatness);
                }};
    style.clump = [](const SkinPoint& point) { return 0.4F * topOf(point); };
    style.settings.nodesPerHair = 8;
    style.settings.material.shine = 0.55F;
    style.settings.material.tipAlpha = 0.7F;
    return style;
}

Style sidePart()
{
    constexpr float kPartM = 0.030F; // On the head's left.
    Style style{.id = "side-part",
                .name = QStringLiteral("Side part"),
                .tags = {QStringLiteral("short"), QStringLiteral("straight")},
                .settings = settings(0.15F, 0.05F, 0.006F),
                .density = {},
                .length = faded(0.006F, 0.018F, constant(0.080F), 0.15F),
                .curl = constant(0.02F),
                .clump = constant(0.25F),
                .gel = [](const SkinPoint& point) { return 0.35F * topOf(point); },
                .braid = {},
                .colour = plain(QColor(0x6B, 0x43, 0x25)),
                .direction = [](const SkinPoint& point) -> std::optional<glm::vec3> {
                    const float top = topOf(point);
                    if (top <= 0.0F || point.positionHd.z < -0.06F)
                        return std::nullopt;
                    const bool wide = point.positionHd.x < kPartM;
                    return alongSkin(point, {wide ? -1.0F : 1.0F, -0.3F, wide ? 0.15F : -0.35F}, 0.93F);
                }};
    style.density = [](const SkinPoint& point) {
        const bool parted = topOf(point) > 0.0F && point.positionHd.z > -0.063F;
        const float gap = parted ? smooth(0.0006F, 0.0016F, std::abs(point.positionHd.x - kPartM)) : 1.0F;
        return 0.95F * smooth(-0.001F, 0.010F, point.scalpM) * gap;
    };
    style.settings.nodesPerHair = 10;
    style.settings.material.shine = 0.6F;
    style.settings.material.tipAlpha = 0.7F;
    return style;
}

Style frenchCrop()
{
    Style style{.id = "french-crop",
                .name = QStringLiteral("French crop"),
                .tags = {QStringLiteral("short"), QStringLiteral("straight")},
                .settings = settings(0.10F, 0.05F, 0.008F),
                .density = scalp(0.95F, 0.010F),
                .length = faded(0.003F, 0.009F, constant(0.042F), 0.10F),
                .curl = constant(0.03F),
                .clump = {},
                .gel = constant(0.0F),
                .braid = {},
                .colour = plain(QColor(0x33, 0x24, 0x1C))};
    style.clump = [](const SkinPoint& point) { return 0.5F * topOf(point); };
    style.settings.greatestCurlRadiusM = 0.008F;
    style.settings.nodesPerHair = 8;
    style.settings.material.tipAlpha = 0.6F;
    return style;
}

} // namespace

std::vector<Style> builtInStyles()
{
    return {longStraight(), bob(),     ringlets(),        afro(),  twoPlaits(), mohawk(),
            splitDye(),     buzzCut(), slickedUndercut(), quiff(), sidePart(),  frenchCrop()};
}

} // namespace hairpaint::presets
