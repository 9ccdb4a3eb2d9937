// gui_latency/groom: how long an event of the window waits while 100,000 hairs are groomed again and again;
// gui_latency/head_import: while heads of 130,000 triangles are prepared and put into the real window in turns, which
// draws them; gui_latency/opacity: while the opacity of a layer is dragged that is one of eight on a map of 2048 texels
// a side, in the real window; gui_latency/style: while styles are clicked in turns; gui_latency/open: while two
// projects are opened in turns. Counters: the median, the 99th percentile and the longest wait, in ms.
// frames/large_brush: how far apart the pictures of the 3D area come while a brush of 10 cm paints lengths on the head
// and the hair moves; the same counters.
#include "app/background/heads.h"
#include "app/background/jobs.h"
#include "app/session/session.h"
#include "app/styles/library.h"
#include "app/window/main_window.h"
#include "model/document/group_commands.h"
#include "model/document/scene_commands.h"
#include "model/files/glb_writing.h"
#include "model/files/project_file.h"
#include "tests/support/test_heads.h"
#include "view/head_area/head_view.h"
#include "view/look/resources.h"
#include "view/panels/style_strip.h"
#include "view/panels/style_tile.h"

#include <QApplication>
#include <QEvent>
#include <QEventLoop>
#include <QMouseEvent>
#include <QTemporaryDir>
#include <QTimer>
#include <QUndoStack>
#include <QWidget>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

namespace hairpaint {
namespace {

using Clock = std::chrono::steady_clock;

QApplication& application()
{
    static int argc = 1;
    static char name[] = "hairpaint_bench";
    static char* argv[] = {name, nullptr};
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    // Never destroyed: what Qt keeps in statics of its own would be gone before it.
    static auto* made = new QApplication(argc, argv);
    return *made;
}

struct Sent : QEvent
{
    Sent() : QEvent(QEvent::User) {}
    Clock::time_point at = Clock::now();
};

void reportTimes(benchmark::State& state, std::vector<double>& milliseconds)
{
    if (milliseconds.empty())
        return state.SkipWithError("nothing came");
    std::ranges::sort(milliseconds);
    const auto at = [&milliseconds](double fraction) {
        return milliseconds[static_cast<std::size_t>(fraction * static_cast<double>(milliseconds.size() - 1))];
    };
    state.counters["median_ms"] = at(0.5);
    state.counters["p99_ms"] = at(0.99);
    state.counters["longest_ms"] = at(1.0);
}

/// Takes what another thread sends every few milliseconds, as a mouse does.
class Receiver : public QObject
{
public:
    Receiver()
        : m_sender([this](const std::stop_token& stop) {
              constexpr std::chrono::milliseconds kApart(3);
              std::mutex mutex;
              std::unique_lock lock(mutex);
              std::condition_variable_any ended;
              do
                  QCoreApplication::postEvent(this, new Sent);
              while (!ended.wait_for(lock, stop, kApart, [&stop] { return stop.stop_requested(); }));
          })
    {}
    ~Receiver() override { stop(); }

    void report(benchmark::State& state)
    {
        stop();
        reportTimes(state, m_waits);
    }

protected:
    bool event(QEvent* event) override
    {
        if (event->type() != QEvent::User)
            return QObject::event(event);
        const Clock::duration waited = Clock::now() - static_cast<const Sent*>(event)->at;
        m_waits.push_back(std::chrono::duration<double, std::milli>(waited).count());
        return true;
    }

private:
    void stop()
    {
        m_sender.request_stop();
        if (m_sender.joinable())
            m_sender.join();
    }

