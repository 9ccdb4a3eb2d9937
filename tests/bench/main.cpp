// hairpaint_bench: how long the parts take. Google Benchmark's own options apply; --benchmark_out=FILE writes JSON.
#include <benchmark/benchmark.h>

#include <string_view>
#include <vector>

namespace {

/// Names without what they were timed by, so that they stay the same when that changes.
template<typename Reporter>
class PlainNames : public Reporter
{
public:
    using Reporter::Reporter;
    void ReportRuns(const std::vector<benchmark::BenchmarkReporter::Run>& runs) override
    {
        std::vector<benchmark::BenchmarkReporter::Run> renamed = runs;
        for (benchmark::BenchmarkReporter::Run& run : renamed) {
            run.run_name.time_type.clear();
            run.run_name.iterations.clear();
        }
        Reporter::ReportRuns(renamed);
    }
};

} // namespace

int main(int argc, char** argv)
{
    bool toFile = false;
    for (int i = 1; i < argc; ++i)
        toFile = toFile || std::string_view(argv[i]).starts_with("--benchmark_out=");
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
        return 2;
    PlainNames<benchmark::ConsoleReporter> console(benchmark::ConsoleReporter::OO_Tabular);
    PlainNames<benchmark::JSONReporter> json;
    benchmark::RunSpecifiedBenchmarks(&console, toFile ? &json : nullptr);
    benchmark::Shutdown();
    return 0;
}
