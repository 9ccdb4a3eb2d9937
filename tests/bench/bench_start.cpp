// From the program's start to the first picture with hair in its window.
#include <QProcess>

#include <benchmark/benchmark.h>

namespace hairpaint {
namespace {

constexpr int kPatienceMs = 20000;

/// Where the environment names no platform for windows, they are drawn off-screen.
void startToFirstHair(benchmark::State& state)
{
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    if (!environment.contains(QStringLiteral("QT_QPA_PLATFORM")))
        environment.insert(QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("offscreen"));
    environment.insert(QStringLiteral("QT_LOGGING_RULES"), QStringLiteral("hairpaint.start=true"));
    for ([[maybe_unused]] auto _ : state) {
        QProcess program;
        program.setProcessEnvironment(environment);
        program.setProcessChannelMode(QProcess::MergedChannels);
        program.start(QStringLiteral(HAIRPAINT_PROGRAM), QStringList());
        QByteArray said;
        while (!said.contains("hairs after") && program.waitForReadyRead(kPatienceMs))
            said += program.readAll();
        state.PauseTiming();
        program.kill();
        program.waitForFinished();
        if (!said.contains("hairs after"))
            state.SkipWithError("the program shows no hair");
        state.ResumeTiming();
    }
}

BENCHMARK(startToFirstHair)->Name("start_to_first_hair")->Iterations(5)->UseRealTime()->Unit(benchmark::kMillisecond);

} // namespace
} // namespace hairpaint
