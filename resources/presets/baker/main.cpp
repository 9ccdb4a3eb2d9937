// Bakes the built-in styles: hairpaint_preset_baker FOLDER writes one .hairpreset a style, with its picture, and
// order.txt.
#include "app/cli/settled_hair.h"
#include "app/picture.h"
#include "bust_landmarks.h"
#include "model/commands/commands.h"
#include "model/files/head_file.h"
#include "model/files/preset_file.h"
#include "model/files/project_file.h"
#include "model/preset.h"
#include "styles.h"

#include <QCoreApplication>
#include <QFile>

#include <cmath>
#include <cstdio>

namespace hairpaint::presets {

namespace {

constexpr int kMapSize = 512;
constexpr QSize kPictureSize(192, 192);
constexpr QSize kWholeSize(480, 480);
constexpr QRect kHeadPart(105, 18, 276, 276); ///< Of the whole picture: the bust's foot is no hair.

std::uint16_t texelValue(float value)
{
    return static_cast<std::uint16_t>(std::lround(std::clamp(value, 0.0F, 1.0F) * 65535.0F));
}

sim::Texel valueAt(const Style& style, const model::MapSpec& spec, const Place& place)
{
    const auto scalar = [&place](const ScalarField& field) { return sim::Texel{texelValue(field(place)), 65535}; };
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
        return {static_cast<std::uint16_t>(style.braid ? style.braid(place) : 0.0F), 65535};
    case model::MapKind::Colour: {
        const QColor colour = style.colour(place);
        return {texelValue(colour.redF()), texelValue(colour.greenF()), texelValue(colour.blueF()), 65535};
    }
    }
    return {};
}

/// Every place that a texel shows, so that it is looked up once for all maps.
std::vector<std::optional<Place>> placesOf(const sim::Skin& skin)
{
    std::vector<std::optional<Place>> places(static_cast<std::size_t>(kMapSize) * kMapSize);
    for (int y = 0; y < kMapSize; ++y)
        for (int x = 0; x < kMapSize; ++x) {
            const glm::vec2 uv((static_cast<float>(x) + 0.5F) / kMapSize,
                               1.0F - (static_cast<float>(y) + 0.5F) / kMapSize);
            if (const std::optional<sim::SurfacePoint> point = skin.atUv(uv))
                places[static_cast<std::size_t>(y) * kMapSize + static_cast<std::size_t>(x)] =
                    Place{.positionHd = point->positionHd,
                          .normalHd = point->normalHd,
                          .scalpM = heads::scalpDistance(point->positionHd)};
        }
    return places;
}

model::Preset bake(const Style& style, const std::vector<std::optional<Place>>& places)
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
                if (const auto& place = places[static_cast<std::size_t>(y) * kMapSize + static_cast<std::size_t>(x)])
                    raster.setTexel(x, y, valueAt(style, spec, *place));
        for (int tile = 0; tile < raster.tileCount(); ++tile)
            raster.compact(tile);
    }
    model::Preset preset = model::presetFrom(project, style.name);
    preset.tags = style.tags;
    return preset;
}

/// The style as it hangs after two calm seconds.
QImage pictureOf(const model::Preset& preset, app::PictureMaker& maker)
{
    model::Project project = model::newProject();
    model::applyPreset(project, preset);
    project.wind.enabled = false;
    const app::SettledHair hair(project, 2.0);
    const QImage whole = maker.take(project, hair.frame(), rendering::StandardView::ThreeQuarter, kWholeSize);
    return whole.copy(kHeadPart).scaled(kPictureSize, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

int run(const QString& folder)
{
    model::Result<std::unique_ptr<app::PictureMaker>> maker = app::PictureMaker::create();
    if (!maker) {
        std::fprintf(stderr, "%s\n", qPrintable(maker.error().message));
        return 1;
    }
    const std::vector<std::optional<Place>> places = placesOf(*model::builtInHead()->skin);
    QByteArray order;
    for (const Style& style : builtInStyles()) {
        model::Preset preset = bake(style, places);
        preset.picture = pictureOf(preset, **maker);
        const QString path = folder + QLatin1Char('/') + QLatin1StringView(style.id) + QStringLiteral(".hairpreset");
        if (const model::Result<void> saved = model::savePreset(preset, path); !saved) {
            std::fprintf(stderr, "%s\n", qPrintable(saved.error().message));
            return 1;
        }
        order += QByteArray(style.id) + '\n';
    }
    QFile list(folder + QStringLiteral("/order.txt"));
    return list.open(QIODevice::WriteOnly) && list.write(order) == order.size() ? 0 : 1;
}

} // namespace

} // namespace hairpaint::presets

int main(int argc, char** argv)
{
    QCoreApplication application(argc, argv);
    if (argc != 2) {
        std::fputs("Usage: hairpaint_preset_baker FOLDER\n", stderr);
        return 2;
    }
    return hairpaint::presets::run(QString::fromLocal8Bit(argv[1]));
}
