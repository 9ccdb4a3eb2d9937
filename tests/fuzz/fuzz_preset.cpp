// Presets: what opens can be saved and opens again.
#include "model/files/preset_file.h"
#include "tests/fuzz/made_archive.h"

using namespace hairpaint;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    fuzz::Input input(data, size);
    const QString path =
        fuzz::scratchFile(QStringLiteral("input.hairpreset"), fuzz::archiveOf(input, "application/x-hairpaint-preset"));
    const model::Result<model::PresetEntry> entry = model::presetEntry(path);
    if (const model::Result<model::Preset> preset = model::loadPreset(path)) {
        fuzz::require(entry.has_value());
        const QString again = fuzz::scratchPath(QStringLiteral("saved.hairpreset"));
        fuzz::require(model::savePreset(*preset, again).has_value());
        fuzz::require(model::loadPreset(again).has_value());
    }
    return 0;
}