    std::vector<double> m_waits;
    std::jthread m_sender;
};

void duringGrooms(benchmark::State& state)
{
    application();
    model::Project project = app::starterProject();
    project.wind.enabled = true;
    sim::GroupSettings& settings = project.groups.front().settings;
    const double painted = settings.greatestDensityPerM2;
    constexpr double kHairs = 100'000.0;
    const auto await = [](app::Session& session) {
        while (session.hair() != app::Session::Hair::Current)
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    };
    {
        app::Session session(project);
        await(session);
        settings.greatestDensityPerM2 =
            static_cast<float>(painted * kHairs / static_cast<double>(session.frame()->hairCount));
    }
    app::Session session(project);
    await(session);
    Receiver receiver;
    model::Document& document = session.document();
    for ([[maybe_unused]] auto step : state) {
        sim::GroupSettings next = document.project().groups.front().settings;
        next.greatestLengthM *= 0.99F;
        document.push(
            model::setSettingsCommand(document, document.project().groups.front().id, next, QStringLiteral("Length")));
        await(session);
    }
    receiver.report(state);
    state.counters["hairs"] = static_cast<double>(session.frame()->hairCount);
}

void duringHeadImports(benchmark::State& state)
{
    application();
    view::initResources();
    app::MainWindow window(app::starterProject());
    window.resize(1280, 800);
    window.show();
    app::Jobs jobs(window);
    model::Document& document = window.session().document();
    const sim::HeadMesh mesh = test::makeBallHead(360, 0.11F);
    while (window.session().hair() != app::Session::Hair::Current)
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    Receiver receiver;
    for ([[maybe_unused]] auto step : state) {
        const auto head = jobs.await<app::ImportedHead>(
            {.text = QStringLiteral("Preparing"), .whenCancelled = {}}, [&](const model::Progress& progress) {
                return app::remakeHead(QStringLiteral("ball"), model::glbFromMesh(mesh), {}, progress);
            });
        if (!head || !*head)
            return state.SkipWithError("the head could not be made");
        document.push(model::setHeadCommand(document, (*head)->head, (*head)->ellipsoids));
        while (window.session().hair() != app::Session::Hair::Current)
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
    receiver.report(state);
}

/// A window of the usual size whose hair is there.
std::unique_ptr<app::MainWindow> openWindow()
{
    application();
    view::initResources();
    auto window = std::make_unique<app::MainWindow>(app::starterProject());
    window->resize(1280, 800);
    window->show();
    return window;
}

void awaitHair(app::MainWindow& window)
{
    while (window.session().hair() != app::Session::Hair::Current)
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
}

void duringStyles(benchmark::State& state)
{
    const auto window = openWindow();
    awaitHair(*window);
    const auto* strip = window->findChild<view::StyleStrip*>();
    while (strip->paths().size() < 6)
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    Receiver receiver;
    int number = 0;
    const QUndoStack& steps = window->session().document().undoStack();
    for ([[maybe_unused]] auto step : state) {
        const QList<view::StyleTile*> tiles = strip->findChildren<view::StyleTile*>();
        const int before = steps.index();
        tiles.at(1 + ++number % 5)->click();
        while (steps.index() == before)
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        awaitHair(*window);
    }
    receiver.report(state);
}

void duringOpening(benchmark::State& state)
{
    const auto window = openWindow();
    awaitHair(*window);
    const QTemporaryDir folder;
    const QString paths[] = {folder.filePath(QStringLiteral("a.hairpaint")),
                             folder.filePath(QStringLiteral("b.hairpaint"))};
    for (const QString& path : paths)
        if (!model::saveProject(app::starterProject(), path, {}))
            return state.SkipWithError("nothing could be saved");
    Receiver receiver;
    int number = 0;
    for ([[maybe_unused]] auto step : state) {
        window->openFile(paths[++number % 2]);
        awaitHair(*window);
    }
    receiver.report(state);
}

void duringOpacityTicks(benchmark::State& state)
{
    constexpr int kLayers = 8;
    constexpr int kMapSize = 2048;
    application();
    view::initResources();
    model::Project project = app::starterProject();
    const model::Id group = project.groups.front().id;
    model::MapStack& colour = project.groups.front().map(model::MapKind::Colour);
    colour.size = kMapSize;
    colour.layers.clear();
    for (int i = 0; i < kLayers; ++i) {
        model::Layer layer =
            model::makeLayer(project, model::mapSpec(model::MapKind::Colour), kMapSize, QStringLiteral("L"));
        for (int index = 0; index < layer.raster.tileCount(); ++index) {
            std::uint16_t value = 0;
            for (std::uint16_t& channel : layer.raster.writableTile(index))
                channel = value = static_cast<std::uint16_t>(value * 31 + index + i + 1);
        }
        colour.layers.push_back(std::move(layer));
    }
    const model::Id layer = colour.layers.back().id;
    app::MainWindow window(std::move(project));
    window.resize(1280, 800);
    window.show();
    window.session().editor().target().setMap(model::MapKind::Colour);
    const auto await = [&window] {
        while (window.session().hair() != app::Session::Hair::Current)
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    };
    model::Document& document = window.session().document();
    model::EditSession edit = document.begin({});
    await();
    Receiver receiver;
    int tick = 0;
    for ([[maybe_unused]] auto step : state) {
        const float opacity = 0.2F + 0.001F * static_cast<float>(++tick % 700);
        edit.preview(
            {.aspect = model::Change::Aspect::LayerList, .group = group, .map = model::MapKind::Colour},
            [=](model::Project& shown) { shown.layer(group, model::MapKind::Colour, layer)->opacity = opacity; });
        const Clock::time_point next = Clock::now() + std::chrono::milliseconds(16);
        while (Clock::now() < next || document.resolving())
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
    receiver.report(state);
    edit.drop();
}

void duringStrokes(benchmark::State& state)
{
    application();
    view::initResources();
    model::Project project = app::starterProject();
    project.wind = {.enabled = true, .velocity = {3.0F, 0.0F, 1.0F}, .gustiness = 0.5F, .turbulence = 0.3F};
    app::MainWindow window(std::move(project));
    window.resize(1440, 900);
    window.show();
    view::EditorState& editor = window.session().editor();
    editor.target().setMap(model::MapKind::Length);
    model::ToolSettings settings = editor.tools().settings();
    settings.brushSizeM = 0.10F;
    editor.tools().setSettings(settings);
    // As the program waits for a hand: asleep where nothing comes, so that both cores are left to the hair.
    const auto workFor = [](int milliseconds) {
        QEventLoop loop;
        QTimer::singleShot(std::chrono::milliseconds(milliseconds), Qt::PreciseTimer, &loop, &QEventLoop::quit);
        loop.exec();
    };
    workFor(3000);
    view::HeadView& area = window.headView();
    std::vector<double> apart;
    Clock::time_point last = Clock::now();
    const auto connection =
        QObject::connect(&area, &view::HeadView::frameDrawn, &area, [&](const rendering::FrameStatistics&) {
            const Clock::time_point now = Clock::now();
            apart.push_back(std::chrono::duration<double, std::milli>(now - last).count());
            last = now;
        });
    const auto send = [&](QEvent::Type type, QPointF at) {
        const bool down = type != QEvent::MouseButtonRelease;
        QMouseEvent event(type, at, area.mapToGlobal(at), type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton,
                          down ? Qt::LeftButton : Qt::NoButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&area, &event);
    };
    const QPointF middle(area.width() * 0.5, area.height() * 0.3);
    for ([[maybe_unused]] auto step : state) {
        send(QEvent::MouseButtonPress, middle);
        for (int i = 0; i < 100; ++i) {
            const double angle = 0.2 * i;
            send(QEvent::MouseMove, middle + QPointF(60.0 * std::sin(angle), 40.0 * std::sin(1.7 * angle)));
            workFor(8);
        }
        send(QEvent::MouseButtonRelease, middle);
    }
    QObject::disconnect(connection);
    reportTimes(state, apart);
}

BENCHMARK(duringStrokes)->Name("frames/large_brush")->Iterations(5)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(duringGrooms)->Name("gui_latency/groom")->Iterations(20)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(duringHeadImports)
    ->Name("gui_latency/head_import")
    ->Iterations(10)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(duringStyles)->Name("gui_latency/style")->Iterations(15)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(duringOpening)->Name("gui_latency/open")->Iterations(10)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(duringOpacityTicks)
    ->Name("gui_latency/opacity")
    ->Iterations(100)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

} // namespace
} // namespace hairpaint
