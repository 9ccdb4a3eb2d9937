// Bakes the built-in styles: hairpaint_preset_baker FOLDER writes one .hairpreset a style, with its picture, and
// order.txt; hairpaint_preset_baker FOLDER ID... only those styles.
#include "app/headless/picture.h"
#include "app/styles/style_pictures.h"
#include "model/files/preset_file.h"
#include "model/styles/preset.h"
#include "slimming.h"
#include "styles.h"

#include <QCoreApplication>
#include <QFile>
#include <QStringList>

#include <cstdio>

namespace hairpaint::presets {

namespace {

int run(const QString& folder, const QStringList& wanted)
{
    app::PictureMaker maker;
    GrownHair grown;
    QByteArray order;
    for (const Style& style : builtInStyles()) {
        order += QByteArray(style.id) + '\n';
        if (!wanted.isEmpty() && !wanted.contains(QLatin1StringView(style.id)))
            continue;
        model::Preset preset = played(style, grown);
        preset.picture = app::stylePicture(preset, maker);
        const QString path = folder + QLatin1Char('/') + QLatin1StringView(style.id) + QStringLiteral(".hairpreset");
        if (const model::Result<void> saved = model::savePreset(preset, path); !saved) {
            std::fprintf(stderr, "%s\n", qPrintable(saved.error().message));
            return 1;
        }
        if (const model::Checked<void> slimmed = slim(path); !slimmed) {
            std::fprintf(stderr, "%s: %s\n", qPrintable(path), qPrintable(slimmed.error().text));
            return 1;
        }
    }
    QFile list(folder + QStringLiteral("/order.txt"));
    return list.open(QIODevice::WriteOnly) && list.write(order) == order.size() ? 0 : 1;
}

} // namespace

} // namespace hairpaint::presets

int main(int argc, char** argv)
{
    QCoreApplication application(argc, argv);
    const QStringList arguments = QCoreApplication::arguments();
    if (arguments.size() < 2) {
        std::fputs("Usage: hairpaint_preset_baker FOLDER [ID]...\n", stderr);
        return 2;
    }
    return hairpaint::presets::run(arguments.at(1), arguments.mid(2));
}
