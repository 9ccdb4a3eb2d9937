// Asks a style's functions for the value of every texel.
#include "bake.h"

#include "model/files/project_file.h"
#include "model/heads/built_in_heads.h"
#include "sim/groom/direction_texel.h"

#include <cmath>

namespace hairpaint::presets {

namespace {

constexpr int kMapSize = 512;

std::uint16_t texelValue(float value)
{
    return static_cast<std::uint16_t>(std::lround(std::clamp(value, 0.0F, 1.0F) * 65535.0F));
}

sim::Texel valueAt(const Style& style, const model::MapSpec& spec, const SkinPoint& point)
{
    const auto scalar = [&point](const ScalarField& field) { return sim::Texel{texelValue(field(point)), 65535}; };
    switch (spec.kind) {
    case model::MapKind::Density:
        return scalar(style.density);
    case model::MapKind::Length:
        return scalar(style.length);
    case model::MapKind::Curl:
        return scalar(style.curl);
    case model::MapKind::Clump:
        return scalar(style.clump);
    case model::MapKind::Gel:
        return scalar(style.gel);
    case model::MapKind::Braid:
        return {static_cast<std::uint16_t>(style.braid ? style.braid(point) : 0.0F), 65535};
    case model::MapKind::Colour: {
        const QColor colour = style.colour(point);
        return {texelValue(colour.redF()), texelValue(colour.greenF()), texelValue(colour.blueF()), 65535};
    }
    case model::MapKind::Direction: {
        const std::optional<glm::vec3> along = style.direction ? style.direction(point) : std::nullopt;
        if (!along)
            return sim::texelOfDirection({}); // Not painted: as hair naturally lies.
        sim::Texel texel = sim::texelOfDirection(point.frame.fromHd(*along));
        texel[2] = 65535;
        return texel;
    }
    default:
        return spec.defaultValue; // Not painted.
    }
}

} // namespace

SkinPoints pointsOn(const sim::Skin& skin)
{
    const heads::HeadRegions& regions = heads::builtInHeads().front()->regions;
    SkinPoints points(static_cast<std::size_t>(kMapSize) * kMapSize);
    for (int y = 0; y < kMapSize; ++y)
        for (int x = 0; x < kMapSize; ++x) {
            const glm::vec2 uv((static_cast<float>(x) + 0.5F) / kMapSize,
                               1.0F - (static_cast<float>(y) + 0.5F) / kMapSize);
            if (const std::optional<sim::SurfacePoint> point = skin.atUv(uv))
                points[static_cast<std::size_t>(y) * kMapSize + static_cast<std::size_t>(x)] =
                    SkinPoint{.positionHd = point->positionHd,
                              .normalHd = point->normalHd,
                              .scalpM = regions.scalpDistance(point->positionHd),
                              .frame = sim::SkinFrame::at(*point)};
        }
    return points;
}

model::Preset bake(const Style& style, const SkinPoints& points)
{
    model::Project project = model::newProject();
    model::HairGroup& group = project.groups.front();
    group.settings = style.settings;
    for (const model::MapSpec& spec : model::mapSpecs()) {
        model::MapStack& stack = group.map(spec.kind);
        stack.size = kMapSize;
        stack.layers = {model::makeLayer(project, spec, kMapSize, style.name)};
        sim::TiledRaster& raster = stack.layers.front().raster;
        for (int y = 0; y < kMapSize; ++y)
            for (int x = 0; x < kMapSize; ++x)
                if (const auto& point = points[static_cast<std::size_t>(y) * kMapSize + static_cast<std::size_t>(x)])
                    raster.setTexel(x, y, valueAt(style, spec, *point));
        for (int tile = 0; tile < raster.tileCount(); ++tile)
            raster.compact(tile);
    }
    model::Preset preset = model::presetFrom(project, style.name);
    preset.tags = style.tags;
    return preset;
}

} // namespace hairpaint::presets
