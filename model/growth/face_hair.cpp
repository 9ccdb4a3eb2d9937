// Painted by distances along the skin.
#include "model/growth/face_hair.h"

#include "model/files/head_file.h"
#include "model/heads/built_in_heads.h"
#include "model/maps/texel_ops.h"
#include "model/styles/hair_kinds.h"
#include "model/styles/style_transfer.h"
#include "model/values/texel_math.h"

#include <QLatin1StringView>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace hairpaint::model {

namespace {

constexpr int kFineMapSize = 2048; ///< A lid's edge is a millimetre wide.
constexpr int kMapSize = 1024;
constexpr float kReachM = 0.004F;
constexpr QRgb kBrown = 0xFF33241B;

/// What grows at a point of the skin, each 0..1.
struct Growth
{
    float density = 0.0F;
    float length = 0.0F;
};

struct FaceGroup
{
    const char* kind; ///< A HairKind's name.
    int mapSize;
    /// Roughly how far within the region a point is, m; nothing grows further out than kReachM.
    float (*inside)(const heads::HeadRegions& regions, const glm::vec3& positionHd);
    Growth (*at)(const heads::HeadRegions& regions, const glm::vec3& positionHd);
};

float faded(float from, float to, float x)
{
    const float t = std::clamp((x - from) / (to - from), 0.0F, 1.0F);
    return t * t * (3.0F - 2.0F * t);
}

constexpr std::array kFaceGroups{
    // All of the scalp, thinner over the last centimetre of the hairline.
    FaceGroup{"Scalp", kMapSize,
              [](const heads::HeadRegions& regions, const glm::vec3& positionHd) {
                  return regions.scalpDistance(positionHd);
              },
              [](const heads::HeadRegions& regions, const glm::vec3& positionHd) {
                  return Growth{.density = faded(-0.003F, 0.007F, regions.scalpDistance(positionHd)), .length = 0.5F};
              }},
    FaceGroup{
        "Brows", kFineMapSize,
        [](const heads::HeadRegions& regions, const glm::vec3& positionHd) { return regions.browDistance(positionHd); },
        [](const heads::HeadRegions& regions, const glm::vec3& positionHd) {
            const float inside = regions.browDistance(positionHd);
            return Growth{.density = faded(-0.0008F, 0.0022F, inside),
                          .length = 0.25F + 0.20F * faded(0.0F, 0.0035F, inside)};
        }},
    FaceGroup{"Lashes", kFineMapSize,
              [](const heads::HeadRegions& regions, const glm::vec3& positionHd) {
                  return -regions.lashDistance(positionHd);
              },
              [](const heads::HeadRegions& regions, const glm::vec3& positionHd) {
                  float along = 0.0F;
                  const float distance = regions.lashDistance(positionHd, &along);
                  const float fromCorner = std::min(along, 1.0F - along);
                  return Growth{.density = 1.0F - faded(0.0008F, 0.0014F, distance),
                                .length = 0.35F + 0.25F * faded(0.0F, 0.3F, fromCorner) + 0.20F * along};
              }},
    // A full beard of 2 cm, thinner and shorter toward its edge, thickest on lip and chin.
    FaceGroup{"Beard", kMapSize,
              [](const heads::HeadRegions& regions, const glm::vec3& positionHd) {
                  return regions.beardDistance(positionHd);
              },
              [](const heads::HeadRegions& regions, const glm::vec3& positionHd) {
                  const float inside = regions.beardDistance(positionHd);
                  const float cheek = faded(0.025F, 0.045F, std::abs(positionHd.x));
                  return Growth{.density = faded(-0.003F, 0.0025F * cheek - 0.001F, inside) * (1.0F - 0.25F * cheek),
                                .length = 0.12F + 0.14F * faded(0.0F, 0.010F, inside)};
              }},
};

/// Paints density and length where something grows.
void paint(HairGroup& group, const FaceGroup& what, const Head& head)
{
    const heads::HeadRegions& regions = heads::headRows().front()->regions;
    sim::TiledRaster& density = group.map(MapKind::Density).layers.front().raster;
    sim::TiledRaster& length = group.map(MapKind::Length).layers.front().raster;
    // Faces whose vertices lie near by are enough: what grows is wider than they are.
    const sim::HeadMesh& mesh = head.skin->mesh();
    const auto side = static_cast<float>(what.mapSize);
    for (const glm::uvec3& t : mesh.triangles) {
        glm::vec2 low(1.0F);
        glm::vec2 high(0.0F);
        bool grows = false;
        for (int corner = 0; corner < 3; ++corner) {
            const glm::vec3& positionHd = mesh.positionsHd[t[corner]];
            grows = grows || what.inside(regions, positionHd) > -kReachM;
            low = glm::min(low, mesh.uvs[t[corner]]);
            high = glm::max(high, mesh.uvs[t[corner]]);
        }
        if (!grows)
            continue;
        const glm::ivec2 first(static_cast<int>(low.x * side), static_cast<int>((1.0F - high.y) * side));
        const glm::ivec2 last(static_cast<int>(high.x * side), static_cast<int>((1.0F - low.y) * side));
        for (int y = std::max(first.y, 0); y <= std::min(last.y, what.mapSize - 1); ++y)
            for (int x = std::max(first.x, 0); x <= std::min(last.x, what.mapSize - 1); ++x) {
                const glm::vec2 uv((static_cast<float>(x) + 0.5F) / side, 1.0F - (static_cast<float>(y) + 0.5F) / side);
                const std::optional<sim::SurfacePoint> point = head.skin->atUv(uv);
                const Growth growth = point ? what.at(regions, point->positionHd) : Growth{};
                if (growth.density <= 0.0F)
                    continue;
                density.setTexel(x, y, {unit16(growth.density), 65535});
                length.setTexel(x, y, {unit16(growth.length), 65535});
            }
    }
}

HairGroup grown(Project& project, const FaceGroup& what, const Head& head)
{
    HairGroup group = makeGroup(project, QString::fromLatin1(what.kind), what.mapSize);
    const auto kinds = hairKinds();
    const auto kind = std::ranges::find_if(
        kinds, [&](const HairKind& one) { return QLatin1StringView(one.name) == QLatin1StringView(what.kind); });
    kind->apply(group.settings);
    paint(group, what, head);
    PaintValue brown;
    brown.colour = QColor::fromRgb(kBrown);
    const MapSpec& colour = mapSpec(MapKind::Colour);
    sim::Texel texel = texelOf(colour, brown);
    texel[static_cast<std::size_t>(colour.valueChannels)] = 65535;
    Layer& layer = group.map(MapKind::Colour).layers.front();
    layer.raster = sim::TiledRaster(layer.raster.size(), layer.raster.channels(), texel);
    return group;
}

std::optional<std::vector<HairGroup>> grownWhere(const std::function<bool(const FaceGroup&)>& wanted,
                                                 const std::shared_ptr<const Head>& head, const Progress& progress)
{
    const std::shared_ptr<const Head> known = defaultHead();
    if (head != known && !canCarry(known, head))
        return std::vector<HairGroup>();
    Project project;
    project.head = known;
    std::vector<HairGroup> groups;
    for (const FaceGroup& what : kFaceGroups)
        if (wanted(what))
            groups.push_back(grown(project, what, *known));
    return head == known || groups.empty() ? groups : carriedGroups(std::move(groups), known, head, progress);
}

} // namespace

std::optional<std::vector<HairGroup>> faceHair(const std::shared_ptr<const Head>& head, const Progress& progress)
{
    const auto isWanted = [](const FaceGroup& one) {
        return std::ranges::any_of(hairKinds(), [&](const HairKind& kind) {
            return kind.ofEveryFace && QLatin1StringView(kind.name) == QLatin1StringView(one.kind);
        });
    };
    return grownWhere(isWanted, head, progress);
}

std::optional<HairGroup> grownHair(const HairKind& kind, const std::shared_ptr<const Head>& head,
                                   const Progress& progress)
{
    std::optional<std::vector<HairGroup>> groups =
        grownWhere([&](const FaceGroup& one) { return QLatin1StringView(one.kind) == QLatin1StringView(kind.name); },
                   head, progress);
    return groups && !groups->empty() ? std::optional<HairGroup>(std::move(groups->front())) : std::nullopt;
}

} // namespace hairpaint::model
