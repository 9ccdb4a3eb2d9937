// Bakes the built-in styles: hairpaint_preset_baker FOLDER writes one .hairpreset a style, with its picture, and
// order.txt.
#include "app/cli/settled_hair.h"
#include "app/picture.h"
#include "bake.h"
#include "model/commands/commands.h"
#include "model/files/head_file.h"
#include "model/files/preset_file.h"
#include "model/files/project_file.h"
#include "model/preset.h"
#include "styles.h"

#include <QCoreApplication>
#include <QFile>

#include <cstdio>

namespace hairpaint::presets {

namespace {

constexpr QSize kPictureSize(192, 192);
constexpr QSize kWholeSize(480, 480);
constexpr QRect kHeadPart(105, 18, 276, 276); ///< Of the whole picture: the bust's foot is no hair.

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
    const Places places = placesOn(*model::builtInHead()->skin);
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
