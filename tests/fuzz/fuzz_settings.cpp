// settings.json: whatever lies there, the program starts with values that it can work with, and keeps what it is told.
#include "app/settings/dialog_positions.h"
#include "app/settings/settings.h"
#include "app/settings/tool_memory.h"
#include "model/document/document.h"
#include "tests/fuzz/fuzz_input.h"
#include "view/editing/editor_state.h"

#include <QApplication>
#include <QDir>
#include <QStandardPaths>

#include <cmath>
#include <optional>

using namespace hairpaint;

namespace {

/// What the settings are read into: a program without a window.
struct Started
{
    Started()
    {
        QStandardPaths::setTestModeEnabled(true);
        QCoreApplication::setApplicationName(QStringLiteral("hairpaint-fuzz-settings"));
        qputenv("XDG_CONFIG_HOME", QFile::encodeName(fuzz::scratchPath(QStringLiteral("config"))));
    }

    int argumentCount = 1;
    char name[8] = "fuzzed";
    char* arguments[2] = {name, nullptr};
    QApplication application{argumentCount, arguments};
    model::Document document{model::Project{}};
    view::EditorState editor{document};
};

bool isWithin(int value, int least, int most)
{
    return value >= least && value <= most;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static Started started;
    const QString path =
        QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation) + QStringLiteral("/settings.json");
    fuzz::require(QDir().mkpath(QFileInfo(path).absolutePath()));
    QFile file(path);
    fuzz::require(file.open(QIODevice::WriteOnly) &&
                  file.write(reinterpret_cast<const char*>(data), static_cast<qint64>(size)) ==
                      static_cast<qint64>(size));
    file.close();

    app::Settings settings;
    const view::Preferences preferences = settings.preferences();
    fuzz::require(isWithin(static_cast<int>(preferences.presenter), 0, 2));
    const view::PictureChoice picture = settings.pictureChoice();
    fuzz::require(isWithin(picture.size.width(), picture.kLeastPx, picture.kMostPx) &&
                  isWithin(picture.size.height(), picture.kLeastPx, picture.kMostPx) && picture.colour.isValid() &&
                  isWithin(picture.samples, 1, 16));
    if (const std::optional<QPoint> corner = settings.dialogPosition(QStringLiteral("export"))) {
        constexpr int kFarthestPx = 1'000'000;
        fuzz::require(isWithin(corner->x(), -kFarthestPx, kFarthestPx) &&
                      isWithin(corner->y(), -kFarthestPx, kFarthestPx));
        const QRect screen(0, 0, 1920, 1080);
        fuzz::require(screen.contains(app::insideScreen(*corner, {400, 300}, screen)));
    }
    (void)settings.key(QStringLiteral("file.save"));
    (void)settings.recentFiles();
    (void)settings.windowGeometry();
    (void)settings.lastFolder();
    (void)settings.avatarAuthor();
    (void)settings.viewTurned();

    recallToolOptions(settings, started.editor);
    for (const auto& tool : started.editor.tools().all())
        for (const model::ToolOption* option : tool->options())
            fuzz::require(std::isfinite(optionOf(started.editor.tools().settings(), *option)));
    return 0;
}
