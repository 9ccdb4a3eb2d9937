// Prepares the built-in heads before the first input: under the sanitizers that takes longer than an input may.
#include "model/files/head_file.h"
#include "tests/fuzz/fuzz_input.h"

using namespace hairpaint;

extern "C" int LLVMFuzzerInitialize(int* /*argc*/, char*** /*argv*/)
{
    for (const model::NamedHead& head : model::builtInHeads())
        fuzz::require(model::builtInHead(head.name).has_value());
    return 0;
}
