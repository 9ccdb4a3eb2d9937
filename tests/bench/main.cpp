// hairpaint_bench: how long the parts take. Google Benchmark's own options apply: --benchmark_format=json prints JSON,
// --benchmark_out=FILE writes it.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <string>
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
    // Google Benchmark takes its options out of argv.
    const auto given = [options = std::vector<std::string>(argv + 1, argv + argc)](std::string_view start) {
        return std::ranges::any_of(options, [start](const std::string& option) { return option.starts_with(start); });
    };
    const bool printsJson = given("--benchmark_format=json");
    const bool printsTable = !given("--benchmark_format=") || given("--benchmark_format=console");
    const bool toFile = given("--benchmark_out=");
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
        return 2;
    PlainNames<benchmark::ConsoleReporter> table(benchmark::ConsoleReporter::OO_Tabular);
    PlainNames<benchmark::JSONReporter> json;
    PlainNames<benchmark::JSONReporter> file;
    benchmark::BenchmarkReporter* display = nullptr; // What the options name.
    if (printsJson)
        display = &json;
    else if (printsTable)
        display = &table;
    benchmark::RunSpecifiedBenchmarks(display, toFile ? &file : nullptr);
    benchmark::Shutdown();
    return 0;
}
