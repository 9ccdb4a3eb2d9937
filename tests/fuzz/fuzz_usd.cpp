// Hair of other programs as USD text, of two layers that may name each other: what reads is whole.
#include "model/importing/usd_reader.h"
#include "tests/fuzz/fuzz_curves.h"
#include "tests/fuzz/fuzz_input.h"

#include <utility>

using namespace hairpaint;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    fuzz::Input input(data, size);
    const QByteArray both = input.rest();
    const qsizetype end = both.indexOf('\0');
    const QByteArray text = "#usda 1.0\n" + both.first(end < 0 ? both.size() : end);
    const QByteArray other = "#usda 1.0\n" + (end < 0 ? QByteArray() : both.sliced(end + 1));
    const auto opener = [&](const QString& asset, const QString&) -> std::optional<model::UsdLayer> {
        if (asset.size() != 1)
            return std::nullopt;
        return model::UsdLayer{.text = asset == QLatin1String("a") ? text : other, .path = asset};
    };
    if (auto curves = model::readUsdText(text, {}, opener); curves && *curves)
        fuzz::requireWhole(std::move(**curves));
    return 0;
}
