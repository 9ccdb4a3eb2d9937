// A small project in which nothing has its default, for tests of files.
#pragma once

#include "model/files/glb_writing.h"
#include "model/files/head_file.h"
#include "model/project/project.h"
#include "tests/support/test_heads.h"

#include <algorithm>
#include <vector>

namespace hairpaint::test {

/// A texel pattern with uniform tiles, gradients and steps, the same on every machine.
inline void paintPattern(sim::TiledRaster& raster, bool index, int seed)
{
    const auto coverage = static_cast<std::size_t>(raster.channels() - 1);
    for (const int tile : {0, 6}) {
        const sim::TexelRect rect = raster.tileRect(tile);
        for (int y = rect.y0; y < rect.y1; ++y)
            for (int x = rect.x0; x < rect.x1; ++x) {
                sim::Texel texel{};
                for (std::size_t channel = 0; channel < coverage; ++channel)
                    texel[channel] = static_cast<std::uint16_t>(index ? (x + y) / 16 % 2 : x * 251 + y * 13 + seed);
                texel[coverage] = static_cast<std::uint16_t>((x + y) % 5 == 0 ? 0 : (x % 64) * 1040);
                raster.setTexel(x, y, texel);
            }
    }
    sim::Texel full{};
    for (std::size_t channel = 0; channel < coverage; ++channel)
        full[channel] = index ? 1 : 40'000;
    full[coverage] = 65535;
    raster.setUniform(1, full);
}

inline constexpr float kSampleHeadCm = 4.0F; ///< Radius: what is measured around a head takes time by its volume.

/// `lacking`: maps that the file it is compared with has not: empty, with the last ids.
inline model::Project makeSampleProject(int mapSize = 256, const std::vector<model::MapKind>& lacking = {},
                                        float headCm = kSampleHeadCm)
{
    using namespace model;
    Project project;
    project.seed = 18'446'744'073'709'551'557ULL;
    project.maxHairs = 123'456;
    project.background = 0xFF102030;
    project.skin = model::SkinTone::Olive;
    const Result<std::shared_ptr<const Head>> head =
        makeHead(QStringLiteral("Kugel ä"), glbFromMesh(makeBallHead(12, headCm)), 0.01F, UpAxis::Z);
    project.head = *head;
    project.wind = {.enabled = false, .velocity = {1.1F, -2.2F, 3.3F}, .gustiness = 0.7F, .turbulence = 0.1F};
    project.light = {.azimuthRad = -1.5F,
                     .elevationRad = 0.25F,
                     .intensity = 2.5F,
                     .ambient = 0.125F,
                     .red = 0.9F,
                     .green = 0.8F,
                     .blue = 0.7F,
                     .temperatureK = 3200.0F,
                     .fill = 0.5F,
                     .rim = 1.5F,
                     .surroundings = Surroundings::Club,
                     .scattering = Scattering::KajiyaKay};
    const auto isLacking = [&](MapKind kind) { return std::ranges::find(lacking, kind) != lacking.end(); };
    for (int number = 0; number < 2; ++number) {
        HairGroup group = makeGroup(project, number == 0 ? QStringLiteral("Scalp \"1\"\n") : QString(), mapSize);
        group.visible = number == 0;
        sim::GroupSettings& s = group.settings;
        s.greatestDensityPerM2 = 1.23e6F;
        s.greatestLengthM = 0.1F + 0.2F * static_cast<float>(number);
        s.shortestLengthM = 0.003F;
        s.nodesPerHair = 13;
        s.basisHairs = 777;
        s.turnsMode = sim::TurnsMode::PerLength;
        s.steppedTurns = true;
        s.turnsPerLengthM = 0.07F;
        s.greatestCurlRadiusM = 0.017F;
        s.braidSpacingM = 0.111F;
        s.braidRadiusM = 0.0123F;
        s.lengthAsCut = true;
        s.curl = {.diameterM = 0.009F,
                  .pitchM = 0.018F,
                  .flatness = 0.4F,
                  .inStepFromM = 0.02F,
                  .switchbacksPerM = 10.0F,
                  .skips = 0.08F,
                  .uncoil = 0.2F,
                  .gather = 0.7F};
        s.locks = {
            .sizeM = 0.013F, .small = 0.4F, .flatness = 0.3F, .twistsPerM = 4.0F, .ragged = 0.6F, .parting = 0.2F};
        s.physics = {.damping = 3.3F,
                     .gravityScale = 0.9F,
                     .windScale = 1.7F,
                     .stiffnessM = 0.07F,
                     .friction = 0.66F,
                     .volumeM = 0.0099F};
        s.material = {.widthM = 71e-6F,
                      .shine = 0.77F,
                      .roughness = 0.22F,
                      .rootAlpha = 0.9F,
                      .tipAlpha = 0.1F,
                      .colourVariation = 0.3F};
        project.nextId = group.id + 1;
        for (SharedStack& stack : group.maps)
            if (!isLacking(stack->kind))
                stack.write().layers.front().id = project.takeId();
        for (const MapSpec& spec : mapSpecs()) {
            if (isLacking(spec.kind))
                continue;
            std::vector<Layer>& layers = group.map(spec.kind).layers;
            paintPattern(layers.front().raster, spec.texel == TexelKind::Index, layers.front().id);
            if (number == 0 && spec.kind == MapKind::Length) {
                Layer second = makeLayer(project, spec, mapSize, QStringLiteral("Obere Lage"));
                second.visible = false;
                second.opacity = 1.0F / 3.0F;
                second.blend = BlendMode::Multiply;
                second.locked = true;
                layers.push_back(std::move(second));
            }
        }
        project.groups.push_back(std::move(group));
    }
    project.nextId += 5;
    for (HairGroup& group : project.groups)
        for (const MapKind kind : lacking)
            group.map(kind).layers.front().id = project.takeId();
    project.setShapesOfHead(
        std::vector<sim::Ellipsoid>{{.centreHd = {0.01F, -0.02F, 0.3F}, .semiAxesM = {0.07F, 0.08F, 0.09F}},
                                    {.centreHd = {0.1F, 0.0F, 0.0F},
                                     .semiAxesM = {0.011F, 0.022F, 0.033F},
                                     .rotation = glm::quat(0.5F, 0.5F, -0.5F, 0.5F)}});
    return project;
}

/// Empty where both hold the same, else what differs.
inline QString difference(const model::Project& a, const model::Project& b)
{
    using namespace model;
    if (a.nextId != b.nextId || a.seed != b.seed || a.maxHairs != b.maxHairs || a.background != b.background ||
        a.skin != b.skin)
        return QStringLiteral("numbers");
    if (a.worn != b.worn)
        return QStringLiteral("what is worn");
    if (a.wind != b.wind || a.light != b.light)
        return QStringLiteral("wind or light");
    // Built-in heads are shared, and large.
    const bool isSameHead = a.head == b.head;
    if (!isSameHead &&
        (a.head->name != b.head->name || a.head->builtIn != b.head->builtIn || a.head->unitScale != b.head->unitScale ||
         a.head->upAxis != b.head->upAxis || a.head->sourceGlb != b.head->sourceGlb ||
         a.head->skin->mesh().positionsHd != b.head->skin->mesh().positionsHd ||
         a.head->skin->mesh().uvs != b.head->skin->mesh().uvs))
        return QStringLiteral("head");
    if (a.groups.size() != b.groups.size())
        return QStringLiteral("number of groups");
    for (std::size_t g = 0; g < a.groups.size(); ++g) {
        const HairGroup& one = a.groups[g];
        const HairGroup& other = b.groups[g];
        if (one.id != other.id || one.name != other.name || one.visible != other.visible ||
            one.settings != other.settings || one.maps.size() != other.maps.size())
            return QStringLiteral("group %1").arg(g);
        for (std::size_t m = 0; m < one.maps.size(); ++m) {
            const QString where = QStringLiteral("group %1, map %2").arg(g).arg(m);
            if (one.maps[m]->kind != other.maps[m]->kind || one.maps[m]->size != other.maps[m]->size ||
                one.maps[m]->layers.size() != other.maps[m]->layers.size())
                return where;
            for (std::size_t l = 0; l < one.maps[m]->layers.size(); ++l) {
                const Layer& x = one.maps[m]->layers[l];
                const Layer& y = other.maps[m]->layers[l];
                if (x.id != y.id || x.name != y.name || x.visible != y.visible || x.opacity != y.opacity ||
                    x.blend != y.blend || x.locked != y.locked)
                    return where + QStringLiteral(", a layer's properties");
                if (!(x.raster == y.raster))
                    return where + QStringLiteral(", a layer's texels");
            }
        }
    }
    return {};
}

/// Whether a message is one sentence that names the file.
inline bool isOneSentenceNaming(const QString& message, const QString& path)
{
    QString rest = message;
    const QString name = path.mid(path.lastIndexOf(QLatin1Char('/')) + 1);
    if (!rest.contains(name))
        return false;
    rest.remove(path).remove(name);
    return rest.endsWith(QLatin1Char('.')) && !rest.contains(QStringLiteral(". ")) &&
           !rest.contains(QLatin1Char('\n')) && rest.size() < 400;
}

} // namespace hairpaint::test
