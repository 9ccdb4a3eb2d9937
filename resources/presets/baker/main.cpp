// Bakes the built-in styles: hairpaint_preset_baker FOLDER writes one .hairpreset a style, with its picture, and
// order.txt.
#include "app/picture.h"
#include "app/style_pictures.h"
#include "bake.h"
#include "model/files/head_file.h"
#include "model/files/preset_file.h"
#include "model/preset.h"
#include "styles.h"

#include <QCoreApplication>
#include <QFile>

#include <cstdio>

namespace hairpaint::presets {

namespace {

int run(const QString& folder)
{
    model::Result<std::unique_ptr<app::PictureMaker>> maker = app::PictureMaker::create();
    if (!maker) {
        std::fprintf(stderr, "%s\n", qPrintable(maker.error().message));
        return 1;
    }
    const SkinPoints points = pointsOn(*model::builtInHead()->skin);
    QByteArray order;
    for (const Style& style : builtInStyles()) {
        model::Preset preset = bake(style, points);
        preset.picture = app::stylePicture(preset, **maker);
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
