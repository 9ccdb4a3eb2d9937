// Hair of other programs as `.hair`: what reads is whole.
#include "model/importing/hair_file_reader.h"
#include "tests/fuzz/fuzz_curves.h"
#include "tests/fuzz/fuzz_input.h"

#include <QBuffer>

#include <utility>

using namespace hairpaint;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    QBuffer file;
    file.setData(reinterpret_cast<const char*>(data), static_cast<int>(size));
    fuzz::require(file.open(QIODevice::ReadOnly));
    if (auto curves = model::readHairFile(file); curves && *curves)
        fuzz::requireWhole(std::move(**curves));
    return 0;
}
