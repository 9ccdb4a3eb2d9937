// Hair of other programs as USD text: what reads is whole.
#include "model/importing/usd_reader.h"
#include "tests/fuzz/fuzz_curves.h"
#include "tests/fuzz/fuzz_input.h"

using namespace hairpaint;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    fuzz::Input input(data, size);
    const QByteArray text = "#usda 1.0\n" + input.rest();
    if (const auto curves = model::readUsdText(text); curves && *curves)
        fuzz::requireWhole(**curves);
    return 0;
}
